//! The elastica.
//!
//! `cargo run --release --example elastica -- alpha=10`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main_as::<rncf_models::Elastica>(rncf::app::Command::Static)
}
