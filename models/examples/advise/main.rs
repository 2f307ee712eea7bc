//! How much model a scene needs: `advise` on three scenes of which it is known (docs/advise.md).
//!
//! `cargo run --release --example advise -- [--scene engine|boom|spinner] [--wanted 1e-3]`

mod scenes;

use std::process::ExitCode;

use rncf::app::{Command, Entry, enter, main_among};

fn main() -> ExitCode {
    let scenes = [
        ("engine", enter::<scenes::Engine> as Entry),
        ("boom", enter::<scenes::Boom>),
        ("spinner", enter::<scenes::Spinner>),
    ];
    main_among("scene", Command::Advise, &scenes)
}
