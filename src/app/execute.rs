//! What each command does: the work, its files, and the words at the end.

use std::ops::ControlFlow;

use super::arguments::Arguments;
use super::campbell::campbell_watched;
use super::clock::Seconds;
use super::command::Command;
use super::diagrams::{campbell_lines, campbell_part, critical_lines, mode_lines, modes_csv, modes_part};
use super::history::History;
use super::modes::modes;
use super::parameters::{digits, short};
use super::pictures::{Pictures, animation, paraview};
use super::progress::Bar;
use super::recorder::{HISTORY, OnDisk};
use super::run::run_recorded;
use super::run_error::{Incomplete, RunError};
use super::steady::equilibria;
use super::summary::{self, Summary};
use super::{advise, card, chart, checkpoint, explain, export, files, plan, report, scenario};
use crate::equilibrium::Kind;

pub(super) const FAILURE: u8 = 1;
pub(super) const MISTAKE: u8 = 2;
pub(super) const INTERRUPTION: u8 = 130;

/// A failure with its exit code.
pub(super) struct Failure {
    pub code: u8,
    pub message: String,
}

impl Failure {
    pub fn new(code: u8, message: impl ToString) -> Self {
        Self {
            code,
            message: message.to_string(),
        }
    }
}

impl From<&RunError> for Failure {
    fn from(error: &RunError) -> Self {
        let reason = match error {
            RunError::Settings(_) | RunError::Model(_) => return Failure::new(MISTAKE, error),
            RunError::Start(_) | RunError::Files(_) | RunError::Equilibrium(_) => None,
            RunError::Incomplete(result) => result.incomplete.as_ref(),
            RunError::Equilibria(result) => result.incomplete.as_ref(),
            RunError::Campbell(result) => result.incomplete.as_ref(),
        };
        let is_interrupted = reason == Some(&Incomplete::Interrupted);
        Failure::new(if is_interrupted { INTERRUPTION } else { FAILURE }, error)
    }
}

/// Does what the arguments say and writes; the text for standard output.
pub(super) fn execute(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let failed = |text| Failure::new(FAILURE, text);
    if arguments.command != Command::Explain {
        files::create_folder(&arguments.out).map_err(failed)?;
    }
    if let Some(path) = &arguments.saved {
        scenario::keep(arguments, path)?;
    }
    // Tasks of one plan work side by side: each writes a file of its own.
    let shares = matches!(arguments.command, Command::Task | Command::Explain);
    let claimed = (!shares).then(|| files::claim(&arguments.out));
    let _claim = claimed.transpose().map_err(failed)?;
    match arguments.command {
        Command::Run => execute_run(arguments, interrupted),
        Command::Steady => execute_equilibria(arguments, Kind::Steady, interrupted),
        Command::Static => execute_equilibria(arguments, Kind::Static, interrupted),
        Command::Modes => execute_modes(arguments),
        Command::Campbell => execute_campbell(arguments, interrupted),
        Command::Chart => chart::execute(arguments, interrupted),
        Command::Advise => advise::execute(arguments, interrupted),
        Command::Sweep => plan::sweep(arguments, interrupted),
        Command::Plan => plan::lay_out(arguments),
        Command::Task => plan::task(arguments, interrupted),
        Command::Collect => plan::collect(arguments),
        Command::Explain => explain::execute(arguments),
    }
}

fn flow(is_interrupted: bool) -> ControlFlow<()> {
    if is_interrupted {
        ControlFlow::Break(())
    } else {
        ControlFlow::Continue(())
    }
}

