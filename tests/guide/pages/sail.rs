//! Tethers that spin: the tension of a mass on a wire, and its swing under a thrust.

use std::f64::consts::TAU;

use rncf::app::charts::Line;
use rncf::app::{Figure, RunSettings};
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::sail::Sail;

use crate::{chart, column, drawn, line, range, says, shows};

#[test]
fn the_tethers_swing_as_a_pendulum_does() {
    let sail = Sail::default();
    let (run, shots) = drawn(&sail, RunSettings::default());
    let history = &run.history;
    let (length, spin, tip) = (1000.0, 0.5_f64.to_radians(), 0.5);
    let wire = 2700.0 * 4.57e-9;
    let exact = tip * spin * spin * length + wire * spin * spin * length * length / 2.0;
    let [low, high] = range(&column(history, "tension"));
    assert!(
        (low / exact - 1.0).abs() < 3e-3 && (high / exact - 1.0).abs() < 3e-3,
        "{low} N, {high} N, {exact} N"
    );
    says("sail", &format!("{exact:.5} N"));
    // Out of the plane of the spin a tether is a pendulum of the same frequency in the field of the centrifugal force. The core and
    // the thrust on all tethers move along the axis together, so that only what differs from the motion of the whole counts.
    let (moment, inertia) = (
        5e-8 * length * length / 2.0,
        tip * length * length + wire * length.powi(3) / 3.0,
    );
    let static_moment = tip * length + wire * length * length / 2.0;
    let pushed = 4.0 * 5e-8 * length;
    let whole = 20.0 + 4.0 * (tip + wire * length);
    // M z + 4 S phi = F, I phi + S z + I w^2 phi = Q, with rates twice.
    let inertia_ = inertia - 4.0 * static_moment * static_moment / whole;
    let (rate, load) = (
        spin * (inertia / inertia_).sqrt(),
        moment - static_moment * pushed / whole,
    );
    let swing = |t: f64| load / (inertia * spin * spin) * (1.0 - (rate * t).cos()) * length;
    let coning = column(history, "coning");
    let most = range(&(0..=600).map(|t| swing(f64::from(t))).collect::<Vec<_>>())[1];
    for (&t, &z) in history.keys.iter().zip(&coning) {
        assert!((z - swing(t)).abs() < 0.05 * most, "{t} s: {z} m, {} m", swing(t));
    }
    says("sail", &format!("by up to {:.2} m and back", range(&coning)[1]));
    says("sail", &format!("within 5 % of {most:.2} m"));
    says("sail", &format!("{:.0} s", TAU / rate));
    let mut figure = Figure::default();
    let pendulum = Line::new((0..=120).map(|i| f64::from(i) * 5.0).map(|t| (t, swing(t))), 5).dashed();
    figure.add(
        "How far the tips are out of the plane, and a pendulum",
        &["tethers"],
        chart("t [s]", "coning [m]", vec![line(history, "coning", 1.0, 0), pendulum]),
    );
    let drawing = Drawing {
        silent: vec!["sail".into()],
        ..Drawing::new(
            &shots,
            View::CORNER,
            vec![shots.count() * 4 / 5],
            "The sail at the start (grey), and after it has turned",
        )
    };
    shows(
        "sail",
        Some(&drawing),
        &figure,
        "A sail of four tethers, and how far their tips swing out of the plane",
    );
}
