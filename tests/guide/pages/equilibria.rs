//! A column that buckles: Euler's load, the elastica beyond it, and the frequency that falls to zero.

use std::f64::consts::PI;

use rncf::app::charts::Line;
use rncf::app::{EquilibriumSettings, Figure, modes, static_equilibria};
use rncf_guide::drawing::{Drawing, View};
use rncf_guide::equilibria::Column;
use rncf_guide::leaning::Example as Leaning;

use crate::{at_rest, chart, column, integral, over, says, shows};

/// Bending stiffness, N m^2.
const EI: f64 = 210e9 * 208e-12;

/// Euler's load of a column of 1 m with a free end.
fn euler() -> f64 {
    PI * PI * EI / 4.0
}

/// The elastica: load and how far the top leans, for an angle of the top.
fn elastica(angle: f64) -> [f64; 2] {
    let k = (angle / 2.0).sin();
    let quarter = integral(0.0, PI / 2.0, |phi| 1.0 / (1.0 - (k * phi.sin()).powi(2)).sqrt());
    [EI * quarter * quarter, 2.0 * k / quarter]
}

/// How far the top leans under a load.
fn leans(load: f64) -> f64 {
    let (mut low, mut high) = (1e-6, 3.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if elastica(middle)[0] < load {
            low = middle
        } else {
            high = middle
        }
    }
    elastica(low)[1]
}

#[test]
fn the_column_buckles_at_eulers_load() {
    let straight = Column::default();
    let found = static_equilibria(&straight, &over(&straight, "load", 0.0, 200.0, 32)).unwrap();
    let critical = found.critical[0].value;
    assert!((critical / euler() - 1.0).abs() < 2e-5, "{critical} N, {} N", euler());
    says("equilibria", &format!("buckles, {critical:.3} N"));
    says("equilibria", &format!("it gives {:.3} N", euler()));
    let leaning = Leaning::default();
    let found = static_equilibria(&leaning, &over(&leaning, "load", 0.0, 200.0, 100)).unwrap();
    let lean = column(&found.history, "lean");
    let [last, exact] = [lean[lean.len() - 1], leans(200.0)];
    assert!((last / exact - 1.0).abs() < 2e-3, "{last} m, {exact} m");
    says("equilibria", &format!("leans by {last:.3} m"));
    says("equilibria", &format!("the elastica without it by {exact:.3} m"));
    let mut figure = Figure::default();
    let angles = (0..=130)
        .map(|i| f64::from(i) * 0.015 + 1e-4)
        .map(elastica)
        .filter(|at| at[0] <= 200.0);
    let branch = Line::new(
        [(0.0, 0.0)].into_iter().chain(angles.map(|[load, lean]| (load, lean))),
        5,
    )
    .dashed();
    let ours = Line::new(found.history.keys.iter().copied().zip(lean.iter().copied()), 0);
    figure.add(
        "How far the top leans, and the elastica of a perfect column",
        &["with the breeze"],
        chart("load [N]", "lean [m]", vec![ours, branch]),
    );
    let shots = at_rest(&Leaning { load: 200.0, ..leaning });
    let drawing = Drawing {
        arrow: 0.25,
        ..Drawing::new(
            &shots,
            View::XY,
            vec![shots.count() - 1],
            "The column without load (grey), and under 200 N and the breeze",
        )
    };
    shows(
        "equilibria",
        Some(&drawing),
        &figure,
        "A column that buckles, and how far its top leans over the load",
    );
}

#[test]
fn its_frequency_falls() {
    let first = |load: f64| {
        modes(
            &Column {
                load,
                ..Column::default()
            },
            &EquilibriumSettings::default(),
        )
        .unwrap()
        .modes[0]
            .im
            / (2.0 * PI)
    };
    let mu = 7850.0 * 100e-6;
    let exact = 1.875_104_068_711_961_f64.powi(2) * (EI / mu).sqrt() / (2.0 * PI);
    assert!((first(0.0) / exact - 1.0).abs() < 2e-3, "{} Hz, {exact} Hz", first(0.0));
    says("equilibria", &format!("{:.3} Hz to {:.3} Hz", first(0.0), first(100.0)));
    // Nearly a straight line of the squares that ends at Euler's load.
    let guess = first(0.0) * (1.0 - 100.0 / euler()).sqrt();
    assert!(
        (first(100.0) / guess - 1.0).abs() < 0.05,
        "{} Hz, {guess} Hz",
        first(100.0)
    );
}
