//! Flexible slider-crank (Ren & Yang 2021, section 4.2).
//!
//! `cargo run --release --example slider_crank -- omega_s="12 rad/s" damping="0.1 ms"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::SliderCrank>()
}
