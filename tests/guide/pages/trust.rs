//! How the rope's end depends on the mesh, and what becomes of its energy.

use rncf::app::charts::Line;
use rncf::app::{Figure, RunSettings, run};
use rncf::{Formulation, Options};
use rncf_guide::trust::Rope;

use crate::{chart, column, line, range, says, shows};

fn tip(elements: usize, rtol: f64) -> f64 {
    let settings = RunSettings {
        options: Options {
            rtol,
            ..Options::default()
        },
        ..RunSettings::default()
    };
    let found = run(
        &Rope {
            elements,
            ..Rope::default()
        },
        &settings,
    )
    .unwrap();
    *column(&found.history, "tip.x").last().unwrap()
}

#[test]
fn the_mesh_shows_and_the_tolerance_does_not() {
    let finest = tip(64, 1e-6);
    let steps = (tip(8, 1e-8), tip(8, 1e-6));
    assert!((steps.0 - steps.1).abs() < 1e-7, "{steps:?}");
    says("trust", &format!("tip.x = {:.7} m in both", steps.0));
    says("trust", &format!("Now tip.x = {:.4} m", tip(16, 1e-6)));
    says("trust", &format!("with 64 elements {finest:.4} m"));
    let counts = [4, 6, 8, 12, 16, 24, 32];
    let errors: Vec<(f64, f64)> = counts
        .iter()
        .map(|&n| (n as f64, (tip(n, 1e-6) - finest).abs()))
        .collect();
    assert!(errors.windows(2).all(|pair| pair[1].1 < pair[0].1 * 1.2), "{errors:?}");
    let loss = run(
        &Rope {
            damping: 0.0,
            ..Rope::default()
        },
        &RunSettings::default(),
    )
    .unwrap();
    let energy = column(&loss.history, "energy");
    let [low, high] = range(&energy);
    assert!(low > -1e-6 && high < 1e-6, "{low} J, {high} J");
    says("trust", &format!("ends at {} J", short(energy[energy.len() - 1])));
    let absolute = RunSettings {
        formulation: Formulation::Ancf,
        ..RunSettings::default()
    };
    let other = run(&Rope::default(), &absolute).unwrap();
    assert!((column(&other.history, "tip.x").last().unwrap() - steps.1).abs() < 1e-6);
    let mut figure = Figure::default();
    let mut of_mesh = chart("elements", "error of tip.x [m]", vec![Line::new(errors, 0)]);
    of_mesh.logarithmic = true;
    figure.add("Error of the end after 2 s, beside 64 elements", &[], of_mesh);
    let lines = vec![line(&loss.history, "energy", 1e-6, 0)];
    figure.add(
        "Energy without damping, of 0.42 J that fall",
        &[],
        chart("t [s]", "energy [uJ]", lines),
    );
    shows(
        "trust",
        None,
        &figure,
        "The error of the rope's end over the number of elements, and its energy over time",
    );
}

/// Two digits.
fn short(value: f64) -> String {
    format!("{value:.1e}")
}
