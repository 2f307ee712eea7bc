//! Rotating cantilever: its frequencies over the speed.
//!
//! `cargo run --release --example rotating_cantilever -- eta=6`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main_as::<rncf_models::RotatingCantilever>(rncf::app::Command::Modes)
}
