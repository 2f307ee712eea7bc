//! A run in time; what it leaves on disk while it goes on is the recorder's.

use std::ops::ControlFlow;

use super::cautions;
use super::clock::{Clock, Seconds};
use super::doubts::doubts;
use super::envelopes::Envelopes;
use super::history::{Column, History, SKETCHED};
use super::pictures::Pictures;
use super::recorder::{InMemory, Recorder};
use super::run_error::{Incomplete, RunError};
use super::sketch::Sketch;
use super::steady;
use crate::mesh::Fidelity;
use crate::{
    Caution, Formulation, Integrator, Joints, Method, Model, Options, Scene, Start, State, Statistics, StepSize,
    Warning,
};

/// What to run and how.
#[derive(Clone, Debug, PartialEq)]
pub struct RunSettings {
    /// Coordinates of the bodies.
    pub formulation: Formulation,
    /// What becomes of linear joints.
    pub joints: Joints,
    /// Bodies that are described otherwise than they are declared, by their names.
    pub fidelity: Vec<(String, Fidelity)>,
    /// How the bodies start.
    pub start: Start,
    /// Integration method.
    pub method: Method,
    /// Tolerance and step size.
    pub options: Options,
    /// End time, s; `None`: the model's own.
    pub t_end: Option<f64>,
    /// Time between two rows of the history, s; `None`: the model's own.
    pub every: Option<f64>,
    /// Whether pictures of the bodies are taken.
    pub pictures: bool,
}

impl Default for RunSettings {
    /// RNCF, eliminated joints, from rest, Radau with rtol 1e-6, the model's times.
    fn default() -> Self {
        Self {
            formulation: Formulation::Rncf,
            joints: Joints::Eliminated,
            fidelity: Vec::new(),
            start: Start::Rest,
            method: Method::Radau,
            options: Options::default(),
            t_end: None,
            every: None,
            pictures: false,
        }
    }
}

/// How far a run is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Time reached, s.
    pub t: f64,
    /// End time, s.
    pub t_end: f64,
    /// Last step, s.
    pub h: f64,
}

/// An accepted step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepTaken {
    /// Where it ends, s.
    pub t: f64,
    /// Its size, s.
    pub h: f64,
}

/// What became of a run, complete or not.
#[derive(Clone, Debug)]
pub struct RunResult {
    /// The settings, with both times filled in.
    pub settings: RunSettings,
    /// Outputs at whole multiples of `every`, by the method's dense output. On the command line, where the table is on disk,
    /// what pictures of it need.
    pub history: History,
    /// Largest section forces and stresses of the bodies, over the rows of the history.
    pub envelopes: Envelopes,
    /// Where the bodies are in some rows of the history, where that was asked for.
    pub pictures: Option<Pictures>,
    /// All accepted steps; on the command line what pictures of them need.
    pub steps: Vec<StepTaken>,
    /// Counts of the integration.
    pub statistics: Statistics,
    /// Number of unknowns.
    pub unknowns: usize,
    /// Number of constraints with multipliers.
    pub constraints: usize,
    /// Largest deviation of the total energy from its initial value, relative to the largest energy
    /// met; `None` where the model does not conserve it.
    pub energy_error: Option<f64>,
    /// What the model says a reader must know.
    pub cautions: Vec<Caution>,
    /// The same in sentences, what the start corrected of the declared positions and velocities, and what the
    /// scene warns of, each with the numbers of the row where it is worst.
    pub warnings: Vec<String>,
    /// Last good state.
    pub state: State,
    /// Time that the run took.
    pub seconds: Seconds,
    /// Why the run stopped before its end; `None` where it is complete.
    pub incomplete: Option<Incomplete>,
}

/// Most rows of a history in memory, 8 bytes for each of them and each column, and on disk.
const MOST_ROWS: [f64; 2] = [1e7, 1e9];

/// Runs a model.
///
/// # Errors
/// [`RunError`]; a run that stopped on its way is an error too and carries its result.
pub fn run<M: Model>(model: &M, settings: &RunSettings) -> Result<RunResult, RunError> {
    run_watched(model, settings, |_| ControlFlow::Continue(()))
}

