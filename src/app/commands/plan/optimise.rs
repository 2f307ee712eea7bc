//! Values of parameters at which a result is least, largest, or as it is wanted.
//!
//! The first points are those of a Latin hypercube; from the best of them a simplex goes down ([`super::simplex`]). Every
//! point is a file like that of a sweep, so that a search that was ended goes on where it was, and comes to the same end.

use std::path::Path;

use serde_json::{Value, json};

use super::simplex::descend;
use super::table::{Row, Table};
use super::{Design, MOST_LINES, PLAN, Plan, do_points, failure, mistake, picture, point, put_varied, warnings};
use crate::AnyModel;
use crate::app::commands::progress::Bar;
use crate::app::commands::written::write;
use crate::app::line::arguments::Arguments;
use crate::app::line::command::Command;
use crate::app::line::goal::{Aim, Goal};
use crate::app::line::parameters::{Values, Varied};
use crate::app::line::words::quoted;
use crate::app::machine::clock::Clock;
use crate::app::machine::files;
use crate::app::page::charts::{Chart, Line, figure};
use crate::app::page::summary;
use crate::app::results::failure::Failure;
use crate::app::writing::csv::cell;
use crate::app::writing::entries::put;
use crate::app::writing::html::escape;
use crate::app::writing::numbers::{digits, in_unit};

const TABLE: &str = "optimise.csv";
/// A scenario with the values that were found.
const BEST: &str = "best.toml";
/// How near to each other the points lie where the search ends, in parts of the ranges.
const PRECISION: f64 = 1e-5;

/// Why a search ends before its time.
enum End {
    Failed(Failure),
    /// So many points as are allowed.
    Most,
}

/// Searches; writes the table of all points, the page, and a scenario of the best point.
///
/// # Errors
/// With its exit code: a search that makes no sense; a file that cannot be written; Ctrl-C, where the same command goes on;
/// no point without a failure; more points than are allowed.
pub(in crate::app) fn optimise(arguments: &Arguments, interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    let settings = &arguments.plan;
    let goal = settings.goal.as_ref().ok_or_else(|| {
        mistake("say what is looked for: `--minimise`, `--maximise` or `--fit`, e.g. `--minimise \"tip.x max\"`".into())
    })?;
    let clock = Clock::start();
    let bounds = bounds(arguments).map_err(mistake)?;
    let (mut plan, text) = start(arguments, bounds.len()).map_err(mistake)?;
    files::write(&arguments.out, PLAN, &text).map_err(failure)?;
    let folder = plan.folder(&arguments.out);
    files::create_folder(&folder).map_err(failure)?;
    files::remove_partial(&folder);
    let most = settings.most.unwrap_or(plan.points.len() + 200 * bounds.len());
    if settings.is_fresh {
        let names: Vec<String> = (0..most).map(point::name).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        files::remove(&folder, &names).map_err(failure)?;
    }

    let mut bar = Bar::new(arguments.quiet);
    let first: Vec<usize> = (0..plan.points.len()).collect();
    do_points(
        arguments,
        &plan,
        &folder,
        open(arguments, &plan, &folder, &first),
        &interrupted,
        |done, count| {
            bar.show_share(
                done as f64 / count as f64,
                &format!("{done} of the first {count} points"),
            );
        },
    )?;
    let table = Table::gather(arguments.model(), &plan, None, |index| {
        point::read(&folder, &plan, index)
    });
    let of_cube = |values: &[f64]| -> Vec<f64> {
        let parts = values.iter().zip(&bounds);
        parts.map(|(value, [low, high])| (value - low) / (high - low)).collect()
    };
    let heights = table
        .rows
        .iter()
        .filter_map(|row| Some((row, goal.height(&table, row)?)));
    let start = heights.min_by(|a, b| a.1.total_cmp(&b.1));
    let start = start.map(|(row, height)| (of_cube(&row.params), height));
    let Some(start) = start else {
        bar.clear();
        return finish(arguments, &plan, goal, &bounds, false, clock);
    };
    let outcome = descend(start, PRECISION, |cube| {
        if plan.points.len() >= most {
            return Err(End::Most);
        }
        let values = cube
            .iter()
            .zip(&bounds)
            .map(|(part, [low, high])| low + part * (high - low));
        let index = plan.points.len();
        plan.points.push(values.collect());
        do_points(
            arguments,
            &plan,
            &folder,
            open(arguments, &plan, &folder, &[index]),
            &interrupted,
            |_, _| {},
        )
        .map_err(End::Failed)?;
        bar.show_share(index as f64 / most as f64, &format!("{index} points"));
        // A table of one row: the results have the same names there.
        let one = Table::gather(arguments.model(), &plan, None, |at| {
            (at == index).then(|| point::read(&folder, &plan, at)).flatten()
        });
        let height = one.rows.first().and_then(|row| goal.height(&one, row));
        Ok(height.unwrap_or(f64::INFINITY))
    });
    bar.clear();
    let is_settled = match outcome {
        Ok(_) => true,
        Err(End::Most) => false,
        Err(End::Failed(failure)) => return Err(failure),
    };
    finish(arguments, &plan, goal, &bounds, is_settled, clock)
}

