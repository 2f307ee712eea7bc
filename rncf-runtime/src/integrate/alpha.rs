//! HHT-alpha and generalized-alpha for index 3 (THEORY 7.1, 7.2) with corrected start, step change
//! and velocity (THEORY 10).
//!
//! HHT averages the forces F = f + C_x^T lambda of both ends of a step,
//! `M a_1 = alpha F_0 - (1 + alpha) F_1`. With the true acceleration, `M qdd = -F`, and a constant mass
//! this is `a_1 = (1 + alpha) qdd_1 - alpha qdd_0` with equilibrium `M qdd_1 + F_1 = 0` at the end of
//! the step: generalized-alpha with alpha_m = 0, alpha_f = -alpha. Both run as such, also where the
//! mass depends on the state: averaged accelerations need no second mass matrix.
//!
//! Orientations: the update gives theta in the chart that begins with the step, `v` and `a` are
//! angular velocity and acceleration in body axes (THEORY 7.2). As theta''' = w'' + (w x w') / 2, the
//! local error of theta is h^3 (kappa w'' - (w x w') / 12), and so is the velocity bias.
//!
//! An accepted step is kept free of numerical bias: position, velocity projected onto the
//! constraints, true acceleration, and the distance `a - qdd` per step size. What a step of size h
//! starts from follows from these: `a_0 = qdd + h (a - qdd)/h`, `v_0 = v - kappa h^2 P j`. Start,
//! restart and step change are thereby one and the same. The stabilised index 2 (THEORY 7.4) has both
//! positions and velocities on the constraints and no velocity bias.

use super::bordered::{Bordered, Measure};
use super::charts::Charts;
use super::coefficients::Coefficients;
use super::compensated::{self, Low};
use super::control::{Controller, RETRY};
use super::history::History;
use super::lasting::Lasting;
use super::levers::Levers;
use super::newton::{Failure, Iterate, Newton};
use super::norms::{largest, norm, row};
use super::options::{Options, StepSize};
use super::scheme::{Cause, Outcome, Scheme};
use super::statistics::Statistics;
use crate::archive::{Archive, Keep};
use crate::error::SolveErrorKind;
use crate::linalg::Singular;
use crate::system::{State, System};

/// Tolerance of Newton's increments relative to the sizes of the unknowns with a fixed step, where
/// no error test needs it but orders of convergence should be visible.
const FIXED_STEP_RTOL: f64 = 1e-10;
/// Difference step of the first jerk relative to the first step.
const DIFFERENCE: f64 = 1e-3;

/// A method of the alpha family.
pub(super) struct Alpha {
    coefficients: Coefficients,
    fixed: bool,
    stabilised: bool,
    charts: Charts,
    inverse_weights: Vec<f64>,
    newton: Newton,
    bordered: Bordered,
    controller: Controller,
    history: History,
    /// Last accepted state and the one before.
    now: State,
    before: State,
    /// What rounding took from `now`.
    low: Low,
    /// (a - qdd) / h at `now`.
    offset: Vec<f64>,
    /// Step size, velocity and acceleration as the last step left them; no step size after a start.
    left: Left,
    /// P j at `now`, with what the charts add to the jerk, if known.
    constrained_jerk: Vec<f64>,
    jerk_known: bool,
    /// Jerk at the last start, for the first prediction.
    first_jerk: Vec<f64>,
    trial: Iterate,
    /// a_0 of the attempt.
    a0: Vec<f64>,
    work: Vec<f64>,
}

/// What the last step left, with its numerical bias.
struct Left {
    h: Option<f64>,
    v: Vec<f64>,
    /// What rounding took from `v`.
    low: Vec<f64>,
    a: Vec<f64>,
}

