//! Radau IIA with three stages, order 5 (THEORY 7.5), for second-order systems with index-3
//! constraints. The unknowns of a step are the three increments of position Z_i = X_i - x_n, less what
//! the velocity at the start makes of them, W_i = Z_i - c_i h v_n, and the multipliers; with G = A^-1 / h,
//! `V = v_n + G W` and `A = G (V - v_n)`. Nothing large cancels in accelerations then. Step control as in RADAU5 (Hairer,
//! Wanner, Solving Ordinary Differential Equations II, IV.8).
//!
//! Free orientations are integrated in a chart that begins anew with every step, `chart`; with the
//! stabilised index 2 the velocities are on their constraints, too, `stabilised`.

mod chart;
mod coefficients;
mod error;
mod matrices;
mod newton;
mod stabilised;
mod stages;

use super::Statistics;
use super::compensated::{self, Low};
use super::options::{Options, StepSize};
use super::scheme::{Cause, Outcome, Scheme};
use crate::error::SolveErrorKind;
use crate::system::{State, System};
use coefficients::Coefficients;
use error::Estimate;
use matrices::Matrices;
use newton::{Converged, Failure, ITERATIONS, Newton};
use stages::Stages;

/// Relative tolerance of Newton's increments with a fixed step: order 5 should be visible.
const FIXED_STEP_RTOL: f64 = 1e-13;
/// Largest error of a converged iterate, relative to the sizes of the unknowns, at any tolerance: the next
/// step must find its way back to the constraints.
const COARSE: f64 = 1e-4;
/// Contraction above which the next step evaluates the tangent anew.
const AGED: f64 = 0.02;
/// The next step keeps its size, and thus the factorizations, if it would grow by less.
const KEEP: f64 = 1.2;
/// Iterations up to which a step may grow, and contraction up to which it may after more of them.
const EASY: u32 = 5;
const CONTRACTING: f64 = 0.04;
/// After an iteration failed, the next steps stay below this part of the step that failed, and the growth of
/// that limit from step to step.
const BELOW_FAILURE: f64 = 0.7;
const RECOVERY: f64 = 1.05;
/// Bounds of the change of the step.
const SHRINK: f64 = 0.2;
const GROW: f64 = 4.0;
const SAFETY: f64 = 0.9;

/// The method and its last accepted step.
pub(super) struct Radau {
    coefficients: Coefficients,
    fixed: bool,
    matrices: Matrices,
    newton: Newton,
    estimate: Estimate,
    /// Start and end of the last accepted step.
    before: State,
    now: State,
    /// What rounding took from `now`.
    low: Low,
    /// Where the tangent is evaluated.
    middle: State,
    /// Stages of the last accepted step, none after a start.
    last: Option<Stages>,
    trial: Stages,
    /// The tangent was evaluated at `now`, or may serve it.
    tangent: Age,
    /// Step size and error of the last accepted step, for the prediction of the next one.
    accepted: Option<(f64, f64)>,
    /// The last attempt was rejected, or there was none since the start.
    first_or_rejected: bool,
    /// Largest step at which the iteration is trusted, s.
    trusted: f64,
}

/// How far the tangent can be trusted.
#[derive(Clone, Copy, PartialEq)]
enum Age {
    /// Evaluated for this step.
    Fresh,
    /// Of an earlier step, with good contraction.
    Kept,
    /// To be evaluated anew.
    Stale,
}

