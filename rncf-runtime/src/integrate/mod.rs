//! Time integration of a [`System`]: HHT, generalized-alpha, Radau IIA and energy-momentum integration.
//!
//! The driver ([`Integrator`]) owns the time axis: limits, kinks, the end, and the counts of
//! steps. A method (`scheme::Scheme`) tries one step at a time.

mod alpha;
mod anderson;
mod bordered;
mod charts;
mod compensated;
mod consistent;
mod control;
mod dense;
mod diagnose;
mod energy;
mod history;
mod lasting;
mod newton;
mod noise;
mod options;
mod radau;
mod renewal;
mod scheme;
mod segments;
mod stabiliser;
mod start;
mod statistics;
mod switches;
mod watch;

#[cfg(test)]
mod tests;

pub use options::{Method, Options, StepSize};
pub use statistics::Statistics;

use crate::archive::{Archive, Keep};
use crate::error::{SolveError, SolveErrorKind};
use crate::linalg::Singular;
use crate::system::{ConstraintLevel, State, System};
use alpha::{Alpha, Coefficients};
use bordered::{Bordered, add};
use consistent::Inconsistent;
use energy::EnergyMomentum;
use radau::Radau;
use renewal::Renewal;
use scheme::{Cause, Outcome, Scheme};
use segments::Segments;
use switches::Switches;
use watch::{Trouble, Watch};

/// Switches are looked for so many steps ahead: the last two before one share what is left.
const AHEAD: f64 = 2.0;
/// A step within this part of the ceiling is at the ceiling.
const AT_CEILING: f64 = 0.99;

/// Steps after which it is looked whether something moves faster than light.
const LIGHT: u64 = 16;
/// Where to look when a motion grows without end.
const CAUSES: &str = "look for a damper or load with the wrong sign, or a load that is far too large";

/// Why [`Integrator::step`] came back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// One step was accepted.
    Step,
    /// A step was accepted that ends at a kink of a motion or load.
    Kink,
    /// The end time is reached.
    End,
}

/// Advances a system from a consistent initial state to an end time.
pub struct Integrator<'s, S: System + ?Sized> {
    system: &'s mut S,
    method: Method,
    scheme: Running,
    options: Options,
    segments: Segments,
    switches: Switches,
    bordered: Bordered,
    /// Step that the next attempt would like to take, s.
    wanted: f64,
    /// The last step ended at a kink: begin anew behind it.
    at_kink: bool,
    previous_time: f64,
    statistics: Statistics,
    watch: Watch,
    /// Memory for constraint values.
    violations: Vec<f64>,
    renewal: Renewal,
}

/// The method that runs.
enum Running {
    Alpha(Box<Alpha>),
    Radau(Box<Radau>),
    Energy(Box<EnergyMomentum>),
}

impl<'s, S: System + ?Sized> Integrator<'s, S> {
    /// Makes the initial accelerations and multipliers consistent and prepares the method.
    ///
    /// Time, positions, orientations and velocities of `start` are used. A start at a kink counts as
    /// behind it. Positions and velocities that are slightly off the constraints are put onto them,
    /// see [`Statistics::position_correction`].
    ///
    /// # Errors
    /// A setting out of range, a method without dissipation on constraints of index 3, a state of the
    /// wrong length, positions or velocities that violate a constraint by more than that, constraints
    /// that depend on each other, a motion that has neither inertia nor a tie, or a singular matrix.
    pub fn new(
        system: &'s mut S,
        start: State,
        t_end: f64,
        method: Method,
        options: Options,
    ) -> Result<Self, SolveError> {
        let t0 = start.t;
        let fail = |kind, worst| SolveError {
            kind,
            t: t0,
            h: 0.0,
            worst,
        };
        start::check_settings(t0, t_end, method, &options).map_err(|kind| fail(kind, None))?;
        let options = Options {
            rtol: options.local_tolerance(method),
            ..options
        };
        let m = system.constraints();
        start::check_dissipation(m, method, &options).map_err(|kind| fail(kind, None))?;
        let mut switches = Switches::default();
        let mut kinks = system.kinks();
        if switches.is_at(t0, |t, out| system.gaps(t, out)) {
            kinks.push(t0);
        }
        let segments = Segments::new(t0, t_end, &kinks);
        let mut state = sized(system, start, segments.start()).map_err(|kind| fail(kind, None))?;
        let mut statistics = Statistics::default();
        prepare(system, &mut state, t_end - t0, &mut statistics).map_err(|(kind, worst)| fail(kind, worst))?;
        refuse_jumps(system, &state, &segments)?;
        let mut integrator = Self {
            bordered: Bordered::new(system),
            scheme: Running::new(system, method, &options, t_end - t0),
            renewal: Renewal::new(options.renewal(system.unknowns())),
            system,
            method,
            options,
            segments,
            switches,
            wanted: 0.0,
            at_kink: false,
            previous_time: state.t,
            statistics,
            watch: Watch::default(),
            violations: vec![0.0; m],
        };
        integrator.begin(state)?;
        Ok(integrator)
    }