impl Alpha {
    /// The method with the given coefficients for `system`.
    pub(super) fn new(system: &mut dyn System, coefficients: Coefficients, options: &Options) -> Self {
        let (n, m) = (system.unknowns(), system.constraints());
        let zeros = State::of(system, 0.0);
        let fixed = matches!(options.step, StepSize::Fixed(_));
        let rtol = if fixed {
            options.rtol.min(FIXED_STEP_RTOL)
        } else {
            options.rtol
        };
        let mut newton = Newton::new(system, coefficients.factors(), rtol, options.stabilised);
        if fixed {
            newton.bear_noise();
        }
        Self {
            coefficients,
            fixed,
            stabilised: options.stabilised && m > 0,
            charts: Charts::new(system.turns(), system.pattern()),
            inverse_weights: system.sizes().iter().map(|size| 1.0 / (options.rtol * size)).collect(),
            newton,
            bordered: Bordered::new(system),
            controller: Controller::of_second_order(),
            history: History::new(n, m),
            now: zeros.clone(),
            before: zeros.clone(),
            low: Low::zeros(n),
            offset: vec![0.0; n],
            left: Left {
                h: None,
                v: vec![0.0; n],
                low: vec![0.0; n],
                a: vec![0.0; n],
            },
            constrained_jerk: vec![0.0; n],
            jerk_known: false,
            first_jerk: vec![0.0; n],
            trial: Iterate {
                state: zeros,
                low: Low::zeros(n),
                algorithmic: vec![0.0; n],
                levers: Levers::new(system, coefficients),
            },
            a0: vec![0.0; n],
            work: vec![0.0; n],
        }
    }

    /// The same for a run over `span` (s) whose result has the tolerance `rtol`.
    pub(super) fn over(mut self, system: &dyn System, rtol: f64, span: f64) -> Self {
        self.newton.lasts(Lasting::new(system, rtol, span));
        self
    }

