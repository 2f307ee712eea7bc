//! The driver of an integration: it owns the time axis with its limits and kinks, the end, and the counts of steps.
//!
//! It sees the system as `dyn`, so that it is compiled once, here, and not again for every model.

mod passed;
mod taken_up;

use super::alpha::Alpha;
use super::bordered::{Bordered, add};
use super::coefficients::Coefficients;
use super::diagnose;
use super::energy::EnergyMomentum;
use super::method::Method;
use super::noise;
use super::norms::row as row_of;
use super::options::{Options, StepSize};
use super::radau::Radau;
use super::renewal::Renewal;
use super::scheme::{Cause, Outcome, Scheme};
use super::segments::Segments;
use super::sight::Sight;
use super::start::{self, describe};
use super::statistics::Statistics;
use super::strays::{self, Strays};
use super::switches::Switches;
use super::watch::{Trouble, Watch};
use crate::error::{SolveError, SolveErrorKind};
use crate::linalg::Singular;
use crate::system::{Branch, ConstraintLevel, State, System};

/// Switches are looked for so many steps ahead: the last two before one share what is left.
const AHEAD: f64 = 2.0;
/// A step within this part of the ceiling is at the ceiling.
const AT_CEILING: f64 = 0.99;

/// Part of the longest of the last steps that the first one behind a kink is at least: those before it became as short as the way to it. In steps that are
/// shorter by many orders round-off of constraints makes velocities that no error test takes.
const BEHIND: f64 = 1e-2;
/// Part of it at which steps have become so short that round-off grows in them.
const ROUND_OFF: f64 = 1e-6;
/// The longest step is remembered over some dozens.
const FORGETTING: f64 = 0.95;
/// Rejections by the error of steps from one state, after which it is the state that is looked at.
const STUBBORN: u32 = 4;
/// Steps after which it is looked whether something moves faster than light.
const LIGHT: u64 = 16;
/// So many of the smallest steps behind a failure it is looked what has no value any more: of the last ones round-off makes errors that are too large.
const BEFORE_END: f64 = 1e6;
/// Where to look when a motion grows without end.
const CAUSES: &str = "look for a damper or load with the wrong sign, or a load that is far too large";

/// Why [`Integrator::step`](super::Integrator::step) came back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// One step was accepted.
    Step,
    /// A step was accepted that ends at a kink of a motion or load.
    Kink,
    /// The end time is reached.
    End,
}

/// All that an integration knows besides the system.
pub(super) struct Driver {
    pub(super) method: Method,
    pub(super) scheme: Box<dyn Scheme>,
    pub(super) options: Options,
    pub(super) segments: Segments,
    pub(super) switches: Switches,
    /// Made when the first step is taken.
    pub(super) sight: Option<Sight>,
    /// Of a system whose velocities may stray.
    pub(super) strays: Option<Strays>,
    pub(super) bordered: Bordered,
    /// Step that the next attempt would like to take, s.
    pub(super) wanted: f64,
    /// The last step ended at a kink: begin anew behind it.
    pub(super) at_kink: bool,
    /// A kink that was found is one of a constraint, whose rate may jump with the place.
    pub(super) at_corner: bool,
    /// Laws at whose kinks a step is cut, and the sides from which they come to them; and those at whose kinks the segment began.
    pub(super) met: Vec<(usize, bool)>,
    pub(super) awaited: Vec<(usize, bool)>,
    pub(super) previous_time: f64,
    /// The longest of the last steps, s; and whether it was tried to come back to such ones from steps that only became shorter.
    pub(super) longest: f64,
    pub(super) has_left: bool,
    pub(super) statistics: Statistics,
    pub(super) watch: Watch,
    /// Memory for constraint values.
    pub(super) violations: Vec<f64>,
    pub(super) renewal: Renewal,
}

