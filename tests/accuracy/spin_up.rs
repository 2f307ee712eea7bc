//! The spin-up manoeuvre against the numbers and records of THEORY 9.1, and the formulations against each other.

use rncf::{Method, Model, Options};
use rncf_models::{SpinUp, SpinUpSpatial};
use rncf_reference::table::{EXTREMES, Extreme, History, Record};

use rncf_test_models::SpinUpExact;

use crate::models::SpinUpReduced;
use crate::runs::{WAYS, adaptive, apart, fixed, grid, history, short};

/// The method of the table and of the records.
const PUBLISHED: Method = Method::GeneralizedAlpha { rho_inf: 0.9 };
/// Tolerance of the runs that count as converged.
const CONVERGED: f64 = 1e-9;

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

/// Largest differences of a model's history from a record up to `end` (s) by a method.
fn difference(record: &History, model: &impl Model, end: f64, method: Method, options: Options) -> f64 {
    let times: Vec<f64> = record.t.iter().copied().filter(|&t| t < end + 0.05).collect();
    let rows: Vec<Vec<f64>> = record.u.iter().zip(&record.v).map(|(&u, &v)| vec![u, v]).collect();
    let (found, _) = history(model, WAYS[0], method, options, &times);
    apart(&found, &rows[..found.len()])
}

/// A record against the converged motion, within `allowed` (m): the error of the record's own steps, of second order
/// and growing with time as the free vibrations that the run-up leaves fall out of phase. That it is so is shown by
/// the same method: with the record's step it gives the record, with half of it a fourth of the difference.
fn meets_record(record: Record, model: &impl Model, step: f64, limits: [(f64, f64); 2]) {
    let history = record.history().unwrap();
    for (end, allowed) in limits {
        let own = difference(&history, model, end, PUBLISHED, fixed(step));
        let converged = difference(&history, model, end, Method::Radau, adaptive(CONVERGED));
        let half = step_error_of(model, end, 0.5 * step) / step_error_of(model, end, step);
        println!(
            "{record:?} until {end} s: {converged:.1e} m from Radau, {own:.1e} m from its own method; half the step has \
             {half:.2} of its error"
        );
        assert!(own < 3e-8 && converged < allowed, "{record:?}: {own} {converged}");
        assert!((half - 0.25).abs() < 0.05, "{record:?}: {half}");
    }
}

/// Error of the published method, m.
fn step_error_of(model: &impl Model, end: f64, step: f64) -> f64 {
    let times = grid(0.1, end);
    let (converged, _) = history(model, WAYS[0], Method::Radau, adaptive(CONVERGED), &times);
    let (found, _) = history(model, WAYS[0], PUBLISHED, fixed(step), &times);
    apart(&found, &converged)
}

#[test]
fn histories_of_the_records() {
    use Record::{Spin4Elements6, Spin4Elements16, Spin10Elements16, Spin10Elements16Exact, Spin100Elements24};
    meets_record(Spin4Elements6, &planar(4.0, 6), 0.0025, [(7.0, 1e-6), (20.0, 3e-6)]);
    meets_record(Spin4Elements16, &planar(4.0, 16), 0.005, [(7.0, 3e-6), (20.0, 1e-5)]);
    meets_record(Spin10Elements16, &planar(10.0, 16), 0.0025, [(7.0, 2e-6), (18.0, 8e-6)]);
    meets_record(
        Spin100Elements24,
        &planar(100.0, 24),
        0.0025,
        [(3.5, 5e-6), (18.0, 2.5e-4)],
    );
    let exact = SpinUpExact::default();
    meets_record(Spin10Elements16Exact, &exact, 0.005, [(7.0, 7e-6), (18.0, 3e-5)]);
    // The exact curvature is another motion: the records can tell.
    let other = Spin10Elements16.history().unwrap();
    assert!(difference(&other, &exact, 7.0, Method::Radau, adaptive(CONVERGED)) > 1e-5);
}

