//! Radau IIA with S stages, order 2 S - 1 (THEORY 7.5), for second-order systems with index-3
//! constraints: three, five or seven. The unknowns of a step are the S increments of position Z_i = X_i - x_n, less what
//! the velocity at the start makes of them, W_i = Z_i - c_i h v_n, and the multipliers; with G = A^-1 / h,
//! `V = v_n + G W` and `A = G (V - v_n)`. Nothing large cancels in accelerations then. Step control as in RADAU5 (Hairer,
//! Wanner, Solving Ordinary Differential Equations II, IV.8).
//!
//! Free orientations are integrated in a chart that begins anew with every step, `chart`; with the
//! stabilised index 2 the velocities are on their constraints, too, `stabilised`.

mod between;
mod chart;
mod coefficients;
mod error;
mod matrices;
mod newton;
mod stabilised;
mod stages;

use super::compensated::{self, Low};
use super::control::Controller;
use super::lasting::Lasting;
use super::options::{Options, StepSize};
use super::scheme::{Cause, Outcome, Scheme};
use super::statistics::Statistics;
use crate::archive::{Archive, Keep};
use crate::error::SolveErrorKind;
use crate::system::{State, System};
use between::Between;
use coefficients::Coefficients;
use error::Estimate;
use matrices::Matrices;
use newton::{Converged, Failure, Newton};
use stages::Stages;

/// Relative tolerance of Newton's increments with a fixed step: order 5 should be visible.
const FIXED_STEP_RTOL: f64 = 1e-13;
/// Largest error of a converged iterate, relative to the sizes of the unknowns, at any tolerance: the next
/// step must find its way back to the constraints.
const COARSE: f64 = 1e-6;
/// What the error estimate with three stages multiplies remainders of the iteration by.
const MULTIPLIED: f64 = 11.76;
/// Part of the remainders where bodies turn in the axes of their unknowns: a kept matrix grows old by the turn, what it leaves has one sign step after
/// step, and drives vibrations of stiff elements faster than the method damps them.
const TURNING: f64 = 0.1;
/// Roots of the tolerance by which polynomials through multipliers may differ that are kept between the ends of steps.
const MISSED: f64 = 0.03;
/// Contraction above which the next step evaluates the tangent anew.
const AGED: f64 = 0.02;
/// Iterations up to which a step may grow, and contraction up to which it may after more of them.
const EASY: u32 = 5;
const CONTRACTING: f64 = 0.04;
/// Largest growth from one step to the next.
const GROWTH: f64 = 4.0;
/// Part of the way that a proposed step rises.
const RELEASE: f64 = 0.3;
/// Ratio of the next attempt to one whose error is not finite, and to a first one whose error is too large.
const RETRY: f64 = 0.2;
const FIRST_RETRY: f64 = 0.1;

