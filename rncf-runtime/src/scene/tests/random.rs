//! States at random, and changes of them along right increments.

use crate::space::{Rotation, Vector, turned};
use crate::system::{State, System};

/// A small generator: the tests need no more than numbers without pattern.
pub struct Random(pub u64);

impl Random {
    /// Between -1 and 1.
    pub fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Changes all parts of a state by about `size`.
    pub fn shake(&mut self, system: &dyn System, state: &mut State, size: f64) {
        for i in 0..state.x.len() {
            state.x[i] += size * self.number();
            state.v[i] += self.number();
            state.a[i] += self.number();
        }
        state.lambda.iter_mut().for_each(|lambda| *lambda = self.number());
        for turn in &mut state.turns {
            *turn = turned(turn, Vector::new(self.number(), self.number(), self.number()));
        }
        state.rebase(system.turns());
    }
}

/// The state with unknown `index` moved by `step`; orientations by a right increment.
pub fn moved(system: &dyn System, state: &State, index: usize, step: f64) -> State {
    let mut moved = state.clone();
    let turn = system
        .turns()
        .iter()
        .position(|&first| (first..first + 3).contains(&index));
    match turn {
        Some(turn) => {
            let first = system.turns()[turn];
            let mut increment = [0.0; 3];
            increment[index - first] = step;
            let orientation: Rotation = state.orientation(turn, first);
            moved.turns[turn] = turned(&orientation, increment.into());
            moved.x[first..first + 3].fill(0.0);
        }
        None => moved.x[index] += step,
    }
    moved
}