#[test]
fn spatial_beam_stays_in_the_plane() {
    for (spin, elements) in [(4.0, 6), (10.0, 8), (100.0, 12)] {
        for (method, options, allowed) in [
            // The same steps: what Newton's iteration leaves, 1e-13 and 1e-12 of 8 m, in 3600 steps.
            (Method::Radau, fixed(0.005), 2e-8),
            (PUBLISHED, fixed(0.005), 5e-8),
            // Other steps, since the error norm counts the third components: the tolerance.
            (Method::Radau, adaptive(CONVERGED), 10.0 * CONVERGED * 8.0),
        ] {
            let times = grid(0.1, 18.0);
            let (flat, _) = history(&planar(spin, elements), WAYS[0], method, options, &times);
            let (rows, _) = history(&spatial(spin, elements), WAYS[0], method, options, &times);
            let w = rows.iter().map(|row| row[2].abs()).fold(0.0, f64::max);
            let in_plane: Vec<Vec<f64>> = rows.iter().map(|row| row[..2].to_vec()).collect();
            let difference = apart(&flat, &in_plane);
            println!(
                "{spin} rad/s, n = {elements}, {method:?}, {:?}: |w| <= {w:.1e} m, planar and spatial differ by \
                 {difference:.1e} m",
                options.step
            );
            assert!(w <= 1e-14 && difference < allowed, "{w} {difference}");
        }
    }
}

#[test]
fn formulations_agree_to_the_tolerance() {
    for (spin, elements, end) in [(4.0, 6, 20.0), (40.0, 6, 5.0)] {
        let times = grid(0.1, end);
        let model = planar(spin, elements);
        for method in [Method::Radau, Method::Hht { alpha: -0.3 }] {
            for rtol in [1e-4, 1e-5, 1e-6, 1e-7] {
                let runs = WAYS.map(|way| history(&model, way, method, adaptive(rtol), &times));
                let differences: Vec<f64> = runs[1..].iter().map(|run| apart(&run.0, &runs[0].0)).collect();
                let steps: Vec<u64> = runs.iter().map(|run| run.1.steps).collect();
                // Local errors of third order are held to the tolerance in ANCF's large motion, in steps of their
                // cube root: the sum is of second order in the step.
                let (factor, scale) = match method {
                    Method::Radau => (10.0, rtol),
                    _ => (6.0, rtol.powf(2.0 / 3.0)),
                };
                let worst = differences.iter().copied().fold(0.0, f64::max);
                println!(
                    "{spin} rad/s, {method:?}, rtol {rtol:e}: apart by {} m, {:.2} of 8 m times {scale:.1e}; steps \
                     {steps:?}",
                    short(&differences),
                    worst / (8.0 * scale)
                );
                assert!(worst < factor * 8.0 * scale, "{method:?}, {rtol:e}: {differences:?}");
            }
        }
    }
}

/// THEORY 5.1, remark vi: the exact and the three-point rule on coarse meshes, least v at 4 rad/s on
/// the 0.1 s grid; the reduced rule is the more accurate one.
#[test]
fn rules_of_integration_on_coarse_meshes() {
    const RULES: [(usize, f64, f64); 4] = [
        (2, -0.49584, -0.51055),
        (4, -0.53129, -0.53260),
        (6, -0.53368, -0.53383),
        (8, -0.53395, -0.53398),
    ];
    let times = grid(0.1, 9.0);
    for (elements, exact, reduced) in RULES {
        let full = history(&planar(4.0, elements), WAYS[0], Method::Radau, adaptive(1e-8), &times).0;
        let few = history(
            &SpinUpReduced { elements },
            WAYS[0],
            Method::Radau,
            adaptive(1e-8),
            &times,
        )
        .0;
        for (name, rows, printed) in [("exact", full, exact), ("three points", few, reduced)] {
            let value = extremes(&times, &rows)[0];
            println!("{elements} elements, {name}: least v {value:.6} m, printed {printed}");
            // Five printed digits, and the step error of the record (its step is not printed).
            assert!(
                (value - printed).abs() < 4e-5,
                "{elements} elements, {name}: {value} m, printed {printed}"
            );
        }
    }
}
