//! Lateral buckling of a right-angle frame.
//!
//! `cargo run --release --example right_angle_frame -- static`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main::<rncf_models::RightAngleFrame>()
}
