//! Continuation of equilibria from the start, in the scale of the motion or of the loads.

use super::assembled::assembled;
use super::distance::distance;
use super::negative::Negative;
use super::newton::{Failure, Newton, Patience};
use super::spun_up::{SpunUp, from_rest};
use crate::error::{Short, SolveError, SolveErrorKind};
use crate::model::{Kind, Scene, Uniform};
use crate::system::State;

/// Smallest increment of the scale.
pub(super) const SMALLEST: f64 = 1.0 / 65536.0;

/// Part of the angular velocity up to which a way that ends has led nowhere.
pub(super) const NO_WAY: f64 = 1.0 / 64.0;

/// Increment of the loads at which Newton's iteration seldom leaps over a limit point.
pub(super) const LOAD_STEP: f64 = 1.0 / 32.0;

/// Parts of a first step at which it is looked at, too.
pub const CUTS: [f64; 2] = [0.5, 0.25];

/// Distance, relative to the sizes of the unknowns, at which a way back has come to where it began.
pub(super) const RETURNED: f64 = 1e-6;
/// Distance over the sizes from where a flow ended that its equilibrium may have.
const NEAR: f64 = 0.1;

/// Iterations of Newton's method in which what is linear is found: one finds it, others the last digits.
const LINEAR: u32 = 3;
/// Up to how many times doubled loads are tried from which one is followed back.
const DOUBLINGS: i32 = 8;

/// An equilibrium and the way to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// The continuation steps in their order, the last one at scale 1.
    pub path: Vec<Continued>,
    /// Newton iterations of attempts that failed and were repeated with a smaller increment.
    pub wasted_iterations: u32,
}

/// One continuation step.
#[derive(Clone, Debug, PartialEq)]
pub struct Continued {
    /// Part of the angular velocity, or of the loads of a static equilibrium, 0 to 1.
    pub scale: f64,
    /// Equilibrium at that scale: positions and orientations, velocities and accelerations of the uniform
    /// motion, multipliers.
    pub state: State,
    /// Newton iterations that it took.
    pub iterations: u32,
    /// It changes where the bodies buckle or reach a limit point, and at a critical speed.
    pub negative: Negative,
    /// Whether Newton's iteration ended far from where its first increment pointed, so that a limit point may lie between.
    pub strayed: bool,
    /// Whether the iteration moved the unknowns by a visible part of their sizes.
    pub moved_far: bool,
}

impl Continued {
    /// One that lies far from where its iteration began.
    fn far(at: &Uniform, state: State, iterations: u32, negative: Negative) -> Self {
        Self {
            scale: at.scale,
            state,
            iterations,
            negative,
            strayed: false,
            moved_far: true,
        }
    }
}

impl Equilibrium {
    /// The equilibrium at the full angular velocity or load.
    pub fn state(&self) -> Option<&State> {
        self.path.last().map(|step| &step.state)
    }

    /// Newton iterations of all attempts.
    pub fn iterations(&self) -> u32 {
        self.wasted_iterations + self.path.iter().map(|step| step.iterations).sum::<u32>()
    }
}

/// Relative equilibrium of `scene` with the spin, loads and constraints of time `t` (s).
///
/// # Errors
/// As [`follow`].
pub fn steady(scene: &mut dyn Scene, t: f64) -> Result<Equilibrium, SolveError> {
    follow(scene, &Uniform::steady(t), 1.0, |_, _| ())
}

/// Equilibrium at rest of `scene` under the loads of time `t` (s), which are stepped from zero.
///
/// # Errors
/// As [`follow`].
pub fn static_load(scene: &mut dyn Scene, t: f64) -> Result<Equilibrium, SolveError> {
    follow(scene, &Uniform::at_rest(t), LOAD_STEP, |_, _| ())
}

/// The equilibria from the start of `scene` up to `at` with growing [`Uniform::scale`], in increments of
/// at most `largest`; `visit` sees every step when it is found, so that the way is known up to where it
/// ends.
///
/// # Errors
/// [`SolveErrorKind::NoEquilibrium`] if the unknowns are not those of the turning frames, if a frame,
/// load, joint, force or constraint is not invariant under the rotation (by name), or if no equilibrium
/// continues those before.
pub fn follow(
    scene: &mut dyn Scene,
    at: &Uniform,
    largest: f64,
    visit: impl FnMut(&mut dyn Scene, &Continued),
) -> Result<Equilibrium, SolveError> {
    along(scene, at, largest, Patience::Patient, visit)
}

