//! Dense output between steps against a run with half the step, which ends steps there.

use rncf::{Method, Model, State};

use crate::models::SoftSpatial;
use crate::reference::{Mistake, Reference, START};
use crate::runs::{WAYS, far, fixed, orders, short, states_at};

/// States at the middles of all steps of size `h` from the start for 0.4 s, by steps of size `step`.
fn middles(reference: &Reference, way: usize, method: Method, h: f64, step: f64) -> Vec<State> {
    let model = SoftSpatial {
        elements: reference.elements,
        ..SoftSpatial::default()
    };
    let mut scene = model.build(WAYS[way].0, WAYS[way].1).unwrap();
    let start = reference.start(scene.as_ref());
    let count = (0.4 / h).round() as usize;
    let mut times: Vec<f64> = (0..count).map(|k| START + h * (k as f64 + 0.5)).collect();
    times.push(START + 0.4);
    states_at(scene.as_mut(), start, method, fixed(step), &times).0
}

/// Largest differences of x, v, a, lambda between the dense output and steps that end there.
fn differences(reference: &Reference, way: usize, method: Method, h: f64) -> [f64; 4] {
    let between = middles(reference, way, method, h, h);
    let exactly = middles(reference, way, method, h, 0.5 * h);
    let mut worst = [0.0; 4];
    for (a, b) in between.iter().zip(&exactly) {
        assert!((a.t - b.t).abs() < 1e-12);
        for (worst, found) in worst.iter_mut().zip([
            far(&a.x, &b.x),
            far(&a.v, &b.v),
            far(&a.a, &b.a),
            far(&a.lambda, &b.lambda),
        ]) {
            *worst = f64::max(*worst, found);
        }
    }
    worst
}

#[test]
fn dense_output_has_its_order() {
    let reference = Reference::new(3, 1, Mistake::None);
    for way in 0..WAYS.len() {
        for (method, steps) in [
            (Method::Radau, [0.02, 0.01, 0.005]),
            (Method::Hht { alpha: -0.3 }, [0.005, 0.0025, 0.00125]),
            (Method::GeneralizedAlpha { rho_inf: 0.8 }, [0.005, 0.0025, 0.00125]),
        ] {
            let table = steps.map(|h| differences(&reference, way, method, h));
            for (kind, name) in ["x", "v", "a", "lambda"].iter().enumerate() {
                let column = table.map(|row| row[kind]);
                if column == [0.0; 3] {
                    assert!(kind == 3 && way == 0, "only multipliers may be absent");
                    continue;
                }
                let order = orders(&column)[1];
                println!(
                    "{:?} {method:?} {name}: {}, order {order:.2}",
                    WAYS[way],
                    short(&column)
                );
                assert!(order > expected(method, way)[kind] - 0.15, "{name}: {column:?}");
            }
        }
    }
}

/// Orders of x, v, a and lambda between steps: of the alpha methods that of the steps; of Radau one more than the
/// degree of the polynomial, but with moving conditions the multipliers' own 2.
fn expected(method: Method, way: usize) -> [f64; 4] {
    match (method, way) {
        (Method::Radau, 0 | 1) => [4.0, 4.0, 3.0, 3.0],
        (Method::Radau, _) => [4.0, 4.0, 3.0, 2.0],
        _ => [2.0; 4],
    }
}
