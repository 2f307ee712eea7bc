//! Many runs of one model with other values of its parameters: grids, Latin hypercubes and random samples.
//!
//! A plan names its points once and for all ([`design`]); each is one task whose result is one file ([`point`]), written
//! whole or not at all, and skipped where it is there. `sweep` does all of them on the cores of this machine, `task` one of
//! them, so that any engine can hand them out; `collect` makes one table of the files ([`table`]) with pictures
//! ([`picture`]). `optimise` chooses its points by the results of earlier ones ([`optimise`]).

mod design;
mod goal;
mod optimise;
mod picture;
mod point;
mod random;
mod simplex;
mod table;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

pub(in crate::app) use self::optimise::optimise;
use self::point::Work;
use self::table::Table;
use crate::app::commands::parallel::on_all_cores;
use crate::app::commands::progress::Bar;
use crate::app::commands::written::write;
use crate::app::line::arguments::Arguments;
use crate::app::line::command::Command;
use crate::app::line::parameters::{Values, Varied};
use crate::app::line::plan::Design;
use crate::app::machine::clock::Clock;
use crate::app::machine::files;
use crate::app::page::summary::{self, checksums};
use crate::app::results::failure::{FAILURE, Failure, INTERRUPTION, MISTAKE};
use crate::app::writing::entries::{Summary, put};
use crate::app::writing::numbers::{digits, in_unit, short};
use crate::hash::hash;
use crate::{AnyModel, ParamKind};

/// The file that a plan is written to.
const PLAN: &str = "plan.toml";
const TABLE: &str = "sweep.csv";
/// Most sentences that are printed of failed points, and of notes.
const MOST_LINES: usize = 3;

/// The points of a plan.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Plan {
    /// Hash of what is computed and with what: results of other plans have another one.
    pub name: String,
    pub design: Design,
    pub varied: Vec<Varied>,
    /// Values of the varied parameters, SI.
    pub points: Vec<Vec<f64>>,
}

impl Plan {
    /// The points, and the text of the plan's file.
    fn new(arguments: &Arguments) -> Result<(Self, String), String> {
        let mut plan = Self::laid_out(arguments, arguments.plan.design, "")?;
        let count = plan.points.len();
        let text = arguments
            .scenario
            .to_text(arguments.model(), Command::Sweep, Some(count));
        plan.name = name_of(arguments, &text);
        Ok((plan, text))
    }

    /// The points of a design, under the name of a text that says what is computed and with what.
    fn laid_out(arguments: &Arguments, design: Design, text: &str) -> Result<Self, String> {
        let settings = &arguments.plan;
        Ok(Self {
            name: name_of(arguments, text),
            design,
            varied: settings.varied.clone(),
            points: design::points(arguments.model(), &settings.varied, design, settings.seed)?,
        })
    }

    /// Where its points are, in the folder of the results.
    fn folder(&self, out: &Path) -> PathBuf {
        out.join(format!("points-{}", self.name))
    }
}

fn name_of(arguments: &Arguments, text: &str) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let (of, model) = (arguments.plan.of.name(), arguments.model());
    let mut whole = format!(
        "{version} {of}\n{text}\n{:016x} {}",
        model.equations_hash(),
        model.source()
    );
    // Under the same path another table may stand.
    for (name, number) in checksums(arguments.model()) {
        whole += &format!("\n{name} {number}");
    }
    for Varied { param, values } in &arguments.plan.varied {
        if let (ParamKind::Table(_), Values::List(numbers)) = (arguments.model().params()[*param].kind, values) {
            whole += &format!("\n{numbers:?}");
        }
    }
    format!("{:016x}", hash(&whole))
}

fn failure(text: String) -> Failure {
    Failure::new(FAILURE, text)
}

fn mistake(text: String) -> Failure {
    Failure::new(MISTAKE, text)
}