/// The equilibrium up to `at` where Newton's iteration leads straight to it: a first look, for where there may be none.
///
/// # Errors
/// As [`follow`], and where a longer look would find one.
pub fn glance(scene: &mut dyn Scene, at: &Uniform) -> Result<Equilibrium, SolveError> {
    along(scene, at, 1.0, Patience::Strict, |_, _| ())
}

/// [`follow`] with the given patience of the iteration.
pub(super) fn along(
    scene: &mut dyn Scene,
    at: &Uniform,
    largest: f64,
    patience: Patience,
    mut visit: impl FnMut(&mut dyn Scene, &Continued),
) -> Result<Equilibrium, SolveError> {
    let start = assembled(scene, at);
    check(scene, at, &start)?;
    let mut last = start.clone();
    let mut newton = Newton::new(scene);
    let largest = largest.clamp(SMALLEST, 1.0);
    let (mut scale, mut increment) = (0.0, largest);
    let mut found = Equilibrium {
        path: vec![],
        wasted_iterations: 0,
    };
    while scale < at.scale {
        let target = (scale + increment).min(at.scale);
        // At small spins the equilibria need not be near the start: they hang on the ratio of the loads alone.
        let patiences = match (patience, at.kind) {
            (Patience::Patient, Kind::Steady) if scale == 0.0 => &[Patience::Strict, Patience::Patient][..],
            _ => &[patience],
        };
        let mut result = Err(Failure::NotFinite(None));
        for &patience in patiences {
            if result.is_err() {
                let wasted;
                (result, wasted) = attempt(scene, &mut newton, at, [scale, target], &last, patience);
                found.wasted_iterations += wasted;
            }
        }
        match result {
            Ok(mut step) => {
                let stands = at.kind == Kind::Steady && scale == 0.0 && angular_velocity(scene, at) == 0.0;
                if stands && (step.strayed || newton.has_moved_far() && strays_within(scene, &mut newton, at, &last)) {
                    // All loads at once may leap over a limit point.
                    let loaded = Uniform::at_rest(at.t);
                    return along(scene, &loaded, LOAD_STEP, patience, visit);
                }
                if at.kind == Kind::Steady && scale == 0.0 && target == at.scale && step.strayed && !stands {
                    // Of two equilibria the one nearer to the start counts: this iteration may have leapt over it.
                    if let Some(other) = grown_from_rest(scene, at)
                        && is_nearer(scene, &last, &other.state, &step.state)
                    {
                        found.wasted_iterations += step.iterations;
                        step = other;
                    }
                }
                scale = target;
                increment = (2.0 * increment).min(largest);
                last.clone_from(&step.state);
                visit(scene, &step);
                found.path.push(step);
            }
            Err(_)
                if increment == largest
                    && scale == 0.0
                    && at.kind == Kind::Static
                    && rests_nowhere(scene, &mut newton, at, &start)
                    && let Some(step) = settled(scene, &mut newton, at, &start) =>
            {
                visit(scene, &step);
                found.path.push(step);
                return Ok(found);
            }
            Err(failure) => {
                increment = 0.5 * (target - scale);
                if increment < SMALLEST {
                    let elsewhere = match at.kind {
                        _ if scale >= NO_WAY * at.scale => None,
                        Kind::Steady if patience == Patience::Patient => settled(scene, &mut newton, at, &start),
                        Kind::Steady => None,
                        Kind::Static => held_by_loads(scene, &mut newton, at, &start),
                    };
                    let Some(step) = elsewhere else {
                        return Err(failed(scene, at, &failure, scale));
                    };
                    visit(scene, &step);
                    found.path.push(step);
                    return Ok(found);
                }
            }
        }
    }
    Ok(found)
}

