//! Table 4 of the paper: steps of the flexible slider-crank at five speeds, with and without damping, in both formulations;
//! adaptive HHT, alpha = -0.3, rtol 1e-7 as in Table 1 (the paper names no tolerance here), and Radau at the same rtol.
//!
//! The error of dx is the largest difference at the rows of the history from a converged run (Radau, ANCF, rtol 1e-9).
//!
//! `cargo run --release --example table_4`

use rncf::app::{RunResult, RunSettings, run};
use rncf::prelude::*;
use rncf_models::SliderCrank;

/// Steps at five speeds, with c = 0 and c > 0.
type Steps = [[u32; 5]; 2];

/// Published steps at 4, 8, 12, 14, 16 rad/s (their five speeds are not named) with c = 0 and c > 0: elements, ANCF, RNCF.
const PUBLISHED: [(usize, Steps, Steps); 2] = [
    (
        10,
        [[21727, 32803, 39180, 42639, 65381], [10603, 21775, 25866, 31498, 39466]],
        [[10127, 17105, 17902, 23676, 31009], [3679, 9810, 13285, 15919, 21006]],
    ),
    (
        20,
        [[22243, 32297, 40070, 44233, 61476], [10448, 21696, 23323, 29991, 37978]],
        [[10264, 17727, 21047, 28952, 35051], [3595, 9646, 12797, 15089, 20261]],
    ),
];
const SPEEDS: [f64; 5] = [4.0, 8.0, 12.0, 14.0, 16.0];
const DAMPING: [f64; 2] = [0.0, 1e-4];

fn main() {
    println!(
        "| method | elements | c (s) | rad/s | ANCF steps (factorizations) | RNCF steps (factorizations) | ANCF/RNCF | published | errors of dx, ANCF, RNCF (m) | CPU s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for (name, method) in [("HHT -0.3", Method::Hht { alpha: -0.3 }), ("Radau", Method::Radau)] {
        for (elements, ancf, rncf) in PUBLISHED {
            for (row, damping) in DAMPING.into_iter().enumerate() {
                for (column, omega_s) in SPEEDS.into_iter().enumerate() {
                    let model = SliderCrank {
                        omega_s,
                        damping,
                        elements,
                        ..SliderCrank::default()
                    };
                    let published = f64::from(ancf[row][column]) / f64::from(rncf[row][column]);
                    let runs = compare(&model, method);
                    print_row(name, &model, &runs, published);
                }
            }
        }
    }
}

/// Runs in ANCF and RNCF with their errors of dx.
fn compare(model: &SliderCrank, method: Method) -> [(RunResult, f64); 2] {
    let converged = solve(model, Formulation::Ancf, Method::Radau, 1e-9);
    [Formulation::Ancf, Formulation::Rncf].map(|formulation| {
        let result = solve(model, formulation, method, 1e-7);
        let pairs = result.history.column(1).zip(converged.history.column(1));
        let error = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        (result, error)
    })
}

fn print_row(name: &str, model: &SliderCrank, [(ancf, error), (rncf, other)]: &[(RunResult, f64); 2], published: f64) {
    let counts = |result: &RunResult| format!("{} ({})", result.statistics.steps, result.statistics.factorizations);
    println!(
        "| {name} | {} | {:e} | {} | {} | {} | {:.2} | {published:.2} | {error:.1e}, {other:.1e} | {:.2}, {:.2} |",
        model.elements,
        model.damping,
        model.omega_s,
        counts(ancf),
        counts(rncf),
        ancf.statistics.steps as f64 / rncf.statistics.steps as f64,
        ancf.seconds.cpu,
        rncf.seconds.cpu,
    );
}

fn solve(model: &SliderCrank, formulation: Formulation, method: Method, rtol: f64) -> RunResult {
    let settings = RunSettings {
        formulation,
        method,
        options: Options {
            rtol,
            ..Options::default()
        },
        ..RunSettings::default()
    };
    run(model, &settings).unwrap_or_else(|error| panic!("{error}"))
}
