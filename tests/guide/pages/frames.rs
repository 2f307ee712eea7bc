//! An arm on a hub that is spun up: about its deflection under the even acceleration it swings.

use rncf::Formulation;
use rncf::app::charts::Line;
use rncf::app::{Figure, RunSettings, run as run_};
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::flight::Example as Flight;
use rncf_guide::frames::Arm;

use crate::{chart, column, drawn, line, says, shows};

/// Bending stiffness, N m^2, and mass per length, kg/m.
const EI: f64 = 210e9 * 491e-12;
const MU: f64 = 7850.0 * 78.5e-6;

#[test]
fn the_arm_swings_about_its_deflection() {
    let (run, shots) = drawn(&Arm::default(), RunSettings::default());
    let history = &run.history;
    let deflection = column(history, "deflection");
    // A cantilever under the load mu alpha x: 11 mu alpha L^5/(120 EI).
    let bent = -11.0 * MU * 10.0 / (120.0 * EI);
    // Seven periods of 7.2 Hz, nearly: the mean of the swing is the deflection without it.
    let during: Vec<f64> = history
        .keys
        .iter()
        .zip(&deflection)
        .filter(|(t, _)| **t < 0.97)
        .map(|(_, &v)| v)
        .collect();
    let mean = during.iter().sum::<f64>() / during.len() as f64;
    assert!((mean / bent - 1.0).abs() < 0.03, "{mean} m, {bent} m");
    says("frames", &format!("{:.2} mm", 1e3 * bent));
    says("frames", &format!("mean of the arm until then is {:.2} mm", 1e3 * mean));
    says(
        "frames",
        &format!("deflection of {:.2} mm", 1e3 * deflection[deflection.len() - 1]),
    );
    let absolute = RunSettings {
        formulation: Formulation::Ancf,
        ..RunSettings::default()
    };
    let other = run_(&Arm::default(), &absolute).unwrap();
    let [one, two] = [&run.statistics, &other.statistics];
    assert_eq!(one.steps, 513);
    says("frames", "takes 513 steps for it");
    assert!(
        two.steps.abs_diff(1000) < 30 && two.factorizations > 5 * one.factorizations,
        "{two:?}"
    );
    let mut figure = Figure::default();
    let still = Line::new([(0.0, 1e3 * bent), (1.0, 1e3 * bent), (1.0, 0.0), (2.0, 0.0)], 5).dashed();
    let lines = vec![line(history, "deflection", 1e-3, 0), still];
    figure.add(
        "Deflection of the tip, seen in the hub",
        &["arm"],
        chart("t [s]", "deflection [mm]", lines),
    );
    let drawing = Drawing {
        magnified: 20.0,
        ..Drawing::new(
            &shots,
            View::XY,
            vec![20, 40, 60, 80],
            "The arm after 0, 0.2, 0.4, 0.6 and 0.8 s, its deflection 20 times as large",
        )
    };
    shows(
        "frames",
        Some(&drawing),
        &figure,
        "An arm on a hub that is spun up, and the deflection of its tip",
    );
}

/// What flies keeps its spin, and the weight acts on its centre of mass alone.
#[test]
fn a_rod_flies_as_a_body_does() {
    let (run, _) = drawn(&Flight::default(), RunSettings::default());
    let spins = column(&run.history, "spin");
    // The chord trembles about the mean spin; the rod is nearly rigid.
    let mean = spins.iter().sum::<f64>() / spins.len() as f64;
    assert!((mean - 10.0).abs() < 0.05, "{mean} rad/s");
}
