//! Stage values of a step in its chart and the polynomials through them.

use pulp::Arch;

use super::chart::Chart;
use super::coefficients::Coefficients;
use crate::archive::{Archive, Keep};
use crate::linalg::{Vectorised, dispatch};
use crate::system::State;

/// Part of the largest multiplier that is nothing.
const NOTHING: f64 = 1e-9;

/// Values at the S stages of a step, in its chart.
#[derive(Clone, Debug)]
pub(super) struct Stages<const S: usize> {
    /// Step size, s.
    pub(super) h: f64,
    /// Increments of position from the start of the step, less those at the velocity of the start:
    /// the unknowns.
    pub(super) w: [Vec<f64>; S],
    /// Increments of position from the start of the step.
    pub(super) z: [Vec<f64>; S],
    /// Changes of the rates since the start of the step.
    pub(super) change: [Vec<f64>; S],
    /// Rates that the positions have less their drift: those that enter the equations of motion.
    pub(super) v: [Vec<f64>; S],
    /// Derivatives of the rates.
    pub(super) a: [Vec<f64>; S],
    /// Multipliers.
    pub(super) lambda: [Vec<f64>; S],
    /// Multipliers mu of the stabilised index 2, and the drift `C_y^T mu`; empty with index 3.
    pub(super) mu: [Vec<f64>; S],
    pub(super) drift: [Vec<f64>; S],
}

impl<const S: usize> Keep for Stages<S> {
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

impl<const S: usize> Stages<S> {
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
    pub(super) fn differentiate(&mut self, coefficients: &Coefficients<S>, start: &State) {
        dispatch(Arch::new(), Differentiated(self, coefficients, start));
    }

    #[inline(always)]
    fn differentiated(&mut self, coefficients: &Coefficients<S>, start: &State) {
        let rates = &start.v[..];
        let n = rates.len();
        let w = slices(&self.w, n);
        let h = self.h;
        for (s, row) in coefficients.inverse.iter().enumerate() {
            let row = row.map(|value| value / h);
            let dt = coefficients.nodes[s] * h;
            let (z, change) = (&mut self.z[s][..n], &mut self.change[s][..n]);
            for i in 0..n {
                z[i] = dt * rates[i] + w[s][i];
                change[i] = combined(&row, &w, i);
            }
            for (change, drift) in change.iter_mut().zip(&self.drift[s]) {
                *change += drift;
            }
            for ((v, rate), change) in self.v[s].iter_mut().zip(rates).zip(&*change) {
                *v = rate + change;
            }
        }
        let change = slices(&self.change, n);
        for (row, out) in coefficients.inverse.iter().zip(&mut self.a) {
            let row = row.map(|value| value / h);
            let out = &mut out[..n];
            for i in 0..n {
                out[i] = combined(&row, &change, i);
            }
        }
    }

