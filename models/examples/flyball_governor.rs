//! Stiff flyball governor (IFToMM benchmark A05).
//!
//! `cargo run --release --example flyball_governor -- omega_0="6.2832 rad/s"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::FlyballGovernor>()
}
