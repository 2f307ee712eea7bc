//! The command line of a model: one line in an example's `main`.
//!
//! ```text
//! cargo run --release --example spin_up -- [run|steady] [name=value ...] [flags]
//! ```
//!
//! [`main`] reads the line, runs, shows progress, and writes the history (CSV), the summary (JSON)
//! and the report (HTML). [`run`] and [`steady`] do the same work in memory and print nothing.

mod arguments;
mod charts;
mod clock;
mod envelopes;
mod files;
mod history;
mod nearest;
mod parameters;
mod progress;
mod report;
mod run;
mod section_table;
mod steady;
mod summary;
#[cfg(test)]
mod testing;
mod units;

use std::io::Write;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

pub use clock::Seconds;
pub use envelopes::{BodyEnvelope, Envelopes, Peak};
pub use history::{Column, Extreme, History};
pub use run::{Incomplete, Progress, RunError, RunResult, RunSettings, StepTaken, run, run_watched};
pub use steady::{SteadyResult, steady};

use crate::Model;
use arguments::{Arguments, Command, Refusal, parse};

/// Set by Ctrl-C; the run ends after its step, and its files are written.
static INTERRUPTED: AtomicBool = AtomicBool::new(false);

const FAILURE: u8 = 1;
const MISTAKE: u8 = 2;
const INTERRUPTION: u8 = 130;

/// A failure with its exit code.
struct Failure {
    code: u8,
    message: String,
}

impl Failure {
    fn new(code: u8, message: impl ToString) -> Self {
        Self {
            code,
            message: message.to_string(),
        }
    }
}

/// Reads the command line, runs the model and writes its files.
///
/// Exit codes: 0 complete; 1 a step failed or a file cannot be written; 2 a mistake on the command
/// line or in a parameter; 130 Ctrl-C. Files are complete up to the last good time in all cases
/// in which a run has begun.
pub fn main<M: Model>() -> ExitCode {
    let arguments = match parse::<M>(&program(), std::env::args_os().skip(1)) {
        Ok(arguments) => arguments,
        Err(Refusal::Help(text)) => {
            say(&text);
            return ExitCode::SUCCESS;
        }
        Err(Refusal::Mistake(text)) => return fail(Failure::new(MISTAKE, text)),
    };
    watch_for_interruption();
    match execute(&arguments, || INTERRUPTED.load(Ordering::Relaxed)) {
        Ok(text) => {
            if !arguments.quiet {
                say(&text);
            }
            ExitCode::SUCCESS
        }
        Err(failure) => fail(failure),
    }
}

/// The example's name: the file stem of the program.
fn program() -> String {
    let path = std::env::args_os().next().unwrap_or_default();
    match Path::new(&path).file_stem() {
        Some(stem) => stem.to_string_lossy().into_owned(),
        None => "model".into(),
    }
}

/// Writes to standard output; that nobody reads it is no failure of the run.
fn say(text: &str) {
    let _ = writeln!(std::io::stdout(), "{}", text.trim_end());
}

fn fail(failure: Failure) -> ExitCode {
    let _ = writeln!(std::io::stderr(), "error: {}", failure.message);
    ExitCode::from(failure.code)
}

/// The first Ctrl-C ends the run in good order, a second one ends the program at once.
fn watch_for_interruption() {
    // Without a handler Ctrl-C ends the program as usual, which is the best that is left.
    let _ = ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(INTERRUPTION));
        }
    });
}

/// Runs and writes; the text for standard output.
fn execute<M: Model>(arguments: &Arguments<M>, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    files::create_folder(&arguments.out).map_err(|text| Failure::new(FAILURE, text))?;
    match arguments.command {
        Command::Run => execute_run(arguments, interrupted),
        Command::Steady => execute_steady(arguments),
    }
}

