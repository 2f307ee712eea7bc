//! The electric solar wind sail that spins slowly, with tethers that pull and never push (THEORY 10, T6).
//!
//! `cargo run --release --example esail_slack -- asymmetry=1e-4`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::EsailSlack>()
}