/// As [`run`]; `watch` is called after every step, and ends the run by [`ControlFlow::Break`].
///
/// # Errors
/// As [`run`].
pub fn run_watched<M: Model>(
    model: &M,
    settings: &RunSettings,
    watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<RunResult, RunError> {
    run_recorded(model, settings, &mut InMemory, watch)
}

/// As [`run_watched`] with a recorder.
pub(super) fn run_recorded<M: Model>(
    model: &M,
    settings: &RunSettings,
    recorder: &mut dyn Recorder,
    watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<RunResult, RunError> {
    let clock = Clock::start();
    let settings = complete_for(settings, model.run(), MOST_ROWS[usize::from(recorder.is_on_disk())])?;
    let mut scene = model
        .build_as(settings.formulation, settings.joints, &settings.fidelity)
        .map_err(RunError::Model)?;
    let start = match settings.start {
        Start::Rest => scene.rest(0.0),
        Start::Steady => {
            let frame = steady::frame_state(model, 0.0)?;
            scene.state_of_frame(&frame)
        }
    };
    let (t_end, _) = times(&settings);
    let mut result = RunResult {
        settings,
        history: History::new::<M>(Column::time()),
        envelopes: Envelopes::new(scene.as_ref(), &Column::time()),
        pictures: None,
        steps: Vec::new(),
        statistics: Statistics::default(),
        unknowns: scene.unknowns(),
        constraints: scene.constraints(),
        energy_error: None,
        cautions: model.cautions(t_end),
        warnings: Vec::new(),
        state: start.clone(),
        seconds: Seconds::default(),
        incomplete: None,
    };
    integrate(scene.as_mut(), start, &mut result, recorder, watch)?;
    let told = cautions::sentences::<M>(&result.cautions);
    let told = told.into_iter().chain(doubts(model, result.settings.options.rtol));
    result.warnings.splice(0..0, told);
    result.seconds = clock.seconds();
    match result.incomplete {
        None => Ok(result),
        Some(_) => Err(RunError::Incomplete(Box::new(result))),
    }
}

/// The settings with the model's times where none are given.
///
/// # Errors
/// A time that makes no sense.
pub(super) fn complete(settings: &RunSettings, defaults: crate::RunDefaults) -> Result<RunSettings, RunError> {
    complete_for(settings, defaults, MOST_ROWS[0])
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
        ..settings.clone()
    })
}