    /// Jerk at `now`: difference quotient of consistent accelerations over a small part of `h`, its
    /// constrained part from the third derivative of the constraints.
    fn jerk_at_start(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Result<(), Singular> {
        let dt = DIFFERENCE * h;
        let later = &mut self.trial.state;
        later.t = self.now.t + dt;
        later.turns.clone_from(&self.now.turns);
        for i in 0..self.now.x.len() {
            later.x[i] = self.now.x[i] + dt * (self.now.v[i] + 0.5 * dt * self.now.a[i]);
            later.v[i] = self.now.v[i] + dt * self.now.a[i];
        }
        self.bordered.move_to(system, later);
        self.bordered.accelerations(system, later, statistics)?;
        for i in 0..self.now.x.len() {
            self.first_jerk[i] = (later.a[i] - self.now.a[i]) / dt;
        }
        self.bordered.move_to(system, &self.now);
        let (jerk, change) = (&mut self.first_jerk, &mut self.work);
        self.bordered
            .constrain_jerk(system, &self.now, jerk, change, statistics)
    }

    /// Velocity and acceleration from which a step of size `h` starts: into the trial's velocity and `a0`.
    fn prepare(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Result<(), Singular> {
        if self.left.h == Some(h) {
            self.trial.state.v.copy_from_slice(&self.left.v);
            self.trial.low.v.copy_from_slice(&self.left.low);
            self.a0.copy_from_slice(&self.left.a);
            let Iterate { state, levers, .. } = &mut self.trial;
            levers.prepare(&self.now, &state.v, h, true);
            return Ok(());
        }
        let kappa = self.coefficients.kappa();
        if !self.jerk_known && !self.stabilised {
            // The border is at `now` since the last accepted step.
            self.charts.curvature(1.0 / (12.0 * kappa), &self.now, &mut self.work);
            let (other, out) = (&self.work, &mut self.constrained_jerk);
            let measure = Measure {
                factor: kappa * h.powi(3),
                inverse_weights: &self.inverse_weights,
            };
            self.bordered
                .constrained_jerk(system, &self.now, other, &measure, out, statistics)?;
            self.jerk_known = true;
        }
        let bias = if self.stabilised { 0.0 } else { kappa * h * h };
        for i in 0..self.a0.len() {
            self.a0[i] = self.now.a[i] + h * self.offset[i];
            let start = -bias * self.constrained_jerk[i];
            (self.trial.state.v[i], self.trial.low.v[i]) = compensated::sum(self.now.v[i], self.low.v[i], start);
        }
        let Iterate { state, levers, .. } = &mut self.trial;
        levers.prepare(&self.now, &state.v, h, false);
        Ok(())
    }

    /// Predicts the end of a step of size `h` from what [`Alpha::prepare`] left.
    fn predict(&mut self, h: f64) {
        let Coefficients {
            alpha_m,
            alpha_f,
            beta,
            gamma,
        } = self.coefficients;
        let Iterate {
            state,
            low,
            algorithmic,
            levers,
        } = &mut self.trial;
        (state.t, low.t) = compensated::sum(self.now.t, self.low.t, h);
        state.turns.clone_from(&self.now.turns);
        if !self.history.extrapolate(&self.now, state) {
            state.lambda.copy_from_slice(&self.now.lambda);
            for i in 0..state.a.len() {
                state.a[i] = self.now.a[i] + h * self.first_jerk[i];
            }
        }
        let n = state.a.len();
        let (a, a0, known) = (&state.a[..n], &self.a0[..n], &self.now.a[..n]);
        let ends = &mut algorithmic[..n];
        for i in 0..n {
            ends[i] = ((1.0 - alpha_f) * a[i] + alpha_f * known[i] - alpha_m * a0[i]) / (1.0 - alpha_m);
        }
        let (x, low_x, v, low_v) = (&mut state.x[..n], &mut low.x[..n], &mut state.v[..n], &mut low.v[..n]);
        let (from, low_from) = (&self.now.x[..n], &self.low.x[..n]);
        for i in 0..n {
            let change = h * (v[i] + h * ((0.5 - beta) * a0[i] + beta * ends[i]));
            (x[i], low_x[i]) = compensated::sum(from[i], low_from[i], change);
            let change = h * ((1.0 - gamma) * a0[i] + gamma * ends[i]);
            (v[i], low_v[i]) = compensated::sum(v[i], low_v[i], change);
        }
        levers.predict();
        levers.correct(h, state, low);
    }

    /// Converges the end of a step of size `h`; a matrix of an earlier step gets a second chance.
    fn converge(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Result<(), Cause> {
        let mut patiently = false;
        loop {
            self.prepare(system, h, statistics)
                .map_err(|singular| Cause::Singular {
                    worst: row(singular, self.a0.len()),
                })?;
            self.predict(h);
            let (newton, trial) = (&mut self.newton, &mut self.trial);
            let solved = if patiently {
                newton.solve_patiently(system, &self.now, h, trial, statistics)
            } else {
                newton.solve(system, &self.now, h, trial, statistics)
            };
            match solved {
                Ok(()) => return Ok(()),
                Err(Failure::OldMatrix) => self.newton.discard(),
                // A fixed step is not shortened.
                Err(Failure::Failed(Cause::Newton { .. })) if self.fixed && !patiently => patiently = true,
                Err(Failure::Failed(cause)) => {
                    self.newton.discard();
                    return Err(cause);
                }
            }
        }
    }

    /// Weighted local error of the attempt.
    fn error(&mut self, h: f64) -> f64 {
        let factor = self.coefficients.kappa() * h * h;
        self.charts.curvature(-h * h * h / 12.0, &self.now, &mut self.work);
        for i in 0..self.work.len() {
            self.work[i] += factor * (self.trial.algorithmic[i] - self.a0[i]);
        }
        norm(&self.work, &self.inverse_weights)
    }

    /// Makes the trial the last accepted state, its velocity free of bias.
    fn accept(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Result<(), Singular> {
        let Iterate {
            state,
            low,
            algorithmic,
            levers,
        } = &mut self.trial;
        levers.accept(h, state);
        self.left.low.copy_from_slice(&low.v);
        self.left.v.copy_from_slice(&state.v);
        if !self.stabilised && !state.lambda.is_empty() {
            self.bordered.approach(system, state);
            let measure = Measure {
                factor: h,
                inverse_weights: &self.inverse_weights,
            };
            let change = &mut self.work;
            let changed = self
                .bordered
                .velocity_change(system, state, Some(&measure), change, statistics);
            if let Err(singular) = changed {
                self.bordered.approach(system, &self.now);
                self.left.h = None;
                return Err(singular);
            }
            compensated::add_multiple(&mut state.v, &mut low.v, 1.0, change);
        }
        state.rebase(self.charts.turns());
        low.rebase(self.charts.turns());
        std::mem::swap(&mut self.low, low);
        self.left.h = Some(h);
        self.left.a.copy_from_slice(algorithmic);
        for i in 0..self.offset.len() {
            self.offset[i] = (algorithmic[i] - state.a[i]) / h;
        }
        self.history.remember(&self.now, state, &self.inverse_weights);
        std::mem::swap(&mut self.before, &mut self.now);
        std::mem::swap(&mut self.now, state);
        self.jerk_known = false;
        Ok(())
    }
}

/// What is known between two steps.
impl Keep for Alpha {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            coefficients: _,
            fixed: _,
            stabilised: _,
            charts: _,
            inverse_weights: _,
            newton,
            bordered: _,
            controller,
            history,
            now,
            before,
            low,
            offset,
            left: Left { h, v, low: left_low, a },
            constrained_jerk: _,
            jerk_known: _,
            first_jerk,
            trial,
            a0: _,
            work: _,
        } = self;
        newton.keep(archive);
        controller.keep(archive);
        history.keep(archive);
        now.keep(archive);
        before.keep(archive);
        low.keep(archive);
        h.keep(archive);
        trial.levers.keep(archive);
        for values in [offset, v, left_low, a, first_jerk] {
            archive.fixed(values);
        }
    }
}

impl Scheme for Alpha {
    fn begin(
        &mut self,
        system: &mut dyn System,
        state: &State,
        h: f64,
        statistics: &mut Statistics,
    ) -> Result<(), SolveErrorKind> {
        self.now.clone_from(state);
        self.now.rebase(self.charts.turns());
        self.low.clear();
        self.before.clone_from(&self.now);
        self.history.restart();
        self.controller.restart();
        self.newton.discard();
        self.left.h = None;
        self.jerk_known = false;
        self.jerk_at_start(system, h, statistics)
            .map_err(|_| SolveErrorKind::Singular)?;
        if !self.first_jerk.iter().all(|j| j.is_finite()) {
            return Err(SolveErrorKind::NotFinite);
        }
        // The jerk of a stiff mode that starts off its quiet motion is no guide over a whole step.
        self.newton
            .filter(system, h, &self.now, &mut self.first_jerk, statistics)
            .map_err(|failure| match failure {
                Failure::Failed(Cause::NotFinite) => SolveErrorKind::NotFinite,
                _ => SolveErrorKind::Singular,
            })?;
        let shift = self.coefficients.shift();
        for i in 0..self.offset.len() {
            self.offset[i] = shift * self.first_jerk[i];
        }
        let dt = DIFFERENCE * h;
        let later = &mut self.trial.state;
        for i in 0..self.offset.len() {
            later.x[i] = self.now.x[i] + dt * self.now.v[i];
            later.v[i] = self.now.v[i] + dt * self.now.a[i];
            later.a[i] = self.now.a[i] + dt * self.first_jerk[i];
        }
        self.trial.levers.begin(&self.now, &self.trial.state, dt);
        Ok(())
    }

    fn attempt(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Outcome {
        let failed = |controller: &mut Controller, cause| Outcome::Rejected {
            next: controller.failed(h, RETRY),
            cause,
        };
        if let Err(cause) = self.converge(system, h, statistics) {
            return failed(&mut self.controller, cause);
        }
        let error = if self.fixed { 0.0 } else { self.error(h) };
        if !error.is_finite() {
            return failed(&mut self.controller, Cause::NotFinite);
        }
        if error > 1.0 {
            return Outcome::Rejected {
                next: self.controller.reject(h, error),
                cause: Cause::Error,
            };
        }
        if let Err(singular) = self.accept(system, h, statistics) {
            let worst = row(singular, self.a0.len());
            return failed(&mut self.controller, Cause::Singular { worst });
        }
        let next = if self.fixed {
            h
        } else {
            self.controller.accept(h, error)
        };
        Outcome::Accepted { next }
    }

    fn take_up(&mut self, system: &mut dyn System) {
        self.bordered.approach(system, &self.now);
    }

    fn state(&self) -> &State {
        &self.now
    }

    fn time_rest(&self) -> f64 {
        self.low.t
    }

    fn interpolate(&self, t: f64, out: &mut State) {
        super::dense::hermite(&self.before, &self.now, self.charts.turns(), t, out);
    }

    fn worst_error(&self) -> Option<usize> {
        // `work` holds the local error since the attempt failed its test.
        largest(&self.work, &self.inverse_weights)
    }
}
