//! What a uniform motion is not: that which is declared, or that which stays.

use super::modes::{MANY, SeenMode, growth};
use crate::app::writing::numbers::digits;
use crate::app::writing::sentences::listed;
use crate::equilibrium::{self, Uniform};
use crate::{Scene, SolveError, State, modes};

/// Most names in a sentence.
const MOST: usize = 3;

/// That what does not start in the rotation is taken to turn with all else.
pub(in crate::app) fn taken_along(scene: &mut dyn Scene, at: &Uniform) -> Option<String> {
    let names = equilibrium::taken_along(scene, at);
    let [starts, counts, it] = match names.len() {
        1 => ["does not start", "counts", "it"],
        _ => ["do not start", "count", "them"],
    };
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    Some(format!(
        "{} {starts} in the rotation of {} rad/s, and {counts} as turning so: one rotation holds for all that moves freely. Give {it} that `angular_velocity`, or follow what turns otherwise in a run",
        listed(&names, MOST)?,
        digits(scene.spin_in(at), 7)
    ))
}

/// The time, s, in which a disturbance of an equilibrium grows by the factor e; `None` where none does.
///
/// # Errors
/// Its modes are not found.
pub(in crate::app) fn time_of_growth(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    count: usize,
) -> Result<Option<f64>, SolveError> {
    let (found, _) = modes::modes_and_growing(scene, at, state, modes::Wanted { count }, MANY)?;
    let seen: Vec<SeenMode> = found.iter().map(|mode| SeenMode::of(scene, at, state, mode)).collect();
    Ok(growth(&seen).map(|growth| 1.0 / growth))
}
