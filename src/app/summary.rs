//! What a run was and what it took, as JSON; the report shows the same values.

use serde_json::{Map, Value, json};

use super::clock::Seconds;
use super::history::History;
use super::run::{RunResult, RunSettings, times};
use super::section_table;
use super::steady::SteadyResult;
use crate::{Joints, Method, Model, ParamKind, Start, StepSize};

/// Keys in the order in which they are written.
pub(super) type Summary = Map<String, Value>;

/// Keys of a run's method and settings, for the report.
pub(super) const SETTINGS: &[&str] = &[
    "formulation",
    "joints",
    "start",
    "integrator",
    "alpha",
    "rho_inf",
    "rtol",
    "step",
    "max_step",
    "t_end",
    "every",
    "spin",
];

/// Keys of counts and times, for the report.
pub(super) const STATISTICS: &[&str] = &[
    "unknowns",
    "constraints",
    "steps",
    "rejected_steps",
    "rejected_by_error",
    "rejected_by_newton",
    "restarts",
    "steps_at_ceiling",
    "share_at_ceiling",
    "smallest_step",
    "largest_step",
    "newton_iterations",
    "residual_evaluations",
    "jacobian_evaluations",
    "factorizations",
    "solves",
    "cpu_seconds",
    "cpu_clock",
    "wall_seconds",
    "energy_error",
    "max_constraint_residual",
    "position_correction",
    "velocity_correction",
];

/// Summary of a run in time.
pub(super) fn of_run<M: Model>(model: &M, result: &RunResult) -> Summary {
    let mut summary = head(model, "run");
    let reason = result.incomplete.as_ref().map(ToString::to_string);
    outcome(&mut summary, reason);
    settings(&mut summary, &result.settings);
    put(&mut summary, "t_reached", json!(result.state.t));
    put(&mut summary, "unknowns", json!(result.unknowns));
    put(&mut summary, "constraints", json!(result.constraints));
    counts(&mut summary, result);
    seconds(&mut summary, result.seconds);
    put(&mut summary, "energy_error", json!(result.energy_error));
    let violation = (result.constraints > 0).then_some(result.statistics.max_constraint_residual);
    put(&mut summary, "max_constraint_residual", json!(violation));
    put(
        &mut summary,
        "position_correction",
        json!(result.statistics.position_correction),
    );
    put(
        &mut summary,
        "velocity_correction",
        json!(result.statistics.velocity_correction),
    );
    section_table::put(&mut summary, &result.envelopes);
    tail::<M>(&mut summary, &result.history, &result.warnings);
    summary
}

/// Summary of relative equilibria.
pub(super) fn of_steady<M: Model>(model: &M, result: &SteadyResult) -> Summary {
    let mut summary = head(model, "steady");
    outcome(&mut summary, result.incomplete.as_ref().map(ToString::to_string));
    put(&mut summary, "formulation", json!("rncf"));
    put(&mut summary, "joints", json!(joints(Joints::Eliminated)));
    put(&mut summary, "t_end", json!(result.t));
    put(&mut summary, "spin", json!(result.spin));
    put(&mut summary, "unknowns", json!(result.unknowns));
    put(&mut summary, "constraints", json!(result.constraints));
    put(&mut summary, "steps", json!(result.history.keys.len()));
    put(&mut summary, "newton_iterations", json!(result.newton_iterations));
    seconds(&mut summary, result.seconds);
    section_table::put(&mut summary, &result.envelopes);
    tail::<M>(&mut summary, &result.history, &result.warnings);
    summary
}

fn put(summary: &mut Summary, key: &str, value: Value) {
    summary.insert(key.into(), value);
}

fn head<M: Model>(model: &M, command: &str) -> Summary {
    let mut summary = Summary::new();
    put(&mut summary, "model", json!(M::NAME));
    put(&mut summary, "command", json!(command));
    put(&mut summary, "rncf_version", json!(env!("CARGO_PKG_VERSION")));
    let parameters = M::params().iter().enumerate().map(|(index, param)| {
        let value = model.get(index);
        let value = match param.kind {
            ParamKind::Count => json!(value as u64),
            ParamKind::Quantity => json!(value),
        };
        (param.name.to_owned(), value)
    });
    put(&mut summary, "parameters", Value::Object(parameters.collect()));
    summary
}

fn outcome(summary: &mut Summary, reason: Option<String>) {
    put(summary, "completed", json!(reason.is_none()));
    put(summary, "reason", json!(reason));
}