/// The ranges of the parameters, SI, ascending.
fn bounds(arguments: &Arguments) -> Result<Vec<[f64; 2]>, String> {
    let varied = &arguments.plan.varied;
    if varied.is_empty() {
        return Err("no parameter has a range to search: write `name=from..to`".into());
    }
    let one = |one: &Varied| match one.values {
        Values::Range(from, to, None) => Ok([from.min(to), from.max(to)]),
        _ => Err(format!(
            "`{}`: `optimise` searches whole ranges, `name=from..to`; lists, steps and distributions are for `sweep`",
            arguments.model().params()[one.param].name
        )),
    };
    varied.iter().map(one).collect()
}

/// The plan with its first points, and the text of its file. Results keep their place where only more points are allowed.
fn start(arguments: &Arguments, dimension: usize) -> Result<(Plan, String), String> {
    let design = match arguments.plan.design {
        Design::Grid => Design::Latin(8 * dimension),
        design => design,
    };
    let mut scenario = arguments.scenario.clone();
    let text = scenario.to_text(arguments.model(), Command::Optimise, None);
    scenario.flags.retain(|(flag, _)| flag != "most" && flag != "fresh");
    let named = scenario.to_text(arguments.model(), Command::Optimise, None);
    Ok((Plan::laid_out(arguments, design, &named)?, text))
}

/// Those points whose results are not there yet, for these values.
fn open(arguments: &Arguments, plan: &Plan, folder: &Path, indices: &[usize]) -> Vec<usize> {
    let params = arguments.model().params();
    let is_there = |&&index: &&usize| {
        let Some(record) = point::read(folder, plan, index) else {
            return true;
        };
        let same = |(one, value): (&Varied, &f64)| {
            let kept = record["parameters"][params[one.param].name].as_f64();
            kept.is_some_and(|kept| (kept - value).abs() <= 1e-12 * value.abs())
        };
        !plan.varied.iter().zip(&plan.points[index]).all(same)
    };
    indices.iter().filter(is_there).copied().collect()
}

/// Writes all files and says what was found.
fn finish(
    arguments: &Arguments,
    plan: &Plan,
    goal: &Goal,
    bounds: &[[f64; 2]],
    is_settled: bool,
    clock: Clock,
) -> Result<String, Failure> {
    let (model, settings) = (arguments.model(), &arguments.plan);
    let folder = plan.folder(&arguments.out);
    let table = Table::gather(model, plan, None, |index| point::read(&folder, plan, index));
    let heights: Vec<Option<f64>> = table.rows.iter().map(|row| goal.height(&table, row)).collect();
    let rows = table.rows.iter().zip(&heights);
    let best = rows.filter_map(|(row, height)| Some((row, (*height)?)));
    let best = best.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(row, _)| row);
    let count = plan.points.len();
    let problem = problem(goal, &table, best, is_settled, count);

    let mut summary = summary::head(model, "optimise");
    summary::outcome(&mut summary, problem.clone());
    put(&mut summary, "plan", json!(plan.name));
    put(&mut summary, "of", json!(settings.of.name()));
    put(&mut summary, "sought", json!(goal.words()));
    put_varied(&mut summary, model, &plan.varied);
    put(&mut summary, "points", json!(count));
    put(&mut summary, "points_failed", json!(table.failed().count()));
    if settings.of == Command::Run {
        summary::settings(&mut summary, &arguments.settings);
    }
    summary::seconds(&mut summary, clock.seconds());
    let mut warnings = warnings(model, plan, &table, TABLE);
    let mut files = String::new();
    if let Some(best) = best {
        put(&mut summary, "best_point", json!(best.point));
        put(&mut summary, "best_values", best_values(model, plan, best));
        put(&mut summary, "best_results", json!(goal.found(&table, best)));
        warnings.extend(goal.missed(&table, best));
        warnings.extend(at_bounds(model, plan, bounds, best));
        let text = best_scenario(arguments, plan, best);
        files::write(&arguments.out, BEST, &text).map_err(failure)?;
        files = format!(
            "\n  {} (the best point, for `--scenario`)",
            arguments.out.join(BEST).display()
        );
    }
    put(&mut summary, "notes", summary::notes(model, &warnings));

    let found = best.map(|best| {
        let values = plan.varied.iter().zip(&best.params);
        let values = values.map(|(one, value)| {
            let param = &model.params()[one.param];
            format!("{}={}", param.name, quoted(&rounded(param, *value)))
        });
        let values: Vec<_> = values.collect();
        format!("{} at {}", goal.found(&table, best), values.join(" "))
    });
    let mut page = descent(goal, &heights);
    if let Ok(page) = &mut page {
        if let Some(found) = &found {
            page.insert_str(
                0,
                &format!("<p><b>{}: {}</b></p>\n", escape(&goal.words()), escape(found)),
            );
        }
        *page += &picture::clouds_of(model, plan, &table).map_err(failure)?;
    }
    let csv = (TABLE, with_heights(&table.to_csv(model, plan), &heights));
    let files = write(arguments, "optimise", csv, &summary, page)? + &files;
    let mut head = format!("{}: {}", model.name(), goal.words());
    if let Some(found) = found {
        head += &format!(": {found}");
    }
    head += &format!("; {count} points, {} s", digits(clock.seconds().wall, 3));
    for warning in warnings.iter().take(2 * MOST_LINES) {
        head += &format!("\nwarning: {warning}");
    }
    match problem {
        None => Ok(format!("{head}\n{files}")),
        Some(problem) => Err(failure(format!("{problem}\n{head}\n{files}"))),
    }
}

