//! Table 2 of the paper: the motor at six speeds in both formulations with rtol 1e-7: adaptive HHT, alpha = -0.3 (its
//! text), generalized-alpha (its caption) with and without the step ceiling of 0.01 s that the published counts imply
//! (THEORY 9.3), and Radau.
//!
//! The error of v_mid is the largest difference at the rows of the history from a converged run (Radau, RNCF, rtol 1e-10)
//! of the same elements. A run that takes more than the limit of seconds is stopped; its row says where.
//!
//! `cargo run --release --example table_2`, or with the limit of a run: `-- 60`

use std::ops::ControlFlow;
use std::time::Instant;

use rncf::app::{Incomplete, RunError, RunResult, RunSettings, run_watched};
use rncf::prelude::*;
use rncf_models::Motor;

/// Speed (rpm), elements; published steps and seconds of ANCF and of RNCF.
const CASES: [(f64, usize, [f64; 2], [f64; 2]); 6] = [
    (7500.0, 4, [84377.0, 174.0], [127.0, 0.50]),
    (10000.0, 8, [112710.0, 398.0], [131.0, 0.79]),
    (12500.0, 12, [187668.0, 1057.0], [145.0, 1.68]),
    (15000.0, 16, [213713.0, 1809.0], [1036.0, 41.0]),
    (17500.0, 24, [222129.0, 4660.0], [1655.0, 105.0]),
    (20000.0, 32, [253934.0, 6460.5], [3246.0, 309.0]),
];

/// Method, its step ceiling (s).
const METHODS: [(&str, Method, f64); 5] = [
    ("HHT −0.3", Method::Hht { alpha: -0.3 }, 0.01),
    ("generalized-α 0.8", Method::GeneralizedAlpha { rho_inf: 0.8 }, 0.01),
    ("HHT −0.3", Method::Hht { alpha: -0.3 }, f64::INFINITY),
    (
        "generalized-α 0.8",
        Method::GeneralizedAlpha { rho_inf: 0.8 },
        f64::INFINITY,
    ),
    ("Radau", Method::Radau, f64::INFINITY),
];

/// Seconds after which a run is stopped.
const LIMIT: f64 = 300.0;

fn main() {
    let limit = std::env::args().nth(1).map_or(LIMIT, |text| {
        text.parse()
            .unwrap_or_else(|_| panic!("the limit of a run is a number of seconds, not `{text}`"))
    });
    for published_elements in [false, true] {
        let elements = if published_elements { "as published" } else { "4" };
        println!("\nElements: {elements}\n");
        println!(
            "| method | ceiling (s) | rpm | elements | ANCF steps (rejected) | RNCF steps (rejected) | at ceiling | CPU s | errors of v_mid (m) | ANCF/RNCF steps, s | published |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|---|");
        for (rpm, elements, ancf, rncf) in CASES {
            let model = Motor {
                speed: rpm * std::f64::consts::PI / 30.0,
                elements: if published_elements { elements } else { 4 },
                ..Motor::default()
            };
            let converged = solve(
                &model,
                Formulation::Rncf,
                Method::Radau,
                1e-10,
                f64::INFINITY,
                f64::INFINITY,
            );
            for (name, method, ceiling) in METHODS {
                let runs = [Formulation::Ancf, Formulation::Rncf]
                    .map(|formulation| solve(&model, formulation, method, 1e-7, ceiling, limit));
                let published = [ancf[0] / rncf[0], ancf[1] / rncf[1]];
                print_row(
                    &format!("{name} | {}", ceiling_text(ceiling)),
                    rpm,
                    &model,
                    &runs,
                    &converged,
                    published,
                );
            }
        }
    }
}

fn ceiling_text(ceiling: f64) -> String {
    if ceiling.is_finite() {
        ceiling.to_string()
    } else {
        "none".to_string()
    }
}

/// Prints the runs in ANCF and RNCF; `published` are the ratios of steps and seconds.
fn print_row(method: &str, rpm: f64, model: &Motor, runs: &[RunResult; 2], converged: &RunResult, published: [f64; 2]) {
    let [ancf, rncf] = runs.each_ref().map(|result| {
        let stopped = match result.incomplete {
            None => String::new(),
            Some(_) => format!(", stopped at {:.2} s", result.state.t),
        };
        let statistics = &result.statistics;
        format!("{} ({}){stopped}", statistics.steps, statistics.rejected_steps)
    });
    let [error, other] = runs.each_ref().map(|result| {
        let pairs = result.history.column(0).zip(converged.history.column(0));
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    });
    let statistics = &runs[1].statistics;
    println!(
        "| {method} | {rpm} | {} | {ancf} | {rncf} | {:.0} % | {:.3}, {:.4} | {error:.1e}, {other:.1e} | {:.1}, {:.1} | {:.0}, {:.0} |",
        model.elements,
        100.0 * statistics.steps_at_ceiling as f64 / statistics.steps as f64,
        runs[0].seconds.cpu,
        runs[1].seconds.cpu,
        runs[0].statistics.steps as f64 / statistics.steps as f64,
        runs[0].seconds.cpu / runs[1].seconds.cpu,
        published[0],
        published[1],
    );
}

/// Runs a model; a run that takes longer than `limit` (s) ends early.
fn solve(model: &Motor, formulation: Formulation, method: Method, rtol: f64, max_step: f64, limit: f64) -> RunResult {
    let settings = RunSettings {
        formulation,
        method,
        options: Options {
            rtol,
            max_step,
            ..Options::default()
        },
        ..RunSettings::default()
    };
    let clock = Instant::now();
    let result = run_watched(model, &settings, |_| {
        if clock.elapsed().as_secs_f64() > limit {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    match result {
        Ok(result) => result,
        Err(RunError::Incomplete(result)) if result.incomplete == Some(Incomplete::Interrupted) => *result,
        Err(error) => panic!("{error}"),
    }
}