impl Radau {
    /// The method for `system`.
    pub(super) fn new<S: System + ?Sized>(system: &mut S, options: &Options) -> Self {
        let (n, m) = (system.unknowns(), system.constraints());
        let fixed = matches!(options.step, StepSize::Fixed(_));
        let stabilised = options.stabilised && m > 0;
        let tolerances = if fixed {
            (FIXED_STEP_RTOL, 0.02)
        } else {
            // Far below the error estimate, which is of lower order than the solution.
            (options.rtol, options.rtol.sqrt().min(0.03).min(COARSE / options.rtol))
        };
        let matrices = Matrices::new(system, stabilised);
        Self {
            coefficients: Coefficients::new(),
            fixed,
            newton: Newton::new(system, &matrices, tolerances, fixed, stabilised),
            matrices,
            estimate: Estimate::new(system, options.rtol),
            before: State::of(system, 0.0),
            now: State::of(system, 0.0),
            low: Low::zeros(n),
            middle: State::of(system, 0.0),
            last: None,
            trial: Stages::new(n, m, stabilised),
            tangent: Age::Stale,
            accepted: None,
            first_or_rejected: true,
            trusted: f64::INFINITY,
        }
    }

    /// Converges the stages of a step of size `h`; a tangent of an earlier step gets a second chance.
    fn converge<S: System + ?Sized>(
        &mut self,
        system: &mut S,
        h: f64,
        statistics: &mut Statistics,
    ) -> Result<Converged, (f64, Cause)> {
        loop {
            match &self.last {
                Some(last) => self
                    .trial
                    .extrapolate(&self.coefficients, &self.matrices.chart, last, &self.now, h),
                None => self.trial.predict_first(&self.coefficients, &self.now, h),
            }
            if self.tangent == Age::Stale {
                // One tangent serves all stages: the one in the middle is nearest to them.
                self.trial.differentiate(&self.coefficients, &self.now);
                self.trial.in_chart(&self.coefficients, 1, &self.now, &mut self.middle);
                self.matrices.linearize(system, &self.middle, statistics);
                self.tangent = Age::Fresh;
            }
            if let Err(singular) = self.matrices.factor(&self.coefficients, h, statistics) {
                if self.tangent == Age::Kept {
                    self.tangent = Age::Stale;
                    continue;
                }
                let worst = super::newton::row(singular, self.now.x.len());
                return Err((0.5, Cause::Singular { worst }));
            }
            let (coefficients, matrices) = (&self.coefficients, &mut self.matrices);
            let failure =
                match self
                    .newton
                    .solve(system, coefficients, matrices, &self.now, &mut self.trial, statistics)
                {
                    Ok(converged) => return Ok(converged),
                    Err(failure) => failure,
                };
            self.newton.restart();
            if self.tangent == Age::Kept {
                self.tangent = Age::Stale;
                continue;
            }
            return Err(match failure {
                Failure::Slow { worst, ratio } => (ratio, Cause::Newton { worst }),
                Failure::NotFinite => (0.25, Cause::NotFinite),
            });
        }
    }

    fn error<S: System + ?Sized>(&mut self, system: &mut S, statistics: &mut Statistics) -> f64 {
        let (coefficients, matrices) = (&self.coefficients, &mut self.matrices);
        let (estimate, start, stages) = (&mut self.estimate, &self.now, &self.trial);
        let error = estimate.error(coefficients, matrices, start, stages, statistics);
        if error >= 1.0 && self.first_or_rejected {
            return estimate.filtered(system, coefficients, matrices, start, stages, statistics);
        }
        error
    }

    /// Ratio of the next step by this error and the trend since the last step (Gustafsson).
    fn ratio(&self, h: f64, error: f64, iterations: u32) -> f64 {
        let all = f64::from(2 * ITERATIONS);
        let safety = SAFETY * (1.0 + all) / (f64::from(iterations) + all);
        let mut ratio = safety * error.max(1e-10).powf(-0.25);
        if let Some((last_h, last_error)) = self.accepted
            && error < 1.0
        {
            let trend = (last_error / (error * error).max(1e-20)).powf(0.25);
            ratio = ratio.min(SAFETY * h / last_h * trend);
        }
        ratio.clamp(SHRINK, GROW)
    }

