//! Lateral buckling of a cantilever strip.
//!
//! `cargo run --release --example lateral_buckling -- static`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::LateralBuckling>()
}
