//! Energy-momentum integration: second order, for models that conserve energy and have a constant mass.
//!
//! ```text
//! M (v1 - v0) / h + F(q0, q1) = 0,   (q1 - q0) / h = (v0 + v1) / 2
//! ```
//!
//! with a force that does the work `F (q1 - q0) = U(q1) - U(q0)` ([`crate::system::Conserving`]). Multiplied by
//! `q1 - q0 = h (v0 + v1) / 2` the first equation says that kinetic energy and potential exchange exactly what the other
//! takes, at every size of the step; and since F has no resultant, momentum and angular momentum stay:
//! `q1 x M v1 - q0 x M v0 = q_m x M (v1 - v0) + (q1 - q0) x M v_m`, where the last term vanishes as M couples vectors and
//! not components. Newton's iteration goes on to round-off.
//!
//! With the acceleration `a = (v1 - v0) / h` of the step, `q1 = q0 + h v0 + h^2 a / 2`: one unknown for each equation.
//!
//! The local error of positions is that of the trapezoidal rule, `h^2 (a1 - a0) / 12` with the true accelerations of both
//! ends.

mod newton;

use super::bordered::Bordered;
use super::charts::Charts;
use super::compensated::{self, Low};
use super::control::{Controller, RETRY};
use super::norms::{largest, norm, row};
use super::options::{Options, StepSize};
use super::scheme::{Cause, Outcome, Scheme};
use super::statistics::Statistics;
use crate::archive::{Archive, Keep};
use crate::error::SolveErrorKind;
use crate::linalg::Singular;
use crate::system::{State, System};
use newton::{Newton, Trial};

/// Most iterations of a step, and of one that starts from uniform motion.
const ITERATIONS: u32 = 16;
const PATIENT_ITERATIONS: u32 = 60;

/// The method.
pub(super) struct EnergyMomentum {
    fixed: bool,
    stabilised: bool,
    charts: Charts,
    inverse_weights: Vec<f64>,
    newton: Newton,
    bordered: Bordered,
    controller: Controller,
    /// First unknown of what is carried along without inertia.
    carried: usize,
    /// Last accepted state and the one before.
    now: State,
    before: State,
    /// What rounding took from `now`.
    low: Low,
    /// Rate of the accelerations over the last step; zero after a start.
    jerk: Vec<f64>,
    trial: Trial,
    work: Vec<f64>,
}

impl EnergyMomentum {
    /// The method for `system`.
    pub(super) fn new(system: &mut dyn System, options: &Options) -> Self {
        let n = system.unknowns();
        let zeros = State::of(system, 0.0);
        Self {
            fixed: matches!(options.step, StepSize::Fixed(_)),
            stabilised: options.stabilised,
            charts: Charts::new(system.turns(), system.pattern()),
            inverse_weights: system.sizes().iter().map(|size| 1.0 / (options.rtol * size)).collect(),
            newton: Newton::new(system),
            bordered: Bordered::new(system),
            controller: Controller::of_second_order(),
            carried: n - system.border(),
            now: zeros.clone(),
            before: zeros.clone(),
            low: Low::zeros(n),
            jerk: vec![0.0; n],
            trial: Trial {
                state: zeros,
                low: Low::zeros(n),
            },
            work: vec![0.0; n],
        }
    }

    /// Predicts the end of a step of size `h` by the last rate of the accelerations, or with the velocity alone.
    fn predict(&mut self, h: f64, uniformly: bool) {
        let Trial { state, low } = &mut self.trial;
        (state.t, low.t) = compensated::sum(self.now.t, self.low.t, h);
        state.turns.clone_from(&self.now.turns);
        state.lambda.copy_from_slice(&self.now.lambda);
        for i in 0..state.a.len() {
            state.a[i] = if uniformly {
                0.0
            } else {
                self.now.a[i] + 0.5 * h * self.jerk[i]
            };
        }
        self.newton.place(h, &self.now, &self.low, &mut self.trial);
    }