/// The equilibrium at the whole angular velocity that a start flows to: where next to rest nothing is stiff, as hinged
/// blades, no way leads there.
fn settled(scene: &mut dyn Scene, newton: &mut Newton, at: &Uniform, start: &State) -> Option<Continued> {
    let mut state = start.clone();
    let turning = angular_velocity(scene, at);
    let speed = if turning > 0.0 {
        turning
    } else {
        newton.pace(scene, at, &state)
    };
    newton.flow(scene, at, &mut state, speed).ok()?;
    let near = state.clone();
    let (mut result, mut iterations) = newton.solve(scene, at, &mut state, Patience::Strict);
    let mut negative = newton.count(at);
    if result.is_err() {
        // Where a stiff body swings, every third increment swings it and the others only take back how that stretched it:
        // increments grow and shrink in turns. What is found so must be where the flow ended, and stable.
        let more;
        state.clone_from(&near);
        (result, more) = newton.solve(scene, at, &mut state, Patience::Patient);
        iterations += more;
        negative = newton.count(at);
        if distance(scene, &near, &state) > NEAR || negative.is_any() {
            return None;
        }
    }
    result.ok()?;
    Some(Continued::far(at, state, iterations, negative))
}

/// The equilibrium under all loads where they are linear and hold what nothing else does, as a law of a point's place: growing from zero they would hold it
/// at one place for all parts of them, and what flows there need not come to rest.
fn held_by_loads(scene: &mut dyn Scene, newton: &mut Newton, at: &Uniform, start: &State) -> Option<Continued> {
    let (found, _) = attempt(scene, newton, at, [0.0, at.scale], start, Patience::Strict);
    found.ok().filter(|step| step.iterations <= LINEAR && !step.strayed)
}

/// The equilibrium next to the start without loads, if two least loads find as many negative directions of the stiffness there; `None` where they do not, as
/// of what nothing ties or stiffens.
pub fn unloaded(scene: &mut dyn Scene, at: &Uniform) -> Option<Continued> {
    let start = assembled(scene, at);
    check(scene, at, &start).ok()?;
    let mut newton = Newton::new(scene);
    let mut near = |scale: f64| {
        let (at, mut state) = (at.scaled(scale), start.clone());
        let (result, iterations) = newton.solve(scene, &at, &mut state, Patience::Strict);
        let stays = result.is_ok() && !newton.has_moved_far() && !newton.holds_untied();
        stays.then(|| Continued {
            scale,
            state,
            iterations,
            negative: newton.count(&at),
            strayed: newton.has_strayed(),
            moved_far: false,
        })
    };
    let found = near(SMALLEST)?;
    (near(4.0 * SMALLEST)?.negative == found.negative).then_some(found)
}

/// Whether an iteration from `last` to a part of the loads of `at` ends far from where it pointed to, or nowhere: what lies beyond a limit
/// point may look near by chance.
fn strays_within(scene: &mut dyn Scene, newton: &mut Newton, at: &Uniform, last: &State) -> bool {
    CUTS.into_iter().any(|part| {
        let mut state = last.clone();
        let loads = Uniform::at_rest(at.t).scaled(part * at.scale);
        let (result, _) = newton.solve(scene, &loads, &mut state, Patience::Strict);
        result.is_err() || newton.has_strayed()
    })
}

/// Angular velocity of a uniform motion, rad/s.
fn angular_velocity(scene: &dyn Scene, at: &Uniform) -> f64 {
    let full = at.spin.map(|spin| spin.velocity.norm());
    at.speed() * full.unwrap_or_else(|| scene.spin(at.t))
}

/// Whether a start is no equilibrium without loads, nor near one, as a slack rope, or leaves it at the least load, as a rope
/// that lies straight and hangs on one end: its stiffness there is round-off, and need not be found singular. Nor does it stay
/// where the whole load leads away along a motion that nothing ties.
fn rests_nowhere(scene: &mut dyn Scene, newton: &mut Newton, at: &Uniform, start: &State) -> bool {
    let mut stays = |part: f64| {
        let mut state = start.clone();
        let (result, _) = newton.solve(scene, &at.scaled(part * at.scale), &mut state, Patience::Strict);
        result.is_ok() && (part == 0.0 || !newton.has_moved_far())
    };
    if !stays(0.0) || !stays(SMALLEST) {
        return true;
    }
    let (result, _) = newton.solve(scene, at, &mut start.clone(), Patience::Strict);
    result.is_err() && newton.holds_untied()
}

