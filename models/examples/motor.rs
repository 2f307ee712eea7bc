//! High-speed motor: an unbalanced rotor on a flexible shaft (Ren & Yang 2021, section 4.1.3).
//!
//! `cargo run --release --example motor -- speed="15000 rpm"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::Motor>()
}