fn settings(summary: &mut Summary, settings: &RunSettings) {
    put(summary, "formulation", json!(settings.formulation.name()));
    put(summary, "joints", json!(joints(settings.joints)));
    let start = match settings.start {
        Start::Rest => "rest",
        Start::Steady => "steady",
    };
    put(summary, "start", json!(start));
    match settings.method {
        Method::Radau => put(summary, "integrator", json!("radau")),
        Method::Hht { alpha } => {
            put(summary, "integrator", json!("hht"));
            put(summary, "alpha", json!(alpha));
        }
        Method::GeneralizedAlpha { rho_inf } => {
            put(summary, "integrator", json!("generalized-alpha"));
            put(summary, "rho_inf", json!(rho_inf));
        }
    }
    put(summary, "stabilised", json!(settings.options.stabilised));
    put(summary, "rtol", json!(settings.options.rtol));
    let step = match settings.options.step {
        StepSize::Adaptive => json!("adaptive"),
        StepSize::Fixed(h) => json!(h),
    };
    put(summary, "step", step);
    let ceiling = settings.options.max_step;
    put(summary, "max_step", json!(ceiling.is_finite().then_some(ceiling)));
    let (t_end, every) = times(settings);
    put(summary, "t_end", json!(t_end));
    put(summary, "every", json!(every));
}

fn joints(joints: Joints) -> &'static str {
    match joints {
        Joints::Eliminated => "eliminated",
        Joints::Multipliers => "multipliers",
    }
}

fn counts(summary: &mut Summary, result: &RunResult) {
    let s = &result.statistics;
    let bounded = result.settings.options.max_step.is_finite();
    let share = (bounded && s.steps > 0).then(|| s.steps_at_ceiling as f64 / s.steps as f64);
    let values = [
        ("steps", json!(s.steps)),
        ("rejected_steps", json!(s.rejected_steps)),
        ("rejected_by_error", json!(s.rejected_by_error)),
        ("rejected_by_newton", json!(s.rejected_by_newton)),
        ("restarts", json!(s.restarts)),
        ("steps_at_ceiling", json!(bounded.then_some(s.steps_at_ceiling))),
        ("share_at_ceiling", json!(share)),
        ("smallest_step", json!(s.smallest_step)),
        ("largest_step", json!(s.largest_step)),
        ("newton_iterations", json!(s.newton_iterations)),
        ("residual_evaluations", json!(s.residual_evaluations)),
        ("jacobian_evaluations", json!(s.jacobian_evaluations)),
        ("factorizations", json!(s.factorizations)),
        ("solves", json!(s.solves)),
    ];
    for (key, value) in values {
        put(summary, key, value);
    }
}

fn seconds(summary: &mut Summary, seconds: Seconds) {
    put(summary, "cpu_seconds", json!(seconds.cpu));
    let clock = if seconds.cpu_is_measured { "process" } else { "wall" };
    put(summary, "cpu_clock", json!(clock));
    put(summary, "wall_seconds", json!(seconds.wall));
}

fn tail<M: Model>(summary: &mut Summary, history: &History, notes: &[String]) {
    put(summary, "rows", json!(history.keys.len()));
    // `t_min` reads as in the first column: a time, or a spin in a steady run.
    let (low_at, high_at) = (format!("{}_min", history.key.name), format!("{}_max", history.key.name));
    let outputs = history.columns.iter().enumerate().map(|(index, column)| {
        let mut entry = Map::new();
        entry.insert("name".into(), json!(column.name));
        entry.insert("unit".into(), json!(column.unit));
        if let Some((low, high)) = history.extremes(index) {
            entry.insert("min".into(), json!(low.value));
            entry.insert(low_at.clone(), json!(low.at));
            entry.insert("max".into(), json!(high.value));
            entry.insert(high_at.clone(), json!(high.at));
        }
        Value::Object(entry)
    });
    put(summary, "outputs", outputs.collect());
    let all: Vec<&str> = M::NOTES
        .iter()
        .copied()
        .chain(notes.iter().map(String::as_str))
        .collect();
    put(summary, "notes", json!(all));
}

/// The text of the file.
pub(super) fn to_text(summary: &Summary) -> String {
    // The alternate form of a JSON value is the indented one.
    format!("{:#}\n", Value::Object(summary.clone()))
}
