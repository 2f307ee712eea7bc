//! The flexible slider-crank against THEORY 9.4: independent runs of the same element in the inertial frame, without
//! multipliers.

use rncf::{Formulation, Joints, Method};
use rncf_models::SliderCrank;

use crate::runs::{adaptive, apart, grid, history};

/// A speed (rad/s) with the figures of its rows in the table: largest |dx| (mm), its time (s), rms of dx (mm), largest mid (mm);
/// 16 elements, sampled every 0.01 s up to 2.5 s.
struct Rows {
    speed: f64,
    /// Undamped, steps of 0.5 ms and 0.25 ms.
    undamped: [[f64; 4]; 2],
    /// c = 0.1 ms, steps of 0.5 ms.
    damped: [f64; 4],
}

const TABLE: [Rows; 5] = [
    Rows {
        speed: 4.0,
        undamped: [[0.04225, 1.29, 0.01027, 0.3100], [0.04225, 1.29, 0.01027, 0.3100]],
        damped: [0.04226, 1.29, 0.01027, 0.3100],
    },
    Rows {
        speed: 8.0,
        undamped: [[0.21238, 0.90, 0.05858, 1.4922], [0.21237, 0.90, 0.05858, 1.4921]],
        damped: [0.21239, 0.90, 0.05857, 1.4920],
    },
    Rows {
        speed: 12.0,
        undamped: [[0.89205, 2.36, 0.22902, 5.8895], [0.89579, 2.36, 0.22929, 5.8938]],
        damped: [0.89194, 2.36, 0.22898, 5.8883],
    },
    Rows {
        speed: 14.0,
        undamped: [[3.89127, 2.08, 0.81726, 13.6979], [3.88043, 2.08, 0.81727, 13.7089]],
        damped: [3.88147, 2.08, 0.81649, 13.6905],
    },
    Rows {
        speed: 16.0,
        undamped: [[23.67924, 1.92, 5.51457, 38.2609], [23.65195, 1.92, 5.52999, 37.9730]],
        damped: [23.57148, 1.92, 5.49234, 38.1622],
    },
];

impl Rows {
    /// The figures without the step's error: it falls with the square of the step in the undamped rows, and the damped row has
    /// the same, for its frequencies differ by 1e-5 only.
    fn converged(&self, damping: f64) -> [f64; 4] {
        let [coarse, fine] = self.undamped;
        std::array::from_fn(|i| {
            let undamped = fine[i] + (fine[i] - coarse[i]) / 3.0;
            if damping == 0.0 {
                undamped
            } else {
                self.damped[i] + undamped - coarse[i]
            }
        })
    }
}

fn model(speed: f64, damping: f64) -> SliderCrank {
    SliderCrank {
        omega_s: speed,
        damping,
        elements: 16,
        ..SliderCrank::default()
    }
}

/// Largest |dx|, its time, rms of dx, largest mid; mm and s.
fn figures(rows: &[Vec<f64>], times: &[f64]) -> [f64; 4] {
    let dx: Vec<f64> = rows.iter().map(|row| 1e3 * row[1]).collect();
    let largest = (0..dx.len())
        .max_by(|&i, &j| dx[i].abs().total_cmp(&dx[j].abs()))
        .unwrap();
    let rms = (dx.iter().map(|dx| dx * dx).sum::<f64>() / dx.len() as f64).sqrt();
    let mid = rows.iter().map(|row| 1e3 * row[2]).fold(0.0, f64::max);
    [dx[largest].abs(), times[largest], rms, mid]
}

/// Relative tolerance of the comparison; at 14 and 16 rad/s the rod is near snapping through, and rows of 0.01 s miss the peaks.
fn tolerance(speed: f64) -> f64 {
    match speed {
        4.0 | 8.0 => 1e-4,
        12.0 => 5e-4,
        14.0 => 2e-3,
        _ => 8e-3,
    }
}

fn check(formulation: Formulation) {
    let times = grid(0.01, 2.5);
    for rows in &TABLE {
        for damping in [0.0, 1e-4] {
            let speed = rows.speed;
            let way = (formulation, Joints::Eliminated);
            let (history, statistics) = history(&model(speed, damping), way, Method::Radau, adaptive(1e-7), &times);
            let found = figures(&history, &times);
            let expected = rows.converged(damping);
            let run = format!("{} at {speed} rad/s, c = {damping:e} s", formulation.name());
            println!("{run}: {found:.5?} for {expected:.5?}, {} steps", statistics.steps);
            for (what, (found, expected)) in found.into_iter().zip(expected).enumerate() {
                let name = ["largest |dx|", "its time", "rms of dx", "largest mid"][what];
                assert!(
                    (found - expected).abs() <= tolerance(speed) * expected + 8e-5,
                    "{run}: {name} is {found} instead of {expected}"
                );
            }
        }
    }
}

#[test]
fn table_in_referenced_coordinates() {
    check(Formulation::Rncf);
}

#[test]
fn table_in_absolute_coordinates() {
    check(Formulation::Ancf);
}

#[test]
fn both_formulations_are_one_model() {
    let times = grid(0.05, 2.5);
    let run = |formulation| {
        let way = (formulation, Joints::Eliminated);
        history(&model(8.0, 0.0), way, Method::Radau, adaptive(1e-9), &times).0
    };
    let apart = apart(&run(Formulation::Rncf), &run(Formulation::Ancf));
    assert!(apart < 2e-8, "{apart:e} m apart");
}