/// The method that runs, over `span` (s).
pub(super) fn scheme_of(system: &mut dyn System, method: Method, options: &Options, span: f64) -> Box<dyn Scheme> {
    let mut alpha = |coefficients| Box::new(Alpha::new(system, coefficients, options).over(system, options.rtol, span));
    match method {
        Method::Hht { alpha: value } => alpha(Coefficients::hht(value)),
        Method::GeneralizedAlpha { rho_inf } => alpha(Coefficients::generalized_alpha(rho_inf)),
        Method::Radau => Box::new(Radau::<3>::new(system, options, span)),
        Method::Radau9 => Box::new(Radau::<5>::new(system, options, span)),
        Method::Radau13 => Box::new(Radau::<7>::new(system, options, span)),
        Method::EnergyMomentum => Box::new(EnergyMomentum::new(system, options)),
    }
}

impl Driver {
    /// See [`super::Integrator::new`].
    pub(super) fn new(
        system: &mut dyn System,
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
        start::check_states(system, method).map_err(|kind| fail(kind, None))?;
        let mut switches = Switches::default();
        let mut kinks = system.kinks();
        if switches.is_at(t0, |t, out| system.gaps(t, out)) {
            kinks.push(t0);
        }
        let segments = Segments::new(t0, t_end, &kinks);
        let mut state = start::sized(system, start, segments.start()).map_err(|kind| fail(kind, None))?;
        let mut statistics = Statistics::default();
        start::prepare(system, &mut state, t_end - t0, &mut statistics).map_err(|(kind, worst)| fail(kind, worst))?;
        start::refuse_jumps(system, &state, &segments)?;
        let mut driver = Self {
            bordered: Bordered::new(system),
            scheme: scheme_of(system, method, &options, t_end - t0),
            renewal: Renewal::new(options.renewal(system.unknowns())),
            method,
            options,
            segments,
            switches,
            sight: None,
            strays: None,
            wanted: 0.0,
            at_kink: false,
            at_corner: false,
            met: Vec::new(),
            awaited: Vec::new(),
            previous_time: state.t,
            longest: 0.0,
            has_left: false,
            statistics,
            watch: Watch::default(),
            violations: vec![0.0; m],
        };
        driver.begin(system, state)?;
        Ok(driver)
    }

    /// See [`super::Integrator::step`].
    pub(super) fn step(&mut self, system: &mut dyn System) -> Result<Stop, SolveError> {
        if self.at_kink {
            self.restart(system)?;
        }
        let (t, low) = (self.state().t, self.scheme.time_rest());
        let branches = system.branches(self.state());
        if self.segments.is_at_end(t) {
            return Ok(Stop::End);
        }
        let has_kinks = branches.iter().any(Branch::ends_steps);
        let fixed = matches!(self.options.step, StepSize::Fixed(_));
        let may_stray = !fixed && self.may_stray(system);
        let before = (has_kinks || may_stray).then(|| self.state().clone());
        let (mut across, mut failed) = (0, 0);
        loop {
            let limited = self.wanted.min(self.options.max_step);
            let mut h = self.segments.fit((t, low), limited, fixed, self.options.max_step);
            if self.finds_kink(system, t, h) {
                h = self.segments.fit((t, low), limited, fixed, self.options.max_step);
            }
            let seen = self.seen(system, t, h);
            let is_cut = seen < h && !fixed;
            if is_cut {
                h = seen;
                // A switch that a longer look has missed.
                if self.finds_kink(system, t, h) {
                    h = self.segments.fit((t, low), h, fixed, self.options.max_step).min(h);
                }
            }
            match self.scheme.attempt(system, h, &mut self.statistics) {
                Outcome::Accepted { next } => {
                    if let Some(before) = &before {
                        let course = self.branches_of_step(system, (before.t, &branches));
                        let passed = self.ends_at_passed_kink(system, &course);
                        // Of kinks that lie so near that they count as one, every step is of another side.
                        let is_long = strays::RETRY * h > self.segments.smallest_step(t);
                        let may_retry = has_kinks && !fixed && !passed && is_long && across < passed::ACROSS;
                        let is_across = may_retry && self.is_on_other_side(system, &course);
                        across += u32::from(is_across);
                        if passed || is_across || is_long && self.strays(system, h) {
                            if !passed {
                                self.wanted = strays::RETRY * h;
                            }
                            self.statistics.rejected_steps += 1;
                            self.statistics.rejected_by_error += 1;
                            self.begin(system, before.clone())?;
                            continue;
                        }
                        self.forget_passed(&course);
                    }
                    self.longest = h.max(FORGETTING * self.longest);
                    self.has_left &= h < BEHIND * BEHIND * self.longest;
                    // A step cut short by a kink or the end says little about the next one.
                    self.wanted = if next >= h && !is_cut { next.max(limited) } else { next };
                    self.statistics.shortened_steps += u64::from(is_cut);
                    let stop = self.accepted(system, t, h);
                    if let Some(error) = self.half_turn(system, &branches, (t, h)) {
                        return Err(error);
                    }
                    if let Some(error) = self.trouble(system, stop, h, fixed) {
                        return Err(error);
                    }
                    if stop != Stop::End && self.renewal.is_due(&self.statistics) {
                        self.renew(system);
                    }
                    return Ok(stop);
                }
                Outcome::Rejected { next, cause } => {
                    self.count_rejection(&cause);
                    if fixed || next < self.segments.smallest_step(t) {
                        return Err(self.rejection_error(system, t, h, cause));
                    }
                    self.wanted = next;
                    failed += u32::from(cause == Cause::Error);
                    if cause == Cause::Error && self.leaves_round_off(h) {
                        self.begin_on_constraints(system)?;
                        self.wanted = BEHIND * self.longest;
                        continue;
                    }
                    if failed == STUBBORN && !self.violations.is_empty() {
                        self.begin_on_constraints(system)?;
                    }
                }
            }
        }
    }