/// The work of each point.
fn work_of(arguments: &Arguments) -> Work<'_> {
    Work {
        of: arguments.plan.of,
        run: &arguments.settings,
        equilibrium: &arguments.equilibrium,
        limit: arguments.plan.limit,
    }
}

/// Writes the plan and does nothing of it.
///
/// # Errors
/// With its exit code: a plan that makes no sense, a file that cannot be written.
pub(in crate::app) fn lay_out(arguments: &Arguments) -> Result<String, Failure> {
    let (plan, text) = Plan::new(arguments).map_err(mistake)?;
    files::write(&arguments.out, PLAN, &text).map_err(failure)?;
    let path = arguments.out.join(PLAN);
    Ok(format!(
        "{}: a plan of {} points\n  {}",
        arguments.model().name(),
        plan.points.len(),
        path.display()
    ))
}

/// Does all points that are not there yet on the cores of this machine, and collects them.
///
/// # Errors
/// With its exit code: a plan that makes no sense; a file that cannot be written; Ctrl-C, where all points that were done
/// stay and the same command goes on; no point at all without a failure.
pub(in crate::app) fn sweep(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let (plan, text) = Plan::new(arguments).map_err(mistake)?;
    files::write(&arguments.out, PLAN, &text).map_err(failure)?;
    let folder = plan.folder(&arguments.out);
    files::create_folder(&folder).map_err(failure)?;
    files::remove_partial(&folder);
    if arguments.plan.is_fresh {
        let names: Vec<String> = (0..plan.points.len()).map(point::name).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        files::remove(&folder, &names).map_err(failure)?;
    }
    let clock = Clock::start();
    let open: Vec<usize> = (0..plan.points.len())
        .filter(|&index| point::read(&folder, &plan, index).is_none())
        .collect();
    let mut bar = Bar::new(arguments.quiet);
    let outcome = do_points(arguments, &plan, &folder, open, &interrupted, |done, count| {
        bar.show_share(done as f64 / count as f64, &format!("{done} of {count} points"));
    });
    bar.clear();
    outcome?;
    finish(arguments, &plan, clock)
}

/// Does points on the cores of this machine; `told` gets how many of how many are done.
///
/// # Errors
/// With its exit code: a file that cannot be written; Ctrl-C, where all points that were done stay.
fn do_points(
    arguments: &Arguments,
    plan: &Plan,
    folder: &Path,
    open: Vec<usize>,
    interrupted: &impl Fn() -> bool,
    mut told: impl FnMut(usize, usize),
) -> Result<(), Failure> {
    let (count, mut done, mut is_interrupted) = (open.len(), 0, false);
    let (model, work) = (arguments.model().boxed(), work_of(arguments));
    let model = model.as_ref();
    let outcome = on_all_cores(
        open,
        interrupted,
        |&index, stop| point::work(model, plan, index, folder, &work, stop),
        |_, written: Result<bool, String>| {
            is_interrupted |= !written?;
            done += 1;
            told(done, count);
            Ok(None)
        },
    );
    outcome.map_err(failure)?;
    if is_interrupted || interrupted() {
        let text = "interrupted by the user; the same command again goes on from here";
        return Err(Failure::new(INTERRUPTION, text));
    }
    Ok(())
}