    /// Advances by one accepted step.
    ///
    /// At the end time it returns [`Stop::End`] without a step.
    ///
    /// # Errors
    /// The reason, with the last good state untouched in [`Integrator::state`].
    pub fn step(&mut self) -> Result<Stop, SolveError> {
        if self.at_kink {
            self.restart()?;
        }
        let (t, low) = (self.state().t, self.scheme.time_rest());
        if self.segments.is_at_end(t) {
            return Ok(Stop::End);
        }
        let fixed = matches!(self.options.step, StepSize::Fixed(_));
        loop {
            let limited = self.wanted.min(self.options.max_step);
            let mut h = self.segments.fit((t, low), limited, fixed, self.options.max_step);
            if self.finds_kink(t, h) {
                h = self.segments.fit((t, low), limited, fixed, self.options.max_step);
            }
            match self.scheme.attempt(self.system, h, &mut self.statistics) {
                Outcome::Accepted { next } => {
                    // A step cut short by a kink or the end says little about the next one.
                    self.wanted = if next >= h { next.max(limited) } else { next };
                    let stop = self.accepted(t, h);
                    if let Some(error) = self.trouble(stop, h, fixed) {
                        return Err(error);
                    }
                    if stop != Stop::End && self.renewal.is_due(&self.statistics) {
                        self.renew();
                    }
                    return Ok(stop);
                }
                Outcome::Rejected { next, cause } => {
                    self.count_rejection(&cause);
                    if fixed || next < self.segments.smallest_step(t) {
                        return Err(self.rejection_error(t, h, cause));
                    }
                    self.wanted = next;
                }
            }
        }
    }

    /// State at the end of the last accepted step (true accelerations, not algorithmic ones).
    pub fn state(&self) -> &State {
        self.scheme.state()
    }

    /// Start of the last accepted step, s; equal to the time of [`Integrator::state`] before the first.
    pub fn previous_time(&self) -> f64 {
        self.previous_time
    }

    /// State at `t` within the last accepted step by the method's dense output.
    pub fn interpolate(&self, t: f64, out: &mut State) {
        self.scheme.interpolate(t, out);
    }

    /// Counts so far.
    pub fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    /// The system that is integrated, for outputs between steps.
    pub fn system(&mut self) -> &mut S {
        self.system
    }

    /// Begins at positions and velocities: consistent accelerations, a first step, the method.
    fn begin(&mut self, mut state: State) -> Result<(), SolveError> {
        let t = state.t;
        state.rebase(self.system.turns());
        self.bordered.move_to(self.system, &state);
        self.bordered
            .accelerations(self.system, &mut state, &mut self.statistics)
            .map_err(|singular| self.singular(t, singular))?;
        if !state.a.iter().chain(&state.lambda).all(|value| value.is_finite()) {
            return Err(self.not_finite(&state, 0.0));
        }
        if self.wanted == 0.0 {
            self.wanted = self.first_step(&state)?;
        }
        let h = self.segments.fit(
            (t, 0.0),
            self.wanted.min(self.options.max_step),
            matches!(self.options.step, StepSize::Fixed(_)),
            self.options.max_step,
        );
        self.scheme
            .begin(self.system, &state, h, &mut self.statistics)
            .map_err(|kind| self.error(kind, t, h, None))
    }

    fn first_step(&mut self, state: &State) -> Result<f64, SolveError> {
        let given = match self.options.step {
            StepSize::Fixed(h) => Some(h),
            StepSize::Adaptive => self.options.first_step,
        };
        if let Some(h) = given {
            return Ok(h);
        }
        let (rtol, left) = (self.options.rtol, self.segments.left(state.t));
        let (bordered, statistics) = (&mut self.bordered, &mut self.statistics);
        let h = start::first_step(self.system, bordered, state, rtol, left, statistics)
            .map_err(|singular| self.singular(state.t, singular))?;
        if !h.is_finite() {
            return Err(self.not_finite(state, 0.0));
        }
        Ok(h.max(self.segments.smallest_step(state.t)))
    }

