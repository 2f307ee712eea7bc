//! Bricard's mechanism (IFToMM benchmark A03).
//!
//! `cargo run --release --example bricard -- --rtol 1e-8`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::Bricard>()
}