/// Integrates from `start`, and fills the result up to the last good time.
fn integrate(
    scene: &mut dyn Scene,
    start: State,
    result: &mut RunResult,
    recorder: &mut dyn Recorder,
    mut watch: impl FnMut(&Progress) -> ControlFlow<()>,
) -> Result<(), RunError> {
    let RunSettings { method, options, .. } = result.settings;
    let (t_end, every) = times(&result.settings);
    let columns = scene.output_columns();
    let mut integrator = Integrator::new(scene, start, t_end, method, options).map_err(RunError::Start)?;
    let moved = corrections(integrator.statistics());
    let mut rows = Rows::new(every, t_end, integrator.state(), columns);
    if result.settings.pictures {
        result.pictures = Pictures::new(integrator.system(), rows.count);
    }
    let mut energy = EnergyDrift::default();
    let mut steps = Steps::default();
    if recorder.is_on_disk() {
        result.history.thin();
        steps.thin();
    }
    recorder.begin(result).map_err(RunError::Files)?;
    rows.state.clone_from(integrator.state());
    energy.meet(integrator.system().energy(&rows.state));
    let mut incomplete = rows.record(&mut integrator, result, recorder).err();
    while incomplete.is_none() {
        let stop = match integrator.step() {
            Ok(stop) => stop,
            Err(error) => {
                incomplete = Some(Incomplete::Solve(error));
                break;
            }
        };
        let t = integrator.state().t;
        let h = t - integrator.previous_time();
        if h > 0.0 {
            steps.push(t, h);
            rows.state.clone_from(integrator.state());
            energy.meet(integrator.system().energy(&rows.state));
        }
        incomplete = rows.record(&mut integrator, result, recorder).err();
        if stop == crate::Stop::End {
            break;
        }
        if watch(&Progress { t, t_end, h }).is_break() {
            incomplete = incomplete.or(Some(Incomplete::Interrupted));
        }
    }
    if let Err(error) = recorder.end() {
        incomplete = incomplete.or(Some(Incomplete::Files(error)));
    }
    result.steps = steps.taken();
    result.energy_error = energy.relative();
    let yielding = result.envelopes.warning();
    let jumps = integrator.statistics().jumps.clone();
    let told = cautions::texts(rows.warnings);
    result.warnings = moved.into_iter().chain(jumps).chain(told).chain(yielding).collect();
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

/// End time and time between rows of completed settings.
pub(super) fn times(settings: &RunSettings) -> (f64, f64) {
    (settings.t_end.unwrap_or(0.0), settings.every.unwrap_or(f64::INFINITY))
}

/// Rows of the history at whole multiples of a time.
struct Rows {
    every: f64,
    t_end: f64,
    next: u64,
    count: u64,
    state: State,
    values: Vec<f64>,
    warnings: Vec<Warning>,
}

impl Rows {
    fn new(every: f64, t_end: f64, state: &State, columns: usize) -> Self {
        Self {
            every,
            t_end,
            next: 0,
            // 0.3 / 0.1 is less than 3.
            count: (t_end / every * (1.0 + 1e-12)).floor() as u64 + 1,
            state: state.clone(),
            values: vec![0.0; columns],
            warnings: Vec::new(),
        }
    }

    /// Adds the rows up to the end of the last step.
    fn record(
        &mut self,
        integrator: &mut Integrator<'_, dyn Scene + '_>,
        result: &mut RunResult,
        recorder: &mut dyn Recorder,
    ) -> Result<(), Incomplete> {
        let reached = integrator.state().t;
        while self.next < self.count {
            let time = self.next as f64 * self.every;
            let t = time.min(self.t_end);
            // Steps end a rounding before a kink: a row at the kink is that of the step before.
            let slack = 1e-13 * self.t_end;
            if t > reached + slack {
                break;
            }
            if t >= reached - slack {
                self.state.clone_from(integrator.state());
            } else {
                integrator.interpolate(t, &mut self.state);
            }
            integrator.system().outputs(&self.state, &mut self.values);
            for warning in integrator.system().warnings(&self.state) {
                cautions::meet(&mut self.warnings, warning);
            }
            result.history.push(time, &self.values).map_err(Incomplete::Output)?;
            recorder.row(time, &self.values);
            result.envelopes.meet(integrator.system(), time, &self.state);
            if let Some(pictures) = &mut result.pictures {
                pictures.take(self.next, integrator.system(), time, &self.state);
            }
            self.next += 1;
        }
        recorder.keep_up().map_err(Incomplete::Files)
    }
}

/// The accepted steps.
#[derive(Default)]
struct Steps {
    ends: Vec<f64>,
    sizes: Vec<f64>,
    sketch: Option<Sketch>,
}

impl Steps {
    /// Keeps from now on what pictures need.
    fn thin(&mut self) {
        self.sketch = Some(Sketch::new(SKETCHED));
    }

    fn push(&mut self, t: f64, h: f64) {
        match &mut self.sketch {
            Some(sketch) => sketch.add(&mut self.ends, &mut self.sizes, t, &[h]),
            None => {
                self.ends.push(t);
                self.sizes.push(h);
            }
        }
    }

    fn taken(self) -> Vec<StepTaken> {
        let steps = self.ends.into_iter().zip(self.sizes);
        steps.map(|(t, h)| StepTaken { t, h }).collect()
    }
}

/// Deviation of the energy from its first value.
#[derive(Default)]
struct EnergyDrift {
    first: Option<f64>,
    lost: bool,
    deviation: f64,
    largest: f64,
}

impl EnergyDrift {
    fn meet(&mut self, energy: Option<f64>) {
        let Some(energy) = energy else {
            self.lost = true;
            return;
        };
        let first = *self.first.get_or_insert(energy);
        self.deviation = self.deviation.max((energy - first).abs());
        self.largest = self.largest.max(energy.abs());
    }

    fn relative(&self) -> Option<f64> {
        if self.lost || self.first.is_none() {
            return None;
        }
        Some(if self.deviation == 0.0 {
            0.0
        } else {
            self.deviation / self.largest
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::sweep::SweepSettings;
    use crate::app::testing::Rotor;

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
        let summary = crate::app::summary::of_run(&rotor, &result);
        assert_eq!(summary["notes"][1], "the spring is soft at 6 rad/s");
        let steady = steady(&rotor, &SweepSettings::default()).unwrap();
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
