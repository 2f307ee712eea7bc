//! Where an equilibrium is looked for: the start, or what became of it where motions have turned or shifted what it is tied to.

use super::distance::turned;
use super::newton::{Newton, Patience};
use crate::model::{Scene, Uniform};
use crate::system::{ConstraintLevel, State};

/// Largest and smallest step, as parts of the time: half a turn in one step would lead nowhere.
const LARGEST: f64 = 1.0 / 64.0;
const SMALLEST: f64 = 1.0 / 16384.0;
/// Most steps: what turns some hundred times is not followed.
const MOST: usize = 1024;
/// Violation of constraints over the largest size up to which what was carried on is assembled.
const ASSEMBLED: f64 = 1e-6;
/// Times up to the wanted one at which it is looked whether anything moves: whole turns lead back.
const LOOKS: u32 = 37;
/// Part of forces, and of sizes, by which they change by round-off where all turns together.
const ROUND_OFF: f64 = 1e-12;
/// Distance over the sizes (rad of what turns) that one step may lead: within it no joint holds a second time.
const NEXT: f64 = 0.5;

/// A state from which an equilibrium at the time of `at` may be looked for: [`Scene::uniform_guess`], or where motions have moved what
/// it is tied to, the state without loads that has followed them from t = 0. A joint that turned by more than a quarter turn holds half
/// a turn away, too. A scene in which nothing has a length takes the one of its loads ([`Scene::measure_length`]).
pub fn assembled(scene: &mut dyn Scene, at: &Uniform) -> State {
    scene.measure_length(at);
    let guess = scene.uniform_guess(at);
    if at.t == 0.0 {
        return guess;
    }
    let begun = Uniform::at_rest(0.0).scaled(0.0);
    let start = scene.uniform_guess(&Uniform { spin: at.spin, ..begun });
    // What turns uniformly is carried on with it, and stays assembled where nothing ties it to what does not turn.
    let is_carried = start.x != guess.x || start.turns != guess.turns;
    let stays = if is_carried {
        let [[_, before], [_, after]] = [balance(scene, 0.0, &start), balance(scene, at.t, &guess)];
        let size = scene.largest_length().max(1.0);
        before
            .iter()
            .zip(&after)
            .all(|(before, after)| after.abs() <= before.abs() + ASSEMBLED * size)
    } else {
        let [before, after] = [0.0, at.t].map(|t| balance(scene, t, &start));
        // Where nothing moves there is no round-off.
        before == after
            || is_same(scene, &before, &after)
                && (1..LOOKS).all(|look| {
                    let between = balance(scene, at.t * f64::from(look) / f64::from(LOOKS), &start);
                    is_same(scene, &before, &between)
                })
    };
    if stays {
        return guess;
    }
    followed(scene, at.t, start).unwrap_or(guess)
}

/// Whether forces and violations differ by round-off alone.
fn is_same(scene: &dyn Scene, before: &[Vec<f64>; 2], after: &[Vec<f64>; 2]) -> bool {
    let largest = |values: &[f64]| values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let size = scene.largest_length().max(1.0);
    let scales = [largest(&before[0]), size];
    let pairs = before.iter().zip(after).zip(scales);
    pairs.into_iter().all(|((before, after), scale)| {
        let mut pairs = before.iter().zip(after);
        pairs.all(|(before, after)| (after - before).abs() <= ROUND_OFF * scale)
    })
}

/// Forces without loads, and violations of the constraints, at a time.
fn balance(scene: &mut dyn Scene, t: f64, state: &State) -> [Vec<f64>; 2] {
    let mut state = state.clone();
    state.t = t;
    let at = Uniform::at_rest(t).scaled(0.0);
    scene.uniform_state(&at, &mut state);
    let [mut forces, mut violations] = [vec![0.0; scene.unknowns()], vec![0.0; scene.constraints()]];
    scene.uniform_residual(&at, &state, &mut forces);
    scene.constraint(ConstraintLevel::Position, &state, &mut violations);
    [forces, violations]
}

/// The state at time `t` (s) that is led there from `start` by the motions, without loads; `None` where the way ends. Where no equilibrium
/// is near the start, as of what hangs on springs, what acts on it is left out of account.
fn followed(scene: &mut dyn Scene, t: f64, start: State) -> Option<State> {
    let mut newton = Newton::new(scene);
    let mut last = next(scene, &mut newton, 0.0, &start).unwrap_or_else(|| {
        [newton.unbalanced, _] = balance(scene, 0.0, &start);
        start
    });
    let (mut part, mut increment) = (0.0, LARGEST);
    for _ in 0..MOST {
        let target = f64::min(part + increment, 1.0);
        if let Some(state) = next(scene, &mut newton, target * t, &last) {
            (last, part) = (state, target);
            if part == 1.0 {
                return Some(last);
            }
            increment = LARGEST.min(2.0 * increment);
        } else {
            increment *= 0.5;
            if increment < SMALLEST {
                return None;
            }
        }
    }
    None
}

/// The state at time `t` (s) that the motions lead to from `last`; `None` where it is not next to it.
fn next(scene: &mut dyn Scene, newton: &mut Newton, t: f64, last: &State) -> Option<State> {
    let mut state = last.clone();
    state.t = t;
    let (result, _) = newton.solve(scene, &Uniform::at_rest(t).scaled(0.0), &mut state, Patience::Strict);
    (result.is_ok() && turned(scene, last, &state) <= NEXT).then_some(state)
}
