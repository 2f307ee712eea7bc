//! Rotating cantilever: its frequencies over the speed.
//!
//! `cargo run --release --example rotating_cantilever -- modes eta=6`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::RotatingCantilever>()
}
