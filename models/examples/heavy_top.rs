//! Heavy top on a fixed point (Brüls, Cardona & Arnold 2012).
//!
//! `cargo run --release --example heavy_top -- --rtol 1e-8`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::HeavyTop>()
}
