//! Stage values of a step in its chart and the polynomials through them.

use pulp::Arch;

use super::chart::Chart;
use super::coefficients::Coefficients;
use crate::archive::{Archive, Keep};
use crate::linalg::{Vectorised, dispatch};
use crate::system::State;

/// Values at the three stages of a step, in its chart.
#[derive(Clone, Debug)]
pub(super) struct Stages {
    /// Step size, s.
    pub(super) h: f64,
    /// Increments of position from the start of the step, less those at the velocity of the start:
    /// the unknowns.
    pub(super) w: [Vec<f64>; 3],
    /// Increments of position from the start of the step.
    pub(super) z: [Vec<f64>; 3],
    /// Changes of the rates since the start of the step.
    pub(super) change: [Vec<f64>; 3],
    /// Rates that the positions have less their drift: those that enter the equations of motion.
    pub(super) v: [Vec<f64>; 3],
    /// Derivatives of the rates.
    pub(super) a: [Vec<f64>; 3],
    /// Multipliers.
    pub(super) lambda: [Vec<f64>; 3],
    /// Multipliers mu of the stabilised index 2, and the drift `C_y^T mu`; empty with index 3.
    pub(super) mu: [Vec<f64>; 3],
    pub(super) drift: [Vec<f64>; 3],
}

impl Keep for Stages {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            h,
            w,
            z,
            change,
            v,
            a,
            lambda,
            mu,
            drift,
        } = self;
        h.keep(archive);
        for stages in [w, z, change, v, a, lambda, mu, drift] {
            stages.iter_mut().for_each(|values| archive.fixed(values));
        }
    }
}

impl Stages {
    pub(super) fn new(n: usize, m: usize, stabilised: bool) -> Self {
        let vectors = |length: usize| std::array::from_fn(|_| vec![0.0; length]);
        Self {
            h: 0.0,
            w: vectors(n),
            z: vectors(n),
            change: vectors(n),
            v: vectors(n),
            a: vectors(n),
            lambda: vectors(m),
            mu: vectors(if stabilised { m } else { 0 }),
            drift: vectors(if stabilised { n } else { 0 }),
        }
    }

    /// Increments, rates and their derivatives at the stages from the unknowns and the drift:
    /// `Z = W + c h v_n`, `V - v_n = A^-1 W / h + drift`, `A = A^-1 (V - v_n) / h`.
    pub(super) fn differentiate(&mut self, coefficients: &Coefficients, start: &State) {
        dispatch(Arch::new(), Differentiated(self, coefficients, start));
    }

    #[inline(always)]
    fn differentiated(&mut self, coefficients: &Coefficients, start: &State) {
        let rates = &start.v[..];
        let n = rates.len();
        let [w0, w1, w2] = &self.w;
        let [w0, w1, w2] = [&w0[..n], &w1[..n], &w2[..n]];
        let h = self.h;
        for (s, row) in coefficients.inverse.iter().enumerate() {
            let [a, b, c] = [row[0] / h, row[1] / h, row[2] / h];
            let dt = coefficients.nodes[s] * h;
            let own = [w0, w1, w2][s];
            let (z, change) = (&mut self.z[s][..n], &mut self.change[s][..n]);
            for i in 0..n {
                z[i] = dt * rates[i] + own[i];
                change[i] = a * w0[i] + b * w1[i] + c * w2[i];
            }
            for (change, drift) in change.iter_mut().zip(&self.drift[s]) {
                *change += drift;
            }
            for ((v, rate), change) in self.v[s].iter_mut().zip(rates).zip(&*change) {
                *v = rate + change;
            }
        }
        let [c0, c1, c2] = &self.change;
        let [c0, c1, c2] = [&c0[..n], &c1[..n], &c2[..n]];
        for (row, out) in coefficients.inverse.iter().zip(&mut self.a) {
            let [a, b, c] = [row[0] / h, row[1] / h, row[2] / h];
            let out = &mut out[..n];
            for i in 0..n {
                out[i] = a * c0[i] + b * c1[i] + c * c2[i];
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
                self.w[s][i] = 0.5 * dt * dt * start.a[i];
                self.z[s][i] = dt * start.v[i] + self.w[s][i];
            }
            self.lambda[s].copy_from_slice(&start.lambda);
        }
        self.begin_without_drift();
    }

