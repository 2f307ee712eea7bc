//! Lateral buckling of a cantilever strip.
//!
//! `cargo run --release --example lateral_buckling`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main_as::<rncf_models::LateralBuckling>(rncf::app::Command::Static)
}
