//! The spin-up manoeuvre against the numbers and records of THEORY 9.1, and the formulations against each other.

use rncf::{Method, Model};
use rncf_models::{SpinUp, SpinUpSpatial};
use rncf_tests::table::{EXTREMES, Extreme, Record};

use crate::models::SpinUpExact;
use crate::runs::{WAYS, adaptive, apart, fixed, grid, history, short};

/// The method of the table and of the records.
const PUBLISHED: Method = Method::GeneralizedAlpha { rho_inf: 0.9 };
/// Tolerance of the runs that count as converged.
const CONVERGED: f64 = 1e-8;

fn planar(spin: f64, elements: usize) -> SpinUp {
    SpinUp {
        omega_s: spin,
        elements,
        ..SpinUp::default()
    }
}

fn spatial(spin: f64, elements: usize) -> SpinUpSpatial {
    SpinUpSpatial {
        omega_s: spin,
        elements,
        ..SpinUpSpatial::default()
    }
}

/// Least v, its time, least u.
fn extremes(times: &[f64], rows: &[Vec<f64>]) -> [f64; 3] {
    let least = (0..rows.len())
        .min_by(|&i, &j| rows[i][1].total_cmp(&rows[j][1]))
        .expect("a row");
    let u = rows.iter().map(|row| row[0]).fold(f64::INFINITY, f64::min);
    [rows[least][1], times[least], u]
}

/// Error of the table's own steps in v, m: of second order, from its rows with two steps.
fn step_error(row: &Extreme) -> f64 {
    let at_5_ms = match row.spin {
        4.0 => 2e-6,
        10.0 => 4e-6,
        _ => 1.6e-5,
    };
    at_5_ms * (row.step / 0.005).powi(2)
}

/// Half a unit of the last printed digit, m, with its own rounding.
const PRINTED: f64 = 5.1e-7;

#[test]
fn extremes_of_the_table() {
    let times = grid(0.1, 18.0);
    for row in EXTREMES {
        let model = planar(row.spin, row.elements);
        let (converged, statistics) = history(&model, WAYS[0], Method::Radau, adaptive(CONVERGED), &times);
        let (same, _) = history(&model, WAYS[0], PUBLISHED, fixed(row.step), &times);
        let [v, time, u] = extremes(&times, &converged);
        let [v_same, time_same, u_same] = extremes(&times, &same);
        println!(
            "{} rad/s, n = {}, h = {}: v {:.6} (table {:.6}, by its method {:.6}) at {time:.1} s, u {:.6} ({:.6}, {:.6}); \
             Radau {} steps",
            row.spin, row.elements, row.step, v, row.v, v_same, u, row.u, u_same, statistics.steps
        );
        let allowed = step_error(&row) + PRINTED;
        assert!(
            (v - row.v).abs() < allowed && (u - row.u).abs() < allowed,
            "{row:?}: {v} {u}"
        );
        assert!((time - row.time).abs() < 1e-9 && (time_same - row.time).abs() < 1e-9);
        assert!(
            (v_same - row.v).abs() < PRINTED && (u_same - row.u).abs() < PRINTED,
            "{row:?}: {v_same} {u_same}"
        );
    }
}

/// Largest difference from a record until `end` (s), by Radau and by the record's own method and step.
fn record_differences(record: Record, model: &impl Model, step: f64, end: f64) -> [f64; 2] {
    let record = record.history().unwrap();
    let times: Vec<f64> = record.t.iter().copied().filter(|&t| t < end + 0.05).collect();
    let rows: Vec<Vec<f64>> = record.u.iter().zip(&record.v).map(|(&u, &v)| vec![u, v]).collect();
    [(Method::Radau, adaptive(CONVERGED)), (PUBLISHED, fixed(step))].map(|(method, options)| {
        let (found, _) = history(model, WAYS[0], method, options, &times);
        apart(&found, &rows[..found.len()])
    })
}

#[test]
fn histories_of_the_records() {
    let exact = SpinUpExact::default();
    for end in [3.5, 7.0, 14.0, 20.0] {
        println!("until {end} s: by Radau, by the record's method");
        for (record, spin, elements, step) in [
            (Record::Spin4Elements6, 4.0, 6, 0.0025),
            (Record::Spin4Elements16, 4.0, 16, 0.005),
            (Record::Spin10Elements16, 10.0, 16, 0.0025),
            (Record::Spin100Elements24, 100.0, 24, 0.0025),
        ] {
            println!(
                "{record:?}: {:?}",
                record_differences(record, &planar(spin, elements), step, end)
            );
        }
        println!(
            "exact {:?}",
            record_differences(Record::Spin10Elements16Exact, &exact, 0.005, end)
        );
    }
}

#[test]
fn spatial_beam_stays_in_the_plane() {
    let times = grid(0.1, 18.0);
    for (spin, elements) in [(4.0, 6), (10.0, 8), (100.0, 12)] {
        let options = adaptive(CONVERGED);
        let (flat, _) = history(&planar(spin, elements), WAYS[0], Method::Radau, options, &times);
        let (rows, _) = history(&spatial(spin, elements), WAYS[0], Method::Radau, options, &times);
        let w = rows.iter().map(|row| row[2].abs()).fold(0.0, f64::max);
        let in_plane: Vec<Vec<f64>> = rows.iter().map(|row| row[..2].to_vec()).collect();
        let difference = apart(&flat, &in_plane);
        println!("{spin} rad/s, n = {elements}: |w| <= {w:.1e} m, planar and spatial differ by {difference:.1e} m");
    }
}

#[test]
fn formulations_agree_to_the_tolerance() {
    for (spin, elements, end) in [(4.0, 6, 20.0), (40.0, 6, 5.0)] {
        let times = grid(0.1, end);
        for method in [Method::Radau, Method::Hht { alpha: -0.3 }] {
            for rtol in [1e-4, 1e-5, 1e-6, 1e-7] {
                let runs = WAYS.map(|way| history(&planar(spin, elements), way, method, adaptive(rtol), &times));
                let differences: Vec<f64> = runs[1..].iter().map(|run| apart(&run.0, &runs[0].0)).collect();
                let steps: Vec<u64> = runs.iter().map(|run| run.1.steps).collect();
                println!(
                    "{spin} rad/s {method:?} rtol {rtol:e}: differences {} m, steps {steps:?}",
                    short(&differences)
                );
            }
        }
    }
}
