//! Single runs: a setting with its tolerance, its limit and its time.

use std::ops::ControlFlow;

use super::ladder::Setting;
use super::search::{Found, Outcome, Trial, difference, measure};
use crate::app::commands::progress::Bar;
use crate::app::judged::finer::Judging;
use crate::app::machine::clock::Clock;
use crate::app::results::error::RunError;
use crate::app::results::incomplete::Incomplete;
use crate::app::results::run::{RunResult, RunSettings};
use crate::app::runs::run::run_watched;
use crate::app::writing::numbers::short;
use crate::{AnyModel, Options};

/// Runs that take less than this altogether, s, are repeated, and the least time counts.
const REPEATED: f64 = 0.3;
/// So many times at most.
const REPETITIONS: usize = 5;
/// Part of the wanted accuracy that the integration in time may take.
const SHARE: f64 = 0.05;
/// Tolerances below this are not tried: round-off is near.
pub(super) const TIGHTEST: f64 = 1e-11;

/// Why a run has no result.
pub(super) enum Stop {
    Impossible(String),
    Interrupted,
}

/// Runs settings of one model.
pub(super) struct Work<'w> {
    pub model: &'w dyn AnyModel,
    pub base: RunSettings,
    /// Processor time after which a run is ended, s.
    pub limit: f64,
    /// Columns that count; `None`: all that change.
    pub outputs: Option<&'w [usize]>,
    pub interrupted: &'w dyn Fn() -> bool,
    pub bar: Bar,
    /// Warnings of the model as declared.
    pub warnings: Vec<String>,
}

impl Work<'_> {
    /// Finds the tolerance with which the integration in time takes no more than its share of the wanted accuracy,
    /// with the model as declared: the tolerance and the error that it makes.
    ///
    /// # Errors
    /// Why the model as declared does not run.
    pub fn tolerance(&mut self, declared: &Setting, wanted: f64) -> Result<(f64, f64), Stop> {
        let mut rtol = self.base.options.rtol.min(0.1 * wanted);
        let mut rough = self.run(declared, rtol)?;
        self.warnings = rough.warnings.clone();
        loop {
            self.bar.show_share(0.0, "tolerance of the integration");
            let fine = self.run(declared, 0.1 * rtol)?;
            let error = self.time_error(&fine, &rough);
            if error <= SHARE * wanted || 0.1 * rtol < TIGHTEST {
                self.base.options.rtol = rtol;
                return Ok((rtol, error));
            }
            // Decimal, not by repeated division: the tolerance is shown.
            rtol = format!("{:.3e}", 0.1 * rtol).parse().unwrap_or(0.1 * rtol);
            rough = fine;
        }
    }

    fn time_error(&self, fine: &RunResult, rough: &RunResult) -> f64 {
        let (scales, chosen) = measure(self.model, &fine.history, self.outputs);
        let found = Found {
            scales,
            chosen,
            ..Found::default()
        };
        difference(&found, &fine.history, &rough.history)
    }

    /// Error that the integration in time makes of a rung's outputs; `None` where a tighter run fails.
    pub fn time_error_of(&mut self, found: &Found, rung: usize) -> Option<f64> {
        let trial = found.rungs[rung].trial()?;
        let fine = self
            .run(&found.rungs[rung].setting, 0.1 * self.base.options.rtol)
            .ok()?;
        Some(difference(found, &trial.history, &fine.history))
    }

    /// Runs a setting; short ones several times for their processor time.
    pub fn solve(&mut self, setting: &Setting, name: &str, share: f64) -> Outcome {
        self.bar.show_share(share, name);
        let rtol = self.base.options.rtol;
        let first = match self.run(setting, rtol) {
            Ok(result) => result,
            Err(Stop::Impossible(reason)) => return Outcome::Impossible(reason),
            Err(Stop::Interrupted) => return Outcome::Interrupted,
        };
        let (mut cpu, mut spent) = (first.seconds.cpu, first.seconds.cpu);
        for _ in 1..REPETITIONS {
            if spent > REPEATED {
                break;
            }
            match self.run(setting, rtol) {
                Ok(result) => {
                    cpu = cpu.min(result.seconds.cpu);
                    spent += result.seconds.cpu;
                }
                Err(Stop::Interrupted) => return Outcome::Interrupted,
                Err(Stop::Impossible(reason)) => return Outcome::Impossible(reason),
            }
        }
        let is_new = |warning: &String| !self.warnings.contains(warning);
        Outcome::Ran(Box::new(Trial {
            unknowns: first.unknowns,
            steps: first.statistics.steps,
            cpu,
            warnings: first.warnings.into_iter().filter(is_new).collect(),
            history: first.history,
        }))
    }

    fn run(&self, setting: &Setting, rtol: f64) -> Result<RunResult, Stop> {
        let mut model = self.model.boxed();
        for &(param, value) in &setting.counts {
            model.set(param, value);
        }
        let settings = RunSettings {
            fidelity: setting.fidelity.clone(),
            options: Options {
                rtol,
                ..self.base.options
            },
            judged: Judging::No,
            ..self.base.clone()
        };
        let clock = Clock::start();
        let mut is_too_long = false;
        let outcome = run_watched(model.as_ref(), &settings, |_| {
            is_too_long = clock.seconds().cpu > self.limit;
            if is_too_long || (self.interrupted)() {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        match outcome {
            Ok(result) => Ok(result),
            Err(RunError::Incomplete(result)) if result.incomplete == Some(Incomplete::Interrupted) => {
                Err(if is_too_long {
                    let limit = short(self.limit);
                    Stop::Impossible(format!("takes longer than {limit} s: `--limit` gives it more"))
                } else {
                    Stop::Interrupted
                })
            }
            Err(error) => Err(Stop::Impossible(error.to_string())),
        }
    }
}
