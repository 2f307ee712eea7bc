//! The relative equilibrium that grows out of that at rest under the same loads, as the spin grows.

use super::negative::Negative;
use super::newton::{Newton, Patience};
use crate::model::{Scene, Uniform};
use crate::system::State;

/// First and smallest increment of the spin, as parts of it.
const FIRST: f64 = 1.0 / 16.0;
const SMALLEST: f64 = 1.0 / 1024.0;

/// The equilibrium at the whole spin.
pub(super) struct SpunUp {
    pub state: State,
    pub iterations: u32,
    pub negative: Negative,
}

/// The equilibrium at the whole spin of `at`, followed from that at `rest`; `None` where the way ends.
pub(super) fn from_rest(scene: &mut dyn Scene, at: &Uniform, rest: State) -> Option<SpunUp> {
    let mut newton = Newton::new(scene);
    let (mut last, mut iterations) = (rest, 0);
    let (mut part, mut increment) = (0.0, FIRST);
    loop {
        let target = f64::min(part + increment, 1.0);
        let turning = Uniform {
            spinning: target * at.spinning,
            ..*at
        };
        let mut state = last.clone();
        let (result, more) = newton.solve(scene, &turning, &mut state, Patience::Strict);
        iterations += more;
        if result.is_err() || newton.has_strayed() {
            increment *= 0.5;
            if increment < SMALLEST {
                return None;
            }
            continue;
        }
        if target == 1.0 {
            let negative = newton.count(at);
            return Some(SpunUp {
                state,
                iterations,
                negative,
            });
        }
        (last, part) = (state, target);
        increment = FIRST.min(2.0 * increment);
    }
}