    /// Begins anew behind a kink. Where a prescribed velocity jumps, the velocities follow as by an
    /// impact without friction.
    fn restart(&mut self) -> Result<(), SolveError> {
        let mut state = self.state().clone();
        let behind = self.segments.behind_kink();
        for jump in self.system.jumps(&state, behind) {
            if jump.of_position {
                return Err(self.error(SolveErrorKind::Discontinuous(jump.text), state.t, 0.0, None));
            }
            self.statistics.note_jump(state.t, &jump.text);
        }
        state.t = behind;
        self.bordered.move_to(self.system, &state);
        let mut change = vec![0.0; state.v.len()];
        self.bordered
            .velocity_change(self.system, &state, None, &mut change, &mut self.statistics)
            .map_err(|singular| self.singular(state.t, singular))?;
        add(&mut state.v, &change);
        self.segments.pass_kink();
        if let Err(error) = self.begin(state) {
            self.segments.return_to_kink();
            return Err(error);
        }
        self.at_kink = false;
        self.statistics.restarts += 1;
        Ok(())
    }

    /// Looks for a switch that nobody knows before; it ends the present segment.
    fn finds_kink(&mut self, t: f64, h: f64) -> bool {
        let system = &*self.system;
        // What is fitted to the segment must not jump over a kink just behind the step.
        let to = (t + AHEAD * h).min(t + self.segments.left(t));
        let mut from = t;
        while let Some(kink) = self.switches.next(from, to, |t, out| system.gaps(t, out)) {
            // What is as near as round-off to where the segment begins is one with that.
            if !self.segments.is_near(t, kink) {
                return self.segments.insert(kink);
            }
            from = kink.next_up();
        }
        false
    }

    /// Counts an accepted step from `t` and says where it ended.
    fn accepted(&mut self, t: f64, h: f64) -> Stop {
        self.previous_time = t;
        let statistics = &mut self.statistics;
        statistics.smallest_step = if statistics.steps == 0 {
            h
        } else {
            statistics.smallest_step.min(h)
        };
        statistics.largest_step = statistics.largest_step.max(h);
        statistics.steps += 1;
        if h >= AT_CEILING * self.options.max_step {
            statistics.steps_at_ceiling += 1;
        }
        let state = self.scheme.state();
        if !self.violations.is_empty() {
            self.system
                .constraint(ConstraintLevel::Position, state, &mut self.violations);
            let largest = self.violations.iter().fold(0.0_f64, |largest, c| largest.max(c.abs()));
            statistics.max_constraint_residual = statistics.max_constraint_residual.max(largest);
        }
        let t = state.t;
        if self.segments.is_at_end(t) {
            Stop::End
        } else if self.segments.is_at_kink(t) {
            self.at_kink = true;
            Stop::Kink
        } else {
            Stop::Step
        }
    }

    /// Why the run will not come to its end, or means nothing.
    fn trouble(&mut self, stop: Stop, h: f64, fixed: bool) -> Option<SolveError> {
        let t = self.state().t;
        if self.statistics.steps.is_multiple_of(LIGHT) || stop == Stop::End {
            let state = self.scheme.state();
            if let Some(text) = self.system.too_fast(state) {
                let text = format!("{text}: {CAUSES}");
                return Some(self.error(SolveErrorKind::Endless(text), t, h, None));
            }
        }
        if fixed || stop == Stop::End || h >= AT_CEILING * self.options.max_step {
            return None;
        }
        let (state, sizes) = (self.scheme.state(), self.system.sizes());
        let fastest = || {
            let speeds = state.v.iter().zip(sizes).map(|(v, size)| v.abs() / size);
            let fastest = speeds.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
            fastest.unwrap_or_default()
        };
        let trouble = self.watch.accepted(t, self.segments.end() - t, || fastest().1)?;
        let fastest = describe(self.system, fastest().0);
        let text = match trouble {
            Trouble::Grows { factor, steps } => format!(
                "the motion grows without end: {fastest} moves {factor:.3} times as fast as {steps} steps before, and the step has fallen to {h:.1e} s: {CAUSES}"
            ),
            Trouble::Endless { left } => format!(
                "the step stays at {h:.1e} s, and with it {left:.0e} steps are left to the end; the fastest is {fastest}: look for a load, stiffness or start that is far too large, or for a tolerance that is too fine"
            ),
        };
        Some(self.error(SolveErrorKind::Endless(text), t, h, None))
    }

    fn count_rejection(&mut self, cause: &Cause) {
        self.statistics.rejected_steps += 1;
        match cause {
            Cause::Error => self.statistics.rejected_by_error += 1,
            Cause::Newton { .. } | Cause::Singular { .. } | Cause::NotFinite => self.statistics.rejected_by_newton += 1,
        }
    }