/// The method and its last accepted step.
pub(super) struct Radau<const S: usize> {
    coefficients: Coefficients<S>,
    fixed: bool,
    matrices: Matrices<S>,
    newton: Newton<S>,
    estimate: Estimate,
    /// Start and end of the last accepted step.
    before: State,
    now: State,
    /// What rounding took from `now`.
    low: Low,
    /// Where the tangent is evaluated.
    middle: State,
    /// Multipliers within the last accepted step, once they are asked for.
    between: Option<Between>,
    /// Part of the multipliers that interpolation may miss.
    missed: f64,
    /// Stages of the last accepted step, none after a start.
    last: Option<Stages<S>>,
    trial: Stages<S>,
    /// The tangent was evaluated at `now`, or may serve it.
    tangent: Age,
    controller: Controller,
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

impl<const S: usize> Radau<S> {
    /// The method for a run of `system` over `span`, s.
    pub(super) fn new(system: &mut dyn System, options: &Options, span: f64) -> Self {
        let (n, m) = (system.unknowns(), system.constraints());
        let fixed = matches!(options.step, StepSize::Fixed(_));
        let stabilised = options.stabilised && m > 0;
        let coefficients = Coefficients::new();
        let tolerances = if fixed {
            (FIXED_STEP_RTOL, 0.02)
        } else {
            // Far below the error estimate, which is of lower order than the solution, and multiplies what is left.
            let most = options.rtol.sqrt().min(0.03).min(COARSE / options.rtol);
            let most = if system.turns_in_unknowns() {
                TURNING * most
            } else {
                most
            };
            let multiplied: f64 = coefficients.embedded.iter().map(|weight| weight.abs()).sum();
            (options.rtol, most * (MULTIPLIED / multiplied))
        };
        let matrices = Matrices::new(system, stabilised);
        // A fixed step is iterated down to round-off anyway.
        let lasting = Lasting::new(system, options.rtol, if fixed { 0.0 } else { span });
        Self {
            coefficients,
            fixed,
            newton: Newton::new(system, &matrices, tolerances, lasting, fixed, stabilised),
            matrices,
            estimate: Estimate::new(system, options.rtol),
            before: State::of(system, 0.0),
            now: State::of(system, 0.0),
            low: Low::zeros(n),
            middle: State::of(system, 0.0),
            between: None,
            missed: MISSED * options.rtol.sqrt(),
            last: None,
            trial: Stages::new(n, m, stabilised),
            tangent: Age::Stale,
            // The local error estimate is of the order of the stages and one.
            controller: Controller::new(S as f64 + 1.0, GROWTH, RELEASE),
        }
    }

    /// Converges the stages of a step of size `h`; a tangent of an earlier step gets a second chance.
    fn converge(
        &mut self,
        system: &mut dyn System,
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
                self.trial
                    .in_chart(&self.coefficients, S / 2, &self.now, &mut self.middle);
                self.matrices.linearize(system, &self.middle, statistics);
                self.tangent = Age::Fresh;
            }
            if let Err(singular) = self.matrices.factor(&self.coefficients, h, statistics) {
                if self.tangent == Age::Kept {
                    self.tangent = Age::Stale;
                    continue;
                }
                // A shorter step has another middle, which may be where forces have values.
                self.tangent = Age::Stale;
                let worst = super::norms::row(singular, self.now.x.len());
                return Err(match self.matrices.is_finite() {
                    true => (0.5, Cause::Singular { worst }),
                    false => (0.25, Cause::NotFinite),
                });
            }
            let (coefficients, matrices) = (&self.coefficients, &mut self.matrices);
            let (is_fresh, stages) = (self.tangent == Age::Fresh, &mut self.trial);
            let failure = match self.newton.solve(
                system,
                coefficients,
                matrices,
                (&self.now, is_fresh),
                stages,
                statistics,
            ) {
                Ok(converged) => return Ok(converged),
                Err(failure) => failure,
            };
            self.newton.restart();
            // The middle of a shorter step is elsewhere, too: a frame may have turned by a radian to that of this one.
            let is_kept = std::mem::replace(&mut self.tangent, Age::Stale) == Age::Kept;
            if is_kept {
                continue;
            }
            return Err(match failure {
                Failure::Slow { worst, ratio } => (ratio, Cause::Newton { worst }),
                Failure::NotFinite => (0.25, Cause::NotFinite),
            });
        }
    }

    fn error(&mut self, system: &mut dyn System, statistics: &mut Statistics) -> f64 {
        let (coefficients, matrices) = (&self.coefficients, &mut self.matrices);
        let (estimate, start, stages) = (&mut self.estimate, &self.now, &self.trial);
        let error = estimate.error(coefficients, matrices, start, stages, statistics);
        if error >= 1.0 && self.controller.is_new() {
            return estimate.filtered(system, coefficients, matrices, start, stages, statistics);
        }
        error
    }

    /// Makes the trial the last accepted step.
    fn accept(&mut self) {
        std::mem::swap(&mut self.before, &mut self.now);
        let (before, now) = (&self.before, &mut self.now);
        let chart = &self.matrices.chart;
        self.trial.stage(&self.coefficients, chart, S - 1, before, now);
        (now.t, self.low.t) = compensated::sum(before.t, self.low.t, self.trial.h);
        let mut turns = chart.turns().iter().flat_map(|&turn| turn..turn + 3).peekable();
        for i in 0..now.x.len() {
            if turns.next_if_eq(&i).is_none() {
                let (move_by, change) = (self.trial.z[S - 1][i], self.trial.change[S - 1][i]);
                (now.x[i], self.low.x[i]) = compensated::sum(before.x[i], self.low.x[i], move_by);
                (now.v[i], self.low.v[i]) = compensated::sum(before.v[i], self.low.v[i], change);
            }
        }
        now.rebase(chart.turns());
        match &mut self.last {
            Some(last) => std::mem::swap(last, &mut self.trial),
            None => self.last = Some(self.trial.clone()),
        }
    }
}

