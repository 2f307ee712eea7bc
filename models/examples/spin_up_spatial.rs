//! Spin-up manoeuvre of a flexible beam in space (Ren & Yang 2021, section 4.1.1).
//!
//! `cargo run --release --example spin_up_spatial -- omega_s="10 rad/s" elements=16`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::SpinUpSpatial>()
}
