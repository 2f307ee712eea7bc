//! Relative and static equilibria along a parameter, the spin or the load; nothing is printed or
//! written here.

use std::ops::ControlFlow;

use super::buckling::buckling;
use super::continuation::{EquilibriumProgress, Found, Line, Station};
use super::directions::Measured;
use super::finer;
use super::nearer::{EQUILIBRIA, nearer};
use super::way::{self, at_the_end};
use crate::app::judged::finer::Judging;
use crate::app::judged::marks::round_off;
use crate::app::judged::{cautions, coarse, finer_modes};
use crate::app::machine::clock::Clock;
use crate::app::results::envelopes::Envelopes;
use crate::app::results::equilibria::{Equilibria, EquilibriumSettings};
use crate::app::results::error::RunError;
use crate::app::results::history::History;
use crate::app::results::incomplete::Incomplete;
use crate::app::results::uniform;
use crate::app::writing::numbers::{digits, short};
use crate::app::writing::sentences::listed;
use crate::equilibrium::{self, Kind};
use crate::{AnyModel, Scene, modes};

/// Most frames in a sentence.
const MOST: usize = 3;

/// Follows the relative equilibria of a model (THEORY 8.1): from rest to its spin, or along a parameter.
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
/// use rncf::app::{EquilibriumSettings, steady};
/// let found = steady(&Governor::default(), &EquilibriumSettings::default())?;
/// assert!((found.history.values.last().unwrap() - 100.0 / (100.0 - 5.0 * 5.0)).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// A model that cannot be built; [`RunError::Equilibrium`] where none exists, with the frame or load that
/// stands against it; [`RunError::Equilibria`] with the rows found where the way ends early.
pub fn steady(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Result<Equilibria, RunError> {
    equilibria(model, Kind::Steady, settings, |_| ControlFlow::Continue(()))
}

/// Follows the equilibria at rest of a model: with growing loads, or along a parameter.
///
/// # Errors
/// As [`steady`].
pub fn static_equilibria(model: &dyn AnyModel, settings: &EquilibriumSettings) -> Result<Equilibria, RunError> {
    equilibria(model, Kind::Static, settings, |_| ControlFlow::Continue(()))
}

/// That the last equilibria at rest are unstable, as far as the stiffness tells. Under circulatory forces an odd number of negative directions does, whatever the
/// mass and damping; of an even one [`flutter`] asks the modes.
fn unstable(line: &Line) -> Option<String> {
    let (before, last) = line.last_two();
    let certain = |measured: &Measured| match measured.circulates {
        true => measured.negative % 2,
        false => measured.negative,
    };
    let negative = |found: &Found| found.measured.as_ref().map(certain);
    let directions = match negative(last)?.min(negative(before?)?) {
        0 => return None,
        1 => "one direction of its stiffness is".to_string(),
        more => format!("{more} directions of its stiffness are"),
    };
    Some(format!(
        "The last equilibrium is unstable: {directions} negative, and the least disturbance leads away from it"
    ))
}

/// That the last equilibrium under circulatory forces, such as following ones, is unstable though its stiffness is positive.
fn flutter(station: &mut Station, count: usize) -> Option<String> {
    let (scene, at, state) = (&mut *station.scene, &station.at, station.state);
    if !modes::is_circulatory(scene, at, state) {
        return None;
    }
    let Ok(time) = uniform::time_of_growth(scene, at, state, count) else {
        return Some(
            "Whether the last equilibrium is stable is not known: forces that come from no energy act, and its modes were not found".into(),
        );
    };
    let time = digits(time?, 4);
    Some(format!(
        "The last equilibrium is unstable: under forces that come from no energy a disturbance grows by the factor e in {time} s (`modes` shows how)"
    ))
}

/// That the last relative equilibrium is unstable, of a system whose modes cost little: where something turns, the signs of the stiffness do not tell.
fn grows(station: &mut Station, settings: &EquilibriumSettings) -> Option<String> {
    let (scene, at, state) = (&mut *station.scene, &station.at, station.state);
    if !finer_modes::is_asked(settings.judged, scene.unknowns()) {
        return None;
    }
    let time = uniform::time_of_growth(scene, at, state, settings.count).ok()??;
    Some(format!(
        "The last equilibrium is unstable: a disturbance grows by the factor e in {} s (`modes` shows how)",
        digits(time, 4)
    ))
}

/// As [`steady`] or [`static_equilibria`]; `watch` is called after every step, and ends the way by
/// [`ControlFlow::Break`].
///
/// A mass of 1 kg on a coil of 100 N/m is pulled away; the way ends behind the third of ten steps:
///
/// ```
/// use std::ops::ControlFlow;
///
/// use rncf::app::{EquilibriumSettings, Range, RunError, equilibria};
/// use rncf::equilibrium::Kind;
///
/// rncf::model! {
///     pub model Pulled {
///         param pull = 5 N;
///         rigid mass { mass = 1 kg; inertia = [1, 1, 1] g*m^2; origin = [1, 0, 0] m; }
///         joint rail = prismatic(mass, inertial, axis = x);
///         spring coil = linear(mass, inertial, stiffness = 100 N/m, length = 1 m);
///         load away = force(mass, [pull, 0 N, 0 N]);
///         output x = mass.x;
///         run { t_end = 1 s; every = 0.1 s; }
///     }
/// }
///
/// let range = Range { param: 0, from: 0.0, to: 10.0 };
/// let settings = EquilibriumSettings { range: Some(range), steps: 10, ..EquilibriumSettings::default() };
/// let mut values = Vec::new();
/// let ended = equilibria(&Pulled::default(), Kind::Static, &settings, |progress| {
///     values.push(progress.key);
///     if values.len() == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
/// });
/// let Err(RunError::Equilibria(found)) = ended else { panic!("the way has ended early") };
/// let reached = found.history.keys.last().unwrap();
/// assert_eq!((values.len(), *reached), (3, *values.last().unwrap()));
/// assert!((found.history.values.last().unwrap() - (1.0 + reached / 100.0)).abs() < 1e-9);
/// ```
///
/// # Errors
/// As [`steady`].
pub fn equilibria(
    model: &dyn AnyModel,
    kind: Kind,
    settings: &EquilibriumSettings,
    mut watch: impl FnMut(&EquilibriumProgress) -> ControlFlow<()>,
) -> Result<Equilibria, RunError> {
    let clock = Clock::start();
    let mut line = Line::start(model, kind, settings)?;
    let mut history = History::new(model, line.column());
    let mut envelopes = Envelopes::new(line.station().scene, &history.key);
    let mut critical = Vec::new();
    let mut incomplete = None;
    if line.begins_balanced {
        incomplete = record(&mut line, &mut history, &mut envelopes).err();
    }
    while incomplete.is_none() && !line.is_done() {
        if let Err(text) = line.advance() {
            if line.iterations == 0 {
                return Err(RunError::Equilibrium(text));
            }
            incomplete = Some(Incomplete::Equilibrium(text));
            break;
        }
        incomplete = record(&mut line, &mut history, &mut envelopes).err();
        critical.extend(buckling(&mut line));
        if watch(&line.progress()).is_break() && !line.is_done() {
            incomplete = incomplete.or(Some(Incomplete::Interrupted));
        }
    }
    let newton_iterations = line.iterations;
    let leaps = line.warnings();
    let mut unstable = (kind == Kind::Static).then(|| unstable(&line)).flatten();
    let mut station = line.station();
    if incomplete.is_none() && unstable.is_none() {
        unstable = match kind {
            Kind::Static => flutter(&mut station, settings.count),
            Kind::Steady => grows(&mut station, settings),
        };
    }
    let nearer = match (&incomplete, kind) {
        (None, Kind::Steady) => nearer(&mut station, &history, EQUILIBRIA),
        _ => None,
    };
    let cautions = at_the_end(model, settings).cautions(0.0);
    let mut warnings = cautions::sentences(model, &cautions);
    if kind == Kind::Static {
        warnings.extend(rests(station.scene, station.at.t));
    }
    warnings.extend(way::stopped(station.scene, &station.at));
    warnings.extend(uniform::taken_along(station.scene, &station.at));
    warnings.extend(way::as_it_is(station.scene, &station.at, station.state));
    warnings.extend(cautions::texts(station.scene.warnings(station.state)));
    warnings.extend(equilibrium::untied(station.scene, &station.at, station.state));
    warnings.extend(equilibrium::closed(station.scene));
    warnings.extend(envelopes.warnings());
    let coarse = coarse::of_equilibrium(station.scene, &station.at, station.state);
    warnings.extend(leaps);
    warnings.extend(nearer);
    warnings.extend(unstable);
    let mut result = Equilibria {
        kind,
        settings: *settings,
        t: station.at.t,
        spin: station.spin,
        history,
        envelopes,
        critical,
        bodies: station.scene.bodies(),
        masses: station.scene.masses(station.state),
        unknowns: station.scene.unknowns(),
        constraints: station.scene.constraints(),
        newton_iterations,
        cautions,
        warnings,
        off_by: Vec::new(),
        agreement: None,
        seconds: clock.seconds(),
        incomplete,
    };
    let found = look_again(model, &mut station, &result, &mut watch);
    // What outputs are off by says more than the energy of the last state.
    let is_compared = found.as_ref().is_some_and(|found| found.is_compared);
    result.warnings.extend(if is_compared { None } else { coarse });
    if let Some(found) = found {
        result.warnings.extend(found.told);
        (result.off_by, result.agreement) = (found.off_by, found.agreement);
    }
    match result.incomplete {
        None => Ok(result),
        Some(_) => Err(RunError::Equilibria(Box::new(result))),
    }
}

/// That frames which move are taken at rest.
fn rests(scene: &dyn Scene, t: f64) -> Option<String> {
    let named = |name: String| format!("`{name}`");
    let moving: Vec<String> = scene.moving_frames(t).into_iter().map(named).collect();
    let names = listed(&moving, MOST)?;
    let [of, stand, are, their] = if moving.len() > 1 {
        ["frames", "stand", "they are", "their"]
    } else {
        ["frame", "stands", "it is", "its"]
    };
    Some(format!(
        "`static` is about rest: {of} {names} {stand} still where {are} at t = {} s, and all that {their} motion does is left out. `steady` takes what turns, a run in time all motions.",
        short(t)
    ))
}

/// What finer meshes make of equilibria, unless they are not asked for or were interrupted.
fn look_again(
    model: &dyn AnyModel,
    station: &mut Station<'_>,
    result: &Equilibria,
    watch: &mut dyn FnMut(&EquilibriumProgress) -> ControlFlow<()>,
) -> Option<finer::Found> {
    if result.settings.judged == Judging::No || result.incomplete == Some(Incomplete::Interrupted) {
        return None;
    }
    let own = finer::Own {
        kind: result.kind,
        settings: &result.settings,
        history: &result.history,
        critical: &result.critical,
        // Where an output has no value, equilibria go on all the same.
        is_whole: !matches!(result.incomplete, Some(Incomplete::Equilibrium(_))),
        bodies: &result.bodies,
        unknowns: result.unknowns,
        iterations: result.newton_iterations,
        round_off: round_off(station.scene, station.state),
        operands: station.scene.operands(station.state),
    };
    let progress = EquilibriumProgress {
        share: 1.0,
        key: station.key,
    };
    finer::compare(model, &own, &mut || watch(&progress).is_continue())
}

fn record(line: &mut Line<'_>, history: &mut History, envelopes: &mut Envelopes) -> Result<(), Incomplete> {
    let station = line.station();
    let mut row = vec![0.0; station.scene.output_columns()];
    station.scene.uniform_outputs(&station.at, station.state, &mut row);
    history.push(station.key, &row).map_err(Incomplete::Output)?;
    envelopes.meet_uniform(station.scene, &station.at, station.key, station.state);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::results::equilibria::Range;
    use crate::app::results::run::RunSettings;
    use crate::app::runs::run::run;
    use crate::app::testing::Rotor;
    use crate::{Formulation, Options, Start};

    #[test]
    fn the_spring_stretches_by_the_centrifugal_force() {
        let rotor = Rotor::default();
        let result = steady(&rotor, &EquilibriumSettings::default()).unwrap();
        assert_eq!((result.spin, result.unknowns), (3.0, 2));
        assert_eq!(result.history.keys.first(), Some(&0.0));
        assert_eq!(result.history.keys.last(), Some(&3.0));
        assert!(result.history.keys.len() > 10 && result.history.keys.is_sorted());
        for (spin, x) in result.history.keys.iter().zip(result.history.column(0)) {
            let exact = 2.0 * 50.0 / (50.0 - spin * spin);
            assert!((x - exact).abs() < 1e-12, "{x} {exact}");
        }
    }

    #[test]
    fn a_parameter_is_continued_through_the_critical_speed() {
        // Softer springs at 3 rad/s: critical at 9 N/m, 18 N/m for each of two coils.
        let range = Range {
            param: 2,
            from: 100.0,
            to: 10.0,
        };
        let settings = EquilibriumSettings {
            range: Some(range),
            steps: 7,
            ..EquilibriumSettings::default()
        };
        let result = steady(&Rotor::default(), &settings).unwrap();
        assert_eq!(result.history.key.head(), "stiffness [N/m]");
        assert_eq!((result.history.keys[0], result.history.keys[7]), (100.0, 10.0));
        for (stiffness, x) in result.history.keys.iter().zip(result.history.column(0)) {
            let k = 0.5 * stiffness;
            assert!((x - 2.0 * k / (k - 9.0)).abs() < 1e-9 * x.abs(), "{stiffness} {x}");
        }
    }

    #[test]
    fn where_the_way_ends_the_reason_names_the_value() {
        let settings = EquilibriumSettings {
            range: Some(Range {
                param: 2,
                from: 100.0,
                to: -10.0,
            }),
            ..EquilibriumSettings::default()
        };
        let ended = |rotor: &Rotor| {
            let Err(RunError::Equilibria(result)) = steady(rotor, &settings) else {
                panic!("negative springs")
            };
            let reason = result.incomplete.as_ref().unwrap().to_string();
            (reason, *result.history.keys.last().unwrap(), result.warnings)
        };
        let balanced = Rotor {
            length: 0.0,
            ..Rotor::default()
        };
        let (reason, last, _) = ended(&balanced);
        assert!(reason.starts_with("beyond stiffness = 0.00"), "{reason}");
        assert!(reason.ends_with("parameter `stiffness` must be positive"), "{reason}");
        assert!(last < 0.01, "{last}");
        // The stretched spring without bound: 9 N/m of two coils. Behind it equilibria go on.
        let (reason, last, warnings) = ended(&Rotor::default());
        assert!(reason.starts_with("beyond stiffness = 0.00"), "{reason}");
        assert!(last < 0.01, "{last}");
        let told = "no equilibrium continues those up to stiffness = 18.";
        assert!(warnings.iter().any(|text| text.starts_with(told)), "{warnings:?}");
    }

    #[test]
    fn a_watcher_ends_the_way_in_good_order() {
        let outcome = equilibria(
            &Rotor::default(),
            Kind::Static,
            &EquilibriumSettings::default(),
            |progress| {
                if progress.share >= 0.25 {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            },
        );
        let Err(RunError::Equilibria(result)) = outcome else {
            panic!("not interrupted")
        };
        assert_eq!(result.incomplete, Some(Incomplete::Interrupted));
        assert_eq!(result.history.key.head(), "load_factor [1]");
        assert_eq!(result.history.keys.last(), Some(&0.25));
        assert_eq!(result.history.column(0).last(), Some(2.0));
    }

    #[test]
    fn a_start_in_equilibrium_stays_there_in_both_formulations() {
        for formulation in [Formulation::Rncf, Formulation::Ancf] {
            let settings = RunSettings {
                start: Some(Start::Steady),
                formulation,
                options: Options {
                    rtol: 1e-9,
                    ..Options::default()
                },
                ..RunSettings::default()
            };
            let result = run(&Rotor::default(), &settings).unwrap();
            let (low, high) = result.history.extremes(0).unwrap();
            let exact = 2.0 * 50.0 / 41.0;
            assert!((low.value - exact).abs() < 1e-6 && (high.value - exact).abs() < 1e-6);
        }
    }
}