/// What is known between two steps.
impl<const S: usize> Keep for Radau<S> {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            coefficients: _,
            fixed: _,
            matrices: _,
            newton,
            estimate,
            before,
            now,
            low,
            middle: _,
            between: _,
            missed: _,
            last,
            trial,
            tangent: _,
            controller,
        } = self;
        newton.keep(archive);
        estimate.keep(archive);
        before.keep(archive);
        now.keep(archive);
        low.keep(archive);
        let mut is_behind_a_step = last.is_some();
        is_behind_a_step.keep(archive);
        if archive.is_reading() {
            *last = is_behind_a_step.then(|| trial.clone());
        }
        if let Some(last) = last {
            last.keep(archive);
        }
        controller.keep(archive);
    }
}

impl<const S: usize> Scheme for Radau<S> {
    fn begin(
        &mut self,
        _system: &mut dyn System,
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
        self.controller.restart();
        self.newton.restart();
        Ok(())
    }

    fn attempt(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Outcome {
        let converged = match self.converge(system, h, statistics) {
            Ok(converged) => converged,
            Err((ratio, cause)) => {
                let next = self.controller.failed(h, ratio);
                return Outcome::Rejected { next, cause };
            }
        };
        let error = if self.fixed {
            0.0
        } else {
            self.error(system, statistics)
        };
        if !error.is_finite() {
            let next = self.controller.failed(h, RETRY);
            let cause = Cause::NotFinite;
            return Outcome::Rejected { next, cause };
        }
        if error > 1.0 {
            // The middle of a shorter step is elsewhere. Steps of three stages are short enough for the old one to be tried.
            self.tangent = if S > 3 && self.controller.is_new() {
                Age::Stale
            } else {
                Age::Kept
            };
            let mut next = self.controller.reject(h, error);
            if self.last.is_none() {
                next = FIRST_RETRY * h;
            }
            let cause = Cause::Error;
            return Outcome::Rejected { next, cause };
        }
        self.estimate.accepted(h);
        self.accept();
        self.tangent = if converged.contraction > AGED || converged.is_slow {
            Age::Stale
        } else {
            Age::Kept
        };
        if self.fixed {
            return Outcome::Accepted { next: h };
        }
        let mut next = self.controller.accept(h, error);
        // Contraction grows with the step: a longer one must still converge.
        if converged.iterations > EASY {
            next = next.min((CONTRACTING / converged.contraction.max(1e-3)).max(1.0) * h);
        }
        Outcome::Accepted { next }
    }

    fn take_up(&mut self, _system: &mut dyn System) {}

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

    fn inside(&self) -> &[f64] {
        &self.coefficients.nodes[..S - 1]
    }

    fn linearized(&self) -> Option<&State> {
        Some(&self.middle)
    }

    fn balance(&mut self, system: &mut dyn System, state: &mut State) {
        if let Some(last) = &self.last
            && last.misses_multipliers(&self.coefficients, &self.before, state, self.missed)
            && system.reads_multipliers()
        {
            let between = self.between.get_or_insert_with(|| Between::new(system));
            between.balance(system, self.coefficients.real / last.h, state);
        }
    }

    fn worst_error(&self) -> Option<usize> {
        self.estimate.worst()
    }
}
