//! The cheapest description of the bodies that suffices: a ladder from point masses to all nodal vectors, on finer and
//! finer meshes.
//!
//! [`ladder`] says what can be chosen, [`work`] runs a setting, [`search`] runs the ladder and judges, [`told`] says what
//! was found, and [`picture`] draws it.

mod ladder;
mod picture;
mod search;
#[cfg(test)]
mod tests;
mod told;
mod work;

use self::ladder::Choices;
use self::search::{Found, Outcome, Search};
use self::told::Advice;
use self::work::{Stop, Work};
use crate::AnyModel;
use crate::app::commands::progress::Bar;
use crate::app::commands::written::write;
use crate::app::line::advise::WANTED;
use crate::app::line::arguments::Arguments;
use crate::app::line::parameters::List;
use crate::app::machine::clock::{Clock, Seconds};
use crate::app::results::failure::{FAILURE, Failure, INTERRUPTION, MISTAKE};
use crate::app::results::run::RunSettings;
use crate::app::runs::run::complete;
use crate::model::Fidelity;

/// What is wanted of a search in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// Largest error relative to the largest change of an output, e.g. 1e-3.
    pub accuracy: f64,
    /// Columns of the history that count; empty: all that change.
    pub outputs: Vec<usize>,
    /// Processor time after which a single run is ended, s.
    pub limit: f64,
}

impl Default for Wanted {
    /// 1e-3 of all outputs, and a minute for each run.
    fn default() -> Self {
        Self {
            accuracy: WANTED,
            outputs: Vec::new(),
            limit: 60.0,
        }
    }
}

/// A rung of the ladder as it was found.
#[derive(Clone, Debug, PartialEq)]
pub struct AdvisedRung {
    /// In words: `rigid`, `full, elements = 8`, `crank: rigid, rod: modal(2)`.
    pub name: String,
    /// How the bodies are described.
    pub fidelity: Vec<(String, Fidelity)>,
    /// Values of params that count elements, by their index.
    pub counts: Vec<(usize, f64)>,
    /// Number of unknowns; `None` where the rung is impossible.
    pub unknowns: Option<usize>,
    /// Processor time of a run, s.
    pub cpu: Option<f64>,
    /// Difference from the richest rung relative to the largest change of an output, with that rung's own error.
    pub error: Option<f64>,
    /// Whether it agrees with the two next richer rungs and the richest one.
    pub suffices: bool,
    /// Why there is no such scene, or it does not run.
    pub reason: Option<String>,
    /// What the scene warns of and the model as declared does not.
    pub warnings: Vec<String>,
}

/// What a search has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Advised {
    /// From cheap to rich; at the end those with single bodies described otherwise.
    pub rungs: Vec<AdvisedRung>,
    /// The simplest one that suffices.
    pub named: Option<usize>,
    /// The model as it is declared.
    pub declared: Option<usize>,
    /// Tolerance of the integration in time.
    pub rtol: f64,
    /// The advice in sentences, or why there is none and what to do.
    pub sentences: Vec<String>,
}

/// Searches the simplest description of a model's bodies, and mesh, that gives its outputs to a wanted accuracy.
///
/// A stiff rod is turned by a hub; for the way of its end a rod that does not bend, nor resists a tilt, is enough:
///
/// ```
/// use rncf::app::{RunSettings, Wanted, advise};
///
/// rncf::model! {
///     pub model Rod {
///         param elements: count = 4;
///         material steel { density = 7850 kg/m^3; young = 210 GPa; }
///         section round { area = 4 cm^2; second_moment = 1.3 cm^4; }
///         frame hub = rotating(axis = z, angle = 1 [rad/s^2] * t^2);
///         body rod in hub {
///             planar xy;
///             line from [0, 0, 0] m to [0.5, 0, 0] m;
///             mesh elements * cable(round, steel);
///         }
///         joint root = clamp(rod.start, hub);
///         output way = rod.end.in(inertial).y;
///         run { t_end = 1 s; every = 0.1 s; }
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let found = advise(&Rod::default(), &RunSettings::default(), &Wanted { accuracy: 1e-2, ..Wanted::default() })?;
/// let simplest = &found.rungs[found.named.unwrap()];
/// assert!(simplest.name.starts_with("point") && simplest.error.unwrap() < 1e-2);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// Settings or parameters that make no sense, nothing to choose from, or a model that does not run as declared.
pub fn advise(model: &dyn AnyModel, settings: &RunSettings, wanted: &Wanted) -> Result<Advised, String> {
    let task = Task {
        model,
        settings,
        lists: &[],
        wanted: wanted.accuracy,
        outputs: (!wanted.outputs.is_empty()).then_some(&wanted.outputs[..]),
        limit: wanted.limit,
    };
    let searched = task
        .search(&|| false, Bar::new(true))
        .map_err(|failure| failure.message)?;
    let (found, advice) = (&searched.found, searched.advice(model));
    let rung = |(index, rung): (usize, &search::Rung)| {
        let trial = rung.trial();
        AdvisedRung {
            name: rung.name.clone(),
            fidelity: rung.setting.fidelity.clone(),
            counts: rung.setting.counts.clone(),
            unknowns: trial.map(|trial| trial.unknowns),
            cpu: trial.map(|trial| trial.cpu),
            error: found.error(index),
            suffices: rung.suffices,
            reason: match &rung.outcome {
                Outcome::Impossible(reason) => Some(reason.clone()),
                _ => None,
            },
            warnings: trial.map_or_else(Vec::new, |trial| trial.warnings.clone()),
        }
    };
    Ok(Advised {
        rungs: found.rungs.iter().enumerate().map(rung).collect(),
        named: found.named,
        declared: found.declared,
        rtol: searched.rtol,
        sentences: advice.sentences(),
    })
}