fn execute_run(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    if arguments.resume
        && let Some(text) = checkpoint::complete(arguments)?
    {
        return Ok(text);
    }
    let mut bar = Bar::new(arguments.quiet);
    let mut recorder = OnDisk::new(arguments);
    let outcome = run_recorded(arguments.model(), &arguments.settings, &mut recorder, |progress| {
        bar.show(progress);
        flow(interrupted())
    });
    bar.clear();
    let failure = outcome.as_ref().err().map(Failure::from);
    let result = match outcome {
        Ok(result) => result,
        Err(RunError::Incomplete(result)) => *result,
        Err(error) => return Err(Failure::from(&error)),
    };
    let mut summary = summary::of_run(arguments.model(), &result);
    card::put(&mut summary, arguments.model(), &result);
    let part = report::run_part(arguments.model(), &result.history, &result.steps, &result.cautions);
    let mut files = format!("  {}\n", arguments.out.join(HISTORY).display());
    let hint = match result.incomplete {
        Some(Incomplete::Interrupted | Incomplete::Files(_)) => {
            let path = arguments.out.join(checkpoint::NAME);
            format!("\n  {} (the same command with `--resume` goes on)", path.display())
        }
        _ => String::new(),
    };
    files += &match (write_told(arguments, "run", &summary, part), &failure) {
        (Ok(told), _) => told,
        (Err(second), None) => return Err(second),
        // On a full disk the first file that could not be written says more than the next one.
        (Err(_), Some(first)) => {
            let message = format!(
                "{}\nup to there:\n{files}{}",
                first.message,
                hint.trim_start_matches('\n')
            );
            return Err(Failure::new(first.code, message));
        }
    };
    match &result.pictures {
        Some(pictures) => files += &write_pictures(arguments, pictures)?,
        None if result.settings.pictures => files += "\n  (no pictures: this scene has nothing to draw)",
        None => {}
    }
    if result.incomplete.is_none() {
        checkpoint::remove(&arguments.out).map_err(|text| Failure::new(FAILURE, text))?;
    }
    files += &hint;
    let counts = &result.statistics;
    let mut head = format!(
        "{}: t = {} s, {} steps ({} rejected), {} factorizations ({} steps each), {} s",
        arguments.model().name(),
        short(result.state.t),
        counts.steps,
        counts.rejected_steps,
        counts.factorizations,
        counts
            .steps_per_factorization()
            .map_or("no".into(), |steps| digits(steps, 2)),
        digits(result.seconds.cpu, 3),
    );
    head += &result.envelopes.lines();
    finish(head, &result.warnings, files, failure)
}

fn execute_equilibria(arguments: &Arguments, kind: Kind, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let mut bar = Bar::new(arguments.quiet);
    let outcome = equilibria(arguments.model(), kind, &arguments.equilibrium, |progress| {
        bar.show_equilibrium(progress);
        flow(interrupted())
    });
    bar.clear();
    let failure = outcome.as_ref().err().map(Failure::from);
    let result = match outcome {
        Ok(result) => result,
        Err(RunError::Equilibria(result)) => *result,
        Err(error) => return Err(Failure::from(&error)),
    };
    let (what, name) = match kind {
        Kind::Steady => ("relative equilibria", "steady.csv"),
        Kind::Static => ("static equilibria", "static.csv"),
    };
    let summary = summary::of_equilibria(arguments.model(), &result);
    let table = (name, result.history.to_csv());
    let files = write(
        arguments,
        what,
        table,
        &summary,
        report::equilibria_part(arguments.model(), &result),
    )?;
    let mut head = format!(
        "{}: {what}, {}",
        arguments.model().name(),
        way(&result.history, result.seconds)
    );
    for line in critical_lines(&result.history.key, &result.critical, report::BUCKLING) {
        head += &format!("\n{line}");
    }
    head += &result.envelopes.lines();
    finish(head, &result.warnings, files, failure)
}

/// How many equilibria there are, and up to where.
fn way(history: &History, seconds: Seconds) -> String {
    let key = &history.key;
    let last = history.keys.last().copied().unwrap_or(0.0);
    let unit = if key.unit == "1" {
        String::new()
    } else {
        format!(" {}", key.unit)
    };
    format!(
        "{} steps up to {} = {}{unit}, {} s",
        history.rows(),
        key.name,
        short(last),
        digits(seconds.cpu, 3)
    )
}

