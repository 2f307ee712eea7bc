//! Campbell diagrams: modes over a parameter or the spin, each followed by its shape (THEORY 8.1);
//! nothing is printed or written here.

use std::ops::ControlFlow;

use super::finer;
use super::looked::size;
use super::modes::of_finer;
use super::onsets::onset;
use super::tracker::Tracker;
use crate::app::equilibria::continuation::{EquilibriumProgress, Line};
use crate::app::equilibria::nearer::{DIAGRAM, nearer};
use crate::app::equilibria::way;
use crate::app::judged::cautions;
use crate::app::judged::finer::Judging;
use crate::app::judged::finer_model::FinerModel;
use crate::app::judged::finer_modes::{Found, Told};
use crate::app::machine::clock::{Clock, Seconds};
use crate::app::results::campbell::Campbell;
use crate::app::results::equilibria::{EquilibriumSettings, Range};
use crate::app::results::error::RunError;
use crate::app::results::history::History;
use crate::app::results::incomplete::Incomplete;
use crate::app::results::modes::MANY;
use crate::app::results::uniform;
use crate::app::writing::numbers::digits;
use crate::equilibrium::{self, Kind};
use crate::modes::{self, Critical, Wanted};
use crate::{AnyModel, Scene};

/// Part of a critical value within which it is looked for on finer meshes, and most values that are.
const NEAR: f64 = 0.05;
const MOST: usize = 8;

