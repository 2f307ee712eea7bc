//! Roll-up of a beam to a circle.
//!
//! `cargo run --release --example roll_up -- static turns=0.5`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::RollUp>()
}
