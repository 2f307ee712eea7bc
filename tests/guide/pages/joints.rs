//! A crank, a rod and a slider: the stroke in closed form, and the moment of the motor from the energy.

use rncf::Options;
use rncf::app::charts::Line;
use rncf::app::{Figure, RunSettings};
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::flexible::Example as Flexible;
use rncf_guide::joints::Crank;

use crate::{chart, column, drawn, line, range, says, shows};

/// Angle and speed of the crank, and the place of the slider.
fn crank(t: f64) -> [f64; 3] {
    let speed = std::f64::consts::TAU;
    let [angle, turns] = if t < 1.0 {
        [speed * t * t / 2.0, speed * t]
    } else {
        [speed * (t - 0.5), speed]
    };
    let slider = 0.2 * angle.cos() + (0.36 - (0.2 * angle.sin()).powi(2)).sqrt();
    [angle, turns, slider]
}

/// Kinetic energy of the three bodies, J, with velocities from central differences.
fn energy(t: f64) -> f64 {
    let h = 1e-5;
    let places = |t: f64| {
        let [angle, _, slider] = crank(t);
        let tilt = -(0.2 * angle.sin() / 0.6).asin();
        let pin = [0.2 * angle.cos(), 0.2 * angle.sin()];
        [
            angle,
            tilt,
            pin[0] + 0.3 * tilt.cos(),
            pin[1] + 0.3 * tilt.sin(),
            slider,
        ]
    };
    let (low, high) = (places(t - h), places(t + h));
    let rate: Vec<f64> = low
        .iter()
        .zip(&high)
        .map(|(low, high)| (high - low) / (2.0 * h))
        .collect();
    let squares = (0.01 + 1.0 * 0.01) * rate[0].powi(2)
        + 0.06 * rate[1].powi(2)
        + 2.0 * (rate[2].powi(2) + rate[3].powi(2))
        + 3.0 * rate[4].powi(2);
    squares / 2.0
}

#[test]
fn the_slider_goes_as_the_formula_says() {
    let settings = RunSettings {
        options: Options {
            rtol: 1e-9,
            ..Options::default()
        },
        ..RunSettings::default()
    };
    let (run, shots) = drawn(&Crank::default(), settings);
    let history = &run.history;
    for (&t, x) in history.keys.iter().zip(column(history, "stroke")) {
        assert!((x - crank(t)[2]).abs() < 1e-6, "{t} s: {x} m, {} m", crank(t)[2]);
    }
    // The power of the motor is the rate of the energy. The speed has a kink after a second.
    let torque = column(history, "torque");
    let h = 2e-4;
    let power = |t: f64| (energy(t + h) - energy(t - h)) / (2.0 * h) / crank(t)[1];
    for (&t, &moment) in history
        .keys
        .iter()
        .zip(&torque)
        .filter(|(t, _)| **t > 0.05 && (**t - 1.0).abs() > 0.01)
    {
        assert!(
            (moment - power(t)).abs() < 5e-4,
            "{t} s: {moment} N m, {} N m",
            power(t)
        );
    }
    says("joints", "to 1e-6 m");
    let [low, high] = range(&torque);
    says("joints", &format!("a torque of at most {:.1} N m", high.max(-low)));
    says(
        "joints",
        &format!("a force of at most {:.1} N", range(&column(history, "pin_force"))[1]),
    );
    let mut figure = Figure::default();
    let of = |of: &dyn Fn(f64) -> f64, from: u32| -> Vec<(f64, f64)> {
        (from..=300)
            .map(|i| f64::from(i) * 0.01)
            .filter(|t| (t - 1.0).abs() > 0.011 || from == 0)
            .map(|t| (t, of(t)))
            .collect()
    };
    let strokes = vec![
        line(history, "stroke", 1.0, 0),
        Line::new(of(&|t| crank(t)[2], 0), 5).dashed(),
    ];
    figure.add("Place of the slider", &["rncf"], chart("t [s]", "stroke [m]", strokes));
    let moments = vec![line(history, "torque", 1.0, 0), Line::new(of(&power, 5), 5).dashed()];
    figure.add(
        "Torque of the motor",
        &["rncf"],
        chart("t [s]", "torque [N m]", moments),
    );
    let drawing = Drawing {
        silent: vec!["motor".into()],
        ..Drawing::new(&shots, View::XY, vec![120], "At the start (grey), and after 0.6 s")
    };
    shows(
        "joints",
        Some(&drawing),
        &figure,
        "A crank, a rod and a slider, with the place of the slider and the torque of the motor",
    );
}

#[test]
fn the_rod_bends() {
    let (run, _) = drawn(&Flexible::default(), RunSettings::default());
    let [low, high] = range(&column(&run.history, "bending"));
    says("joints", &format!("bends by up to {:.2} mm", 1e3 * high.max(-low)));
    for (&t, x) in run.history.keys.iter().zip(column(&run.history, "stroke")) {
        assert!((x - crank(t)[2]).abs() < 2e-5, "{t} s: {x} m");
    }
}