/// The modes of a model over a parameter, or over the spin from rest to that of the time of the settings.
///
/// A ball of 1 kg slides on a rail of a turning hub, and a coil of 100 N/m and 1 m holds it:
///
/// ```
/// rncf::model! {
///     pub model Governor {
///         param speed = 5 rad/s;
///         frame hub = rotating(axis = z, angle = speed * t);
///         rigid ball in hub { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [1, 0, 0] m; }
///         joint rail = prismatic(ball, hub, axis = x);
///         spring coil = linear(ball, hub, stiffness = 100 N/m, length = 1 m);
///         output r = ball.in(hub).x;
///         run { t_end = 1 s; every = 0.1 s; }
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use rncf::app::{EquilibriumSettings, Range, campbell};
/// let range = Range { param: 0, from: 0.0, to: 8.0 };
/// let found = campbell(&Governor::default(), &EquilibriumSettings { range: Some(range), ..Default::default() })?;
/// // The frequency falls from 10 rad/s to that of the coil less what drives outwards.
/// let seen: Vec<f64> = found.tracks[0].iter().flatten().map(|mode| mode.im).collect();
/// assert!((seen[0] - 10.0).abs() < 1e-6 && (seen.last().unwrap() - f64::sqrt(100.0 - 8.0 * 8.0)).abs() < 1e-6);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// A model that cannot be built; [`RunError::Equilibrium`] where no equilibrium or no modes exist at the
/// start; [`RunError::Campbell`] with the modes found where the way ends early.
pub fn campbell(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Result<Campbell, RunError> {
    campbell_watched(model, settings, |_| ControlFlow::Continue(()))
}

/// As [`campbell`]; `watch` is called after every step, and ends the way by [`ControlFlow::Break`].
///
/// # Errors
/// As [`campbell`].
pub fn campbell_watched(
    model: &dyn AnyModel,
    settings: &EquilibriumSettings,
    mut watch: impl FnMut(&EquilibriumProgress) -> ControlFlow<()>,
) -> Result<Campbell, RunError> {
    let clock = Clock::start();
    let mut line = Line::start(model, Kind::Steady, settings)?;
    let mut tracker = Tracker::default();
    let mut diagram = Campbell {
        settings: *settings,
        t: 0.0,
        key: line.column(),
        keys: Vec::new(),
        spins: Vec::new(),
        excitations: Vec::new(),
        tracks: Vec::new(),
        is_round: true,
        is_all: true,
        critical: Vec::new(),
        standing: Vec::new(),
        is_near: true,
        crossings: Vec::new(),
        onsets: Vec::new(),
        compositions: Vec::new(),
        mesh_errors: Vec::new(),
        bodies: Vec::new(),
        masses: Vec::new(),
        unknowns: 0,
        constraints: 0,
        newton_iterations: 0,
        warnings: Vec::new(),
        agreement: None,
        seconds: Seconds::default(),
        incomplete: None,
    };
    let mut reason = tracker.look(&mut line, &mut diagram).err().map(Incomplete::Equilibrium);
    let mut beyond = Vec::new();
    if reason.is_none() {
        tracker.judge_meshes(&mut line, &diagram);
        beyond.extend(growing_beyond(&mut line, &diagram));
    }
    while reason.is_none() && !line.is_done() {
        reason = line
            .advance()
            .and_then(|()| tracker.look(&mut line, &mut diagram))
            .err()
            .map(Incomplete::Equilibrium);
        if reason.is_none() {
            let onset = onset(&mut line, &diagram);
            diagram.onsets.extend(onset);
        }
        if watch(&line.progress()).is_break() && !line.is_done() {
            reason = reason.or(Some(Incomplete::Interrupted));
        }
    }
    if let (Some(Incomplete::Equilibrium(text)), true) = (&reason, diagram.keys.len() < 2) {
        return Err(RunError::Equilibrium(text.clone()));
    }
    if reason.is_none() {
        tracker.judge_meshes(&mut line, &diagram);
        beyond.extend(growing_beyond(&mut line, &diagram));
    }
    tracker.finish(&mut diagram);
    diagram.is_round &= diagram.spins.iter().any(|&spin| spin > 0.0);
    diagram.incomplete = reason;
    diagram.newton_iterations = line.iterations;
    let leaps = line.warnings();
    let mut station = line.station();
    let nearer = match diagram.incomplete {
        None => nearer(&mut station, &History::new(model, diagram.key.clone()), DIAGRAM),
        Some(_) => None,
    };
    diagram.is_near = nearer.is_none();
    diagram.t = station.at.t;
    diagram.bodies = station.scene.bodies();
    diagram.masses = station.scene.masses(station.state);
    diagram.unknowns = station.scene.unknowns();
    diagram.constraints = station.scene.constraints();
    diagram.warnings = cautions::cautioned(model, station.scene.warnings(station.state));
    let told = [
        way::stopped(station.scene, &station.at),
        uniform::taken_along(station.scene, &station.at),
    ];
    diagram.warnings.extend(told.into_iter().flatten());
    diagram
        .warnings
        .extend(way::as_it_is(station.scene, &station.at, station.state));
    diagram.warnings.extend(beyond);
    diagram.warnings.extend(leaps);
    diagram.warnings.extend(nearer);
    let (at, state) = (station.at, station.state);
    diagram.warnings.extend(equilibrium::untied(station.scene, &at, state));
    diagram.warnings.extend(equilibrium::closed(station.scene));
    diagram.seconds = clock.seconds();
    // The modes of a finer mesh are those about the nearest equilibrium.
    let found = match (&diagram.incomplete, diagram.is_near) {
        (None, true) => on_finer_meshes(model, settings, station.scene, &diagram),
        _ => None,
    };
    let told = Told::of(found, station.scene, (&at, state), |_| diagram.mesh_errors.clone());
    diagram.warnings.extend(told.equilibrium.into_iter().chain(told.modes));
    diagram.agreement = told.agreement;
    match diagram.incomplete {
        None => Ok(diagram),
        Some(_) => Err(RunError::Campbell(Box::new(diagram))),
    }
}

/// That a mode grows beyond the lowest ones at the last value, where not all are looked at on the way.
fn growing_beyond(line: &mut Line<'_>, diagram: &Campbell) -> Option<String> {
    if diagram.is_all {
        return None;
    }
    let (count, station) = (diagram.settings.count, line.station());
    let (at, scene, state) = (station.at, station.scene, station.state);
    let (mut found, _) = modes::modes_and_growing(scene, &at, state, Wanted { count }, MANY).ok()?;
    found.sort_by(|a, b| size(a).total_cmp(&size(b)));
    let fastest = found.into_iter().skip(count).max_by(|a, b| a.re.total_cmp(&b.re))?;
    Some(format!(
        "Beyond the {count} lowest modes one grows at {}, by the factor e in {} s, with {} rad/s: ask for more of them (`--modes`)",
        diagram.key.at(station.key, 7),
        digits(1.0 / fastest.re, 4),
        digits(fastest.im, 7),
    ))
}

/// What finer meshes make of a complete diagram: of the frequencies at its last value, which takes as long as a few of its rows, and of its critical values.
fn on_finer_meshes(
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
    let finer = FinerModel::of(model);
    let at_the_end = way::at_the_end(&finer, &settings);
    let there = of_finer(at_the_end.as_ref(), &settings, &scene.bodies())?;
    let values = critical_values(&finer, &settings, &diagram.critical);
    finer::of_campbell(scene, diagram, &there, values)
}

/// Critical values of a parameter, each beside the nearest one of the finer model; one that is nowhere near counts as that far away.
fn critical_values(finer: &dyn AnyModel, settings: &EquilibriumSettings, own: &[Critical]) -> [Vec<Critical>; 2] {
    let mut both = [Vec::new(), Vec::new()];
    let Some(whole) = settings.range else {
        return both;
    };
    // Critical values are in the declared unit.
    let unit = finer.params()[whole.param].unit_si;
    let [low, high] = [whole.from.min(whole.to), whole.from.max(whole.to)];
    for here in own.iter().take(MOST) {
        let far = NEAR * here.value.abs();
        let range = Range {
            from: (unit * (here.value - far)).max(low),
            to: (unit * (here.value + far)).min(high),
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
        let away = |of: &Critical| (of.value - here.value).abs();
        let nearest = there.critical.into_iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        both[0].push(*here);
        both[1].push(nearest.unwrap_or(Critical {
            value: here.value + far,
            ..*here
        }));
    }
    both
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::results::equilibria::Range;
    use crate::app::testing::Rotor;
    use crate::app::writing::frequency::Frequency;
    use crate::modes::Whirl;

    #[test]
    fn a_rotor_over_its_speed() {
        let rotor = Rotor {
            loss: 0.0,
            length: 0.0,
            ..Rotor::default()
        };
        let settings = EquilibriumSettings {
            range: Some(Range {
                param: 0,
                from: 0.0,
                to: 12.0,
            }),
            steps: 25,
            ..EquilibriumSettings::default()
        };
        let found = campbell(&rotor, &settings).unwrap();
        let w0 = 50f64.sqrt();
        assert_eq!((found.keys.len(), found.tracks.len(), found.is_round), (26, 2, true));
        // Both whirls of the shaft, w0 in axes that stand still, each on its track throughout.
        let mut tracks: Vec<_> = found.tracks.iter().collect();
        tracks.sort_by(|a, b| a[1].unwrap().im.total_cmp(&b[1].unwrap().im));
        for (row, spin) in found.spins.iter().enumerate().skip(1) {
            let [forward, backward] = [tracks[0][row].unwrap(), tracks[1][row].unwrap()];
            assert!((forward.im - (w0 - spin).abs()).abs() < 1e-9, "{row} {forward:?}");
            assert!((backward.im - (w0 + spin)).abs() < 1e-9, "{row} {backward:?}");
            let sense = if *spin < w0 { Whirl::Forward } else { Whirl::Backward };
            assert_eq!((forward.whirl, backward.whirl), (sense, Whirl::Backward));
            for mode in [forward, backward] {
                assert!((mode.inertial_frequencies(*spin)[0] - w0).abs() < 1e-9);
            }
            assert_eq!(forward.inertial_whirl(*spin), Whirl::Forward);
            assert_eq!(backward.inertial_whirl(*spin), Whirl::Backward);
        }
        assert_eq!(found.critical.len(), 1);
        assert_eq!(found.critical[0].change, 2);
        assert!((found.critical[0].value - w0).abs() < 1e-5, "{:?}", found.critical);
        // In space both whirls have w0: 2 W at half of it, and backward 1 W at w0, where forward is critical.
        let mut found_at: Vec<(u32, Whirl, f64)> = found
            .crossings
            .iter()
            .map(|crossing| (crossing.order, crossing.whirl, crossing.key))
            .collect();
        found_at.sort_by(|a, b| a.2.total_cmp(&b.2).then(a.1.name().cmp(b.1.name())));
        let exact = [
            (2, Whirl::Backward, 0.5 * w0),
            (2, Whirl::Forward, 0.5 * w0),
            (1, Whirl::Backward, w0),
        ];
        assert_eq!(found_at.len(), exact.len(), "{found_at:?}");
        for (found, exact) in found_at.iter().zip(exact) {
            assert_eq!((found.0, found.1), (exact.0, exact.1));
            assert!((found.2 - exact.2).abs() < 1e-6, "{found:?} {exact:?}");
        }
        let text = found.to_csv();
        assert!(
            text.starts_with(
                "omega [rad/s],mode 1 im [rad/s],mode 1 re [1/s],mode 1 inertial [rad/s],mode 2 im [rad/s],"
            )
        );
        assert_eq!(text.lines().count(), 27);
    }

    #[test]
    fn next_to_a_critical_speed_of_an_unbalanced_rotor_the_error_is_told() {
        // x = 2 k / (k - w^2): no equilibrium is found where the deflection is a hundred times the arm.
        let w0 = 50f64.sqrt();
        for steps in [3, 18, 25] {
            let rotor = Rotor {
                loss: 0.0,
                ..Rotor::default()
            };
            let settings = EquilibriumSettings {
                range: Some(Range {
                    param: 0,
                    from: 0.5,
                    to: 12.0,
                }),
                steps,
                ..EquilibriumSettings::default()
            };
            let found = campbell(&rotor, &settings).unwrap();
            let [critical] = found.critical[..] else {
                panic!("{:?}", found.critical)
            };
            let error = (critical.value - w0).abs();
            assert!(
                error < 1e-4 && error <= critical.within,
                "{steps}: {error} {critical:?}"
            );
            let step = 11.5 / f64::from(steps);
            assert!(
                critical
                    .open
                    .is_none_or(|[low, high]| low < w0 && w0 < high && high - low < 0.5 * step)
            );
            let lines = crate::app::page::diagrams::campbell_lines(&found, Frequency::default()).join(" ");
            assert_eq!(
                lines.contains("no equilibrium is found"),
                critical.open.is_some(),
                "{lines}"
            );
            assert_eq!(
                lines.contains("It lies there within"),
                critical.within > 1e-5,
                "{lines}"
            );
        }
    }
}
