//! A cable with a mass at its end, tumbling freely.
//!
//! `cargo run --release --example free_flight -- --formulation ancf --rtol 1e-8`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::FreeFlight>()
}