    fn state(&self) -> &State {
        self.scheme.state()
    }

    /// Whether a rejected step is so much shorter than the last ones that round-off of constraints may be what its error test sees, for the first time.
    fn leaves_round_off(&mut self, h: f64) -> bool {
        let is_round_off = !self.violations.is_empty() && h < ROUND_OFF * self.longest;
        is_round_off && !std::mem::replace(&mut self.has_left, true)
    }

    /// Begins at positions and velocities: consistent accelerations, a first step, the method.
    fn begin(&mut self, system: &mut dyn System, mut state: State) -> Result<(), SolveError> {
        let t = state.t;
        state.rebase(system.turns());
        self.bordered.move_to(system, &state);
        self.bordered
            .accelerations(system, &mut state, &mut self.statistics)
            .map_err(|pivot| singular(system, t, pivot))?;
        if !state.a.iter().chain(&state.lambda).all(|value| value.is_finite()) {
            return Err(self.not_finite(system, &state, 0.0));
        }
        if self.wanted == 0.0 {
            self.wanted = self.first_step(system, &state)?;
        }
        let h = self.segments.fit(
            (t, 0.0),
            self.wanted.min(self.options.max_step),
            matches!(self.options.step, StepSize::Fixed(_)),
            self.options.max_step,
        );
        self.scheme
            .begin(system, &state, h, &mut self.statistics)
            .map_err(|kind| error(system, kind, t, h, None))
    }

    /// Begins at the last state, with velocities that satisfy the constraints. What a method has left of their rates no step
    /// makes smaller, and each one counts it as its own error.
    fn begin_on_constraints(&mut self, system: &mut dyn System) -> Result<(), SolveError> {
        let mut state = self.state().clone();
        self.bordered.move_to(system, &state);
        let mut change = vec![0.0; state.v.len()];
        let (bordered, statistics) = (&mut self.bordered, &mut self.statistics);
        bordered
            .velocity_change(system, &state, None, &mut change, statistics)
            .map_err(|pivot| singular(system, state.t, pivot))?;
        add(&mut state.v, &change);
        self.begin(system, state)
    }

