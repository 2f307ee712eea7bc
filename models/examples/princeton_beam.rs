//! Princeton beam experiment.
//!
//! `cargo run --release --example princeton_beam -- load="4 N"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main_as::<rncf_models::PrincetonBeam>(rncf::app::Command::Static)
}
