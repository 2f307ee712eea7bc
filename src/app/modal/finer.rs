//! What finer meshes make of modes, and of a Campbell diagram.

use super::campbell::campbell;
use super::modes::of_finer;
use crate::app::equilibria::finer::{farthest, told_of_values};
use crate::app::equilibria::way;
use crate::app::judged::finer::{FINER, Judging};
use crate::app::judged::finer_model::FinerModel;
use crate::app::judged::finer_modes::{self, Beside, Found, Vibration, compare};
use crate::app::results::campbell::Campbell;
use crate::app::results::equilibria::{EquilibriumSettings, Range};
use crate::app::results::modes::SeenMode;
use crate::app::writing::numbers::digits;
use crate::modes::Critical;
use crate::{AnyModel, Scene};

/// Part of a critical value within which it is looked for on finer meshes, and most values that are.
const NEAR: f64 = 0.05;
const MOST: usize = 8;

/// What finer meshes make of the frequencies, where that is asked for. `model` has the value at which they were found.
pub(super) fn of_modes(
    model: &dyn AnyModel,
    settings: &EquilibriumSettings,
    scene: &dyn Scene,
    modes: &[SeenMode],
) -> Option<Found> {
    if !finer_modes::is_asked(settings.judged, scene.unknowns()) {
        return None;
    }
    let there = of_finer(&finer(model), settings, &scene.bodies())?;
    let [own, there] = [modes, &there].map(|modes| vibrating(numbered(modes)));
    compare(scene, &own, &there, Beside::default())
}

/// The same of a complete diagram: of the frequencies at its last value, which takes as long as a few of its rows, and of its critical values.
pub(super) fn of_campbell(
    model: &dyn AnyModel,
    settings: &EquilibriumSettings,
    scene: &dyn Scene,
    diagram: &Campbell,
) -> Option<Found> {
    if settings.judged == Judging::No {
        return None;
    }
    let settings = EquilibriumSettings {
        judged: Judging::No,
        ..*settings
    };
    let finer = finer(model);
    let at_the_end = way::at_the_end(&finer, &settings);
    let there = of_finer(at_the_end.as_ref(), &settings, &scene.bodies())?;
    let key = &diagram.key;
    let unit = if key.unit == "1" {
        String::new()
    } else {
        format!(" {}", key.unit)
    };
    let end = digits(diagram.keys.last().copied().unwrap_or_default(), 6);
    let [here, near] = critical_values(&finer, &settings, &diagram.critical);
    let beside = Beside {
        place: format!(" at {} = {end}{unit}", key.name),
        values: told_of_values(key, &here, &near),
        of_values: farthest(&here, &near),
    };
    let [own, there] = [last(diagram), numbered(&there)].map(vibrating);
    compare(scene, &own, &there, beside)
}

/// Critical values of a parameter, each beside the nearest one of the finer model; one that is nowhere near counts as that far away.
fn critical_values(finer: &FinerModel, settings: &EquilibriumSettings, own: &[Critical]) -> [Vec<Critical>; 2] {
    let Some(whole) = settings.range else {
        return [Vec::new(), Vec::new()];
    };
    let mut both = [Vec::new(), Vec::new()];
    for own in own.iter().take(MOST) {
        let [low, high] = [whole.from.min(whole.to), whole.from.max(whole.to)];
        let far = NEAR * own.value.abs();
        let range = Range {
            from: (own.value - far).max(low),
            to: (own.value + far).min(high),
            ..whole
        };
        let settings = EquilibriumSettings {
            range: Some(range),
            steps: 1,
            count: 1,
            ..*settings
        };
        let Ok(there) = campbell(finer, &settings) else {
            continue;
        };
        let away = |of: &Critical| (of.value - own.value).abs();
        let nearest = there.critical.into_iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        both[0].push(*own);
        both[1].push(nearest.unwrap_or(Critical {
            value: own.value + far,
            ..*own
        }));
    }
    both
}

fn finer(model: &dyn AnyModel) -> FinerModel {
    FinerModel {
        model: model.boxed(),
        times: FINER,
    }
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