/// Does one point, where it is not there yet.
///
/// # Errors
/// With its exit code: no such point; a file that cannot be written; Ctrl-C.
pub(in crate::app) fn task(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let (plan, _) = Plan::new(arguments).map_err(mistake)?;
    let count = plan.points.len();
    let index = match arguments.plan.index {
        Some(index) if index < count => index,
        Some(index) => {
            let text = format!(
                "`--index {index}`: the plan has {count} points, from 0 to {}",
                count - 1
            );
            return Err(mistake(text));
        }
        None => {
            return Err(mistake(format!(
                "`--index` is missing: which of the {count} points, from 0 on"
            )));
        }
    };
    let folder = plan.folder(&arguments.out);
    files::create_folder(&folder).map_err(failure)?;
    let path = folder.join(point::name(index));
    if point::read(&folder, &plan, index).is_some() {
        return Ok(format!("point {index} is there already\n  {}", path.display()));
    }
    let model = arguments.model().boxed();
    let (model, work) = (model.as_ref(), work_of(arguments));
    let mut is_done = Ok(true);
    let outcome = on_all_cores(
        vec![index],
        interrupted,
        |&index, stop| point::work(model, &plan, index, &folder, &work, stop),
        |_, written| {
            is_done = written;
            Ok(None)
        },
    );
    outcome.and(is_done.map(drop)).map_err(failure)?;
    let Some(record) = point::read(&folder, &plan, index) else {
        return Err(Failure::new(
            INTERRUPTION,
            format!("point {index} was interrupted; nothing is written of it"),
        ));
    };
    let failed = record.get("reason").and_then(Value::as_str);
    let failed = failed.map_or(String::new(), |reason| format!(", which failed: {reason}"));
    Ok(format!("point {index} of {count}{failed}\n  {}", path.display()))
}

/// Collects the points that are there.
///
/// # Errors
/// With its exit code: a plan that makes no sense; a file that cannot be written; points that are missing, where the others
/// are in the table.
pub(in crate::app) fn collect(arguments: &Arguments) -> Result<String, Failure> {
    let (plan, _) = Plan::new(arguments).map_err(mistake)?;
    finish(arguments, &plan, Clock::start())
}

/// Writes the table, the summary and the page; tells what failed and what is missing.
fn finish(arguments: &Arguments, plan: &Plan, clock: Clock) -> Result<String, Failure> {
    let (model, settings) = (arguments.model(), &arguments.plan);
    let folder = plan.folder(&arguments.out);
    let table = Table::gather(model, plan, settings.outputs.as_deref(), |index| {
        point::read(&folder, plan, index)
    });
    let (count, failed) = (plan.points.len(), table.failed().count());
    let sound = table.rows.len() - failed;
    let problem = problem(plan, &table);

    let mut summary = summary::head(model, "sweep");
    summary::outcome(&mut summary, problem.clone());
    put(&mut summary, "plan", json!(plan.name));
    put(&mut summary, "of", json!(settings.of.name()));
    put(&mut summary, "design", json!(design_words(plan.design, settings.seed)));
    put_varied(&mut summary, model, &plan.varied);
    put(&mut summary, "points", json!(count));
    put(&mut summary, "points_failed", json!(failed));
    put(&mut summary, "points_missing", json!(table.missing));
    if settings.of == Command::Run {
        summary::settings(&mut summary, &arguments.settings);
    }
    summary::seconds(&mut summary, clock.seconds());
    if plan.design != Design::Grid {
        put(&mut summary, "statistics", table.statistics());
    }
    let warnings = warnings(model, plan, &table, TABLE);
    put(&mut summary, "notes", summary::notes(model, &warnings));

    let csv = (TABLE, table.to_csv(model, plan));
    let files = write(arguments, "sweep", csv, &summary, picture::part(model, plan, &table))?;
    let mut head = format!(
        "{}: {sound} of {count} points of `{}`",
        model.name(),
        settings.of.name()
    );
    head += &format!(", {} s", digits(clock.seconds().wall, 3));
    for warning in &warnings {
        head += &format!("\nwarning: {warning}");
    }
    match problem {
        None => Ok(format!("{head}\n{files}")),
        Some(problem) => Err(failure(format!("{problem}\n{head}\n{files}"))),
    }
}

/// Why the table is no answer to what was asked, if it is none.
fn problem(plan: &Plan, table: &Table) -> Option<String> {
    if let [first, ..] = table.missing[..] {
        let (count, all) = (table.missing.len(), plan.points.len());
        return Some(format!(
            "{count} of {all} points are missing, the first is point {first}: do them with `task`"
        ));
    }
    let mut failed = table.failed();
    let first = failed.next()?;
    let reason = first.failed.as_deref().unwrap_or_default();
    (1 + failed.count() == table.rows.len()).then(|| format!("all points failed, the first one: {reason}"))
}