    fn first_step(&mut self, system: &mut dyn System, state: &State) -> Result<f64, SolveError> {
        let given = match self.options.step {
            StepSize::Fixed(h) => Some(h),
            StepSize::Adaptive => self.options.first_step,
        };
        if let Some(h) = given {
            return Ok(h);
        }
        let (rtol, left) = (self.options.rtol, self.segments.left(state.t));
        let (bordered, statistics) = (&mut self.bordered, &mut self.statistics);
        let h = start::first_step(system, bordered, state, rtol, left, statistics)
            .map_err(|pivot| singular(system, state.t, pivot))?;
        if !h.is_finite() {
            return Err(self.not_finite(system, state, 0.0));
        }
        Ok(h.max(self.segments.smallest_step(state.t)))
    }

    /// Begins anew behind a kink. Where a prescribed velocity jumps, the velocities follow as by an
    /// impact without friction, and what prescribed frames carry along keeps its own in space.
    fn restart(&mut self, system: &mut dyn System) -> Result<(), SolveError> {
        let mut state = self.state().clone();
        let behind = self.segments.behind_kink();
        let jumps = system.jumps(&state, behind);
        let is_jolted = !jumps.is_empty();
        for jump in jumps {
            if jump.of_position {
                return Err(error(
                    system,
                    SolveErrorKind::Discontinuous(jump.text),
                    state.t,
                    0.0,
                    None,
                ));
            }
            self.statistics.note_jump(state.t, &jump.text);
        }
        let mut jolt = vec![0.0; state.v.len()];
        if is_jolted {
            system.jolt(&state, behind, &mut jolt);
        }
        // A method leaves something of the constraints' rates in every step. An impact that took it away would meet the mass alone, and stretch stiff
        // bodies at their joints, whose damping answers with accelerations that nothing has.
        let mut left = self.bordered.constraint_rates(system, &state);
        if std::mem::take(&mut self.at_corner) {
            left.fill(0.0);
        }
        state.t = behind;
        self.bordered.move_to(system, &state);
        if is_jolted || !left.is_empty() {
            let mut change = vec![0.0; state.v.len()];
            let (bordered, statistics) = (&mut self.bordered, &mut self.statistics);
            bordered
                .impact(system, &state, (&jolt, &left), &mut change, statistics)
                .map_err(|pivot| singular(system, state.t, pivot))?;
            add(&mut state.v, &change);
        }
        let is_met = self.segments.ends_at_met();
        self.segments.pass_kink();
        if is_met {
            self.wanted = self.wanted.max(BEHIND * self.longest);
        }
        if let Err(error) = self.begin(system, state) {
            self.segments.return_to_kink();
            return Err(error);
        }
        self.at_kink = false;
        if !is_met {
            self.awaited.clear();
            self.met.clear();
        }
        // What is still ahead of the kink before is so, too: of two that are near each other each ends one step.
        let met = std::mem::take(&mut self.met);
        self.awaited
            .retain(|(law, _)| met.iter().all(|(other, _)| other != law));
        self.awaited.extend(met);
        self.statistics.restarts += 1;
        Ok(())
    }

    /// Looks for a switch that nobody knows before; it ends the present segment.
    fn finds_kink(&mut self, system: &dyn System, t: f64, h: f64) -> bool {
        // What is fitted to the segment must not jump over a kink just behind the step.
        let to = (t + AHEAD * h).min(t + self.segments.left(t));
        let mut from = t;
        while let Some(kink) = self.switches.next(from, to, |t, out| system.gaps(t, out)) {
            // What is as near as round-off to where the segment begins is one with that.
            if !self.segments.is_near(t, kink) {
                let (near, at_zero) = (self.segments.near(kink), self.segments.at_zero());
                let last = self
                    .switches
                    .last(kink, near, at_zero, &mut |t, out| system.gaps(t, out));
                return self.segments.insert(kink, last);
            }
            from = kink.next_up();
        }
        false
    }

