//! One rotating arm three times: with all nodal vectors, in modes, and in modes for small deformations. Spun up fast it bends
//! far; spun up slowly it hardly bends, but turns faster than modes without stretch can bear (docs/language/bodies.md, "Ladder of
//! fidelity").
//!
//! `cargo run --release --example fidelity`

// One declaration serves several models: not all of them need all of its params.
#![allow(deprecated)]

use rncf::app::{RunResult, RunSettings, run};
use rncf::prelude::*;

/// Declares the arm: beam and spin-up of Ren & Yang 2021, section 4.1.1.
macro_rules! arm {
    ($name:ident, $doc:tt, { $($params:tt)* }, { $($fidelity:tt)* }) => {
        rncf::model! {
            #[doc = $doc]
            pub model $name {
                /// Steady angular velocity.
                param omega_s = 4 rad/s;
                /// Time to reach it.
                param T_s = 15 s;
                $($params)*

                material aluminium { density = 2766.67 kg/m^3; young = 68.95 GPa; }
                section tube { area = 0.7299 cm^2; second_moment = 0.8215 cm^4; }
                motion theta(t) =
                    if t <= T_s { (omega_s/T_s) * (t^2/2 + (T_s/(2*pi))^2 * (cos(2*pi*t/T_s) - 1)) }
                    else { omega_s * (t - T_s/2) };
                frame hub = rotating(axis = z, angle = theta(t));
                body arm in hub {
                    planar xy;
                    line from [0, 0, 0] m to [8, 0, 0] m;
                    mesh 16 * cable(tube, aluminium);
                    $($fidelity)*
                }
                joint root = clamp(arm.start, hub);

                /// Elongation of the tip in the frame.
                output u = arm.end.x - 8 m;
                /// Deflection of the tip in the frame.
                output v = arm.end.y;

                run { t_end = T_s + 5 s; every = T_s / 200; }
            }
        }
    };
}
arm!(ArmFull, "The arm with all its nodal vectors.", {}, {});
arm!(
    ArmModal,
    "The arm in modes.",
    {
        /// Number of modes.
        param modes: count = 4;
    },
    {
        modal(modes);
    }
);
arm!(
    ArmSmall,
    "The arm in modes, for small deformations.",
    {
        /// Number of modes.
        param modes: count = 4;
    },
    {
        small(modes);
    }
);

fn main() {
    for spin_up in [15.0, 1500.0] {
        println!("\nSpun up to 4 rad/s in {spin_up} s\n");
        println!("| arm | unknowns | steps | CPU s | largest deflection (m) | deflection at the end (m) |");
        println!("|---|---|---|---|---|---|");
        let mut warnings = Vec::new();
        let full = ArmFull {
            T_s: spin_up,
            ..ArmFull::default()
        };
        warnings.extend(row("full", &solve(&full)));
        for modes in [4, 12, 24, 40] {
            let modal = ArmModal {
                T_s: spin_up,
                modes,
                ..ArmModal::default()
            };
            warnings.extend(row(&format!("modal({modes})"), &solve(&modal)));
        }
        let small = ArmSmall {
            T_s: spin_up,
            ..ArmSmall::default()
        };
        warnings.extend(row("small(4)", &solve(&small)));
        println!();
        warnings.iter().for_each(|warning| println!("* {warning}"));
    }
}

/// Prints a row of the table; returns the warnings with the name of the arm.
fn row(name: &str, result: &RunResult) -> Vec<String> {
    let deflections: Vec<f64> = result.history.column(1).collect();
    let largest = deflections.iter().map(|v| v.abs()).fold(0.0, f64::max);
    let last = deflections.last().copied().unwrap_or_default();
    println!(
        "| {name} | {} | {} | {:.3} | {largest:.5} | {last:.5} |",
        result.unknowns, result.statistics.steps, result.seconds.cpu
    );
    result
        .warnings
        .iter()
        .map(|warning| format!("{name}: {warning}"))
        .collect()
}

fn solve(model: &impl Model) -> RunResult {
    run(model, &RunSettings::default()).unwrap_or_else(|error| panic!("{error}"))
}
