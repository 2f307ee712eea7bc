//! Stage values of a step and the polynomials through them.

use super::coefficients::Coefficients;
use crate::system::State;

/// Values at the three stages of a step.
#[derive(Clone, Debug)]
pub(super) struct Stages {
    /// Step size, s.
    pub(super) h: f64,
    /// Increments of position from the start of the step.
    pub(super) z: [Vec<f64>; 3],
    /// Velocities.
    pub(super) v: [Vec<f64>; 3],
    /// Accelerations.
    pub(super) a: [Vec<f64>; 3],
    /// Multipliers.
    pub(super) lambda: [Vec<f64>; 3],
}

impl Stages {
    pub(super) fn new(n: usize, m: usize) -> Self {
        let vectors = |length: usize| std::array::from_fn(|_| vec![0.0; length]);
        Self {
            h: 0.0,
            z: vectors(n),
            v: vectors(n),
            a: vectors(n),
            lambda: vectors(m),
        }
    }

    /// Velocities and accelerations of the stages from the increments of position:
    /// `V = A^-1 Z / h`, `A = A^-1 (V - v_n) / h`.
    pub(super) fn differentiate(&mut self, coefficients: &Coefficients, start: &State) {
        for (s, row) in coefficients.inverse.iter().enumerate() {
            let [a, b, c] = row.map(|value| value / self.h);
            for i in 0..start.v.len() {
                self.v[s][i] = a * self.z[0][i] + b * self.z[1][i] + c * self.z[2][i];
            }
        }
        for (s, row) in coefficients.inverse.iter().enumerate() {
            let [a, b, c] = row.map(|value| value / self.h);
            for i in 0..start.v.len() {
                let v = start.v[i];
                self.a[s][i] = a * (self.v[0][i] - v) + b * (self.v[1][i] - v) + c * (self.v[2][i] - v);
            }
        }
    }

    /// Increments and multipliers at the stages of a first step from a consistent state: a motion
    /// of constant acceleration.
    pub(super) fn predict_first(&mut self, coefficients: &Coefficients, start: &State, h: f64) {
        self.h = h;
        for (s, node) in coefficients.nodes.iter().enumerate() {
            let dt = node * h;
            for i in 0..start.v.len() {
                self.z[s][i] = dt * (start.v[i] + 0.5 * dt * start.a[i]);
            }
            self.lambda[s].copy_from_slice(&start.lambda);
        }
    }

    /// Increments and multipliers at the stages of the step of size `h` behind `last`: its
    /// polynomials continued.
    pub(super) fn extrapolate(&mut self, coefficients: &Coefficients, last: &Stages, h: f64) {
        self.h = h;
        for (s, node) in coefficients.nodes.iter().enumerate() {
            let at = 1.0 + node * h / last.h;
            let [_, a, b, c] = coefficients.cubic(at);
            for i in 0..self.z[s].len() {
                let end = last.z[2][i];
                self.z[s][i] = a * last.z[0][i] + b * last.z[1][i] + c * end - end;
            }
            let [a, b, c] = coefficients.quadratic(at);
            for i in 0..self.lambda[s].len() {
                self.lambda[s][i] = a * last.lambda[0][i] + b * last.lambda[1][i] + c * last.lambda[2][i];
            }
        }
    }

    /// Position and multipliers of stage `s` into `state`, with its time.
    pub(super) fn stage(&self, coefficients: &Coefficients, s: usize, start: &State, state: &mut State) {
        state.t = start.t + coefficients.nodes[s] * self.h;
        for i in 0..start.x.len() {
            state.x[i] = start.x[i] + self.z[s][i];
        }
        state.v.copy_from_slice(&self.v[s]);
        state.a.copy_from_slice(&self.a[s]);
        state.lambda.copy_from_slice(&self.lambda[s]);
    }

    /// The state at `t` within the step from `start`: cubic positions and velocities (with those at
    /// the start), quadratic accelerations and multipliers.
    pub(super) fn interpolate(&self, coefficients: &Coefficients, start: &State, t: f64, out: &mut State) {
        let at = (t - start.t) / self.h;
        let [first, a, b, c] = coefficients.cubic(at);
        let quadratic = coefficients.quadratic(at);
        out.t = t;
        out.x.clone_from(&start.x);
        out.v.clone_from(&start.v);
        for i in 0..start.x.len() {
            out.x[i] += a * self.z[0][i] + b * self.z[1][i] + c * self.z[2][i];
            out.v[i] = first * start.v[i] + a * self.v[0][i] + b * self.v[1][i] + c * self.v[2][i];
        }
        combine(quadratic, &self.a, &mut out.a);
        combine(quadratic, &self.lambda, &mut out.lambda);
    }
}

fn combine([a, b, c]: [f64; 3], stages: &[Vec<f64>; 3], out: &mut Vec<f64>) {
    out.clear();
    out.extend((0..stages[0].len()).map(|i| a * stages[0][i] + b * stages[1][i] + c * stages[2][i]));
}
