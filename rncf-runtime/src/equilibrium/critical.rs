//! Where a static equilibrium loses its stability as the loads grow: buckling and limit points.

use super::continuation::{Continued, LOAD_STEP, SMALLEST, along, check, unloaded};
use super::newton::{Newton, Patience};
use crate::error::SolveError;
use crate::model::{Scene, Uniform};
use crate::system::State;

/// Relative width to which the load is bracketed.
const WIDTH: f64 = 1e-6;

/// A critical point of static equilibria.
#[derive(Clone, Debug, PartialEq)]
pub struct Critical {
    /// Part of the loads at which it is, to 1e-6.
    pub factor: f64,
    /// The last equilibrium in front of it.
    pub state: State,
    /// Whether no equilibrium was found behind it (a limit point); else the bodies buckle.
    pub is_limit: bool,
}

/// The first part of the loads of time `t` (s), up to 1, at which the stiffness of the static
/// equilibrium becomes singular; `None` where it does not.
///
/// # Errors
/// As [`follow`](super::follow), if there is no equilibrium at small loads.
pub fn critical_factor(scene: &mut dyn Scene, t: f64) -> Result<Option<Critical>, SolveError> {
    let at = Uniform::at_rest(t);
    let mut path: Vec<Continued> = unloaded(scene, &at).into_iter().collect();
    let outcome = along(scene, &at, LOAD_STEP, Patience::Strict, |_, step| {
        path.push(step.clone())
    });
    let Some(first) = path.first() else {
        return outcome.map(|_| None);
    };
    let changed = path.iter().position(|step| step.negative != first.negative);
    let (before, beyond) = match (changed, outcome) {
        (Some(place), _) => (path[place - 1].clone(), path[place].scale),
        (None, Ok(_)) => return Ok(None),
        // The way ends where its smallest increment leads nowhere: farther on is another branch.
        (None, Err(_)) => {
            let last = path[path.len() - 1].clone();
            let beyond = (last.scale + 2.0 * SMALLEST).min(1.0);
            (last, beyond)
        }
    };
    Ok(Some(bracket(scene, &at, before, beyond, changed.is_none())?))
}

/// Bisects between the last equilibrium in front of the critical point and a load beyond it.
fn bracket(
    scene: &mut dyn Scene,
    at: &Uniform,
    mut before: Continued,
    mut beyond: f64,
    mut is_limit: bool,
) -> Result<Critical, SolveError> {
    check(scene, at, &before.state)?;
    let mut newton = Newton::new(scene);
    while beyond - before.scale > WIDTH * beyond {
        let at = at.scaled(0.5 * (before.scale + beyond));
        let mut state = before.state.clone();
        let (result, iterations) = newton.solve(scene, &at, &mut state, Patience::Strict);
        let negative = newton.count(&at);
        if result.is_ok() && negative == before.negative {
            before = Continued {
                scale: at.scale,
                state,
                iterations,
                negative,
                strayed: newton.has_strayed(),
                moved_far: newton.has_moved_far(),
            };
        } else {
            is_limit = result.is_err();
            beyond = at.scale;
        }
    }
    Ok(Critical {
        factor: 0.5 * (before.scale + beyond),
        state: before.state,
        is_limit,
    })
}
