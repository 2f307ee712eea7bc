//! Dense output between two states by cubic Hermite polynomials.

use crate::space::{inverse_tangent_map, product, three};
use crate::system::State;

/// The state at `t` between `first` and `last`, whose charts have just begun: positions cubic
/// through positions and velocities (orientations in the chart of `first`), velocities cubic
/// through velocities and accelerations, accelerations and multipliers linear.
pub(super) fn hermite(first: &State, last: &State, turns: &[usize], t: f64, out: &mut State) {
    out.clone_from(last);
    let h = last.t - first.t;
    if h <= 0.0 {
        return;
    }
    out.t = t;
    let s = (t - first.t) / h;
    cubic(s, h, (&first.x, &first.v), (&last.x, &last.v), &mut out.x);
    cubic(s, h, (&first.v, &first.a), (&last.v, &last.a), &mut out.v);
    linear(s, &first.a, &last.a, &mut out.a);
    linear(s, &first.lambda, &last.lambda, &mut out.lambda);
    out.turns.clone_from(&first.turns);
    for (index, &turn) in turns.iter().enumerate() {
        let theta = product(&first.turns[index].inverse(), &last.orientation(index, turn)).scaled_axis();
        let rate = inverse_tangent_map(theta) * three(&last.v, turn);
        let start = (&first.x[turn..turn + 3], &first.v[turn..turn + 3]);
        cubic(
            s,
            h,
            start,
            (theta.as_slice(), rate.as_slice()),
            &mut out.x[turn..turn + 3],
        );
    }
}

fn cubic(s: f64, h: f64, first: (&[f64], &[f64]), last: (&[f64], &[f64]), out: &mut [f64]) {
    let r = 1.0 - s;
    let (value0, value1) = (r * r * (1.0 + 2.0 * s), s * s * (1.0 + 2.0 * r));
    let (slope0, slope1) = (h * s * r * r, -h * s * s * r);
    for i in 0..out.len() {
        out[i] = value0 * first.0[i] + value1 * last.0[i] + slope0 * first.1[i] + slope1 * last.1[i];
    }
}

fn linear(s: f64, first: &[f64], last: &[f64], out: &mut [f64]) {
    for i in 0..out.len() {
        out[i] = (1.0 - s) * first[i] + s * last[i];
    }
}
