//! A stone on a string with a law of its own: where it comes to rest, and how it swings there.

use rncf::app::charts::Line;
use rncf::app::{Figure, RunSettings};
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::own_element::Bungee;

use crate::{chart, column, drawn, line, says, shows};

const G: f64 = 9.81;

/// Strain at which `300 N (l + 2 l^3)` is a force.
fn stretched(force: f64) -> f64 {
    let mut l = 0.3;
    for _ in 0..50 {
        l -= (300.0 * (l + 2.0 * l * l * l) - force) / (300.0 * (1.0 + 6.0 * l * l));
    }
    l
}

#[test]
fn the_cord_rests_where_its_law_says() {
    let (run, shots) = drawn(&Bungee::default(), RunSettings::default());
    let history = &run.history;
    let last = |name: &str| *column(history, name).last().unwrap();
    let cord = 1100.0 * 100e-6 * 2.0;
    // Each piece carries what hangs below it.
    let parts = 1000;
    let rest = (0..parts)
        .map(|i| stretched((10.0 + cord * (f64::from(i) + 0.5) / f64::from(parts)) * G))
        .sum::<f64>()
        / f64::from(parts);
    assert!((last("stretch") - rest).abs() < 1e-4, "{} {rest}", last("stretch"));
    assert!(
        (last("pull") / ((10.0 + cord) * G) - 1.0).abs() < 1e-3,
        "{} N",
        last("pull")
    );
    says("own_element", &format!("carries {:.2} N", last("pull")));
    says("own_element", &format!("The stretch is {:.4}", last("stretch")));
    let mut figure = Figure::default();
    let still = Line::new([(0.0, rest), (10.0, rest)], 5).dashed();
    let lines = vec![line(history, "stretch", 1.0, 0), still];
    figure.add(
        "Stretch of the cord, and where it rests",
        &["cord"],
        chart("t [s]", "stretch [1]", lines),
    );
    let drawing = Drawing::new(
        &shots,
        View {
            right: [0.0, -1.0, 0.0],
            up: [1.0, 0.0, 0.0],
        },
        vec![shots.count() - 1],
        "The cord, lying: without force (grey, below), and with the stone at rest",
    );
    shows(
        "own_element",
        Some(&drawing),
        &figure,
        "A stone on a cord, and the stretch of the cord",
    );
}