/// The equilibrium at rest under the loads of `at` to which the start settles, if it is none without loads and none is near.
///
/// # Errors
/// [`SolveErrorKind::NoEquilibrium`] if it is one, or settles nowhere.
pub fn settle(scene: &mut dyn Scene, at: &Uniform) -> Result<Continued, SolveError> {
    let start = assembled(scene, at);
    check(scene, at, &start)?;
    let mut newton = Newton::new(scene);
    let found = rests_nowhere(scene, &mut newton, at, &start).then(|| settled(scene, &mut newton, at, &start));
    found.flatten().ok_or_else(|| {
        let row = newton.farthest();
        failed(scene, at, &Failure::Slow(row), at.scale)
    })
}

/// The stable equilibrium that is followed back from one under greater loads, by halves of them, where none is found from the start on: a rope that lies
/// straight between its ends has next to no stiffness across, and the more it sags, the sooner its iteration ends.
pub fn sagged(scene: &mut dyn Scene, at: &Uniform) -> Option<Continued> {
    let start = assembled(scene, at);
    check(scene, at, &start).ok()?;
    let (mut newton, mut iterations) = (Newton::new(scene), 0);
    let mut solve = |doublings: i32, state: &mut State, patience| {
        let at = at.scaled(2f64.powi(doublings) * at.scale);
        let (result, more) = newton.solve(scene, &at, state, patience);
        iterations += more;
        let negative = newton.count(&at);
        (result.is_ok() && !negative.is_any()).then_some(negative)
    };
    let (greater, mut state) = (1..=DOUBLINGS).find_map(|doublings| {
        let mut state = start.clone();
        solve(doublings, &mut state, Patience::Patient)?;
        Some((doublings, state))
    })?;
    let mut negative = Negative::Even;
    for doublings in (0..greater).rev() {
        negative = solve(doublings, &mut state, Patience::Strict)?;
    }
    Some(Continued::far(at, state, iterations, negative))
}

/// The equilibrium at the whole spin that grows out of that at rest under the same loads.
fn grown_from_rest(scene: &mut dyn Scene, at: &Uniform) -> Option<Continued> {
    let still = Uniform { spinning: 0.0, ..*at };
    let rest = along(scene, &still, 1.0, Patience::Strict, |_, _| ()).ok()?;
    let SpunUp {
        state,
        iterations,
        negative,
    } = from_rest(scene, at, rest.state()?.clone())?;
    Some(Continued::far(at, state, rest.iterations() + iterations, negative))
}

/// Whether the first of two equilibria is nearer to a start than the second.
pub fn is_nearer(scene: &dyn Scene, start: &State, one: &State, other: &State) -> bool {
    distance(scene, start, one) < distance(scene, start, other)
}

/// Whether the equilibrium `from`, which stands where `at` says, goes back to `to`; `None` where nothing is found there.
pub fn goes_back(scene: &mut dyn Scene, at: &Uniform, from: &State, to: &State) -> Option<bool> {
    let mut back = from.clone();
    back.t = at.t;
    let (result, _) = Newton::new(scene).solve(scene, at, &mut back, Patience::Strict);
    result.ok()?;
    Some(distance(scene, &back, to) <= RETURNED)
}