fn execute_modes(arguments: &Arguments) -> Result<String, Failure> {
    let result = modes(arguments.model(), &arguments.equilibrium).map_err(|error| Failure::from(&error))?;
    let summary = summary::of_modes(arguments.model(), &result);
    let part = modes_part(arguments.model().name(), &result, arguments.frequency);
    let mut files = write(
        arguments,
        "modes",
        ("modes.csv", modes_csv(&result)),
        &summary,
        Ok(part),
    )?;
    if arguments.export {
        files += &export::execute(arguments)?;
    }
    let head = format!(
        "{}: {} modes at t = {} s, spin {}, {} s\n{}",
        arguments.model().name(),
        result.modes.len(),
        short(result.t),
        arguments.frequency.shown(result.spin),
        digits(result.seconds.cpu, 3),
        mode_lines(&result, arguments.frequency).trim_end(),
    );
    finish(head, &result.warnings, files, None)
}

fn execute_campbell(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let mut bar = Bar::new(arguments.quiet);
    let outcome = campbell_watched(arguments.model(), &arguments.equilibrium, |progress| {
        bar.show_equilibrium(progress);
        flow(interrupted())
    });
    bar.clear();
    let failure = outcome.as_ref().err().map(Failure::from);
    let result = match outcome {
        Ok(result) => result,
        Err(RunError::Campbell(result)) => *result,
        Err(error) => return Err(Failure::from(&error)),
    };
    let summary = summary::of_campbell(arguments.model(), &result);
    let part = campbell_part(&result, arguments.frequency);
    let table = ("campbell.csv", result.to_csv());
    let files = write(arguments, "Campbell diagram", table, &summary, part)?;
    let mut head = format!(
        "{}: Campbell diagram, {} modes at {} values of {}, {} s",
        arguments.model().name(),
        result.tracks.len(),
        result.keys.len(),
        result.key.name,
        digits(result.seconds.cpu, 3),
    );
    for line in campbell_lines(&result, arguments.frequency) {
        head += &format!("\n{line}");
    }
    finish(head, &result.warnings, files, failure)
}

/// What to say at the end: with a failure, the files go into its message.
fn finish(head: String, warnings: &[String], files: String, failure: Option<Failure>) -> Result<String, Failure> {
    let warnings: String = warnings.iter().map(|text| format!("warning: {text}\n")).collect();
    match failure {
        None => Ok(format!("{head}\n{warnings}{files}")),
        Some(failure) => Err(Failure {
            message: format!("{}\n{warnings}up to there:\n{files}", failure.message),
            ..failure
        }),
    }
}

/// Writes the table, the summary and the report; their paths, one a line.
pub(super) fn write(
    arguments: &Arguments,
    what: &str,
    (name, table): (&str, String),
    summary: &Summary,
    part: Result<String, String>,
) -> Result<String, Failure> {
    files::write(&arguments.out, name, &table).map_err(|text| Failure::new(FAILURE, text))?;
    let told = write_told(arguments, what, summary, part)?;
    Ok(format!("  {}\n{told}", arguments.out.join(name).display()))
}

/// Writes the summary and the report.
fn write_told(
    arguments: &Arguments,
    what: &str,
    summary: &Summary,
    part: Result<String, String>,
) -> Result<String, Failure> {
    let written = || {
        let mut summary = summary.clone();
        summary::command_line(&mut summary, &arguments.line);
        let page = report::page(arguments.model(), what, &summary, &part?);
        let contents = [("summary.json", summary::to_text(&summary)), ("report.html", page)];
        let mut paths = Vec::new();
        for (name, text) in contents {
            files::write(&arguments.out, name, &text)?;
            paths.push(format!("  {}", arguments.out.join(name).display()));
        }
        Ok(paths.join("\n"))
    };
    written().map_err(|text: String| Failure::new(FAILURE, text))
}