/// Why what was found is no answer, if it is none.
fn problem(goal: &Goal, table: &Table, best: Option<&Row>, is_settled: bool, count: usize) -> Option<String> {
    if best.is_none() {
        let failed = table.failed().next().and_then(|row| row.failed.clone());
        return Some(match (failed, goal.lacking(table)) {
            (Some(reason), _) => format!("no point has a result; the first one failed: {reason}"),
            (None, Some(name)) => format!("no point has the result `{name}`"),
            (None, None) => "no point has all results that are looked for".into(),
        });
    }
    let text =
        format!("the search has not ended after {count} points: allow more with `--most`, and it goes on from here");
    (!is_settled).then_some(text)
}

/// A parameter to the precision of the search.
fn rounded(param: &crate::Param, value: f64) -> String {
    let number = digits(value / param.unit_si, 7);
    match param.unit {
        "" | "1" => number,
        unit => format!("{number} {unit}"),
    }
}

fn best_values(model: &dyn AnyModel, plan: &Plan, best: &Row) -> Value {
    let values = plan.varied.iter().zip(&best.params);
    let named = values.map(|(one, value)| (model.params()[one.param].name.to_owned(), json!(value)));
    Value::Object(named.collect())
}

/// Values that the ranges hold back.
fn at_bounds(model: &dyn AnyModel, plan: &Plan, bounds: &[[f64; 2]], best: &Row) -> Vec<String> {
    let values = plan.varied.iter().zip(&best.params).zip(bounds);
    let held = values.filter_map(|((one, value), bounds)| {
        let near = |bound: &&f64| (value - **bound).abs() <= 10.0 * PRECISION * (bounds[1] - bounds[0]);
        let bound = bounds.iter().find(near)?;
        let param = &model.params()[one.param];
        Some(format!(
            "`{}` lies at the end of its range, {}: beyond it may be better",
            param.name,
            in_unit(param, *bound)
        ))
    });
    held.collect()
}

/// What `--scenario` runs again.
fn best_scenario(arguments: &Arguments, plan: &Plan, best: &Row) -> String {
    let model = arguments.model();
    let mut scenario = arguments.scenario.clone();
    for (one, value) in plan.varied.iter().zip(&best.params) {
        let param = &model.params()[one.param];
        scenario.params.retain(|(name, _)| name != param.name);
        let number = digits(value / param.unit_si, 17);
        let unit = if matches!(param.unit, "" | "1") { "" } else { param.unit };
        scenario
            .params
            .push((param.name.into(), format!("{number} {unit}").trim_end().into()));
    }
    let own = [
        "minimise", "maximise", "fit", "most", "samples", "design", "seed", "fresh", "limit", "outputs", "of",
    ];
    scenario.flags.retain(|(flag, _)| !own.contains(&flag.as_str()));
    scenario.to_text(model, arguments.plan.of, None)
}

/// The table with what the search makes small.
fn with_heights(csv: &str, heights: &[Option<f64>]) -> String {
    let mut lines = csv.lines();
    let mut text = format!("{},made small\n", lines.next().unwrap_or_default());
    for (line, height) in lines.zip(heights) {
        text += &format!("{line},{}\n", cell(*height));
    }
    text
}

/// The best value so far over the points.
fn descent(goal: &Goal, heights: &[Option<f64>]) -> Result<String, String> {
    let sign = if matches!(goal.0, Aim::Most(_)) { -1.0 } else { 1.0 };
    let mut best = f64::INFINITY;
    let mut line = Vec::new();
    for (index, height) in heights.iter().enumerate() {
        best = best.min(height.unwrap_or(f64::INFINITY));
        if best.is_finite() {
            line.push((index as f64, sign * best));
        }
    }
    let is_fit = matches!(goal.0, Aim::Fit(_));
    let y = if is_fit {
        "sum of squared relative differences [1]".into()
    } else {
        format!("best so far: {}", goal.axis())
    };
    let positive = line.iter().all(|point| point.1 > 0.0);
    let chart = Chart {
        x: "point [1]".into(),
        y,
        logarithmic: is_fit && positive,
        lines: vec![Line::new(line, 0)],
        ..Chart::default()
    };
    let mut page = String::new();
    if chart.lines[0].points.len() > 1 {
        figure(
            &mut page,
            &format!("{}<span>the best so far</span>", escape(&goal.words())),
            &chart,
            "",
        )?;
    }
    Ok(page)
}
