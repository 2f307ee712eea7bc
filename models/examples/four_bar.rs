//! Double four-bar linkage (IFToMM benchmark A02).
//!
//! `cargo run --release --example four_bar -- --rtol 1e-8`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::FourBar>()
}