/// Writes what was asked for of the pictures; the lines that name the files.
fn write_pictures(arguments: &Arguments, pictures: &Pictures) -> Result<String, Failure> {
    let written = || {
        let mut lines = String::new();
        let mut named = |name: &str| lines += &format!("\n  {}", arguments.out.join(name).display());
        if arguments.animate {
            files::write(
                &arguments.out,
                animation::NAME,
                &animation::page(arguments.model().name(), pictures),
            )?;
            named(animation::NAME);
        }
        if arguments.vtu {
            let folder = arguments.out.join(paraview::FOLDER);
            files::create_folder(&folder)?;
            for picture in 0..pictures.shots.len() {
                files::write(&folder, &paraview::name(picture), &paraview::picture(pictures, picture))?;
            }
            files::write(&arguments.out, paraview::LIST, &paraview::list(pictures))?;
            named(paraview::LIST);
        }
        Ok(lines)
    };
    written().map_err(|text: String| Failure::new(FAILURE, text))
}

#[cfg(test)]
mod tests {
    use std::ffi::OsString;
    use std::fs;

    use serde_json::Value;

    use std::path::{Path, PathBuf};

    use super::*;
    use crate::Model;
    use crate::app::arguments::{Program, parse};
    use crate::app::testing::{Rotor, temporary_folder};

    /// Runs a command line; its outcome and the folder of its files.
    fn command(name: &str, words: &[&str], interrupted: bool) -> (Result<String, Failure>, PathBuf) {
        let out = temporary_folder(name);
        let words = words
            .iter()
            .map(OsString::from)
            .chain(["--out".into(), out.clone().into()]);
        let program = Program {
            name: "rotor",
            default: Command::Run,
            more: "",
            out: PathBuf::new(),
        };
        let Ok(arguments) = parse(&Rotor::default(), &program, words) else {
            panic!("a mistake on the command line")
        };
        (execute(&arguments, || interrupted), out)
    }

