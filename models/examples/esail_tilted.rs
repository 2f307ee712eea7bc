//! E-sail at an angle to the solar wind, held there by the voltages of its tethers.
//!
//! `cargo run --release --example esail_tilted -- ring_share=1 --integrator generalized-alpha --step "5 s"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::EsailTilted>()
}
