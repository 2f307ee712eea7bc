//! Electric solar wind sail at one astronomical unit (Ren & Yang 2021, section 4.3).
//!
//! `cargo run --release --example esail -- spin="0.25 deg/s"`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::Esail>()
}
