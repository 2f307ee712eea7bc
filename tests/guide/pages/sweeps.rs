//! The motor over speed and eccentricity: the stress of its clamp.

use std::f64::consts::TAU;

use rncf::app::charts::Line;
use rncf::app::{Figure, RunSettings, run};
use rncf_models::Motor;

use crate::{chart, column, range, says, shows};

#[test]
fn the_stress_grows_with_speed_and_eccentricity() {
    let mut lines = Vec::new();
    let mut last = [0.0; 2];
    for (color, eccentricity) in [1e-3, 2e-3, 3e-3, 4e-3].into_iter().enumerate() {
        let points = (4..=12).map(|thousands| {
            let rpm = f64::from(thousands) * 1000.0;
            let motor = Motor {
                speed: rpm * TAU / 60.0,
                eccentricity,
                damping: 1e-3,
                T_s: 0.2,
                ..Motor::default()
            };
            let result = run(
                &motor,
                &RunSettings {
                    t_end: Some(0.3),
                    ..RunSettings::default()
                },
            )
            .unwrap();
            let stress = range(&column(&result.history, "clamp_stress"))[1];
            last = [stress, range(&column(&result.history, "v_mid"))[1]];
            (rpm, stress / 1e6)
        });
        lines.push(Line::new(points.collect::<Vec<_>>(), color));
    }
    // What is linear in the eccentricity is: four times of it, four times of the stress, to the torque's share.
    let [one, four] = [&lines[0], &lines[3]].map(|line| line.points[8].1);
    assert!((four / one / 4.0 - 1.0).abs() < 0.02, "{one} MPa, {four} MPa");
    says("sweeps", &format!("its clamp is stressed by {:.0} MPa", last[0] / 1e6));
    says("sweeps", &format!("bends by {:.2} mm", 1e3 * last[1]));
    let mut figure = Figure::default();
    let names = ["1 mm", "2 mm", "3 mm", "4 mm"];
    figure.add(
        "Largest stress in the clamp, eccentricity of",
        &names,
        chart("speed [rpm]", "clamp_stress [MPa]", lines),
    );
    shows(
        "sweeps",
        None,
        &figure,
        "The largest stress in the motor's clamp over its speed, for four eccentricities",
    );
}