    fn rejection_error(&mut self, t: f64, h: f64, cause: Cause) -> SolveError {
        let branching = match &cause {
            Cause::Newton { .. } | Cause::Singular { .. } => diagnose::near_singular(self.system, self.scheme.state()),
            Cause::Error | Cause::NotFinite => None,
        };
        if let Some(text) = branching {
            return self.error(SolveErrorKind::SingularConfiguration(text), t, h, None);
        }
        if let (Cause::Newton { .. } | Cause::Error, StepSize::Adaptive) = (&cause, self.options.step) {
            let state = self.state().clone();
            if let Some(text) = noise::below_round_off(self.system, &state, self.options.rtol) {
                return self.error(SolveErrorKind::BelowRoundOff(text), t, h, None);
            }
        }
        let (kind, worst) = match cause {
            Cause::Error => (SolveErrorKind::StepTooSmall, self.scheme.worst_error()),
            Cause::Newton { worst } => {
                let loose = worst.and_then(|row| self.system.loose_tie(&describe(self.system, row)));
                (
                    loose.map_or(SolveErrorKind::NoConvergence, SolveErrorKind::LooseTie),
                    worst,
                )
            }
            Cause::Singular { worst } => (SolveErrorKind::Singular, worst),
            Cause::NotFinite => {
                let state = self.state().clone();
                return self.not_finite(&state, h);
            }
        };
        self.error(kind, t, h, worst)
    }

    /// What is not finite at a state, or where it would be a step later.
    fn not_finite(&mut self, state: &State, h: f64) -> SolveError {
        let mut later = state.clone();
        later.t += h;
        for i in 0..later.x.len() {
            later.x[i] += h * (state.v[i] + 0.5 * h * state.a[i]);
            later.v[i] += h * state.a[i];
        }
        let text = [state, &later]
            .into_iter()
            .find_map(|state| Some((state.t, self.system.undefined(state)?)));
        match text {
            Some((t, text)) => self.error(SolveErrorKind::Undefined(text), t, h, None),
            None => self.error(SolveErrorKind::NotFinite, state.t, h, None),
        }
    }

    fn singular(&self, t: f64, singular: Singular) -> SolveError {
        let row = newton::row(singular, self.system.unknowns());
        self.error(SolveErrorKind::Singular, t, 0.0, row)
    }

    fn error(&self, kind: SolveErrorKind, t: f64, h: f64, row: Option<usize>) -> SolveError {
        let worst = row.map(|row| describe(self.system, row));
        SolveError { kind, t, h, worst }
    }
}

/// A row of the equations in the user's words: unknowns first, then constraints.
fn describe<S: System + ?Sized>(system: &S, row: usize) -> String {
    let n = system.unknowns();
    if row < n {
        system.describe_unknown(row)
    } else {
        system.describe_constraint(row - n)
    }
}

/// Refuses prescribed positions that jump at a known kink, before the first step.
fn refuse_jumps<S: System + ?Sized>(system: &mut S, state: &State, segments: &Segments) -> Result<(), SolveError> {
    let mut at = state.clone();
    for (before, behind) in segments.around_kinks() {
        at.t = before;
        if let Some(jump) = system.jumps(&at, behind).into_iter().find(|jump| jump.of_position) {
            return Err(SolveError {
                kind: SolveErrorKind::Discontinuous(jump.text),
                t: before,
                h: 0.0,
                worst: None,
            });
        }
    }
    Ok(())
}

/// The initial state at time `t`, its lengths checked, accelerations and multipliers zero.
fn sized<S: System + ?Sized>(system: &S, start: State, t: f64) -> Result<State, SolveErrorKind> {
    let (n, turns) = (system.unknowns(), system.turns().len());
    for (name, length, needed, what) in [
        ("positions", start.x.len(), n, "unknowns"),
        ("velocities", start.v.len(), n, "unknowns"),
        ("orientations", start.turns.len(), turns, "free orientations"),
    ] {
        if length != needed {
            return Err(SolveErrorKind::Setting(format!(
                "the initial state has {length} {name}: the system has {needed} {what}"
            )));
        }
    }
    if !start.x.iter().chain(&start.v).all(|value| value.is_finite()) {
        return Err(SolveErrorKind::NotFinite);
    }
    Ok(State {
        x: start.x,
        v: start.v,
        turns: start.turns,
        ..State::of(system, t)
    })
}

