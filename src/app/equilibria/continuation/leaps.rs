//! Whether an equilibrium continues the last one, or lies on another branch.

use super::{Found, Line, SHORT, secant};
use crate::equilibrium::{CUTS, Continued, Kind, Negative, Uniform, distance, goes_back};
use crate::{Scene, State};

/// Halvings of a step after which equilibria that continue each other are nearer than this part of their distance before.
const FORKED: u32 = 16;
const APART: f64 = 1.0 / 4096.0;
/// Equilibria that grow so many times as far apart lie on both sides of a pole, as those of an unbalanced shaft beside its critical speed.
const POLE: f64 = 16.0;
/// Distance up to which nothing moves in a step.
const STILL: f64 = 1e-6;
/// Part of a step by which it is beside the secant where the way bends.
const BENT: f64 = 0.5;

impl Line<'_> {
    /// Whether the first static step is far from straight where it is cut: what lies beyond a limit point may look near by chance.
    fn leaps_within(&mut self, share: f64) -> bool {
        if self.place > 0 {
            return false;
        }
        let strays = |part: f64| {
            let Ok((mut scene, at)) = self.placed(part * share) else {
                return false;
            };
            let last = self.last.state.clone();
            let found = self.continued(scene.as_mut(), &at, &last);
            self.give_back(scene);
            found.map_or(true, |found| found.strayed)
        };
        CUTS.into_iter().any(strays)
    }

    /// Whether a limit point may lie between the last static equilibrium and the one that was found. Shorter steps show it.
    pub(super) fn leaps(&mut self, scene: &mut dyn Scene, at: &Uniform, share: f64, found: &Continued) -> bool {
        if self.increment > 1 && (found.strayed || self.leaps_within(share)) {
            return true;
        }
        let is_doubtful = found.strayed || found.moved_far && self.place > 0;
        is_doubtful && self.has_leapt(scene, at, found) || self.increment > 1 && self.forks(scene, at, share, found)
    }

    /// The same of relative equilibria. Where short steps are none either, what follows is the other side of a critical speed.
    pub(super) fn leaps_turning(&mut self, scene: &mut dyn Scene, at: &Uniform, share: f64, found: &Continued) -> bool {
        let is_long = self.increment > 2 * SHORT;
        is_long && (found.strayed || found.moved_far && self.has_leapt(scene, at, found))
            || self.increment > 1 && self.forks(scene, at, share, found)
    }

    /// Whether something in a step is no continuation: half of it, a quarter and so on, the one in which the negative directions change or else more
    /// moves, does not become shorter. Next to a fork the way of what is not perfect bends away, and one step may find the branch that goes straight on,
    /// or bends to the other side.
    fn forks(&mut self, scene: &mut dyn Scene, at: &Uniform, share: f64, found: &Continued) -> bool {
        let state = scene.carried(at, &found.state, true);
        let mut before = self.before.as_ref().map(Found::placed);
        let (mut low, mut high) = (self.last.placed(), (share, state));
        let apart = distance(scene, &low.1, &high.1);
        let guess = self.before.is_some().then(|| self.predicted(scene, share));
        let bends = guess.is_some_and(|guess| guess.is_ok_and(|guess| is_bent(scene, [&low.1, &guess, &high.1])));
        let changes = self.changes(found.negative);
        let is_static = self.kind == Kind::Static;
        if apart <= STILL || !(changes || bends && is_static) {
            return false;
        }
        for _ in 0..FORKED {
            let middle = 0.5 * (low.0 + high.0);
            let guess = match &before {
                Some(before) => secant(scene, [before, &low], middle),
                None => low.1.clone(),
            };
            let guesses = [&guess, &low.1, &high.1];
            let Some((state, negative)) = guesses.into_iter().find_map(|guess| self.beside(middle, guess)) else {
                // Beside a critical speed nothing need be found.
                return is_static || self.increment > 2 * SHORT;
            };
            let is_beyond = if changes {
                self.changes(negative)
            } else {
                distance(scene, &low.1, &state) > distance(scene, &state, &high.1)
            };
            if is_beyond {
                high = (middle, state);
            } else {
                before = Some(std::mem::replace(&mut low, (middle, state)));
            }
        }
        let left = distance(scene, &low.1, &high.1) / apart;
        left > APART && (is_static || left < POLE)
    }

    /// Whether these are not the negative directions of the last equilibrium.
    fn changes(&self, negative: Negative) -> bool {
        self.last.negative.is_some_and(|known| negative.differs(known))
    }

    /// The equilibrium near a guess at a part of the way, carried back, and its negative directions.
    fn beside(&mut self, share: f64, guess: &State) -> Option<(State, Negative)> {
        let (mut scene, at) = self.placed(share).ok()?;
        let found = self.continued(scene.as_mut(), &at, guess).ok();
        let found = found.map(|found| (scene.carried(&at, &found.state, true), found.negative));
        self.give_back(scene);
        found
    }

    /// Whether the way back from an equilibrium does not end at the last one.
    fn has_leapt(&mut self, scene: &mut dyn Scene, at: &Uniform, found: &Continued) -> bool {
        let state = scene.carried(at, &found.state, true);
        let Ok((mut scene, at)) = self.placed(self.last.share) else {
            return false;
        };
        let [from, to] = [&state, &self.last.state].map(|state| {
            let mut state = state.clone();
            state.t = at.t;
            scene.carried(&at, &state, false)
        });
        let goes_back = goes_back(scene.as_mut(), &at, &from, &to);
        self.give_back(scene);
        goes_back == Some(false)
    }
}

/// Whether an equilibrium lies beside the guess for it by a large part of the step from the last one; orientations, which are not guessed, aside.
fn is_bent(scene: &dyn Scene, [last, guess, found]: [&State; 3]) -> bool {
    let mut is_turn = vec![false; last.x.len()];
    for &turn in scene.turns() {
        is_turn[turn..turn + 3].fill(true);
    }
    let apart = |one: &State, other: &State| {
        let parts = one.x.iter().zip(&other.x).zip(scene.sizes()).zip(&is_turn);
        let parts = parts.filter(|(_, is_turn)| !**is_turn);
        parts.fold(0.0, |largest: f64, (((a, b), size), _)| {
            largest.max((a - b).abs() / size)
        })
    };
    apart(guess, found) > STILL.max(BENT * apart(last, found))
}
