//! The relative equilibrium that grows out of that at rest under the same loads, as the spin grows.

use super::continuation::{Continued, along};
use super::newton::{Newton, Patience};
use crate::model::{Scene, Uniform};

/// First and smallest increment of the spin, as parts of it.
const FIRST: f64 = 1.0 / 16.0;
const SMALLEST: f64 = 1.0 / 1024.0;

/// The equilibrium at the whole spin of `at`, followed from rest; `None` where the way ends, or nothing is at rest under the loads.
pub(super) fn from_rest(scene: &mut dyn Scene, at: &Uniform) -> Option<Continued> {
    let turning = |part: f64| Uniform {
        spinning: part * at.spinning,
        ..*at
    };
    let rest = along(scene, &turning(0.0), 1.0, Patience::Strict, |_, _| ()).ok()?;
    let mut last = rest.state()?.clone();
    let mut iterations = rest.iterations();
    let mut newton = Newton::new(scene);
    let (mut part, mut increment) = (0.0, FIRST);
    loop {
        let target = f64::min(part + increment, 1.0);
        let mut state = last.clone();
        let (result, more) = newton.solve(scene, &turning(target), &mut state, Patience::Strict);
        iterations += more;
        if result.is_err() || newton.has_strayed() {
            increment *= 0.5;
            if increment < SMALLEST {
                return None;
            }
            continue;
        }
        if target == 1.0 {
            return Some(Continued {
                scale: at.scale,
                state,
                iterations,
                negative: newton.count(at),
                strayed: false,
                moved_far: true,
            });
        }
        (last, part) = (state, target);
        increment = FIRST.min(2.0 * increment);
    }
}
