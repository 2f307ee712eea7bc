//! Princeton beam experiment.
//!
//! `cargo run --release --example princeton_beam -- static load="4 N"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::PrincetonBeam>()
}
