//! A run in time; what it gathers is its course, and what it leaves on disk while it goes on the recorder's.

use std::ops::ControlFlow;

use super::begin::{begin, begin_finer};
use super::course::Course;
use super::recorder::{InMemory, Recorder};
use crate::app::judged::accumulated::{Ended, accumulated};
use crate::app::judged::compared::Off;
use crate::app::judged::doubts::doubts;
use crate::app::judged::finer::{self, Begun, FINER, Found, Judging};
use crate::app::judged::marks::{Marks, largest, round_off};
use crate::app::judged::unfollowed::{Followed, unfollowed};
use crate::app::judged::{agreement, cautions};
use crate::app::machine::clock::{Clock, Seconds};
use crate::app::results::envelopes::Envelopes;
use crate::app::results::error::RunError;
use crate::app::results::history::{Column, History};
use crate::app::results::incomplete::Incomplete;
use crate::app::results::run::{Progress, RunResult, RunSettings, times};
use crate::{AnyModel, Integrator, Method, Scene, State, Statistics, StepSize};

/// A run has a kink for so many steps at least where kinks say how long they are.
const FEW: u64 = 4;
/// Most rows of a history in memory, 8 bytes for each of them and each column, and on disk.
const MOST_ROWS: [f64; 2] = [1e7, 1e9];

/// Runs a model.
///
/// # Errors
/// [`RunError`]; a run that stopped on its way is an error too and carries its result.
pub fn run(model: &dyn AnyModel, settings: &RunSettings) -> Result<RunResult, RunError> {
    run_watched(model, settings, |_| ControlFlow::Continue(()))
}