/// The equilibrium at the second of two scales from that at the first one; also the iterations that led nowhere or
/// back. What an iteration that wandered found counts only if it lies on the side that the first increment pointed to
/// and if the way back ends where it began: of another branch neither needs to hold.
pub(super) fn attempt(
    scene: &mut dyn Scene,
    newton: &mut Newton,
    at: &Uniform,
    [scale, target]: [f64; 2],
    last: &State,
    patience: Patience,
) -> (Result<Continued, Failure>, u32) {
    let mut state = last.clone();
    let (result, iterations) = newton.solve(scene, &at.scaled(target), &mut state, patience);
    if let Err(failure) = result {
        return (Err(failure), iterations);
    }
    let step = Continued {
        scale: target,
        state,
        iterations,
        negative: newton.count(at),
        strayed: newton.has_strayed(),
        moved_far: newton.has_moved_far(),
    };
    let is_first = at.kind == Kind::Static && scale == 0.0 && newton.has_moved_far();
    if patience == Patience::Strict {
        return (Ok(step), 0);
    }
    let is_doubtful =
        newton.has_wandered() || step.strayed || is_first && strays_within(scene, newton, &at.scaled(target), last);
    if !is_doubtful {
        return (Ok(step), 0);
    }
    let leapt = Failure::Leapt(newton.farthest());
    let is_long = target - scale >= 2.0 * SMALLEST;
    if newton.has_turned_back() || is_long && is_first {
        return (Err(leapt), iterations);
    }
    // The way back from another branch leads elsewhere.
    let (mut start, mut wasted) = (last.clone(), 0);
    if scale == 0.0 {
        // The start need be no equilibrium, nor be there one without loads.
        let (result, more) = newton.solve(scene, &at.scaled(0.0), &mut start, patience);
        wasted += more;
        if result.is_err() {
            let (result, more) = attempt(scene, newton, at, [scale, target], last, Patience::Strict);
            return (result, wasted + iterations + more);
        }
    }
    let mut back = step.state.clone();
    let (result, more) = newton.solve(scene, &at.scaled(scale), &mut back, patience);
    wasted += more;
    if result.is_ok() && distance(scene, &back, &start) <= RETURNED {
        (Ok(step), wasted)
    } else {
        (Err(leapt), wasted + iterations)
    }
}

/// The equilibrium near a guess, e.g. that of nearby parameters: positions, orientations and
/// multipliers are read.
///
/// # Errors
/// As [`follow`].
pub fn continue_from(scene: &mut dyn Scene, at: &Uniform, guess: &State) -> Result<Continued, SolveError> {
    continue_holding(scene, at, guess, Vec::new())
}

/// The same where nothing ties some directions of the unknowns ([`untied_directions`](super::untied_directions) of an equilibrium nearby): beside one
/// they do not show, and an iteration that nothing holds is led far along them.
///
/// # Errors
/// As [`follow`].
pub fn continue_holding(
    scene: &mut dyn Scene,
    at: &Uniform,
    guess: &State,
    untied: Vec<Vec<f64>>,
) -> Result<Continued, SolveError> {
    check(scene, at, guess)?;
    let mut state = guess.clone();
    state.t = at.t;
    let mut newton = Newton::new(scene);
    newton.untied = untied;
    let (result, iterations) = newton.solve(scene, at, &mut state, Patience::Strict);
    match result {
        Ok(()) => Ok(Continued {
            scale: at.scale,
            state,
            iterations,
            negative: newton.count(at),
            strayed: newton.has_strayed(),
            moved_far: newton.has_moved_far(),
        }),
        Err(failure) => Err(failed(scene, at, &failure, at.scale)),
    }
}

pub(super) fn error(at: &Uniform, text: String, worst: Option<String>) -> SolveError {
    SolveError {
        kind: SolveErrorKind::NoEquilibrium(text),
        t: at.t,
        h: 0.0,
        worst,
    }
}

/// Whether an equilibrium may exist.
pub(super) fn check(scene: &mut dyn Scene, at: &Uniform, guess: &State) -> Result<(), SolveError> {
    if !scene.is_referenced() {
        let text = "the unknowns do not turn with the bodies; take the formulation rncf";
        return Err(error(at, text.into(), None));
    }
    match scene.uniform_obstacle(at, guess) {
        Some(obstacle) => Err(error(at, obstacle, None)),
        None => Ok(()),
    }
}

pub(super) fn failed(scene: &dyn Scene, at: &Uniform, failure: &Failure, scale: f64) -> SolveError {
    let (part, of) = match at.kind {
        Kind::Steady if scene.spin_in(&at.whole()) == 0.0 => (scale * scale, "load"),
        Kind::Steady => (scale, "angular velocity"),
        Kind::Static => (scale, "load"),
    };
    let (text, row) = failure.explain(&format!("beyond {} of the {of}", Short(part)));
    error(at, text, row.map(|row| describe(scene, row)))
}

pub(super) fn describe(scene: &dyn Scene, row: usize) -> String {
    let n = scene.unknowns();
    if row < n {
        scene.describe_unknown(row)
    } else if row < n + scene.constraints() {
        scene.describe_constraint(row - n)
    } else {
        "a motion that nothing ties".into()
    }
}
