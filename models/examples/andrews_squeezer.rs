//! Andrews' squeezing mechanism: seven bodies in a plane.
//!
//! `cargo run --release --example andrews_squeezer -- --rtol 1e-9`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::AndrewsSqueezer>()
}
