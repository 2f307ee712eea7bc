//! Extrapolation of accelerations and multipliers from accepted steps: where Newton starts.

use crate::system::State;

/// Up to two states before the last accepted one, newest first.
#[derive(Default)]
pub(super) struct History {
    past: [Point; 2],
    known: usize,
}

/// Accelerations and multipliers at one time.
#[derive(Default)]
struct Point {
    t: f64,
    a: Vec<f64>,
    lambda: Vec<f64>,
}

impl History {
    /// An empty history of `n` unknowns and `m` multipliers.
    pub(super) fn new(n: usize, m: usize) -> Self {
        let point = || Point {
            t: 0.0,
            a: vec![0.0; n],
            lambda: vec![0.0; m],
        };
        Self {
            past: [point(), point()],
            known: 0,
        }
    }

    /// Forgets everything: the solution is not smooth across a restart.
    pub(super) fn restart(&mut self) {
        self.known = 0;
    }

    /// Remembers a state that has just become the last but one.
    pub(super) fn remember(&mut self, state: &State) {
        self.past.swap(0, 1);
        self.past[0].t = state.t;
        self.past[0].a.copy_from_slice(&state.a);
        self.past[0].lambda.copy_from_slice(&state.lambda);
        self.known = (self.known + 1).min(2);
    }

    /// Accelerations and multipliers of `out` at its time by the parabola through `last` and the
    /// history, by as much of it as there is; false if there is none.
    pub(super) fn extrapolate(&self, last: &State, out: &mut State) -> bool {
        let [one, two] = &self.past;
        let t = out.t;
        match self.known {
            0 => return false,
            1 => {
                let slope = (t - last.t) / (last.t - one.t);
                combine(&mut out.a, [(1.0 + slope, &last.a), (-slope, &one.a)]);
                combine(&mut out.lambda, [(1.0 + slope, &last.lambda), (-slope, &one.lambda)]);
            }
            _ => {
                let l0 = (t - one.t) * (t - two.t) / ((last.t - one.t) * (last.t - two.t));
                let l1 = (t - last.t) * (t - two.t) / ((one.t - last.t) * (one.t - two.t));
                let l2 = (t - last.t) * (t - one.t) / ((two.t - last.t) * (two.t - one.t));
                combine(&mut out.a, [(l0, &last.a), (l1, &one.a), (l2, &two.a)]);
                combine(
                    &mut out.lambda,
                    [(l0, &last.lambda), (l1, &one.lambda), (l2, &two.lambda)],
                );
            }
        }
        true
    }
}

/// `out = sum of factor * y`.
fn combine<const N: usize>(out: &mut [f64], terms: [(f64, &Vec<f64>); N]) {
    for i in 0..out.len() {
        out[i] = terms.iter().map(|(factor, y)| factor * y[i]).sum();
    }
}