/// Sentences on points that failed and on notes of points, the commonest with where it is found.
fn warnings(model: &dyn AnyModel, plan: &Plan, table: &Table, file: &str) -> Vec<String> {
    let mut warnings = Vec::new();
    let place = |row: &table::Row| {
        let values = plan.varied.iter().zip(&row.params);
        let values = values.map(|(one, value)| {
            let param = &model.params()[one.param];
            format!("{} = {}", param.name, in_unit(param, *value))
        });
        values.collect::<Vec<_>>().join(", ")
    };
    let failed: Vec<_> = table.failed().collect();
    for row in failed.iter().take(MOST_LINES) {
        let reason = row.failed.as_deref().unwrap_or_default();
        warnings.push(format!("point {} ({}) failed: {reason}", row.point, place(row)));
    }
    if failed.len() > MOST_LINES {
        warnings.push(format!(
            "{} points more failed: {file} names them",
            failed.len() - MOST_LINES
        ));
    }
    let noted: Vec<_> = table.rows.iter().filter(|row| !row.notes.is_empty()).collect();
    if let Some(first) = noted.first() {
        let note = &first.notes[0];
        warnings.push(format!(
            "{} points have notes, which stand in {file}; the first is point {} ({}): {note}",
            noted.len(),
            first.point,
            place(first)
        ));
    }
    warnings
}

fn design_words(design: Design, seed: u64) -> String {
    match design {
        Design::Grid => "grid".into(),
        Design::Latin(count) => format!("Latin hypercube of {count} points, seed {seed}"),
        Design::Random(count) => format!("{count} random points, seed {seed}"),
    }
}

/// Adds what is varied, in place of single values of these parameters.
fn put_varied(summary: &mut Summary, model: &dyn AnyModel, varied: &[Varied]) {
    let words = varied_words(model, varied);
    if let Some(Value::Object(values)) = summary.get_mut("parameters") {
        varied.iter().for_each(|one| {
            values.shift_remove(model.params()[one.param].name);
        });
    }
    if let Some(Value::Object(values)) = summary.get_mut("parameters_in_units") {
        for (one, words) in varied.iter().zip(&words) {
            let range = words.split_once(" = ").map_or(words.as_str(), |(_, range)| range);
            values.insert(model.params()[one.param].name.into(), json!(range));
        }
    }
    put(summary, "varied", json!(words.join("; ")));
}

/// The varied parameters as they are typed, in their units.
fn varied_words(model: &dyn AnyModel, varied: &[Varied]) -> Vec<String> {
    let words = |one: &Varied| {
        let param = &model.params()[one.param];
        let unit = if matches!(param.unit, "1" | "") {
            String::new()
        } else {
            format!(" {}", param.unit)
        };
        let bare = |value: f64| short(value / param.unit_si);
        let values = match &one.values {
            Values::List(values) if matches!(param.kind, ParamKind::Table(_)) => {
                let paths: Vec<String> = values.iter().map(|value| in_unit(param, *value)).collect();
                paths.join(", ")
            }
            Values::List(values) => values.iter().map(|value| bare(*value)).collect::<Vec<_>>().join(", ") + &unit,
            Values::Range(from, to, None) => format!("{}..{}{unit}", bare(*from), bare(*to)),
            Values::Range(from, to, Some(parts)) => format!("{}..{}{unit} in {parts}", bare(*from), bare(*to)),
            Values::Normal(mean, deviation) => format!("normal({}, {}){unit}", bare(*mean), bare(*deviation)),
        };
        format!("{} = {values}", param.name)
    };
    varied.iter().map(words).collect()
}
