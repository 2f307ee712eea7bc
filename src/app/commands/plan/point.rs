//! One point of a plan: what is computed there, and the file that holds it.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use serde_json::{Map, Value, json};

use super::Plan;
use crate::AnyModel;
use crate::app::commands::parallel::Watch;
use crate::app::equilibria::steady::equilibria;
use crate::app::line::command::Command;
use crate::app::machine::files;
use crate::app::modal::modes::modes;
use crate::app::page::summary;
use crate::app::results::equilibria::EquilibriumSettings;
use crate::app::results::error::RunError;
use crate::app::results::history::History;
use crate::app::results::run::RunSettings;
use crate::app::runs::recorder::Recorder;
use crate::app::runs::run::run_recorded;
use crate::app::writing::entries::{Summary, to_text};
use crate::equilibrium::Kind;

/// What a point computes, apart from the values of its parameters.
#[derive(Clone, Debug)]
pub(super) struct Work<'w> {
    pub of: Command,
    pub run: &'w RunSettings,
    pub equilibrium: &'w EquilibriumSettings,
    /// Processor seconds after which it is ended.
    pub limit: f64,
}

/// Keeps the last row.
#[derive(Default)]
struct LastRow(Vec<f64>);

impl Recorder for LastRow {
    fn takes_rows(&self) -> bool {
        true
    }

    fn row(&mut self, _t: f64, values: &[f64]) {
        self.0.clear();
        self.0.extend_from_slice(values);
    }
}

/// Name of a point's file.
pub(super) fn name(index: usize) -> String {
    format!("point-{index:06}.json")
}

/// The point's file, whole; `None` where it is not there or another plan's.
pub(super) fn read(folder: &Path, plan: &Plan, index: usize) -> Option<Summary> {
    let text = std::fs::read_to_string(folder.join(name(index))).ok()?;
    let Value::Object(record) = serde_json::from_str(&text).ok()? else {
        return None;
    };
    let is_ours = record.get("plan") == Some(&json!(plan.name)) && record.get("point") == Some(&json!(index));
    is_ours.then_some(record)
}

/// Computes a point and writes its file; a point that fails says so in it. `false`: it was interrupted.
///
/// # Errors
/// The file cannot be written.
pub(super) fn work(
    model: &dyn AnyModel,
    plan: &Plan,
    index: usize,
    folder: &Path,
    work: &Work<'_>,
    stop: &AtomicBool,
) -> Result<bool, String> {
    let mut model = model.boxed();
    for (one, value) in plan.varied.iter().zip(&plan.points[index]) {
        model.set(one.param, *value);
    }
    let mut watch = Watch::new(work.limit, stop);
    let found = solve(model.as_ref(), work, &mut watch);
    if watch.is_interrupted() {
        return Ok(false);
    }
    let (mut record, last) = found.unwrap_or_else(|reason| {
        let mut record = summary::head(model.as_ref(), work.of.name());
        summary::outcome(&mut record, Some(reason));
        (record, Map::new())
    });
    if watch.is_too_long() {
        let reason = format!("ended after {} s of processor time (`--limit`)", work.limit);
        summary::outcome(&mut record, Some(reason));
    }
    // The same for all points, and kept beside the plan.
    record.shift_remove("model_text");
    record.shift_insert(0, "point".into(), json!(index));
    record.shift_insert(0, "plan".into(), json!(plan.name));
    record.insert("last".into(), Value::Object(last));
    files::write(folder, &name(index), &to_text(&record))?;
    Ok(true)
}

type Found = (Summary, Map<String, Value>);

/// The summary, and the last value of every column.
fn solve(model: &dyn AnyModel, work: &Work<'_>, watch: &mut Watch<'_>) -> Result<Found, String> {
    match work.of {
        Command::Static | Command::Steady => {
            let kind = if work.of == Command::Static {
                Kind::Static
            } else {
                Kind::Steady
            };
            let result = match equilibria(model, kind, work.equilibrium, |_| watch.look()) {
                Ok(result) => result,
                Err(RunError::Equilibria(result)) => *result,
                Err(error) => return Err(error.to_string()),
            };
            let width = result.history.columns.len();
            let rows = result.history.values.len();
            let last = named(&result.history, &result.history.values[rows.saturating_sub(width)..]);
            Ok((summary::of_equilibria(model, &result), last))
        }
        Command::Modes => {
            let result = modes(model, work.equilibrium).map_err(|error| error.to_string())?;
            Ok((summary::of_modes(model, &result), Map::new()))
        }
        _ => {
            let mut recorder = LastRow::default();
            let result = match run_recorded(model, work.run, &mut recorder, |_| watch.look()) {
                Ok(result) => result,
                Err(RunError::Incomplete(result)) => *result,
                Err(error) => return Err(error.to_string()),
            };
            let last = named(&result.history, &recorder.0);
            Ok((summary::of_run(model, &result), last))
        }
    }
}

fn named(history: &History, row: &[f64]) -> Map<String, Value> {
    let values = history.columns.iter().zip(row);
    values
        .map(|(column, value)| (column.name.clone(), json!(value)))
        .collect()
}
