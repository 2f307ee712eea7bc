use super::*;
use crate::space::{Vector, exp, matrix};

const NU: Vector = Vector::new(0.7, -1.1, 0.4);
const RATE: Vector = Vector::new(-0.3, 0.2, 0.9);
const STEP: f64 = 1e-5;

fn moved(y: Vector, d: Vector, by: f64) -> Vector {
    y + by * d
}

/// Central difference of a function of the step.
fn difference(of: impl Fn(f64) -> Vector) -> Vector {
    0.5 / STEP * (of(STEP) - of(-STEP))
}

fn close(a: Vector, b: Vector, what: &str) {
    assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-8), "{what}: {a:?} {b:?}");
}

#[test]
fn velocities_and_accelerations_are_those_of_the_rotation() {
    // Both sides of the series, and a large angle.
    for size in [0.0, 1e-3, 0.3, 0.999, 1.001, 2.5] {
        let xi = size * Vector::new(0.48, -0.6, 0.64);
        let point = Point::new(xi);
        close(point.map(NU), tangent_map(xi) * NU, "velocity");
        let velocity = |t: f64| {
            let xi = xi + (t * NU + 0.5 * t * t * RATE);
            Point::new(xi).map(moved(NU, RATE, t))
        };
        let acceleration = point.map(RATE) + point.turning(NU);
        close(acceleration, difference(velocity), "acceleration");
    }
}

#[test]
fn changes_are_derivatives() {
    for size in [0.0, 1e-3, 0.3, 0.999, 1.001, 2.5] {
        let xi = size * Vector::new(0.48, -0.6, 0.64);
        let point = Point::new(xi);
        for d in [Vector::x(), Vector::y(), Vector::new(0.2, -0.3, 1.0)] {
            let near = |t: f64| Point::new(moved(xi, d, t));
            close(point.map_change(NU, d), difference(|t| near(t).map(NU)), "T by xi");
            close(
                point.turning_change(NU, d),
                difference(|t| near(t).turning(NU)),
                "W by xi",
            );
            let by_rate = difference(|t| point.turning(moved(NU, d, t)));
            close(point.turning_change_by_rate(NU, d), by_rate, "W by nu");
        }
    }
}

/// Unknowns of the test: a number, then an orientation.
const FIRST: usize = 1;

/// A smooth function of number y, orientation A, their rates and the derivatives of these, without any
/// symmetry.
fn residual(state: &State) -> [f64; 4] {
    let a = matrix(&state.orientation(0, FIRST));
    let (v, d, y) = (&state.v, &state.a, state.x[0]);
    let (w, dw) = (at(v, FIRST), at(d, FIRST));
    let f = a * Vector::new(1.0 + y, v[0] - 0.3, 0.7 * y * d[0]);
    let g = w.cross(&Vector::new(w[0] * f[1], 2.0 * w[1], (3.0 + y) * w[2] + d[0]));
    let sum = f
        + g
        + Vector::new(
            dw[0] * (2.0 + f[2]),
            3.0 * dw[1] + 0.4 * dw[2] * y,
            dw[2] + w[1] * dw[0],
        );
    [f.dot(&dw) + y * v[0] + d[0], sum[0], sum[1], sum[2]]
}

/// One constraint of the same unknowns.
fn constraint(state: &State) -> f64 {
    let a = matrix(&state.orientation(0, FIRST));
    a[(0, 1)] + 0.4 * a[(2, 0)] * state.x[0] - 0.3 * a[(1, 1)] + state.x[0].powi(2)
}

/// `state` with unknown `i` of its position moved by a right increment `h`.
fn turned(state: &State, i: usize, h: f64) -> State {
    let mut moved = state.clone();
    if i < FIRST {
        moved.x[i] += h;
        return moved;
    }
    moved.rebase(&[FIRST]);
    moved.x[i] = h;
    moved.rebase(&[FIRST]);
    moved
}

/// Derivative of the constraint in every direction.
fn gradient(state: &State) -> Vec<f64> {
    let of = |i: usize, h: f64| constraint(&turned(state, i, h));
    (0..4).map(|i| (of(i, STEP) - of(i, -STEP)) / (2.0 * STEP)).collect()
}

/// Columns of the derivatives of a function of four values by what `moved` moves.
fn columns<const N: usize>(of: impl Fn(&State) -> [f64; N], moved: impl Fn(usize, f64) -> State) -> Vec<f64> {
    (0..4)
        .flat_map(|i| {
            let (up, down) = (of(&moved(i, STEP)), of(&moved(i, -STEP)));
            std::array::from_fn::<f64, N, _>(|k| (up[k] - down[k]) / (2.0 * STEP))
        })
        .collect()
}

