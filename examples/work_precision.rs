//! Work and precision of the three integrators on the spin-up at 4 rad/s with 16 elements, 0 to 20 s,
//! against a converged run of the same element (Radau, rtol 1e-11).
//!
//! `cargo run --release --example work_precision`

use rncf::app::{RunResult, RunSettings, run};
use rncf::prelude::*;
use rncf_models::SpinUp;

fn main() {
    let model = SpinUp {
        elements: 16,
        ..SpinUp::default()
    };
    let reference = solve(&model, Formulation::Rncf, Method::Radau, 1e-11);
    println!("| integrator | rtol | steps | rejected | Newton | factorizations | max error of v (m) | ms |");
    println!("|---|---|---|---|---|---|---|---|");
    let methods = [
        ("Radau", Method::Radau),
        ("HHT -0.05", Method::Hht { alpha: -0.05 }),
        ("HHT -0.3", Method::Hht { alpha: -0.3 }),
        ("gen.-alpha 0.8", Method::GeneralizedAlpha { rho_inf: 0.8 }),
    ];
    for (name, method) in methods {
        for exponent in 4..=10 {
            let rtol = 10f64.powi(-exponent);
            let result = solve(&model, Formulation::Rncf, method, rtol);
            let statistics = &result.statistics;
            println!(
                "| {name} | {rtol:.0e} | {} | {} | {} | {} | {:.1e} | {:.1} |",
                statistics.steps,
                statistics.rejected_steps,
                statistics.newton_iterations,
                statistics.factorizations,
                error(&result, &reference),
                1e3 * result.seconds.cpu,
            );
        }
    }
}

fn solve(model: &SpinUp, formulation: Formulation, method: Method, rtol: f64) -> RunResult {
    let options = Options {
        rtol,
        ..Options::default()
    };
    let settings = RunSettings {
        formulation,
        method,
        options,
        ..RunSettings::default()
    };
    run(model, &settings).unwrap_or_else(|error| panic!("{error}"))
}

/// Largest difference of v on the grid of the history.
fn error(result: &RunResult, reference: &RunResult) -> f64 {
    let of = |result: &RunResult| result.history.column(1).collect::<Vec<f64>>();
    of(result)
        .iter()
        .zip(of(reference))
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}
