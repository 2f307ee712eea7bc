//! Modes, and a Campbell diagram, beside those of finer meshes.

use crate::Scene;
use crate::app::equilibria::finer::{farthest, told_of_values};
use crate::app::judged::finer_modes::{Beside, Found, Vibration, compare};
use crate::app::results::campbell::Campbell;
use crate::app::results::modes::SeenMode;
use crate::modes::Critical;

/// How far modes are from those `there`, on finer meshes.
pub(super) fn of_modes(scene: &dyn Scene, modes: &[SeenMode], there: &[SeenMode]) -> Option<Found> {
    let [own, there] = [modes, there].map(|modes| vibrating(numbered(modes)));
    compare(scene, &own, &there, Beside::default())
}

/// How far the modes at the last value of a diagram are from those `there`, on finer meshes, and critical values from those beside them.
pub(super) fn of_campbell(
    scene: &dyn Scene,
    diagram: &Campbell,
    there: &[SeenMode],
    [here, near]: [Vec<Critical>; 2],
) -> Option<Found> {
    let key = &diagram.key;
    let end = diagram.keys.last().copied().unwrap_or_default();
    let beside = Beside {
        place: format!(" at {}", key.at(end, 6)),
        values: told_of_values(key, &here, &near),
        of_values: farthest(&here, &near),
    };
    let [own, there] = [last(diagram), numbered(there)].map(vibrating);
    compare(scene, &own, &there, beside)
}

fn numbered(modes: &[SeenMode]) -> Vec<(usize, SeenMode)> {
    modes.iter().copied().enumerate().collect()
}

/// The modes at the last value, with the numbers of their tracks.
fn last(diagram: &Campbell) -> Vec<(usize, SeenMode)> {
    let tracks = diagram.tracks.iter().enumerate();
    tracks
        .filter_map(|(track, modes)| Some((track, (*modes.last()?)?)))
        .collect()
}

/// Those that have a frequency, the lowest first; a motion that creeps has none.
fn vibrating(modes: Vec<(usize, SeenMode)>) -> Vec<Vibration> {
    let all = modes.into_iter().filter(|(_, mode)| mode.im > mode.re.abs());
    let mut all: Vec<Vibration> = all.map(|(number, mode)| (number, [mode.re, mode.im])).collect();
    all.sort_by(|a, b| a.1[1].total_cmp(&b.1[1]));
    all
}