fn execute_run<M: Model>(arguments: &Arguments<M>, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let mut bar = progress::Bar::new(arguments.quiet);
    let outcome = run_watched(&arguments.model, &arguments.settings, |progress| {
        bar.show(progress);
        if interrupted() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    bar.clear();
    let failure = outcome
        .as_ref()
        .err()
        .map(|error| Failure::new(exit_code(error), error));
    let result = match outcome {
        Ok(result) => result,
        Err(RunError::Incomplete(result)) => *result,
        Err(error) => return Err(Failure::new(exit_code(&error), error)),
    };
    let summary = summary::of_run(&arguments.model, &result);
    let files = write(arguments, "history.csv", &summary, &result.history, &result.steps)?;
    let counts = &result.statistics;
    let head = format!(
        "{}: t = {} s, {} steps ({} rejected), {} factorizations, {} s",
        M::NAME,
        parameters::short(result.state.t),
        counts.steps,
        counts.rejected_steps,
        counts.factorizations,
        parameters::digits(result.seconds.cpu, 3),
    );
    finish(head, &result.envelopes, &result.warnings, files, failure)
}

fn execute_steady<M: Model>(arguments: &Arguments<M>) -> Result<String, Failure> {
    let outcome = steady(&arguments.model, &arguments.settings);
    let failure = outcome
        .as_ref()
        .err()
        .map(|error| Failure::new(exit_code(error), error));
    let result = match outcome {
        Ok(result) => result,
        Err(RunError::Steady(result)) => *result,
        Err(error) => return Err(Failure::new(exit_code(&error), error)),
    };
    let summary = summary::of_steady(&arguments.model, &result);
    let files = write(arguments, "steady.csv", &summary, &result.history, &[])?;
    let head = format!(
        "{}: relative equilibrium, {} steps up to {} rad/s, {} s",
        M::NAME,
        result.history.keys.len(),
        parameters::short(result.history.keys.last().copied().unwrap_or(0.0)),
        parameters::digits(result.seconds.cpu, 3),
    );
    finish(head, &result.envelopes, &result.warnings, files, failure)
}

/// What to say at the end: with a failure, the files go into its message.
fn finish(
    head: String,
    envelopes: &Envelopes,
    warnings: &[String],
    files: String,
    failure: Option<Failure>,
) -> Result<String, Failure> {
    let bodies = envelopes.lines();
    let warnings: String = warnings.iter().map(|text| format!("warning: {text}\n")).collect();
    match failure {
        None => Ok(format!("{head}\n{bodies}{warnings}{files}")),
        Some(failure) => Err(Failure {
            message: format!("{}\n{warnings}up to there:\n{bodies}{files}", failure.message),
            ..failure
        }),
    }
}

fn exit_code(error: &RunError) -> u8 {
    match error {
        RunError::Settings(_) | RunError::Model(_) => MISTAKE,
        RunError::Incomplete(result) if result.incomplete == Some(Incomplete::Interrupted) => INTERRUPTION,
        RunError::Start(_) | RunError::Incomplete(_) | RunError::Steady(_) => FAILURE,
    }
}

/// Writes the three files; their paths, one a line.
fn write<M: Model>(
    arguments: &Arguments<M>,
    table: &str,
    summary: &summary::Summary,
    history: &History,
    steps: &[StepTaken],
) -> Result<String, Failure> {
    let written = || {
        let page = report::page(&arguments.model, summary, history, steps)?;
        let contents = [
            (table, history.to_csv()),
            ("summary.json", summary::to_text(summary)),
            ("report.html", page),
        ];
        let mut paths = Vec::new();
        for (name, text) in contents {
            files::write(&arguments.out, name, &text)?;
            paths.push(format!("  {}", arguments.out.join(name).display()));
        }
        Ok(paths.join("\n"))
    };
    written().map_err(|text: String| Failure::new(FAILURE, text))
}

#[cfg(test)]
mod tests {
    use std::ffi::OsString;
    use std::fs;

    use serde_json::Value;

    use super::testing::{Rotor, temporary_folder};
    use super::*;

    /// Runs a command line; its outcome and the folder of its files.
    fn command(name: &str, words: &[&str], interrupted: bool) -> (Result<String, Failure>, std::path::PathBuf) {
        let out = temporary_folder(name);
        let words = words
            .iter()
            .map(OsString::from)
            .chain(["--out".into(), out.clone().into()]);
        let Ok(arguments) = parse::<Rotor>("rotor", words) else {
            panic!("a mistake on the command line")
        };
        (execute(&arguments, || interrupted), out)
    }

    fn summary(folder: &Path) -> Value {
        serde_json::from_str(&fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap()
    }

    fn rows(folder: &Path, name: &str) -> Vec<Vec<f64>> {
        let text = fs::read_to_string(folder.join(name)).unwrap();
        let row = |line: &str| line.split(',').map(|number| number.parse().unwrap()).collect();
        text.lines().skip(1).map(row).collect()
    }

    #[test]
    fn a_run_writes_its_three_files() {
        let words = ["coils=4", "loss=0", "--integrator", "hht", "--max-step", "1 ms"];
        let (outcome, folder) = command("complete", &words, false);
        let text = outcome.map_err(|failure| failure.message).unwrap();
        assert!(
            text.starts_with("Rotor: t = 4 s, ") && text.contains("report.html"),
            "{text}"
        );
        let table = rows(&folder, "history.csv");
        assert_eq!((table.len(), table[0].len(), table[80][0]), (81, 4, 80.0 * 0.05));
        let summary = summary(&folder);
        let expected = [
            ("model", "Rotor".into()),
            ("formulation", "rncf".into()),
            ("integrator", "hht".into()),
            ("alpha", (-0.05).into()),
            ("completed", true.into()),
            ("reason", Value::Null),
            ("t_end", 4.0.into()),
            ("unknowns", 2.into()),
            ("constraints", 0.into()),
            ("max_constraint_residual", Value::Null),
            ("max_step", 1e-3.into()),
        ];
        for (key, value) in expected {
            assert_eq!(summary[key], value, "{key}");
        }
        assert_eq!(summary["parameters"]["coils"], 4);
        assert_eq!(summary["parameters"]["omega"], 3.0);
        for key in [
            "steps",
            "steps_at_ceiling",
            "newton_iterations",
            "residual_evaluations",
            "jacobian_evaluations",
            "factorizations",
            "cpu_seconds",
            "wall_seconds",
            "energy_error",
            "smallest_step",
            "largest_step",
        ] {
            assert!(summary[key].as_f64().unwrap() > 0.0, "{key}");
        }
        assert!(summary["rejected_steps"].is_u64());
        let least = table.iter().map(|row| row[1]).fold(f64::INFINITY, f64::min);
        assert_eq!(summary["outputs"][0]["name"], "tip.x");
        assert_eq!(summary["outputs"][0]["min"].as_f64().unwrap(), least);
        let page = fs::read_to_string(folder.join("report.html")).unwrap();
        assert_eq!(page.matches("<svg ").count(), 3);
        assert!(page.contains("// a &lt; b &amp; c") && page.contains("The spring has no mass."));
        assert!(!page.contains("http") || page.matches("http").count() == page.matches("http://www.w3.org/").count());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 3);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn ctrl_c_leaves_complete_files_and_its_reason() {
        let (outcome, folder) = command("interrupted", &["--integrator", "hht"], true);
        let failure = outcome.unwrap_err();
        assert_eq!(failure.code, INTERRUPTION);
        assert!(
            failure.message.contains("interrupted by the user"),
            "{}",
            failure.message
        );
        let summary = summary(&folder);
        assert_eq!(summary["completed"], false);
        assert_eq!(summary["reason"], "interrupted by the user");
        assert_eq!(rows(&folder, "history.csv")[0][0], 0.0);
        assert!(
            fs::read_to_string(folder.join("report.html"))
                .unwrap()
                .contains("interrupted by the user")
        );
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_failing_step_leaves_complete_files_and_its_reason() {
        let (outcome, folder) = command("failing", &["fail_at=1.02 s", "--integrator", "hht"], false);
        let failure = outcome.unwrap_err();
        assert_eq!(failure.code, FAILURE);
        assert!(failure.message.contains(" t = 1.0"), "{}", failure.message);
        let summary = summary(&folder);
        assert_eq!(summary["completed"], false);
        assert!(summary["t_reached"].as_f64().unwrap() <= 1.02);
        assert_eq!(rows(&folder, "history.csv").len(), 21);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn steady_writes_its_table_over_the_spin() {
        let (outcome, folder) = command("steady", &["steady", "omega=60 rpm"], false);
        let text = outcome.map_err(|failure| failure.message).unwrap();
        assert!(
            text.contains("6.28318530718 rad/s") && text.contains("steady.csv"),
            "{text}"
        );
        let head = fs::read_to_string(folder.join("steady.csv")).unwrap();
        assert!(head.starts_with("spin [rad/s],tip.x [m],tip.y [m],pull [N]\n"));
        let last = rows(&folder, "steady.csv").pop().unwrap();
        assert_eq!(last[0], 60.0 * (std::f64::consts::PI / 30.0));
        let summary = summary(&folder);
        assert_eq!(summary["outputs"][0]["spin_max"].as_f64().unwrap(), last[0]);
        assert!(summary["completed"] == true && summary["newton_iterations"].as_u64().unwrap() > 0);
        assert!(
            fs::read_to_string(folder.join("report.html"))
                .unwrap()
                .contains("spin [rad/s]")
        );
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_model_that_cannot_be_built_is_a_mistake() {
        let (outcome, folder) = command("unbuildable", &["stiffness=-1 N/m"], false);
        let failure = outcome.unwrap_err();
        assert_eq!(failure.code, MISTAKE);
        assert_eq!(failure.message, "parameter `stiffness` must be positive");
        fs::remove_dir_all(folder).unwrap();
    }
}