    /// Increments and multipliers at the stages of a first step from a consistent state: a motion
    /// of constant acceleration.
    pub(super) fn predict_first(&mut self, coefficients: &Coefficients<S>, start: &State, h: f64) {
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
        coefficients: &Coefficients<S>,
        chart: &Chart,
        last: &Stages<S>,
        start: &State,
        h: f64,
    ) {
        self.h = h;
        let end = &last.z[S - 1];
        for (s, node) in coefficients.nodes.iter().enumerate() {
            let at = 1.0 + node * h / last.h;
            let (_, weights) = coefficients.with_start(at);
            let z = &mut self.z[s];
            combine(&weights, &last.z, z);
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
            combine(&coefficients.on_nodes(at), &last.lambda, &mut self.lambda[s]);
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
    pub(super) fn place(&self, coefficients: &Coefficients<S>, s: usize, start: &State, state: &mut State) {
        let dt = coefficients.nodes[s] * self.h;
        state.t = start.t + dt;
        state.turns.clone_from(&start.turns);
        let given = start.x.iter().zip(&start.v).zip(&self.w[s]);
        for (x, ((start, rate), w)) in state.x.iter_mut().zip(given) {
            *x = start + (dt * rate + w);
        }
    }

    /// Stage `s` into `state` in the chart: rates and their derivatives for velocity and acceleration.
    pub(super) fn in_chart(&self, coefficients: &Coefficients<S>, s: usize, start: &State, state: &mut State) {
        self.place(coefficients, s, start, state);
        state.v.copy_from_slice(&self.v[s]);
        state.a.copy_from_slice(&self.a[s]);
        state.lambda.copy_from_slice(&self.lambda[s]);
    }

    /// Stage `s` into `state`.
    pub(super) fn stage(
        &self,
        coefficients: &Coefficients<S>,
        chart: &Chart,
        s: usize,
        start: &State,
        state: &mut State,
    ) {
        self.in_chart(coefficients, s, start, state);
        chart.leave(state);
    }

    /// The state at `t` within the step from `start`: in the chart polynomials of degree S for positions and rates (with
    /// those at the start), of degree S - 1 for accelerations and multipliers.
    pub(super) fn interpolate(
        &self,
        coefficients: &Coefficients<S>,
        chart: &Chart,
        start: &State,
        t: f64,
        out: &mut State,
    ) {
        let at = (t - start.t) / self.h;
        let (first, weights) = coefficients.with_start(at);
        let on_nodes = coefficients.on_nodes(at);
        out.clone_from(start);
        out.t = t;
        let n = start.x.len();
        let (z, v) = (slices(&self.z, n), slices(&self.v, n));
        let (x, rates) = (&mut out.x[..n], &mut out.v[..n]);
        for i in 0..n {
            x[i] += combined(&weights, &z, i);
            rates[i] = first * rates[i] + combined(&weights, &v, i);
        }
        combine(&on_nodes, &self.a, &mut out.a);
        combine(&on_nodes, &self.lambda, &mut out.lambda);
        chart.leave(out);
    }

    /// Whether a polynomial that knows the multipliers at the start of the step, too, has others than a state in it, by more than a part of their largest
    /// values there.
    pub(super) fn misses_multipliers(
        &self,
        coefficients: &Coefficients<S>,
        start: &State,
        state: &State,
        part: f64,
    ) -> bool {
        let (first, weights) = coefficients.with_start((state.t - start.t) / self.h);
        let lambda = slices(&self.lambda, start.lambda.len());
        let largest = |i: usize| {
            lambda
                .iter()
                .map(|stage| stage[i].abs())
                .fold(start.lambda[i].abs(), f64::max)
        };
        let least = NOTHING * (0..start.lambda.len()).map(largest).fold(0.0, f64::max);
        (0..start.lambda.len()).any(|i| {
            let other = first * start.lambda[i] + combined(&weights, &lambda, i);
            (other - state.lambda[i]).abs() > part * largest(i).max(least)
        })
    }
}

/// [`Stages::differentiate`] with the instructions of the processor.
struct Differentiated<'a, const S: usize>(&'a mut Stages<S>, &'a Coefficients<S>, &'a State);

impl<const S: usize> Vectorised for Differentiated<'_, S> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        self.0.differentiated(self.1, self.2);
    }
}

/// The first n values of all stages.
#[inline(always)]
pub(super) fn slices<const S: usize>(stages: &[Vec<f64>; S], n: usize) -> [&[f64]; S] {
    std::array::from_fn(|s| &stages[s][..n])
}

/// What the stages have for unknown i, by weights.
#[inline(always)]
pub(super) fn combined<const S: usize>(weights: &[f64; S], stages: &[&[f64]; S], i: usize) -> f64 {
    let mut sum = weights[0] * stages[0][i];
    for s in 1..S {
        sum += weights[s] * stages[s][i];
    }
    sum
}

/// What the stages have, by weights.
pub(super) fn combine<const S: usize>(weights: &[f64; S], stages: &[Vec<f64>; S], out: &mut [f64]) {
    let stages = slices(stages, out.len());
    for (i, out) in out.iter_mut().enumerate() {
        *out = combined(weights, &stages, i);
    }
}