    /// The longest step at `t` up to `h` (s) that jumps over nothing that motions and loads do. Notes tell of what a fixed step jumps over, and of what
    /// no step excludes.
    fn seen(&mut self, system: &mut dyn System, t: f64, h: f64) -> f64 {
        self.sight(system);
        let (Some(sight), segments) = (&mut self.sight, &self.segments) else {
            return h;
        };
        if !sight.readers().is_empty() {
            sight.follow(t, system.paths(self.scheme.state(), sight.readers()));
        }
        // Beyond a kink the step before says nothing.
        let before = if segments.begins_behind(self.previous_time) {
            t
        } else {
            self.previous_time
        };
        let seen = sight.longest(before, t, h, segments.smallest_step(t));
        if let (Some(of), StepSize::Fixed(_)) = (seen.beyond, self.options.step) {
            self.statistics.note_unseen(t + seen.step, of);
        }
        if let Some(of) = seen.unseen {
            self.statistics.note_vague(t, of);
        }
        seen.step
    }

    /// Whether velocities may stray from constraints within a step.
    fn may_stray(&mut self, system: &mut dyn System) -> bool {
        let is_held = self.options.stabilised || self.violations.is_empty();
        let has_positions = !is_held && self.sight(system).has_positions();
        if has_positions && self.strays.is_none() {
            self.strays = Some(Strays::new(system));
        }
        has_positions
    }

    /// Whether they do at the end of the step just taken.
    fn strays(&mut self, system: &mut dyn System, h: f64) -> bool {
        let (rtol, state) = (self.options.rtol, self.scheme.state());
        self.strays
            .as_mut()
            .is_some_and(|strays| strays.are_in(system, state, h, rtol))
    }

    /// What is known of courses over the run.
    fn sight(&mut self, system: &dyn System) -> &mut Sight {
        let segments = &self.segments;
        self.sight
            .get_or_insert_with(|| Sight::new(system.courses(), segments.start(), segments.end()))
    }

