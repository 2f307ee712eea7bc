//! Lateral buckling of a right-angle frame.
//!
//! `cargo run --release --example right_angle_frame`; `-- --help` lists all.

fn main() -> std::process::ExitCode {
    rncf::app::main_as::<rncf_models::RightAngleFrame>(rncf::app::Command::Static)
}