/// As [`run`]; `watch` is called after every step, and ends the run by [`ControlFlow::Break`].
///
/// A ball falls until it is 1 m below its start:
///
/// ```
/// use std::ops::ControlFlow;
///
/// use rncf::app::{RunError, RunSettings, run_watched};
///
/// rncf::model! {
///     pub model Fall {
///         rigid ball { mass = 1 kg; }
///         load weight = gravity([0, 0, -10] m/s^2);
///         output z = ball.z;
///         run { t_end = 1 s; every = 0.01 s; }
///     }
/// }
///
/// let mut reached = 0.0;
/// let ended = run_watched(&Fall::default(), &RunSettings::default(), |progress| {
///     reached = progress.t;
///     if 5.0 * reached * reached > 1.0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
/// });
/// let Err(RunError::Incomplete(found)) = ended else { panic!("the run has ended early") };
/// let (t, z) = (found.history.keys.last().unwrap(), found.history.values.last().unwrap());
/// assert!(*t <= reached && (z + 5.0 * t * t).abs() < 1e-9);
/// ```
///
/// # Errors
/// As [`run`].
pub fn run_watched(
    model: &dyn AnyModel,
    settings: &RunSettings,
    watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<RunResult, RunError> {
    run_recorded(model, settings, &mut InMemory, watch)
}

/// As [`run_watched`] with a recorder.
pub(in crate::app) fn run_recorded(
    model: &dyn AnyModel,
    settings: &RunSettings,
    recorder: &mut dyn Recorder,
    mut watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<RunResult, RunError> {
    let clock = Clock::start();
    let settings = complete_for(settings, model.run(), MOST_ROWS[usize::from(recorder.takes_rows())])?;
    let mut scene = model
        .build_as(settings.formulation, settings.joints, &settings.fidelity)
        .map_err(RunError::Model)?;
    let (start, begun) = begin(
        model,
        settings.start.unwrap_or_default(),
        scene.as_ref(),
        settings.judged,
    )?;
    let (t_end, _) = times(&settings);
    let mut result = RunResult {
        settings,
        history: History::new(model, Column::time()),
        envelopes: Envelopes::new(scene.as_ref(), &Column::time()),
        pictures: None,
        steps: Vec::new(),
        statistics: Statistics::default(),
        unknowns: scene.unknowns(),
        constraints: scene.constraints(),
        energy_error: None,
        bodies: scene.bodies(),
        masses: scene.masses(&start),
        cautions: model.cautions(t_end),
        warnings: Vec::new(),
        marks: Marks::default(),
        judged_until: None,
        off_by: Vec::new(),
        agreement: None,
        coarse: None,
        state: start.clone(),
        seconds: Seconds::default(),
        incomplete: None,
    };
    integrate(scene.as_mut(), start.clone(), &mut result, clock, recorder, &mut watch)?;
    if result.settings.judged != Judging::No && result.incomplete.is_none() {
        look_again(model, scene.as_mut(), &start, &mut result, &mut watch);
    } else {
        result.warnings.extend(result.coarse.take());
    }
    let told = cautions::sentences(model, &result.cautions);
    let told = told
        .into_iter()
        .chain(begun)
        .chain(doubts(model, result.settings.options.rtol));
    result.warnings.splice(0..0, told);
    match result.incomplete {
        None => Ok(result),
        Some(_) => Err(RunError::Incomplete(Box::new(result))),
    }
}

/// Whether motions and loads, and not the tolerance, say how long steps are: of pulses any step, of kinks a good part of them.
fn is_shortened(statistics: &Statistics) -> bool {
    statistics.shortened_steps > 0 || FEW * statistics.restarts >= statistics.steps.max(1)
}

/// Goes the way of a complete run from `start` in other ways, and tells what it missed.
fn look_again(
    model: &dyn AnyModel,
    scene: &mut dyn Scene,
    start: &State,
    result: &mut RunResult,
    watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) {
    let (t_end, _) = times(&result.settings);
    let h = result.steps.last().map_or(0.0, |step| step.h);
    result.marks.round_off = round_off(scene, &result.state);
    let mut goes_on = || watch(&Progress { t: t_end, t_end, h }).is_continue();
    let mut run = Ended {
        t_end,
        method: result.settings.method,
        options: result.settings.options,
        steps: result.statistics.steps,
        iterations: result.statistics.newton_iterations,
        longest: result.statistics.largest_step,
        is_shortened: is_shortened(&result.statistics),
        marks: &result.marks,
        is_compared: false,
    };
    let [mut missed, mut added_up] = [None, None];
    let mut off = Vec::new();
    if run.method != Method::EnergyMomentum {
        let taken: Vec<[f64; 2]> = result.steps.iter().map(|step| [step.t, step.h]).collect();
        let followed = Followed {
            t_end,
            rtol: run.options.rtol,
            statistics: &result.statistics,
            taken: &taken,
            end: &result.state,
            marks: &result.marks,
        };
        let lost = unfollowed(scene, start.clone(), followed, model.outputs());
        let added = accumulated(scene, start.clone(), run, model.outputs(), &mut goes_on);
        (added_up, run.is_compared) = (added.told, added.is_known);
        missed = lost.told;
        off = finer::each([lost.off, added.off].concat());
    }
    let own = Begun {
        scene,
        start: start.clone(),
    };
    let found = compared(model, own, run, &result.settings, &mut goes_on);
    result.judged_until = Some(found.until).filter(|&until| until > 0.0);
    // What outputs are off by says more than the energy of single moments.
    let coarse = found.mesh.or_else(|| result.coarse.take().filter(|_| !found.is_whole));
    let steps = match (added_up, found.steps) {
        // What a run with larger steps promises is the least that those of the run are off by.
        (Some(_), Some(steps)) if largest(&found.off) > largest(&off) => Some(steps),
        (added_up, steps) => added_up.or(steps),
    };
    let off = finer::each([off, found.off].concat());
    result.off_by = off.iter().filter_map(Off::known).collect();
    let told = coarse.into_iter().chain(missed).chain(steps);
    let told: Vec<String> = told.chain(found.rest).collect();
    if found.is_whole && told.is_empty() {
        result.agreement = agreement::of_run(model.outputs(), &off, found.has_meshes, found.looser);
    }
    result.warnings.extend(told);
}

/// Without finer meshes where none changes, or they cannot be built.
fn compared(
    model: &dyn AnyModel,
    own: Begun<'_>,
    run: Ended<'_>,
    settings: &RunSettings,
    goes_on: &mut dyn FnMut() -> bool,
) -> Found {
    let finer = || {
        let scene = model
            .build_as(settings.formulation, settings.joints, &settings.fidelity)
            .ok()?;
        let scene = scene.with_finer_meshes(FINER)?.ok()?;
        let start = begin_finer(model, settings.start.unwrap_or_default(), scene.as_ref(), FINER)?;
        Some((scene, start))
    };
    let mut finer = finer();
    let finer = finer.as_mut().map(|(scene, start)| Begun {
        scene: scene.as_mut(),
        start: start.clone(),
    });
    finer::compare(own, finer, run, model.outputs(), settings.judged, goes_on)
}

/// The settings with the model's times where none are given.
///
/// # Errors
/// A time that makes no sense.
pub(in crate::app) fn complete(settings: &RunSettings, defaults: crate::RunDefaults) -> Result<RunSettings, RunError> {
    complete_for(settings, defaults, MOST_ROWS[0])
}

/// As [`complete`] for a history on disk, which may have many more rows.
pub(in crate::app) fn complete_on_disk(
    settings: &RunSettings,
    defaults: crate::RunDefaults,
) -> Result<RunSettings, RunError> {
    complete_for(settings, defaults, MOST_ROWS[1])
}

fn complete_for(settings: &RunSettings, defaults: crate::RunDefaults, most_rows: f64) -> Result<RunSettings, RunError> {
    let t_end = settings.t_end.unwrap_or(defaults.t_end);
    let every = settings.every.unwrap_or(defaults.every.min(t_end));
    for (name, value) in [("end time", t_end), ("time between rows", every)] {
        if !(value > 0.0 && value.is_finite()) {
            return Err(RunError::Settings(format!(
                "the {name} is {value} s; it must be positive"
            )));
        }
    }
    if every > t_end {
        return Err(RunError::Settings(format!(
            "the time between rows, {every} s, is longer than the run of {t_end} s"
        )));
    }
    if t_end / every > most_rows {
        return Err(RunError::Settings(format!(
            "a row every {every} s up to {t_end} s makes more than {most_rows:e} rows; take a longer time between rows"
        )));
    }
    // A fixed step that never ends the run is a mistake of the same kind.
    if let StepSize::Fixed(h) = settings.options.step
        && t_end / h > 1e9
    {
        return Err(RunError::Settings(format!(
            "a step of {h} s makes more than 1e9 steps up to {t_end} s; take a longer step"
        )));
    }
    Ok(RunSettings {
        t_end: Some(t_end),
        every: Some(every),
        start: Some(settings.start.unwrap_or(defaults.start)),
        ..settings.clone()
    })
}

/// Integrates from `start`, or from where the recorder takes the run up, and fills the result up to the last good time.
fn integrate(
    scene: &mut dyn Scene,
    start: State,
    result: &mut RunResult,
    clock: Clock,
    recorder: &mut dyn Recorder,
    mut watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<(), RunError> {
    let RunSettings { method, options, .. } = result.settings;
    let (t_end, _) = times(&result.settings);
    let columns = scene.output_columns();
    let taken_up = recorder.taken_up(result)?;
    let mut integrator = match &taken_up {
        Some(earlier) if !earlier.renewed.is_empty() => Integrator::resume(scene, &earlier.renewed, method, options),
        _ => Integrator::new(scene, start, t_end, method, options),
    }
    .map_err(RunError::Start)?;
    let mut moved = corrections(integrator.statistics());
    let mut course = Course::new(&mut integrator, columns, recorder.takes_rows(), result, clock);
    match &taken_up {
        Some(earlier) => course.take_up(&earlier.course, result).map_err(RunError::Files)?,
        None => course.begin(&mut integrator, result),
    }
    recorder.begin(result).map_err(RunError::Files)?;
    let mut incomplete = course.record(&mut integrator, result, recorder).err();
    while incomplete.is_none() {
        let stop = match integrator.step() {
            Ok(stop) => stop,
            Err(error) => {
                incomplete = Some(Incomplete::Solve(error));
                break;
            }
        };
        course.step(&mut integrator, result);
        incomplete = course.record(&mut integrator, result, recorder).err();
        if stop == crate::Stop::End {
            break;
        }
        let t = integrator.state().t;
        let h = t - integrator.previous_time();
        if watch(&Progress { t, t_end, h }).is_break() {
            incomplete = incomplete.or(Some(Incomplete::Interrupted));
        }
    }
    let is_complete = incomplete.is_none();
    let ended = recorder.end(is_complete, &mut |bytes| course.write(&integrator, result, bytes));
    if let Err(error) = ended {
        incomplete = incomplete.or(Some(Incomplete::Files(error)));
    }
    moved.extend_from_slice(&integrator.statistics().jumps);
    course.fill(&mut integrator, result, moved);
    result.state.clone_from(integrator.state());
    result.statistics = integrator.statistics().clone();
    result.incomplete = incomplete;
    Ok(())
}

/// Relative corrections of a start below this are round-off of the declared numbers.
const CORRECTED: f64 = 1e-12;

/// What the start changed of the declared positions and velocities.
fn corrections(statistics: &Statistics) -> Vec<String> {
    let corrections = [
        ("positions", statistics.position_correction, "the size of the model"),
        (
            "velocities",
            statistics.velocity_correction,
            "that size in the time of the run",
        ),
    ];
    let moved = corrections.into_iter().filter(|(_, size, _)| *size > CORRECTED);
    moved
        .map(|(what, size, of)| {
            format!("The initial {what} were moved onto the constraints, by up to {size:.1e} of {of}.")
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::results::equilibria::EquilibriumSettings;
    use crate::app::testing::Rotor;
    use crate::{Formulation, Options};

    const METHODS: [Method; 3] = [
        Method::Hht { alpha: -0.05 },
        Method::GeneralizedAlpha { rho_inf: 0.8 },
        Method::Radau,
    ];

    fn tight(method: Method, formulation: Formulation) -> RunSettings {
        RunSettings {
            method,
            formulation,
            options: Options {
                rtol: 1e-9,
                ..Options::default()
            },
            ..RunSettings::default()
        }
    }

    /// The spring in the turning frame, undamped: with z = x + i y, z = e + (L - e)
    /// (w1 exp(i w2 t) - w2 exp(i w1 t))/(w1 - w2), w1, w2 = -w +- sqrt(k), e = k L/(k - w^2).
    fn exact(k: f64, w: f64, t: f64) -> (f64, f64) {
        let (w1, w2) = (-w + k.sqrt(), -w - k.sqrt());
        let e = 2.0 * k / (k - w * w);
        let part = |f: fn(f64) -> f64| (2.0 - e) * (w1 * f(w2 * t) - w2 * f(w1 * t)) / (w1 - w2);
        (e + part(f64::cos), part(f64::sin))
    }

    #[test]
    fn a_warning_is_given_once_and_stands_in_the_notes() {
        let mut rotor = Rotor::default();
        assert!(run(&rotor, &RunSettings::default()).unwrap().warnings.is_empty());
        rotor.omega = 6.0;
        let result = run(&rotor, &RunSettings::default()).unwrap();
        assert_eq!(result.warnings, ["the spring is soft at 6 rad/s"]);
        let summary = crate::app::page::summary::of_run(&rotor, &result);
        assert_eq!(summary["notes"][1], "the spring is soft at 6 rad/s");
        let steady = crate::app::steady(&rotor, &EquilibriumSettings::default()).unwrap();
        assert_eq!(steady.warnings, result.warnings);
    }

    #[test]
    fn corrections_of_the_start_are_noted() {
        let mut statistics = Statistics::default();
        assert!(corrections(&statistics).is_empty());
        statistics.position_correction = 2.999e-4;
        let notes = corrections(&statistics);
        assert_eq!(
            notes,
            ["The initial positions were moved onto the constraints, by up to 3.0e-4 of the size of the model."]
        );
        statistics.velocity_correction = 1e-3;
        assert_eq!(corrections(&statistics).len(), 2);
    }

    #[test]
    fn rows_follow_the_exact_solution_on_the_grid() {
        let rotor = Rotor {
            loss: 0.0,
            ..Rotor::default()
        };
        for method in METHODS {
            for formulation in [Formulation::Rncf, Formulation::Ancf] {
                let result = run(&rotor, &tight(method, formulation)).unwrap();
                assert_eq!(result.history.keys.len(), 81);
                for (k, (x, y)) in result.history.column(0).zip(result.history.column(1)).enumerate() {
                    let t = result.history.keys[k];
                    assert_eq!(t, k as f64 * 0.05);
                    let (exact_x, exact_y) = exact(50.0, 3.0, t);
                    let error = (x - exact_x).hypot(y - exact_y);
                    assert!(error < 2e-5, "{method:?} {formulation:?}: {error:e} at {t}");
                }
                assert_eq!(result.steps.len() as u64, result.statistics.steps);
                assert_eq!(result.state.t, 4.0);
                let energy_error = result.energy_error.unwrap();
                assert!(energy_error > 0.0 && energy_error < 1e-5, "{method:?} {energy_error:e}");
                assert!(result.seconds.wall > 0.0 && result.seconds.cpu > 0.0);
            }
        }
    }

    #[test]
    fn a_rate_that_divides_the_time_only_up_to_rounding_gives_the_last_row() {
        let settings = RunSettings {
            t_end: Some(0.3),
            every: Some(0.1),
            ..RunSettings::default()
        };
        let keys = run(&Rotor::default(), &settings).unwrap().history.keys;
        assert_eq!(keys, [0.0, 0.1, 0.2, 3.0 * 0.1]);
    }

    #[test]
    fn damping_means_no_energy_error() {
        assert_eq!(
            run(&Rotor::default(), &RunSettings::default()).unwrap().energy_error,
            None
        );
    }

    #[test]
    fn an_interrupted_run_keeps_its_rows() {
        let outcome = run_watched(&Rotor::default(), &RunSettings::default(), |progress| {
            if progress.t > 1.0 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        let Err(RunError::Incomplete(result)) = outcome else {
            panic!()
        };
        assert_eq!(result.incomplete, Some(Incomplete::Interrupted));
        assert!(result.state.t > 1.0 && result.state.t < 4.0);
        let last = *result.history.keys.last().unwrap();
        assert!(last > result.state.t - 0.05 && last <= result.state.t);
    }

    #[test]
    fn a_failing_step_keeps_the_rows_before_it() {
        let rotor = Rotor {
            fail_at: 2.0,
            ..Rotor::default()
        };
        for method in METHODS {
            let error = run(&rotor, &tight(method, Formulation::Rncf)).unwrap_err();
            let text = error.to_string();
            let RunError::Incomplete(result) = error else {
                panic!("{text}")
            };
            assert!(text.contains(" t = 1.9") || text.contains(" t = 2 s"), "{text}");
            assert!(matches!(result.incomplete, Some(Incomplete::Solve(_))));
            let last = *result.history.keys.last().unwrap();
            assert!(last > 1.9 && last <= 2.0, "{method:?} {last}");
            assert!(result.history.values.iter().all(|value| value.is_finite()));
        }
    }

    #[test]
    fn settings_that_make_no_sense_are_named() {
        let text = |settings: RunSettings| run(&Rotor::default(), &settings).unwrap_err().to_string();
        let settings = RunSettings {
            t_end: Some(f64::NAN),
            ..RunSettings::default()
        };
        assert_eq!(text(settings), "the end time is NaN s; it must be positive");
        let settings = RunSettings {
            every: Some(1e-9),
            ..RunSettings::default()
        };
        assert_eq!(
            text(settings),
            "a row every 0.000000001 s up to 4 s makes more than 1e7 rows; take a longer time between rows"
        );
        let rotor = Rotor {
            stiffness: -1.0,
            ..Rotor::default()
        };
        let error = run(&rotor, &RunSettings::default()).unwrap_err();
        assert_eq!(error.to_string(), "parameter `stiffness` must be positive");
    }
}