fn shifted(state: &State, of: fn(&mut State) -> &mut Vec<f64>, i: usize, h: f64) -> State {
    let mut moved = state.clone();
    of(&mut moved)[i] += h;
    moved
}

fn all_close(a: &[f64], b: &[f64], what: &str) {
    assert_eq!(a.len(), b.len());
    for (i, (a, b)) in a.iter().zip(b).enumerate() {
        assert!((a - b).abs() < 2e-8, "{what}, entry {i}: {a} {b}");
    }
}

#[test]
fn derivatives_in_the_chart_are_those_of_the_residual_in_the_chart() {
    let (block, constraints) = (
        Pattern::new(4, 4, (0..16).map(|i| (i / 4, i % 4))),
        Pattern::new(4, 1, (0..4).map(|i| (i, 0))),
    );
    let chart = Chart::new(&[FIRST], &block, &constraints);
    let mut place = State::zeros(0.0, 4, 0);
    place.turns = vec![exp(Vector::new(0.4, 1.0, -0.3))];
    place.x.copy_from_slice(&[0.2, 0.5, -0.3, 0.6]);
    place.v.copy_from_slice(&[0.3, 0.7, -1.1, 0.4]);
    place.a.copy_from_slice(&[-0.2, -0.3, 0.2, 0.9]);
    let left = |state: &State| {
        let mut state = state.clone();
        chart.leave(&mut state);
        state
    };
    let state = left(&place);
    let given = Tangent {
        mass: columns(residual, |i, h| shifted(&state, |s| &mut s.a, i, h)),
        damping: columns(residual, |i, h| shifted(&state, |s| &mut s.v, i, h)),
        stiffness: columns(residual, |i, h| turned(&state, i, h)),
    };
    let mut tangent = given.clone();
    chart.tangent(&place, &given, &mut tangent);
    let in_chart =
        |of: fn(&mut State) -> &mut Vec<f64>| columns(|state| residual(&left(state)), |i, h| shifted(&place, of, i, h));
    all_close(&tangent.mass, &in_chart(|s| &mut s.a), "mass");
    all_close(&tangent.damping, &in_chart(|s| &mut s.v), "damping");
    all_close(&tangent.stiffness, &in_chart(|s| &mut s.x), "stiffness");

    let jacobian = gradient(&state);
    let mut in_chart = vec![0.0; 4];
    chart.jacobian(&place.x, &jacobian, &mut in_chart);
    let exact = columns(|state| [constraint(state)], |i, h| shifted(&place, |s| &mut s.x, i, h));
    all_close(&in_chart, &exact, "constraint");
    let rate = |state: &State| [gradient(state).iter().zip(&state.v).map(|(c, v)| c * v).sum::<f64>()];
    let system_rate = columns(rate, |i, h| turned(&state, i, h));
    chart.rate_tangent(&place, &jacobian, &system_rate, &mut in_chart);
    let exact = columns(|state| rate(&left(state)), |i, h| shifted(&place, |s| &mut s.x, i, h));
    for (a, b) in in_chart.iter().zip(exact) {
        assert!((a - b).abs() < 1e-5, "constraint's rate: {a} {b}");
    }
}

#[test]
fn patterns_of_an_orientation_are_united() {
    let (block, constraints) = (
        Pattern::new(4, 4, (0..4).map(|i| (i, i))),
        Pattern::new(4, 2, [(0, 0), (2, 0), (0, 1)]),
    );
    let chart = Chart::new(&[FIRST], &block, &constraints);
    let mut all = Pattern::new(4, 4, [(0, 0)].into_iter().chain((0..9).map(|i| (1 + i / 3, 1 + i % 3))));
    assert_eq!(chart.block, all);
    all = Pattern::new(4, 2, [(0, 0), (1, 0), (2, 0), (3, 0), (0, 1)]);
    assert_eq!(chart.constraints, all);
    let mut values = vec![0.0; 5];
    chart.forces(&[1.0, 2.0, 3.0], &mut values);
    assert_eq!(values, [1.0, 0.0, 2.0, 0.0, 3.0]);
    chart.jacobian(&[0.5, 0.0, 0.0, 0.0], &[1.0, 2.0, 3.0], &mut values);
    assert_eq!(values, [1.0, 0.0, 2.0, 0.0, 3.0]);
}
