//! What each command does: the work, its files, and the words at the end.

use std::ops::ControlFlow;
use std::path::Path;

use super::on_disk::OnDisk;
use super::progress::Bar;
use super::written;
use super::{advise, chart, checkpoint, explain, export, plan};
use crate::app::equilibria::steady::equilibria;
use crate::app::line::arguments::Arguments;
use crate::app::line::command::Command;
use crate::app::machine::clock::Seconds;
use crate::app::machine::files;
use crate::app::modal::campbell::campbell_watched;
use crate::app::modal::modes::modes;
use crate::app::page::compare::Other;
use crate::app::page::critical::critical_lines;
use crate::app::page::diagrams::{campbell_lines, campbell_part, mode_lines, modes_csv, modes_part};
use crate::app::page::{card, mass_table, report, summary};
use crate::app::results::error::RunError;
use crate::app::results::failure::{FAILURE, Failure, MISTAKE};
use crate::app::results::history::{Column, HISTORY, History};
use crate::app::results::incomplete::Incomplete;
use crate::app::runs::run::run_recorded;
use crate::app::writing::numbers::{SHORT, digits, short};
use crate::equilibrium::Kind;

/// Does what the arguments say and writes; the text for standard output.
pub(in crate::app) fn execute(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let failed = |text| Failure::new(FAILURE, text);
    // A mistake leaves no folder behind.
    if arguments.resume && !arguments.out.exists() {
        checkpoint::complete(arguments)?;
    }
    if arguments.command != Command::Explain {
        files::create_folder(&arguments.out).map_err(failed)?;
    }
    if let Some(path) = &arguments.saved {
        keep(arguments, path)?;
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
        Command::Optimise => plan::optimise(arguments, interrupted),
        Command::Plan => plan::lay_out(arguments),
        Command::Task => plan::task(arguments, interrupted),
        Command::Collect => plan::collect(arguments),
        Command::Explain => explain::execute(arguments),
    }
}

/// Keeps what the line of the arguments says.
///
/// # Errors
/// With its exit code: no file is named, or it cannot be written.
fn keep(arguments: &Arguments, path: &Path) -> Result<(), Failure> {
    let text = arguments.scenario.to_text(arguments.model(), arguments.command, None);
    let Some(name) = path.file_name().map(|name| name.to_string_lossy()) else {
        let text = format!("`--save-scenario {}`: a file is needed", path.display());
        return Err(Failure::new(MISTAKE, text));
    };
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let written = files::create_folder(folder).and_then(|()| files::write(folder, &name, &text));
    written.map_err(|text| Failure::new(FAILURE, text))
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
    let columns = History::new(arguments.model(), Column::time()).columns;
    // A mistake shows before the run, not behind it.
    let opened = arguments.compare.as_ref();
    let opened = opened.map(|path| Other::open(path, &arguments.out, &columns));
    let other = opened.transpose().map_err(|text| Failure::new(MISTAKE, text))?;
    let mut bar = Bar::new(arguments.quiet);
    let mut recorder = OnDisk::new(arguments);
    let outcome = run_recorded(arguments.model(), &arguments.settings, &mut recorder, |progress| {
        bar.show(progress);
        flow(interrupted())
    });
    bar.clear();
    let failure = outcome.as_ref().err().map(Failure::from);
    let mut result = match outcome {
        Ok(result) => result,
        Err(RunError::Incomplete(result)) => *result,
        Err(error) => return Err(Failure::from(&error)),
    };
    let compared = other.map(|other| other.beside(&arguments.out.join(HISTORY), &columns));
    let beside = compared.and_then(|compared| {
        compared
            .map_err(|text| result.warnings.push(format!("--compare: {text}")))
            .ok()
    });
    let mut summary = summary::of_run(arguments.model(), &result);
    card::put(&mut summary, arguments.model(), &result);
    if let Some(beside) = &beside {
        beside.put(&mut summary);
    }
    let part = report::run_part(arguments.model(), &result, beside.as_ref());
    let mut files = format!("  {}\n", arguments.out.join(HISTORY).display());
    let hint = match result.incomplete {
        Some(Incomplete::Interrupted | Incomplete::Files(_)) => {
            let path = arguments.out.join(checkpoint::NAME);
            format!("\n  {} (the same command with `--resume` goes on)", path.display())
        }
        _ => String::new(),
    };
    files += &match (written::write_told(arguments, "run", &summary, part), &failure) {
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
        Some(pictures) => {
            let title = arguments.model().name();
            let written = pictures.write(&arguments.out, title, [arguments.animate, arguments.vtu]);
            files += &written.map_err(|text| Failure::new(FAILURE, text))?;
        }
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
    tell(&mut head, result.agreement.as_deref());
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
    let mut summary = summary::of_equilibria(arguments.model(), &result);
    card::put_equilibria(&mut summary, arguments.model(), &result);
    let table = (name, result.history.to_csv());
    let files = written::write(
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
    let mut failure = failure;
    for line in critical_lines(&result.history.key, &result.critical, report::BUCKLING) {
        head += &format!("\n{line}");
        // What is passed before a way ends early is told, too.
        if let Some(failure) = &mut failure {
            failure.message += &format!("\n{line}");
        }
    }
    head += &result.envelopes.lines();
    tell(&mut head, result.agreement.as_deref());
    finish(head, &result.warnings, files, failure)
}

/// How many equilibria there are, and up to where.
fn way(history: &History, seconds: Seconds) -> String {
    let last = history.keys.last().copied().unwrap_or(0.0);
    format!(
        "{} steps up to {}, {} s",
        history.rows(),
        history.key.at(last, SHORT),
        digits(seconds.cpu, 3)
    )
}

fn execute_modes(arguments: &Arguments) -> Result<String, Failure> {
    let result = modes(arguments.model(), &arguments.equilibrium).map_err(|error| Failure::from(&error))?;
    let mut summary = summary::of_modes(arguments.model(), &result);
    card::put_bodies(&mut summary, &result.bodies);
    let part = modes_part(arguments.model().name(), &result, arguments.frequency);
    let mut files = written::write(
        arguments,
        "modes",
        ("modes.csv", modes_csv(&result)),
        &summary,
        Ok(part),
    )?;
    if arguments.export {
        files += &export::execute(arguments)?;
    }
    let mut head = format!(
        "{}: {} modes at t = {} s, spin {}, {} s\n{}",
        arguments.model().name(),
        result.modes.len(),
        short(result.t),
        arguments.frequency.shown(result.spin),
        digits(result.seconds.cpu, 3),
        mode_lines(&result, arguments.frequency).trim_end(),
    );
    tell(&mut head, result.agreement.as_deref());
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
    let mut summary = summary::of_campbell(arguments.model(), &result);
    card::put_bodies(&mut summary, &result.bodies);
    mass_table::put(&mut summary, &result.masses);
    let part = campbell_part(&result, arguments.frequency);
    let table = ("campbell.csv", result.to_csv());
    let files = written::write(arguments, "Campbell diagram", table, &summary, part)?;
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
    tell(&mut head, result.agreement.as_deref());
    finish(head, &result.warnings, files, failure)
}

/// Says how little the results are off.
fn tell(head: &mut String, agreement: Option<&str>) {
    head.extend(agreement.map(|line| format!("\n{line}")));
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

#[cfg(test)]
mod page_tests;
#[cfg(test)]
mod table_file_tests;
#[cfg(test)]
mod tests;
