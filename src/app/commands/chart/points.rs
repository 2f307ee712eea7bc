//! The points of a chart: first errors and counts on all cores, then the times, one run at a time.

use std::collections::HashMap;
use std::ops::ControlFlow;

use super::errors::errors;
use super::grid::{Grid, Setting};
use super::reference::References;
use super::table::{Counts, Outcome, Point, Table};
use crate::AnyModel;
use crate::app::commands::parallel::{Ended, on_all_cores, solve};
use crate::app::results::error::RunError;
use crate::app::results::incomplete::Incomplete;
use crate::app::results::run::RunSettings;
use crate::app::runs::run::run_watched;
use crate::hash::hash;

/// A run is repeated until it has taken this processor time in all, s,
const ENOUGH: f64 = 0.3;
/// or so often.
const MOST_REPETITIONS: u64 = 20;

/// What is known of a grid, in its order.
pub(super) struct Points {
    /// `None`: not yet, or left out because a looser tolerance of the series took too long.
    pub found: Vec<Option<Point>>,
    pub is_interrupted: bool,
}

/// How far the work is: what is done, how much of it and of how much.
pub(super) type Told<'t> = &'t mut dyn FnMut(&str, usize, usize);

/// Key of every setting: stands for the problem, the settings and the references.
pub(super) fn keys(grid: &Grid, model: &dyn AnyModel, references: &References) -> Vec<(Setting, u64)> {
    let key = |setting: &Setting| {
        let identity = grid.identity(model, setting);
        hash(&format!("{identity:016x}{:016x}", references.key))
    };
    grid.settings()
        .into_iter()
        .map(|setting| (setting, key(&setting)))
        .collect()
}

/// Finds errors and counts, then times, of what the table does not have yet; every point goes to the table at once.
///
/// # Errors
/// The table cannot be read or written.
pub(super) fn find(
    (grid, model): (&Grid, &dyn AnyModel),
    references: &References,
    table: &Table,
    limit: f64,
    interrupted: impl Fn() -> bool,
    told: Told<'_>,
) -> Result<Points, String> {
    let keys = keys(grid, model, references);
    let mut known = table.read(&keys)?;
    // What was too long for a shorter limit is tried again.
    known.retain(|_, point| !matches!(point.outcome, Outcome::TooLong(before) if before < limit));
    table.write(grid, keys.iter().filter_map(|(_, key)| known.get(key)))?;
    measure_errors(
        (grid, model),
        references,
        &keys,
        (table, limit),
        &mut known,
        &interrupted,
        told,
    )?;
    let mut points = Points {
        found: keys.iter().map(|(_, key)| known.remove(key)).collect(),
        is_interrupted: interrupted(),
    };
    if !points.is_interrupted {
        points.is_interrupted = measure_times((grid, model), &mut points.found, table, &interrupted, told)?;
    }
    table.write(grid, points.found.iter().flatten())?;
    Ok(points)
}