    /// Counts an accepted step from `t` and says where it ended.
    fn accepted(&mut self, system: &mut dyn System, t: f64, h: f64) -> Stop {
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
            system.constraint(ConstraintLevel::Position, state, &mut self.violations);
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

    /// An angle that has jumped in a step from `t` of size `h`.
    fn half_turn(&self, system: &mut dyn System, before: &[Branch], (t, h): (f64, f64)) -> Option<SolveError> {
        let now = system.branches(self.state());
        let passed = now
            .iter()
            .zip(before)
            .position(|(now, before)| now.is_passed_from(before))?;
        let law = system.describe_branch(passed);
        Some(error(system, SolveErrorKind::HalfTurn(law), t, h, None))
    }

    /// Why the run will not come to its end, or means nothing.
    fn trouble(&mut self, system: &mut dyn System, stop: Stop, h: f64, fixed: bool) -> Option<SolveError> {
        let t = self.state().t;
        if self.statistics.steps.is_multiple_of(LIGHT) || stop == Stop::End {
            let state = self.scheme.state();
            if let Some(text) = system.too_fast(state) {
                let text = format!("{text}: {CAUSES}");
                return Some(error(system, SolveErrorKind::Endless(text), t, h, None));
            }
        }
        if fixed || stop == Stop::End || h >= AT_CEILING * self.options.max_step {
            return None;
        }
        let state = self.scheme.state();
        let left = self.segments.end() - t;
        let trouble = self.watch.accepted(t, left, || system.kinetic_energy(state))?;
        let speeds = state.v.iter().zip(system.sizes()).map(|(v, size)| v.abs() / size);
        let fastest = speeds.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        let fastest = describe(system, fastest.unwrap_or_default().0);
        let text = match trouble {
            Trouble::Grows { factor, steps } => format!(
                "the motion grows without end: its kinetic energy has grown to {factor:.3e} times that of {steps} steps before, the fastest is {fastest}, and the step has fallen to {h:.1e} s: {CAUSES}"
            ),
            Trouble::Endless { left } => format!(
                "the step stays at {h:.1e} s, and with it {left:.0e} steps are left to the end; the fastest is {fastest}: look for a load, stiffness or start that is far too large, or for a tolerance that is too fine"
            ),
        };
        Some(error(system, SolveErrorKind::Endless(text), t, h, None))
    }

    fn count_rejection(&mut self, cause: &Cause) {
        self.statistics.rejected_steps += 1;
        match cause {
            Cause::Error => self.statistics.rejected_by_error += 1,
            Cause::Newton { .. } | Cause::Singular { .. } | Cause::NotFinite => self.statistics.rejected_by_newton += 1,
        }
    }

    fn rejection_error(&mut self, system: &mut dyn System, t: f64, h: f64, cause: Cause) -> SolveError {
        let state = self.state().clone();
        // Steps fall to nothing just before where something ends, as the rows of a table.
        if self.options.step == StepSize::Adaptive
            && let Some((t, text)) = undefined(system, &state, BEFORE_END * h)
        {
            return error(system, SolveErrorKind::Undefined(text), t, h, None);
        }
        if let Some(near) = system.branches(self.scheme.state()).iter().position(Branch::is_near) {
            let law = system.describe_branch(near);
            return error(system, SolveErrorKind::HalfTurn(law), t, h, None);
        }
        let branching = match &cause {
            Cause::Newton { .. } | Cause::Singular { .. } => diagnose::near_singular(system, self.scheme.state()),
            Cause::Error | Cause::NotFinite => None,
        };
        if let Some(text) = branching {
            return error(system, SolveErrorKind::SingularConfiguration(text), t, h, None);
        }
        if let (Cause::Newton { .. } | Cause::Error, StepSize::Adaptive) = (&cause, self.options.step)
            && let Some(text) = noise::below_round_off(system, &state, self.options.rtol)
        {
            return error(system, SolveErrorKind::BelowRoundOff(text), t, h, None);
        }
        let (kind, worst) = match cause {
            Cause::Error => (SolveErrorKind::StepTooSmall, self.scheme.worst_error()),
            Cause::Newton { worst } => {
                let loose = worst.and_then(|row| system.loose_tie(&describe(system, row)));
                (
                    loose.map_or(SolveErrorKind::NoConvergence, SolveErrorKind::LooseTie),
                    worst,
                )
            }
            Cause::Singular { worst } => (SolveErrorKind::Singular, worst),
            Cause::NotFinite => return self.not_finite(system, &state, h),
        };
        error(system, kind, t, h, worst)
    }

    /// What is not finite at a state, or where it would be a step later.
    fn not_finite(&mut self, system: &mut dyn System, state: &State, h: f64) -> SolveError {
        match undefined(system, state, h) {
            Some((t, text)) => error(system, SolveErrorKind::Undefined(text), t, h, None),
            None => error(system, SolveErrorKind::NotFinite, state.t, h, None),
        }
    }
}

/// What has no value at a state, or where it would be a step of `h` later, and when, s.
fn undefined(system: &mut dyn System, state: &State, h: f64) -> Option<(f64, String)> {
    let mut later = state.clone();
    later.t += h;
    for i in 0..later.x.len() {
        later.x[i] += h * (state.v[i] + 0.5 * h * state.a[i]);
        later.v[i] += h * state.a[i];
    }
    [state, &later]
        .into_iter()
        .find_map(|state| Some((state.t, system.undefined(state)?)))
}

/// A singular matrix, with the row in the user's words.
fn singular(system: &dyn System, t: f64, singular: Singular) -> SolveError {
    let row = row_of(singular, system.unknowns());
    error(system, SolveErrorKind::Singular, t, 0.0, row)
}

/// What ended the integration, with the row in the user's words.
fn error(system: &dyn System, kind: SolveErrorKind, t: f64, h: f64, row: Option<usize>) -> SolveError {
    let worst = row.map(|row| describe(system, row));
    SolveError { kind, t, h, worst }
}