    /// Makes the trial the last accepted step.
    fn accept(&mut self) {
        std::mem::swap(&mut self.before, &mut self.now);
        let (before, now) = (&self.before, &mut self.now);
        let chart = &self.matrices.chart;
        self.trial.stage(&self.coefficients, chart, 2, before, now);
        (now.t, self.low.t) = compensated::sum(before.t, self.low.t, self.trial.h);
        let mut turns = chart.turns().iter().flat_map(|&turn| turn..turn + 3).peekable();
        for i in 0..now.x.len() {
            if turns.next_if_eq(&i).is_none() {
                let (move_by, change) = (self.trial.z[2][i], self.trial.change[2][i]);
                (now.x[i], self.low.x[i]) = compensated::sum(before.x[i], self.low.x[i], move_by);
                (now.v[i], self.low.v[i]) = compensated::sum(before.v[i], self.low.v[i], change);
            }
        }
        now.rebase(chart.turns());
        match &mut self.last {
            Some(last) => std::mem::swap(last, &mut self.trial),
            None => self.last = Some(self.trial.clone()),
        }
        self.first_or_rejected = false;
    }
}

impl Scheme for Radau {
    fn begin<S: System + ?Sized>(
        &mut self,
        _system: &mut S,
        state: &State,
        _h: f64,
        _statistics: &mut Statistics,
    ) -> Result<(), SolveErrorKind> {
        self.now.clone_from(state);
        self.now.rebase(self.matrices.chart.turns());
        self.low.clear();
        self.before.clone_from(&self.now);
        self.last = None;
        self.tangent = Age::Stale;
        self.accepted = None;
        self.first_or_rejected = true;
        self.trusted = f64::INFINITY;
        self.newton.restart();
        Ok(())
    }

    fn attempt<S: System + ?Sized>(&mut self, system: &mut S, h: f64, statistics: &mut Statistics) -> Outcome {
        let converged = match self.converge(system, h, statistics) {
            Ok(converged) => converged,
            Err((ratio, cause)) => {
                self.first_or_rejected = true;
                self.trusted = BELOW_FAILURE * h;
                return Outcome::Rejected { next: ratio * h, cause };
            }
        };
        let error = if self.fixed {
            0.0
        } else {
            self.error(system, statistics)
        };
        if !error.is_finite() {
            self.first_or_rejected = true;
            let cause = Cause::NotFinite;
            return Outcome::Rejected {
                next: SHRINK * h,
                cause,
            };
        }
        let mut ratio = self.ratio(h, error, converged.iterations);
        if error >= 1.0 {
            ratio = if self.last.is_none() { 0.1 } else { ratio.min(SAFETY) };
            self.first_or_rejected = true;
            let cause = Cause::Error;
            return Outcome::Rejected { next: ratio * h, cause };
        }
        let after_rejection = self.first_or_rejected && self.last.is_some();
        self.accept();
        self.accepted = Some((h, error.max(1e-2)));
        self.tangent = if converged.contraction > AGED {
            Age::Stale
        } else {
            Age::Kept
        };
        if after_rejection {
            ratio = ratio.min(1.0);
        }
        // Contraction grows with the step: a longer one must still converge.
        self.trusted *= RECOVERY;
        ratio = ratio.min((self.trusted / h).max(1.0));
        if converged.iterations > EASY {
            ratio = ratio.min((CONTRACTING / converged.contraction.max(1e-3)).max(1.0));
        }
        if self.fixed || self.tangent == Age::Kept && (1.0..=KEEP).contains(&ratio) {
            ratio = 1.0;
        }
        Outcome::Accepted { next: ratio * h }
    }

    fn state(&self) -> &State {
        &self.now
    }

    fn time_rest(&self) -> f64 {
        self.low.t
    }

    fn interpolate(&self, t: f64, out: &mut State) {
        match &self.last {
            Some(last) => last.interpolate(&self.coefficients, &self.matrices.chart, &self.before, t, out),
            None => out.clone_from(&self.now),
        }
    }

    fn worst_error(&self) -> Option<usize> {
        self.estimate.worst()
    }
}
