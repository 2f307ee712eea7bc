//! A rope that swings down: its free end falls freely at first, and its hook carries what its momentum asks for.

use rncf::app::{EquilibriumSettings, Figure, RunSettings, static_equilibria};
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::first_rope::Rope;

use crate::{chart, column, drawn, line, says, shows};
use rncf::app::charts::Line;

const G: f64 = 9.81;

#[test]
fn the_rope_falls_freely_and_hangs() {
    let rope = Rope::default();
    let (run, shots) = drawn(&rope, RunSettings::default());
    let history = &run.history;
    let height = column(history, "tip.y");
    // A rod that falls about its end is no faster than this; the end of a rope is, once its wave has arrived.
    let free = |t: f64| -G * t * t / 2.0;
    for (&t, &y) in history.keys.iter().zip(&height).filter(|(t, _)| **t <= 0.1) {
        assert!((y - free(t)).abs() < 5e-4, "{t} s: {y} m, {} m", free(t));
    }
    says("first_rope", "to 0.5 mm in the first 0.1 s");
    // Where it hangs still it is longer by rho g L^2/(2 E).
    let hanging = static_equilibria(&rope, &EquilibriumSettings::default()).unwrap();
    let last = |name: &str| *column(&hanging.history, name).last().unwrap();
    let still = -(1.0 + 1100.0 * G / (2.0 * 5e6));
    assert!(
        (last("tip.y") / still - 1.0).abs() < 1e-5,
        "{} m, {still} m",
        last("tip.y")
    );
    let weight = 1100.0 * std::f64::consts::PI * 25e-6 * G;
    assert!(
        (last("pull") / weight - 1.0).abs() < 1e-6,
        "{} N, {weight} N",
        last("pull")
    );
    says("first_rope", &format!("{:.5} m", -still));
    says("first_rope", &format!("{weight:.4} N"));
    let mut figure = Figure::default();
    let falls = (0..=45).map(|i| f64::from(i) * 0.01).map(|t| (t, free(t)));
    let lines = vec![line(history, "tip.y", 1.0, 0), Line::new(falls, 5).dashed()];
    figure.add("Height of the free end", &["rope"], chart("t [s]", "tip.y [m]", lines));
    figure.add(
        "Force of the hook",
        &[],
        chart("t [s]", "pull [N]", vec![line(history, "pull", 1.0, 0)]),
    );
    let drawing = Drawing::new(
        &shots,
        View::XY,
        vec![10, 20, 30, 40, 50],
        "The rope after 0, 0.1, 0.2, 0.3, 0.4 and 0.5 s",
    );
    shows(
        "first_rope",
        Some(&drawing),
        &figure,
        "A rope that swings down, the height of its end and the force of its hook",
    );
}
