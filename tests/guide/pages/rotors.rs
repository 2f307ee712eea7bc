//! A shaft with a disc: its response to the unbalance is that of Laval's rotor.

use std::f64::consts::{PI, TAU};

use rncf::app::charts::Line;
use rncf::app::{Figure, RunSettings, campbell, steady};
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::rotors::Rotor;

use crate::{chart, column, drawn, over, says, shows};

/// Speed at which Laval's rotor is critical, rad/s: disc and 17/35 of the shaft on the shaft and its bearings.
fn laval() -> f64 {
    let shaft = 48.0 * 210e9 * (PI / 4.0 * 0.01_f64.powi(4)) / 0.6_f64.powi(3);
    let bearings = 2.0 * 10e6;
    let mass = 5.0 + 17.0 / 35.0 * 7850.0 * PI * 1e-4 * 0.6;
    (1.0 / (1.0 / shaft + 1.0 / bearings) / mass).sqrt()
}

#[test]
fn the_rotor_is_critical_where_lavals_is() {
    let rotor = Rotor::default();
    let end = 5000.0 * TAU / 60.0;
    let crossings = campbell(&rotor, &over(&rotor, "speed", 0.0, end, 32)).unwrap();
    let rpm = |speed: f64| speed * 60.0 / TAU;
    let speed = crossings.critical[0].value * TAU / 60.0;
    assert!(
        (speed / laval() - 1.0).abs() < 0.005,
        "{} rpm, {} rpm",
        rpm(speed),
        rpm(laval())
    );
    says("rotors", &format!("critical speed at {:.0} rpm", rpm(speed)));
    says("rotors", &format!("in series {:.0} rpm", rpm(laval())));
    // From both ends towards the critical speed: a way across it may go on to ever larger deflections.
    let whirls = |from: f64, to: f64| -> Vec<(f64, f64)> {
        let found = steady(&rotor, &over(&rotor, "speed", from * TAU / 60.0, to * TAU / 60.0, 80)).unwrap();
        assert!(
            found.incomplete.is_none() && found.warnings.is_empty(),
            "{:?}",
            found.warnings
        );
        let whirl = column(&found.history, "whirl");
        found
            .history
            .keys
            .iter()
            .copied()
            .zip(whirl.into_iter().map(|um| 1e-6 * um))
            .collect()
    };
    let (below, above) = (whirls(0.0, 2300.0), whirls(5000.0, 2500.0));
    let response = |speed: f64| {
        let ratio = (speed / laval()).powi(2);
        // Of the shaft's own share of the mass the centre lies on the axis.
        let share = 5.0 / (5.0 + 17.0 / 35.0 * 7850.0 * PI * 1e-4 * 0.6);
        1e-4 * share * ratio / (1.0 - ratio).abs()
    };
    for &(key, value) in below.iter().chain(&above) {
        let speed = key * TAU / 60.0;
        if (speed / laval() - 1.0).abs() > 0.2 && speed > 20.0 {
            assert!(
                (value / response(speed) - 1.0).abs() < 0.03,
                "{key} rpm: {value} m, {} m",
                response(speed)
            );
        }
    }
    says("rotors", "to 3 % away from the critical speed");
    let mut figure = Figure::default();
    let bounded = |points: Vec<(f64, f64)>| points.into_iter().filter(|point| point.1 < 1000.0).collect::<Vec<_>>();
    let in_um = |points: &[(f64, f64)]| bounded(points.iter().map(|&(key, value)| (key, 1e6 * value)).collect());
    let laval_between = |from: i32, to: i32| {
        let speeds = (from..=to).map(|i| f64::from(i) * 20.0);
        Line::new(
            bounded(speeds.map(|n| (n, 1e6 * response(n * TAU / 60.0))).collect()),
            5,
        )
        .dashed()
    };
    let lines = vec![
        Line::new(in_um(&below), 0),
        Line::new(in_um(&above), 0),
        laval_between(1, 119),
        laval_between(120, 250),
    ];
    let mut drawn_ = chart("speed [rpm]", "whirl [um]", lines);
    drawn_.marks.push((rpm(speed), "critical".into()));
    figure.add("Deflection of the middle, and Laval's rotor", &["shaft"], drawn_);
    let (_, shots) = drawn(
        &rotor,
        RunSettings {
            t_end: Some(1e-3),
            ..RunSettings::default()
        },
    );
    let drawing = Drawing::new(
        &shots,
        View::CORNER,
        vec![0],
        "The shaft: its disc is in the middle, its bearings are at the ends",
    );
    shows(
        "rotors",
        Some(&drawing),
        &figure,
        "A shaft with a disc, and the deflection of its middle over its speed",
    );
}
