//! 45-degree bend under a load out of its plane.
//!
//! `cargo run --release --example bend_45 -- load="300 N"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main_as::<rncf_models::Bend45>(rncf::app::Command::Static)
}
