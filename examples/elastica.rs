//! The elastica.
//!
//! `cargo run --release --example elastica -- static alpha=10`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::Elastica>()
}
