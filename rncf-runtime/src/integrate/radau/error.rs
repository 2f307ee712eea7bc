//! Local error by the embedded formula (THEORY 7.5) in second-order form.
//!
//! With y = (x, v, lambda) and e the embedded weights, the two rows of
//! `(g/h Mass - Jac) err = f(y_n) + Mass (e . z) / h` read
//!
//! ```text
//! (g/h) err_x - err_v = F1 = v_n + (e . Z) / h
//! (g/h) M err_v + D err_v + K err_x + C_x^T err_lambda = F2 = M (a_n + (e . (V - v_n)) / h)
//! ```
//!
//! where `M a_n = -f - C_x^T lambda` at the start. Eliminating err_v = (g/h) err_x - F1 leaves one
//! solution with the real matrix of the step: its right side is F2 + ((g/h) M + D) F1.
//!
//! All in the chart of the step, whose rates and derivatives are velocities and accelerations at its
//! start. The stabilised index 2 is estimated alike: its mu is far below the error.
//!
//! An error of velocity counts with the step: of a vibration it is turned round soon. Bodies that fly or turn freely keep it. Where a stop or
//! an impact makes steps short for a while, it lasts through the long steps behind them: poses count with the longest of the recent steps.

use super::coefficients::Coefficients;
use super::matrices::Matrices;
use super::stages::{Stages, combine};
use crate::archive::{Archive, Keep};
use crate::integrate::norms::largest;
use crate::integrate::recent::Recent;
use crate::integrate::statistics::Statistics;
use crate::system::{State, System};

/// Memory and weights of the estimate.
pub(super) struct Estimate {
    inverse_weights: Vec<f64>,
    /// First unknown of the poses of free frames and rigid bodies.
    poses: usize,
    recent: Recent,
    /// Errors of position and of velocity.
    x: Vec<f64>,
    v: Vec<f64>,
    constraints: Vec<f64>,
    first: Vec<f64>,
    work: Vec<f64>,
    /// `C_x^T`
    jacobian: Vec<f64>,
    state: State,
}

impl Keep for Estimate {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        self.recent.keep(archive);
    }
}

impl Estimate {
    pub(super) fn new(system: &dyn System, rtol: f64) -> Self {
        let (n, m) = (system.unknowns(), system.constraints());
        Self {
            inverse_weights: system.sizes().iter().map(|size| 1.0 / (rtol * size)).collect(),
            poses: n - system.border(),
            recent: Recent::default(),
            x: vec![0.0; n],
            v: vec![0.0; n],
            constraints: vec![0.0; m],
            first: vec![0.0; n],
            work: vec![0.0; n],
            jacobian: vec![0.0; system.constraint_pattern().entries()],
            state: State::of(system, 0.0),
        }
    }

    /// Notes an accepted step of size `h`.
    pub(super) fn accepted(&mut self, h: f64) {
        self.recent.meet(h);
    }

    /// Weighted size of the error of `stages`, which start at `start`.
    pub(super) fn error<const S: usize>(
        &mut self,
        coefficients: &Coefficients<S>,
        matrices: &mut Matrices<S>,
        start: &State,
        stages: &Stages<S>,
        statistics: &mut Statistics,
    ) -> f64 {
        let weights = coefficients.embedded.map(|value| value / stages.h);
        let g = coefficients.real / stages.h;
        // The embedded weights make -1 of the nodes: v_n + (e . Z) / h = (e . W) / h.
        combine(&weights, &stages.w, &mut self.first);
        combine(&weights, &stages.change, &mut self.work);
        for i in 0..self.x.len() {
            self.work[i] = (start.a[i] + self.work[i]) + g * self.first[i];
        }
        self.x.fill(0.0);
        self.finish(coefficients, matrices, stages.h, statistics)
    }

    /// The estimate once more from the slope at `start` + error: it no longer sees motions that
    /// are far faster than the step.
    pub(super) fn filtered<const S: usize>(
        &mut self,
        system: &mut dyn System,
        coefficients: &Coefficients<S>,
        matrices: &mut Matrices<S>,
        start: &State,
        stages: &Stages<S>,
        statistics: &mut Statistics,
    ) -> f64 {
        let weights = coefficients.embedded.map(|value| value / stages.h);
        self.state.clone_from(start);
        combine(&weights, &stages.w, &mut self.first);
        combine(&weights, &stages.change, &mut self.work);
        for i in 0..self.x.len() {
            self.state.x[i] += self.x[i];
            self.state.v[i] += self.v[i];
            self.first[i] += self.v[i];
            self.work[i] = -self.work[i];
        }
        // M a + f at a = -(e . (V - v_n)) / h is -F2.
        self.state.a.copy_from_slice(&self.work);
        matrices.chart.leave(&mut self.state);
        let state = &self.state;
        system.residual(state, &mut self.x);
        statistics.residual_evaluations += 1;
        if !state.lambda.is_empty() {
            let pattern = &matrices.constraint_pattern;
            system.constraint_jacobian(state, &mut self.jacobian);
            pattern.multiply_add(1.0, &self.jacobian, &state.lambda, &mut self.x);
        }
        self.x.iter_mut().for_each(|value| *value = -*value);
        let g = coefficients.real / stages.h;
        self.work
            .iter_mut()
            .zip(&self.first)
            .for_each(|(work, first)| *work = g * first);
        self.finish(coefficients, matrices, stages.h, statistics)
    }

    /// Completes `x` to the right side, solves, and measures; `work` is what the mass multiplies beside it.
    fn finish<const S: usize>(
        &mut self,
        coefficients: &Coefficients<S>,
        matrices: &mut Matrices<S>,
        h: f64,
        statistics: &mut Statistics,
    ) -> f64 {
        let g = coefficients.real / h;
        let (block, tangent) = (&matrices.chart.block, &matrices.tangent);
        block.multiply_add(1.0, &tangent.mass, &self.work, &mut self.x);
        block.multiply_add(1.0, &tangent.damping, &self.first, &mut self.x);
        self.constraints.fill(0.0);
        matrices.solve_real(&mut self.x, &mut self.constraints, statistics);
        let mut sum = 0.0;
        let lasting = self.recent.lasting(h);
        for i in 0..self.x.len() {
            self.v[i] = g * self.x[i] - self.first[i];
            let weight = self.inverse_weights[i];
            let time = if i < self.poses { h } else { lasting };
            sum += (self.x[i] * weight).powi(2) + (time * self.v[i] * weight).powi(2);
        }
        (sum / (2 * self.x.len()).max(1) as f64).sqrt()
    }

    /// The unknown with the largest part in the last estimate.
    pub(super) fn worst(&self) -> Option<usize> {
        largest(&self.x, &self.inverse_weights)
    }
}
