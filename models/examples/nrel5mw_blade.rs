//! Blade of the NREL 5-MW turbine from its table of sections.
//!
//! `cargo run --release --example nrel5mw_blade -- modes`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::Nrel5mwBlade>()
}
