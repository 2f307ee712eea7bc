//! Spin-up manoeuvre of a flexible beam in the plane (Ren & Yang 2021, section 4.1.1).
//!
//! `cargo run --release --example spin_up -- omega_s="10 rad/s" elements=16`; `-- --help` lists all. Alone of all models its
//! own is built for it: the first thing that one runs has not to wait for the others.

#[path = "../models/src/spin_up.rs"]
pub mod model;

fn main() -> std::process::ExitCode {
    rncf::app::main::<model::SpinUp>()
}
