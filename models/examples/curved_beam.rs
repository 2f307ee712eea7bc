//! Spin-up of curved beams (Ren & Yang 2021, section 4.1.2): three models, chosen by `--model`.
//!
//! `cargo run --release --example curved_beam -- --model out_of_plane omega_s="10 rad/s"`; `-- --help` lists all.

use rncf::app::{Command, Entry, enter, main_among};
use rncf_models::{CurvedDownwind, CurvedOutOfPlane, CurvedUpwind};

fn main() -> std::process::ExitCode {
    let models = [
        ("upwind", enter::<CurvedUpwind> as Entry),
        ("downwind", enter::<CurvedDownwind>),
        ("out_of_plane", enter::<CurvedOutOfPlane>),
    ];
    main_among("model", Command::Run, &models)
}
