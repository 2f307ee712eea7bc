//! Roll-up of a beam to a circle.
//!
//! `cargo run --release --example roll_up -- turns=0.5`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main_as::<rncf_models::RollUp>(rncf::app::Command::Static)
}