/// A search to be done.
struct Task<'t> {
    model: &'t dyn AnyModel,
    settings: &'t RunSettings,
    lists: &'t [List],
    wanted: f64,
    outputs: Option<&'t [usize]>,
    limit: f64,
}

/// A search that is done.
struct Searched {
    /// With times and tolerance filled in.
    settings: RunSettings,
    choices: Choices,
    found: Found,
    wanted: f64,
    rtol: f64,
    time_error: f64,
    seconds: Seconds,
    warnings: Vec<String>,
}

impl Task<'_> {
    /// # Errors
    /// With its exit code: a mistake in settings or parameters; a model that does not run; nothing to choose; Ctrl-C before
    /// anything was known.
    fn search(&self, interrupted: &dyn Fn() -> bool, bar: Bar) -> Result<Searched, Failure> {
        let mistake = |text: String| Failure::new(MISTAKE, text);
        let base = complete(self.settings, self.model.run()).map_err(|error| Failure::from(&error))?;
        let choices = Choices::of(self.model, base.formulation, base.joints, self.lists).map_err(mistake)?;
        if choices.bodies.is_empty() && choices.meshes.len() == 1 {
            return Err(mistake(format!(
                "{} has nothing to choose from: no meshed body that is not repeated, and no param that counts elements",
                self.model.name()
            )));
        }
        let clock = Clock::start();
        let mut work = Work {
            model: self.model,
            base,
            limit: self.limit,
            outputs: self.outputs,
            interrupted,
            bar,
            warnings: Vec::new(),
        };
        let (rtol, time_error) = work.tolerance(&choices.as_declared(), self.wanted).map_err(|stop| {
            work.bar.clear();
            match stop {
                Stop::Interrupted => Failure::new(INTERRUPTION, "interrupted by the user before anything was known"),
                Stop::Impossible(reason) => Failure::new(
                    FAILURE,
                    format!("as declared, {} does not run: {reason}", self.model.name()),
                ),
            }
        })?;
        let found = Search {
            model: self.model,
            choices: &choices,
            wanted: self.wanted,
            outputs: self.outputs,
            solve: &mut |setting, name, share| work.solve(setting, name, share),
        }
        .run();
        let of_named = found.named.and_then(|named| work.time_error_of(&found, named));
        work.bar.clear();
        if found.richest.is_some() && found.chosen.is_empty() {
            return Err(mistake(
                "none of the outputs that count changes in this run: there is nothing to judge by".into(),
            ));
        }
        Ok(Searched {
            settings: work.base,
            rtol,
            time_error: of_named.unwrap_or(time_error),
            seconds: clock.seconds(),
            warnings: work.warnings,
            wanted: self.wanted,
            found,
            choices,
        })
    }
}

impl Searched {
    fn advice<'a>(&'a self, model: &'a dyn AnyModel) -> Advice<'a> {
        Advice {
            model,
            settings: &self.settings,
            choices: &self.choices,
            found: &self.found,
            wanted: self.wanted,
            rtol: self.rtol,
            time_error: self.time_error,
            seconds: self.seconds,
            warnings: &self.warnings,
        }
    }
}

/// Does it all and writes; the text for standard output.
///
/// # Errors
/// With its exit code: a mistake in flags or parameters; a model that does not run; nothing to choose; a file that cannot
/// be written; Ctrl-C, where all that is known is written.
pub(in crate::app) fn execute(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let settings = &arguments.advise;
    let &[wanted] = &settings.wanted[..] else {
        return Err(Failure::new(
            MISTAKE,
            "`--wanted` takes one number here, e.g. `--wanted 1e-4`: a ladder serves one accuracy",
        ));
    };
    let task = Task {
        model: arguments.model(),
        settings: &arguments.settings,
        lists: &arguments.lists,
        wanted,
        outputs: settings.outputs.as_deref(),
        limit: settings.limit,
    };
    let searched = task.search(&interrupted, Bar::new(arguments.quiet))?;
    let advice = searched.advice(task.model);
    let summary = advice.summary();
    let table = ("advise.csv", advice.csv());
    let files = write(arguments, "advice", table, &summary, Ok(advice.page()))?;
    let text = format!("{}\n{files}", advice.text());
    if searched.found.is_interrupted {
        return Err(Failure::new(
            INTERRUPTION,
            format!("interrupted by the user; up to there:\n{text}"),
        ));
    }
    Ok(text)
}