/// Puts the initial state onto the constraints, or says what is wrong with it or with them.
fn prepare<S: System + ?Sized>(
    system: &mut S,
    state: &mut State,
    span: f64,
    statistics: &mut Statistics,
) -> Result<(), (SolveErrorKind, Option<String>)> {
    state.rebase(system.turns());
    if let Some(text) = system.undefined(state) {
        return Err((SolveErrorKind::Undefined(text), None));
    }
    let check = |system: &mut S, state: &State| match diagnose::redundancy(system, state) {
        Some(text) => Err((SolveErrorKind::Redundant(text), None)),
        None => Ok(()),
    };
    check(system, state)?;
    consistent::project(system, state, span, statistics).map_err(|inconsistent| match inconsistent {
        Inconsistent::Far(size, index, level) => {
            let mut worst = system.describe_constraint(index);
            if level == ConstraintLevel::Velocity {
                worst.insert_str(0, "the rate of ");
            }
            (SolveErrorKind::Inconsistent(size), Some(worst))
        }
        Inconsistent::Singular(singular) => {
            let row = newton::row(singular, system.unknowns());
            (SolveErrorKind::Singular, row.map(|row| describe(system, row)))
        }
    })?;
    if statistics.position_correction > 0.0 {
        // Redundancy may show on the constraints only.
        check(system, state)?;
    }
    match diagnose::untied(system, state) {
        Some(text) => Err((SolveErrorKind::Untied(text), None)),
        None => Ok(()),
    }
}

impl Running {
    fn new<S: System + ?Sized>(system: &mut S, method: Method, options: &Options, span: f64) -> Self {
        match method {
            Method::Hht { alpha } => Self::alpha(system, Coefficients::hht(alpha), options, span),
            Method::GeneralizedAlpha { rho_inf } => {
                Self::alpha(system, Coefficients::generalized_alpha(rho_inf), options, span)
            }
            Method::Radau => Self::Radau(Box::new(Radau::new(system, options, span))),
            Method::EnergyMomentum => Self::Energy(Box::new(EnergyMomentum::new(system, options))),
        }
    }

    fn alpha<S: System + ?Sized>(system: &mut S, coefficients: Coefficients, options: &Options, span: f64) -> Self {
        Running::Alpha(Box::new(Alpha::new(system, coefficients, options).over(
            system,
            options.rtol,
            span,
        )))
    }
}

impl Keep for Running {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        match self {
            Running::Alpha(scheme) => scheme.keep(archive),
            Running::Radau(scheme) => scheme.keep(archive),
            Running::Energy(scheme) => scheme.keep(archive),
        }
    }
}

impl Scheme for Running {
    fn begin<S: System + ?Sized>(
        &mut self,
        system: &mut S,
        state: &State,
        h: f64,
        statistics: &mut Statistics,
    ) -> Result<(), SolveErrorKind> {
        match self {
            Running::Alpha(scheme) => scheme.begin(system, state, h, statistics),
            Running::Radau(scheme) => scheme.begin(system, state, h, statistics),
            Running::Energy(scheme) => scheme.begin(system, state, h, statistics),
        }
    }

    fn attempt<S: System + ?Sized>(&mut self, system: &mut S, h: f64, statistics: &mut Statistics) -> Outcome {
        match self {
            Running::Alpha(scheme) => scheme.attempt(system, h, statistics),
            Running::Radau(scheme) => scheme.attempt(system, h, statistics),
            Running::Energy(scheme) => scheme.attempt(system, h, statistics),
        }
    }

    fn take_up<S: System + ?Sized>(&mut self, system: &mut S) {
        match self {
            Running::Alpha(scheme) => scheme.take_up(system),
            Running::Radau(scheme) => scheme.take_up(system),
            Running::Energy(scheme) => scheme.take_up(system),
        }
    }

    fn state(&self) -> &State {
        match self {
            Running::Alpha(scheme) => scheme.state(),
            Running::Radau(scheme) => scheme.state(),
            Running::Energy(scheme) => scheme.state(),
        }
    }

    fn time_rest(&self) -> f64 {
        match self {
            Running::Alpha(scheme) => scheme.time_rest(),
            Running::Radau(scheme) => scheme.time_rest(),
            Running::Energy(scheme) => scheme.time_rest(),
        }
    }

    fn interpolate(&self, t: f64, out: &mut State) {
        match self {
            Running::Alpha(scheme) => scheme.interpolate(t, out),
            Running::Radau(scheme) => scheme.interpolate(t, out),
            Running::Energy(scheme) => scheme.interpolate(t, out),
        }
    }

    fn worst_error(&self) -> Option<usize> {
        match self {
            Running::Alpha(scheme) => scheme.worst_error(),
            Running::Radau(scheme) => scheme.worst_error(),
            Running::Energy(scheme) => scheme.worst_error(),
        }
    }
}
