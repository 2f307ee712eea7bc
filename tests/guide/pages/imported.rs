//! An arm of finite elements on a motor: the frequencies of a cantilever, and its deflection under the force.

use rncf::app::charts::Line;
use rncf::app::{EquilibriumSettings, Figure, RunSettings, modes};
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::imported::Arm;

use crate::{chart, column, drawn, line, says, shows};

/// Of `finite_elements.py`: a beam of 2 m, 40 mm wide, 20 mm thick.
const LENGTH: f64 = 2.0;
const YOUNG: f64 = 70e9;
const MU: f64 = 2700.0 * 0.04 * 0.02;

#[test]
fn the_arm_is_the_beam_that_it_was() {
    let arm = Arm::default();
    let still = Arm {
        speed: 0.0,
        pull: 0.0,
        ..arm.clone()
    };
    let seen = modes(&still, &EquilibriumSettings::default()).unwrap();
    let thin = 0.04 * 0.02_f64.powi(3) / 12.0;
    let wide = 0.02 * 0.04_f64.powi(3) / 12.0;
    let root: f64 = 1.875_104_068_711_961;
    for (mode, second_moment) in seen.modes.iter().zip([thin, wide]) {
        let exact = (root / LENGTH).powi(2) * (YOUNG * second_moment / MU).sqrt();
        assert!((mode.im / exact - 1.0).abs() < 1e-3, "{} rad/s, {exact} rad/s", mode.im);
        says("imported", &format!("{:.2} rad/s", mode.im));
        says("imported", &format!("{exact:.2}"));
    }
    let (run, shots) = drawn(&arm, RunSettings::default());
    let history = &run.history;
    // The force bends it, and while the motor gathers speed its own mass does: 11 mu alpha L^5/(120 EI).
    let by_force = 3.0 * LENGTH.powi(3) / (3.0 * YOUNG * wide);
    let speed = 10.0 * std::f64::consts::TAU / 60.0;
    let by_mass = -11.0 * MU * (speed / 2.0) * LENGTH.powi(5) / (120.0 * YOUNG * wide);
    let bent = column(history, "bent");
    let mean = |from: f64, to: f64| {
        let within = history.keys.iter().zip(&bent).filter(|(t, _)| (from..to).contains(*t));
        let values: Vec<f64> = within.map(|(_, &value)| value).collect();
        values.iter().sum::<f64>() / values.len() as f64
    };
    let (early, late) = (mean(0.0, 2.0), mean(2.0, 5.0));
    assert!(
        (early / (by_force + by_mass) - 1.0).abs() < 0.03,
        "{early} m, {} m",
        by_force + by_mass
    );
    assert!((late / by_force - 1.0).abs() < 0.03, "{late} m, {by_force} m");
    says("imported", &format!("{:.3} mm", 1e3 * (by_force + by_mass)));
    says("imported", &format!("{:.3} mm", 1e3 * by_force));
    says("imported", &format!("{:.3} mm and {:.3} mm", 1e3 * early, 1e3 * late));
    let mut figure = Figure::default();
    let [while_, then] = [1e3 * (by_force + by_mass), 1e3 * by_force];
    let steps = Line::new([(0.0, while_), (2.0, while_), (2.0, then), (5.0, then)], 5).dashed();
    let lines = vec![line(history, "bent", 1e-3, 0), steps];
    figure.add(
        "Deflection of the tip, and what it swings about",
        &["arm"],
        chart("t [s]", "bent [mm]", lines),
    );
    let drawing = Drawing {
        magnified: 40.0,
        arrow: 0.4,
        silent: vec!["push".into()],
        ..Drawing::new(
            &shots,
            View::XY,
            vec![50, 100, 150],
            "The arm after 0, 0.5, 1 and 1.5 s, its deflection 40 times as large",
        )
    };
    shows(
        "imported",
        Some(&drawing),
        &figure,
        "An arm of finite elements on a motor, and the deflection of its tip",
    );
}

/// What the interfaces' modes say of a force at the tip in free flight is told on the page by its formula.
#[test]
fn the_craft_keeps_its_spin() {
    let (run, _) = drawn(&rncf_guide::craft::Example::default(), RunSettings::default());
    assert!(
        column(&run.history, "bent").iter().all(|value| value.abs() < 0.1),
        "{:?}",
        run.warnings
    );
}
