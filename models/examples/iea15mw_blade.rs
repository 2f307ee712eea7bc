//! Blade of the IEA 15-MW turbine: full matrices along a bent axis.
//!
//! `cargo run --release --example iea15mw_blade -- modes`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::Iea15mwBlade>()
}
