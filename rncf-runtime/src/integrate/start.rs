//! Before the first step: settings in range, and a first step that fits the scales of the motion.

use super::bordered::Bordered;
use super::consistent::{self, Inconsistent};
use super::diagnose;
use super::method::Method;
use super::norms::{norm, row as row_of};
use super::options::{Options, StepSize};
use super::segments::Segments;
use super::statistics::Statistics;
use crate::error::{SolveError, SolveErrorKind};
use crate::linalg::Singular;
use crate::system::{ConstraintLevel, State, System};

/// First trial step, as a part of the time in which an unknown covers its size, or of the span.
const CAUTIOUS: f64 = 1e-2;

/// Least tolerance: a few units of the last place of numbers.
const LEAST: f64 = 1e-15;

/// Checks the settings of a run.
pub(super) fn check_settings(t: f64, t_end: f64, method: Method, options: &Options) -> Result<(), SolveErrorKind> {
    let check = |valid: bool, name: &str, value: f64, range: &str| {
        if valid {
            Ok(())
        } else {
            Err(SolveErrorKind::Setting(format!(
                "{name} = {value} is out of range: it must be {range}"
            )))
        }
    };
    let positive = |value: f64| value > 0.0 && value.is_finite();
    if let Some(own) = method.parameter() {
        let [low, high] = own.bounds();
        let is_within = own.range.contains(&own.value);
        check(is_within, own.name, own.value, &format!("within [{low}, {high}]"))?;
    }
    check(positive(options.rtol), "rtol", options.rtol, "positive and finite")?;
    check(
        options.rtol >= LEAST,
        "rtol",
        options.rtol,
        "at least 1e-15: below is the round-off of numbers",
    )?;
    if options.step == StepSize::Adaptive && options.rtol > method.loosest() {
        let (name, loosest) = (method.name(), method.loosest());
        let range = format!(
            "at most {loosest:e} with {name}, whose error test says nothing of longer steps: take `radau` for a looser one"
        );
        check(false, "rtol", options.rtol, &range)?;
    }
    if let StepSize::Fixed(h) = options.step {
        check(positive(h), "the fixed step (s)", h, "positive and finite")?;
    }
    if let Some(h) = options.first_step {
        check(positive(h), "the first step (s)", h, "positive and finite")?;
    }
    check(options.max_step > 0.0, "max_step (s)", options.max_step, "positive")?;
    check(t.is_finite(), "the start time (s)", t, "finite")?;
    let range = format!("finite and later than the start at {t} s");
    check(t_end.is_finite() && t_end > t, "t_end (s)", t_end, &range)
}

/// Checks that a method solves equations of first order where the system has some.
pub(super) fn check_states(system: &dyn System, method: Method) -> Result<(), SolveErrorKind> {
    match system.states().first() {
        Some(&state) if !method.is_radau() => Err(SolveErrorKind::Setting(format!(
            "{} integrates equations of second order, and {} has one of first order: take `radau`",
            method.name(),
            system.describe_unknown(state)
        ))),
        _ => Ok(()),
    }
}

/// Checks that a method on constraints of index 3 has dissipation: without any, errors of the multipliers grow from
/// step to step, however short the steps are (THEORY 10, T1).
pub(super) fn check_dissipation(constraints: usize, method: Method, options: &Options) -> Result<(), SolveErrorKind> {
    let Some(own) = method.parameter().filter(|own| own.value == own.undamped) else {
        return Ok(());
    };
    let undamped = format!("{} = {}", own.name, own.value);
    if constraints == 0 || options.stabilised {
        return Ok(());
    }
    Err(SolveErrorKind::Setting(format!(
        "{undamped} damps nothing, and without damping errors in the forces of constraints grow from step to step: \
         take e.g. rho_inf = 0.8 or alpha = -0.05, or `stabilised` constraints"
    )))
}

