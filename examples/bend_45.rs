//! 45-degree bend under a load out of its plane.
//!
//! `cargo run --release --example bend_45 -- static load="300 N"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::Bend45>()
}