    /// Increments and multipliers at the stages of the step of size `h` behind `last`: its
    /// polynomials continued, in the chart that begins at its end.
    pub(super) fn extrapolate(
        &mut self,
        coefficients: &Coefficients,
        chart: &Chart,
        last: &Stages,
        start: &State,
        h: f64,
    ) {
        self.h = h;
        let end = &last.z[2];
        for (s, node) in coefficients.nodes.iter().enumerate() {
            let at = 1.0 + node * h / last.h;
            let [_, a, b, c] = coefficients.cubic(at);
            let z = &mut self.z[s];
            combine([a, b, c], &last.z, z);
            chart.transport(end, z);
            let mut turns = chart.turns().iter().copied().peekable();
            let mut i = 0;
            while i < z.len() {
                if turns.next_if_eq(&i).is_some() {
                    i += 3;
                } else {
                    z[i] -= end[i];
                    i += 1;
                }
            }
            for ((w, z), rate) in self.w[s].iter_mut().zip(&*z).zip(&start.v) {
                *w = z - node * h * rate;
            }
            combine(coefficients.quadratic(at), &last.lambda, &mut self.lambda[s]);
        }
        self.begin_without_drift();
    }

    /// mu vanishes analytically: that is its prediction.
    fn begin_without_drift(&mut self) {
        self.mu
            .iter_mut()
            .chain(&mut self.drift)
            .for_each(|values| values.fill(0.0));
    }

    /// Time and position of stage `s` into `state`; its rates are left as they are.
    pub(super) fn place(&self, coefficients: &Coefficients, s: usize, start: &State, state: &mut State) {
        let dt = coefficients.nodes[s] * self.h;
        state.t = start.t + dt;
        state.turns.clone_from(&start.turns);
        let given = start.x.iter().zip(&start.v).zip(&self.w[s]);
        for (x, ((start, rate), w)) in state.x.iter_mut().zip(given) {
            *x = start + (dt * rate + w);
        }
    }

    /// Stage `s` into `state` in the chart: rates and their derivatives for velocity and acceleration.
    pub(super) fn in_chart(&self, coefficients: &Coefficients, s: usize, start: &State, state: &mut State) {
        self.place(coefficients, s, start, state);
        state.v.copy_from_slice(&self.v[s]);
        state.a.copy_from_slice(&self.a[s]);
        state.lambda.copy_from_slice(&self.lambda[s]);
    }

    /// Stage `s` into `state`.
    pub(super) fn stage(&self, coefficients: &Coefficients, chart: &Chart, s: usize, start: &State, state: &mut State) {
        self.in_chart(coefficients, s, start, state);
        chart.leave(state);
    }

    /// The state at `t` within the step from `start`: in the chart cubic positions and rates (with
    /// those at the start), quadratic accelerations and multipliers.
    pub(super) fn interpolate(
        &self,
        coefficients: &Coefficients,
        chart: &Chart,
        start: &State,
        t: f64,
        out: &mut State,
    ) {
        let at = (t - start.t) / self.h;
        let [first, a, b, c] = coefficients.cubic(at);
        let quadratic = coefficients.quadratic(at);
        out.clone_from(start);
        out.t = t;
        let n = start.x.len();
        let ([z0, z1, z2], [v0, v1, v2]) = (&self.z, &self.v);
        let (z, v) = ([z0, z1, z2].map(|z| &z[..n]), [v0, v1, v2].map(|v| &v[..n]));
        let (x, rates) = (&mut out.x[..n], &mut out.v[..n]);
        for i in 0..n {
            x[i] += a * z[0][i] + b * z[1][i] + c * z[2][i];
            rates[i] = first * rates[i] + a * v[0][i] + b * v[1][i] + c * v[2][i];
        }
        combine(quadratic, &self.a, &mut out.a);
        combine(quadratic, &self.lambda, &mut out.lambda);
        chart.leave(out);
    }
}

/// [`Stages::differentiate`] with the instructions of the processor.
struct Differentiated<'a>(&'a mut Stages, &'a Coefficients, &'a State);

impl Vectorised for Differentiated<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        self.0.differentiated(self.1, self.2);
    }
}

fn combine([a, b, c]: [f64; 3], [first, second, third]: &[Vec<f64>; 3], out: &mut [f64]) {
    for (((out, first), second), third) in out.iter_mut().zip(first).zip(second).zip(third) {
        *out = a * first + b * second + c * third;
    }
}