    /// Solves the step of size `h`. Where stiff motions move that it does not resolve, the accelerations at its start are no
    /// guide: then once more from uniform motion.
    fn solve(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Result<(), Cause> {
        self.predict(h, false);
        let start = (&self.now, &self.low);
        let solved = self
            .newton
            .solve(system, h, start, &mut self.trial, ITERATIONS, statistics);
        if !matches!(solved, Err(Cause::Newton { .. })) {
            return solved;
        }
        self.predict(h, true);
        self.newton.discard();
        let start = (&self.now, &self.low);
        self.newton
            .solve(system, h, start, &mut self.trial, PATIENT_ITERATIONS, statistics)
    }

    /// Puts the true accelerations of its end into the trial, and the velocities of what is carried along.
    fn complete(&mut self, system: &mut dyn System, statistics: &mut Statistics) -> Result<(), Singular> {
        let state = &mut self.trial.state;
        // Without constraints the matrix is the mass, which is constant.
        if !state.lambda.is_empty() {
            self.bordered.move_to(system, state);
        }
        if self.carried < state.v.len() {
            // Of least mass: what has inertia keeps its velocity but for round-off, which it must not feel.
            let change = &mut self.work;
            self.bordered.velocity_change(system, state, None, change, statistics)?;
            for (v, change) in state.v[self.carried..].iter_mut().zip(&change[self.carried..]) {
                *v += change;
            }
        }
        self.bordered.accelerations(system, state, statistics)
    }

    /// Weighted local error of the completed trial.
    fn error(&mut self, h: f64) -> f64 {
        let factor = h * h / 12.0;
        for (i, error) in self.work.iter_mut().enumerate() {
            *error = factor * (self.trial.state.a[i] - self.now.a[i]);
        }
        norm(&self.work, &self.inverse_weights)
    }

    /// Makes the trial the last accepted state.
    fn accept(&mut self, h: f64) {
        let Trial { state, low } = &mut self.trial;
        for (i, jerk) in self.jerk.iter_mut().enumerate() {
            *jerk = (state.a[i] - self.now.a[i]) / h;
        }
        state.rebase(self.charts.turns());
        low.rebase(self.charts.turns());
        low.v[self.carried..].fill(0.0);
        std::mem::swap(&mut self.low, low);
        std::mem::swap(&mut self.before, &mut self.now);
        std::mem::swap(&mut self.now, state);
    }
}

/// What is known between two steps.
impl Keep for EnergyMomentum {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            fixed: _,
            stabilised: _,
            charts: _,
            inverse_weights: _,
            newton: _,
            bordered: _,
            controller,
            carried: _,
            now,
            before,
            low,
            jerk,
            trial: _,
            work: _,
        } = self;
        controller.keep(archive);
        now.keep(archive);
        before.keep(archive);
        low.keep(archive);
        archive.fixed(jerk);
    }
}

impl Scheme for EnergyMomentum {
    fn begin(
        &mut self,
        system: &mut dyn System,
        state: &State,
        _h: f64,
        _statistics: &mut Statistics,
    ) -> Result<(), SolveErrorKind> {
        if let Err(text) = system.conserving() {
            return Err(SolveErrorKind::Setting(text));
        }
        if self.stabilised && system.constraints() > 0 {
            let text = "energy-momentum integration keeps positions alone on the constraints: leave `stabilised` away";
            return Err(SolveErrorKind::Setting(text.to_string()));
        }
        self.now.clone_from(state);
        self.now.rebase(self.charts.turns());
        self.before.clone_from(&self.now);
        self.low.clear();
        self.jerk.fill(0.0);
        self.controller.restart();
        self.newton.discard();
        self.bordered.move_to(system, &self.now);
        Ok(())
    }

    fn attempt(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Outcome {
        let failed = |controller: &mut Controller, cause| Outcome::Rejected {
            next: controller.failed(h, RETRY),
            cause,
        };
        if let Err(cause) = self.solve(system, h, statistics) {
            self.newton.discard();
            return failed(&mut self.controller, cause);
        }
        if let Err(singular) = self.complete(system, statistics) {
            let worst = row(singular, self.work.len());
            return failed(&mut self.controller, Cause::Singular { worst });
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
        self.accept(h);
        let next = if self.fixed {
            h
        } else {
            self.controller.accept(h, error)
        };
        Outcome::Accepted { next }
    }

    fn take_up(&mut self, system: &mut dyn System) {
        self.bordered.move_to(system, &self.now);
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