fn measure_errors(
    (grid, model): (&Grid, &dyn AnyModel),
    references: &References,
    keys: &[(Setting, u64)],
    (table, limit): (&Table, f64),
    known: &mut HashMap<u64, Point>,
    interrupted: impl Fn() -> bool,
    told: Told<'_>,
) -> Result<(), String> {
    // A task is the next setting of a series to look at; what is known is passed over.
    let is_last = |index: usize| (index + 1).is_multiple_of(grid.rtols.len());
    let next = |mut index: usize, known: &HashMap<u64, Point>| loop {
        match known.get(&keys[index].1).map(|point| &point.outcome) {
            None => return Some(index),
            Some(Outcome::TooLong(_)) => return None,
            Some(_) if is_last(index) => return None,
            Some(_) => index += 1,
        }
    };
    let tasks: Vec<usize> = (0..keys.len())
        .step_by(grid.rtols.len())
        .filter_map(|first| next(first, known))
        .collect();
    let (mut number, count) = (known.len(), keys.len());
    let work = |&index: &usize, stop: &_| {
        let setting = &keys[index].0;
        match solve(
            grid.model(model, setting.mesh).as_ref(),
            &grid.run(setting),
            limit,
            stop,
        ) {
            Ended::Complete(result) => Some(Point {
                unknowns: result.unknowns as u64,
                constraints: result.constraints as u64,
                counts: Counts::from(&result.statistics),
                errors: errors(&result.history, &references.exact),
                time_errors: errors(&result.history, &references.on_meshes[setting.mesh]),
                ..empty(keys[index], Outcome::Complete)
            }),
            Ended::Failed(text) => Some(empty(keys[index], Outcome::Failed(text))),
            Ended::TooLong => Some(empty(keys[index], Outcome::TooLong(limit))),
            Ended::Interrupted => None,
        }
    };
    on_all_cores(tasks, interrupted, work, |index, point| {
        let Some(point) = point else { return Ok(None) };
        number += 1;
        told("errors", number, count);
        table.append(grid, &point)?;
        known.insert(point.key, point);
        Ok(next(index, known))
    })
}

fn empty((setting, key): (Setting, u64), outcome: Outcome) -> Point {
    Point {
        setting,
        key,
        outcome,
        unknowns: 0,
        constraints: 0,
        counts: Counts::default(),
        cpu: None,
        repetitions: 0,
        errors: Vec::new(),
        time_errors: Vec::new(),
    }
}

/// Times, one run after the other, with nothing else going on in this process: the least of several repetitions, taken in
/// turns, so that a disturbance does not meet all repetitions of one point. Whether it was interrupted.
fn measure_times(
    (grid, model): (&Grid, &dyn AnyModel),
    found: &mut [Option<Point>],
    table: &Table,
    interrupted: impl Fn() -> bool,
    told: Told<'_>,
) -> Result<bool, String> {
    let is_open = |point: &&mut Point| point.outcome == Outcome::Complete && point.cpu.is_none();
    let mut open: Vec<(&mut Point, Spent)> = (found.iter_mut().flatten())
        .filter(is_open)
        .map(|point| (point, Spent::default()))
        .collect();
    let (mut number, count) = (0, open.len());
    while !open.is_empty() {
        let mut waiting = Vec::new();
        for (point, mut spent) in open {
            // Two rows: what is measured is the integration, not the observation of it, which is the same for all.
            let settings = RunSettings {
                every: grid.base.t_end,
                ..grid.run(&point.setting)
            };
            let watch = |_: &_| {
                if interrupted() {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            };
            match run_watched(grid.model(model, point.setting.mesh).as_ref(), &settings, watch) {
                Ok(result) => spent.add(result.seconds.cpu),
                Err(RunError::Incomplete(result)) if result.incomplete == Some(Incomplete::Interrupted) => {
                    return Ok(true);
                }
                // It was complete before, and runs repeat to the bit.
                Err(error) => return Err(format!("{}: {error}", grid.name(&point.setting))),
            }
            if spent.sum < ENOUGH && spent.repetitions < MOST_REPETITIONS {
                waiting.push((point, spent));
                continue;
            }
            (point.cpu, point.repetitions) = (Some(spent.least), spent.repetitions);
            number += 1;
            told("times", number, count);
            table.append(grid, point)?;
        }
        open = waiting;
    }
    Ok(false)
}

/// Times of the repetitions of a run, s.
struct Spent {
    sum: f64,
    least: f64,
    repetitions: u64,
}

impl Default for Spent {
    fn default() -> Self {
        Self {
            sum: 0.0,
            least: f64::INFINITY,
            repetitions: 0,
        }
    }
}

impl Spent {
    fn add(&mut self, seconds: f64) {
        self.sum += seconds;
        self.least = self.least.min(seconds);
        self.repetitions += 1;
    }
}