    fn summary(folder: &Path) -> Value {
        serde_json::from_str(&fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap()
    }

    fn rows(folder: &Path, name: &str) -> Vec<Vec<f64>> {
        let text = fs::read_to_string(folder.join(name)).unwrap();
        let row = |line: &str| {
            line.split(',')
                .map(|number| number.parse().unwrap_or(f64::NAN))
                .collect()
        };
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
        assert_eq!(summary["parameters_in_units"]["omega"], "3 rad/s");
        let line = summary["command_line"].as_str().unwrap();
        assert!(
            line.starts_with("coils=4 loss=0 --integrator hht --max-step '1 ms' --out "),
            "{line}"
        );
        assert_eq!(summary["model_text"], <Rotor as Model>::SOURCE);
        assert_eq!(summary["model_hash"].as_str().unwrap().len(), 16);
        assert!(summary["date"].as_str().unwrap().ends_with('Z'));
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
    fn while_it_runs_the_rows_are_on_disk_and_the_summary_says_so() {
        let folder = temporary_folder("running");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("report.html"), "of an earlier run").unwrap();
        let program = Program {
            name: "rotor",
            default: Command::Run,
            more: "",
            out: folder.clone(),
        };
        let words = ["--every", "1 ms", "--integrator", "hht", "--t-end", "2 s"].map(OsString::from);
        let Ok(arguments) = parse(&Rotor::default(), &program, words) else {
            panic!("a mistake on the command line")
        };
        let seen = std::cell::Cell::new(0);
        let begun = std::time::Instant::now();
        let outcome = execute(&arguments, || {
            // What another process would find, or anybody after a kill.
            if seen.get() == 0 && begun.elapsed() > std::time::Duration::from_millis(600) {
                let text = fs::read_to_string(folder.join("history.csv")).unwrap();
                assert!(text.ends_with('\n') && text.lines().all(|line| line.split(',').count() == 4));
                seen.set(text.lines().count());
                let summary = summary(&folder);
                assert_eq!(summary["completed"], false);
                assert!(summary["reason"].as_str().unwrap().starts_with("still running"));
                assert!(!folder.join("report.html").exists());
                let error = files::claim(&folder).unwrap_err();
                assert!(error.contains("another run writes to"), "{error}");
            }
            std::thread::sleep(std::time::Duration::from_millis(2));
            false
        });
        outcome.map_err(|failure| failure.message).unwrap();
        assert!(seen.get() > 10, "{} lines", seen.get());
        assert_eq!(rows(&folder, "history.csv").len(), 2001);
        assert_eq!(summary(&folder)["rows"], 2001);
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
    fn static_writes_its_table_over_the_load() {
        let (outcome, folder) = command("static", &["static", "--steps", "4"], false);
        let text = outcome.map_err(|failure| failure.message).unwrap();
        assert!(text.contains("5 steps up to load_factor = 1, "), "{text}");
        let head = fs::read_to_string(folder.join("static.csv")).unwrap();
        assert!(head.starts_with("load_factor [1],tip.x [m],"));
        assert_eq!(rows(&folder, "static.csv")[4][..2], [1.0, 2.0]);
        assert_eq!(summary(&folder)["critical_values"], serde_json::json!([]));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn modes_are_written_and_told_in_the_unit_that_is_asked_for() {
        let words = ["modes", "omega=10 rad/s", "loss=0", "--frequency", "rpm"];
        let (outcome, folder) = command("modes", &words, false);
        let text = outcome.map_err(|failure| failure.message).unwrap();
        let w0 = 50f64.sqrt();
        let rpm = |value: f64| digits(value * 30.0 / std::f64::consts::PI, 7);
        for part in [
            "frequency [rpm]".to_owned(),
            rpm(10.0 - w0),
            rpm(10.0 + w0),
            rpm(w0),
            "No mode grows".into(),
            "reference frame".into(),
        ] {
            assert!(text.contains(&part), "{part}\nin\n{text}");
        }
        let table = rows(&folder, "modes.csv");
        assert!(
            table.len() == 2 && (table[0][2] - (10.0 - w0)).abs() < 1e-9,
            "{table:?}"
        );
        assert_eq!(summary(&folder)["circular_whirl"], true);
        fs::remove_dir_all(folder).unwrap();
        let (outcome, folder) = command("unstable", &["modes", "omega=10 rad/s"], false);
        let text = outcome.map_err(|failure| failure.message).unwrap();
        assert!(text.contains("UNSTABLE"), "{text}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_campbell_diagram_shows_what_is_read_off() {
        let words = ["campbell", "omega=0..60 rpm", "--frequency", "Hz"];
        let (outcome, folder) = command("campbell", &words, false);
        let text = outcome.map_err(|failure| failure.message).unwrap();
        assert!(text.contains("no critical speed in this range"), "{text}");
        // 0.5 sqrt(50) rad/s; in space both whirls have sqrt(50) rad/s.
        assert_eq!(
            text.matches("crosses 2x the spin at omega = 3.535").count(),
            2,
            "{text}"
        );
        assert!(!text.contains("within") && !text.contains("Mode 1 is"), "{text}");
        let page = fs::read_to_string(folder.join("report.html")).unwrap();
        assert_eq!(page.matches("<svg ").count(), 3);
        for part in [
            "omega [rad/s]",
            "frequency in the inertial frame [Hz]",
            "backward whirl",
            "1x",
        ] {
            assert!(page.contains(part), "{part}");
        }
        fs::remove_dir_all(folder).unwrap();
        let (outcome, folder) = command("campbell-interrupted", &words, true);
        assert_eq!(outcome.unwrap_err().code, INTERRUPTION);
        assert_eq!(summary(&folder)["reason"], "interrupted by the user");
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