/// A first step (s) from the change of the accelerations over a cautious trial step; `bordered`
/// is left at the state.
pub(super) fn first_step(
    system: &mut dyn System,
    bordered: &mut Bordered,
    state: &State,
    rtol: f64,
    span: f64,
    statistics: &mut Statistics,
) -> Result<f64, Singular> {
    let inverse_sizes: Vec<f64> = system.sizes().iter().map(|size| 1.0 / size).collect();
    let speed = norm(&state.v, &inverse_sizes);
    let acceleration = norm(&state.a, &inverse_sizes);
    // Time in which the motion covers about one hundredth of the sizes, at most of the span.
    let mut trial = CAUTIOUS * span;
    if speed * trial > CAUTIOUS {
        trial = CAUTIOUS / speed;
    }
    if 0.5 * acceleration * trial * trial > CAUTIOUS {
        trial = (2.0 * CAUTIOUS / acceleration).sqrt();
    }
    trial *= CAUTIOUS;
    let mut later = state.clone();
    later.t += trial;
    for i in 0..state.x.len() {
        later.x[i] += trial * (state.v[i] + 0.5 * trial * state.a[i]);
        later.v[i] += trial * state.a[i];
    }
    bordered.move_to(system, &later);
    bordered.accelerations(system, &mut later, statistics)?;
    bordered.move_to(system, state);
    for i in 0..later.a.len() {
        later.a[i] = (later.a[i] - state.a[i]) / trial;
    }
    // A second-order method errs by about a twelfth of h^3 times the jerk: aim at a tenth of the tolerance.
    let jerk = norm(&later.a, &inverse_sizes);
    let by_jerk = if jerk > 0.0 {
        (rtol / jerk).cbrt()
    } else {
        f64::INFINITY
    };
    Ok(by_jerk.min(100.0 * trial))
}

/// A row of the equations in the user's words: unknowns first, then constraints.
pub(super) fn describe(system: &dyn System, row: usize) -> String {
    let n = system.unknowns();
    if row < n {
        system.describe_unknown(row)
    } else {
        system.describe_constraint(row - n)
    }
}

/// Refuses prescribed positions that jump at a known kink, before the first step.
pub(super) fn refuse_jumps(system: &mut dyn System, state: &State, segments: &Segments) -> Result<(), SolveError> {
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
pub(super) fn sized(system: &dyn System, start: State, t: f64) -> Result<State, SolveErrorKind> {
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
pub(super) fn prepare(
    system: &mut dyn System,
    state: &mut State,
    span: f64,
    statistics: &mut Statistics,
) -> Result<(), (SolveErrorKind, Option<String>)> {
    check_constraints(system, state)?;
    consistent::project(system, state, span, statistics).map_err(|found| refused(system, found))?;
    if statistics.position_correction > 0.0 {
        // Redundancy may show on the constraints only.
        check_independent(system, state)?;
    }
    match diagnose::untied(system, state) {
        Some(text) => Err((SolveErrorKind::Untied(text), None)),
        None => Ok(()),
    }
}

/// Gives the initial state velocities that constraints allow, see [`consistent::set_in_motion`], or says what is wrong with it or with them.
pub(super) fn set_in_motion(
    system: &mut dyn System,
    state: &mut State,
    weights: Vec<f64>,
) -> Result<(), (SolveErrorKind, Option<String>)> {
    check_constraints(system, state)?;
    consistent::set_in_motion(system, state, weights).map_err(|found| refused(system, found))
}

/// Checks that constraints have values, and do not depend on each other.
fn check_constraints(system: &mut dyn System, state: &mut State) -> Result<(), (SolveErrorKind, Option<String>)> {
    state.rebase(system.turns());
    match system.undefined(state) {
        Some(text) => Err((SolveErrorKind::Undefined(text), None)),
        None => check_independent(system, state),
    }
}

fn check_independent(system: &mut dyn System, state: &State) -> Result<(), (SolveErrorKind, Option<String>)> {
    match diagnose::redundancy(system, state) {
        Some(text) => Err((SolveErrorKind::Redundant(text), None)),
        None => Ok(()),
    }
}

/// Why a state is refused, and the worst constraint.
fn refused(system: &dyn System, inconsistent: Inconsistent) -> (SolveErrorKind, Option<String>) {
    match inconsistent {
        Inconsistent::Far(size, index, level) => {
            let mut worst = system.describe_constraint(index);
            if level == ConstraintLevel::Velocity {
                worst.insert_str(0, "the rate of ");
            }
            (SolveErrorKind::Inconsistent(size), Some(worst))
        }
        Inconsistent::Singular(singular) => {
            let row = row_of(singular, system.unknowns());
            (SolveErrorKind::Singular, row.map(|row| describe(system, row)))
        }
    }
}
