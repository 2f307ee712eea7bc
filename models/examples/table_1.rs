//! Table 1 of the paper: adaptive HHT, alpha = -0.3, rtol 1e-7, in both formulations at four speeds,
//! with and without the step ceiling of 0.01 s that the published counts imply (THEORY 10, T4).
//!
//! The error of v is the largest difference, up to t = 15 s, from a converged run of the same element
//! (Radau, RNCF); after that the oscillation at 40 and 100 rad/s has no phase to compare.
//!
//! `cargo run --release --example table_1`

use rncf::app::{RunResult, RunSettings, run};
use rncf::prelude::*;
use rncf_models::{SpinUp, SpinUpSpatial};

/// Spin (rad/s); elements of planar ANCF, spatial ANCF and RNCF; published steps and seconds of each.
const CASES: [(f64, [usize; 3], [&str; 3]); 4] = [
    (4.0, [4, 6, 6], ["4050, 2.15", "4050, 12.6", "2007, 6.0"]),
    (10.0, [8, 10, 10], ["9289, 19.1", "9294, 49.0", "2007, 9.4"]),
    (40.0, [16, 24, 24], ["35971, 314", "38675, 469", "2028, 24.2"]),
    (100.0, [48, 72, 72], ["96479, 4132", "89502, 3862", "2106, 91.0"]),
];

fn main() {
    for max_step in [0.01, f64::INFINITY] {
        println!("\nStep ceiling: {max_step} s\n");
        println!(
            "| rad/s | model | elements | steps | rejected | at ceiling | CPU s | error of v (m) | published steps, s | ANCF/RNCF steps |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|");
        for (omega_s, [planar, spatial, referenced], published) in CASES {
            let rncf = spatial_run(omega_s, referenced, Formulation::Rncf, max_step);
            let plane = planar_run(omega_s, planar, max_step);
            let space = spatial_run(omega_s, spatial, Formulation::Ancf, max_step);
            let cases = [
                ("ANCF planar", planar, plane),
                ("ANCF spatial", spatial, space),
                ("RNCF spatial", referenced, rncf),
            ];
            let steps = cases[2].2.0.statistics.steps as f64;
            for ((name, elements, (result, error)), published) in cases.into_iter().zip(published) {
                let statistics = &result.statistics;
                println!(
                    "| {omega_s} | {name} | {elements} | {} | {} | {:.0} % | {:.3} | {error:.1e} | {published} | {:.1} |",
                    statistics.steps,
                    statistics.rejected_steps,
                    100.0 * statistics.steps_at_ceiling as f64 / statistics.steps as f64,
                    result.seconds.cpu,
                    statistics.steps as f64 / steps,
                );
            }
        }
    }
}

fn spatial_run(omega_s: f64, elements: usize, formulation: Formulation, max_step: f64) -> (RunResult, f64) {
    compare(
        &SpinUpSpatial {
            omega_s,
            elements,
            ..SpinUpSpatial::default()
        },
        formulation,
        max_step,
    )
}

fn planar_run(omega_s: f64, elements: usize, max_step: f64) -> (RunResult, f64) {
    compare(
        &SpinUp {
            omega_s,
            elements,
            ..SpinUp::default()
        },
        Formulation::Ancf,
        max_step,
    )
}

/// The run of the table and its error of v.
fn compare<M: Model>(model: &M, formulation: Formulation, max_step: f64) -> (RunResult, f64) {
    let hht = Options {
        rtol: 1e-7,
        max_step,
        first_step: Some(1e-4),
        ..Options::default()
    };
    let converged = Options {
        rtol: 1e-9,
        ..Options::default()
    };
    let result = solve(model, formulation, Method::Hht { alpha: -0.3 }, hht);
    let reference = solve(model, Formulation::Rncf, Method::Radau, converged);
    let pairs = result.history.column(1).zip(reference.history.column(1));
    let error = pairs.take(301).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    (result, error)
}

fn solve<M: Model>(model: &M, formulation: Formulation, method: Method, options: Options) -> RunResult {
    let settings = RunSettings {
        formulation,
        method,
        options,
        ..RunSettings::default()
    };
    run(model, &settings).unwrap_or_else(|error| panic!("{error}"))
}
