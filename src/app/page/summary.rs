//! What a run was and what it took, as JSON; the report shows the same values.

use serde_json::{Map, Value, json};

use super::{mass_table, section_table};
use crate::app::machine::clock::Seconds;
use crate::app::results::campbell::Campbell;
use crate::app::results::equilibria::{Equilibria, EquilibriumSettings};
use crate::app::results::history::{Column, History};
use crate::app::results::modes::{Modes, SeenMode, growth};
use crate::app::results::run::{RunResult, RunSettings, times};
use crate::app::writing::date;
use crate::app::writing::entries::{Summary, put};
use crate::app::writing::numbers::in_unit;
use crate::equilibrium::Kind;
use crate::hash::hash;
use crate::model::Fidelity;
use crate::modes::{Composition, Critical, Whirl};
use crate::{AnyModel, Joints, ParamKind, Start, StepSize};

/// Keys of a run's method and settings, for the report.
pub(in crate::app) const SETTINGS: &[&str] = &[
    "formulation",
    "joints",
    "start",
    "fidelity",
    "integrator",
    "alpha",
    "rho_inf",
    "rtol",
    "proportional",
    "step",
    "max_step",
    "t_end",
    "every",
    "at",
    "continued",
    "continuation_steps",
    "spin",
    "frame_of_observation",
    "of",
    "design",
    "varied",
];

/// Keys of counts and times, for the report.
pub(in crate::app) const STATISTICS: &[&str] = &[
    "points",
    "points_failed",
    "unknowns",
    "constraints",
    "steps",
    "rejected_steps",
    "rejected_by_error",
    "rejected_by_newton",
    "restarts",
    "shortened_steps",
    "steps_at_ceiling",
    "share_at_ceiling",
    "smallest_step",
    "largest_step",
    "newton_iterations",
    "residual_evaluations",
    "jacobian_evaluations",
    "factorizations",
    "steps_per_factorization",
    "solves",
    "cpu_seconds",
    "cpu_clock",
    "wall_seconds",
    "energy_error",
    "judged_until",
    "max_constraint_residual",
    "position_correction",
    "velocity_correction",
];

/// Summary of a run in time.
pub(in crate::app) fn of_run(model: &dyn AnyModel, result: &RunResult) -> Summary {
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
    put(&mut summary, "judged_until", json!(result.judged_until));
    put(&mut summary, "agreement", json!(result.agreement));
    put_off_by(model, &mut summary, &result.off_by);
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
    mass_table::put(&mut summary, &result.masses);
    section_table::put(&mut summary, &result.envelopes);
    tail(model, &mut summary, &result.history, &result.warnings);
    summary
}

/// How far outputs are off, by their names.
fn put_off_by(model: &dyn AnyModel, summary: &mut Summary, off_by: &[(usize, f64)]) {
    let named = off_by
        .iter()
        .map(|&(output, part)| (model.outputs()[output].name.to_owned(), json!(part)));
    put(summary, "off_by", Value::Object(named.collect()));
}

/// Summary of relative or static equilibria.
pub(in crate::app) fn of_equilibria(model: &dyn AnyModel, result: &Equilibria) -> Summary {
    let is_static = result.kind == Kind::Static;
    let mut summary = head(model, if is_static { "static" } else { "steady" });
    outcome(&mut summary, result.incomplete.as_ref().map(ToString::to_string));
    equilibrium(model, &mut summary, &result.settings, result.t);
    if is_static {
        put(
            &mut summary,
            "critical_values",
            criticals(&result.history.key, &result.critical),
        );
    } else {
        put(&mut summary, "spin", json!(result.spin));
    }
    counted(
        &mut summary,
        [result.unknowns, result.constraints],
        result.newton_iterations,
    );
    put(&mut summary, "steps", json!(result.history.keys.len()));
    put(&mut summary, "agreement", json!(result.agreement));
    put_off_by(model, &mut summary, &result.off_by);
    seconds(&mut summary, result.seconds);
    section_table::put(&mut summary, &result.envelopes);
    tail(model, &mut summary, &result.history, &result.warnings);
    summary
}

/// Summary of the modes about an equilibrium.
pub(in crate::app) fn of_modes(model: &dyn AnyModel, result: &Modes) -> Summary {
    let mut summary = head(model, "modes");
    outcome(&mut summary, None);
    equilibrium(
        model,
        &mut summary,
        &EquilibriumSettings {
            range: None,
            ..result.settings
        },
        result.t,
    );
    put(&mut summary, "spin", json!(result.spin));
    put(&mut summary, "frame_of_observation", json!(REFERENCE));
    put(&mut summary, "circular_whirl", json!(result.is_round));
    put(&mut summary, "stability_margin", json!(result.margin));
    // Nothing is known where nothing moves, or only without stiffness.
    let is_known = result.modes.iter().any(|mode| !mode.is_still());
    let is_unstable = is_known.then(|| growth(&result.modes).is_some());
    put(&mut summary, "is_unstable", json!(is_unstable));
    let modes = result.modes.iter().zip(&result.compositions).enumerate();
    let modes = modes.map(|(index, (mode, composition))| {
        let mut entry = mode_entry(mode, result.spin);
        entry.shift_insert(0, "mode".into(), json!(index + 1));
        put_composition(&mut entry, composition);
        Value::Object(entry)
    });
    put(&mut summary, "modes", modes.collect());
    mass_table::put(&mut summary, &result.masses);
    counted(
        &mut summary,
        [result.unknowns, result.constraints],
        result.newton_iterations,
    );
    seconds(&mut summary, result.seconds);
    put(&mut summary, "agreement", json!(result.agreement));
    put(&mut summary, "notes", notes(model, &result.warnings));
    summary
}

/// Summary of a Campbell diagram.
pub(in crate::app) fn of_campbell(model: &dyn AnyModel, result: &Campbell) -> Summary {
    let mut summary = head(model, "campbell");
    outcome(&mut summary, result.incomplete.as_ref().map(ToString::to_string));
    equilibrium(model, &mut summary, &result.settings, result.t);
    put(&mut summary, "frame_of_observation", json!(REFERENCE));
    put(&mut summary, "circular_whirl", json!(result.is_round));
    let mut values = criticals(&result.key, &result.critical);
    for (value, is_standing) in values.as_array_mut().into_iter().flatten().zip(&result.standing) {
        value["frequency_is_zero"] = json!(is_standing);
    }
    put(&mut summary, "critical_values", values);
    let key = result.key.head();
    let crossings = result.crossings.iter().map(|crossing| {
        json!({
            "mode": crossing.track + 1,
            "order": crossing.order,
            "frame": if crossing.whirl == Whirl::Mixed { "reference" } else { "inertial" },
            "whirl": crossing.whirl.name(),
            key.as_str(): crossing.key,
            "within": crossing.within,
            "im [rad/s]": crossing.im,
        })
    });
    put(&mut summary, "crossings", crossings.collect());
    let onsets = result.onsets.iter().map(|onset| {
        json!({
            key.as_str(): onset.key,
            "within": onset.within,
            "im [rad/s]": onset.im,
            "begins_to_grow": onset.begins,
        })
    });
    put(&mut summary, "onsets", onsets.collect());
    let margins = result.margins();
    let largest = margins
        .iter()
        .zip(&result.keys)
        .filter_map(|(margin, key)| margin.map(|margin| (margin, key)));
    let largest = largest.max_by(|a, b| a.0.total_cmp(&b.0));
    put(
        &mut summary,
        "stability_margin",
        json!(largest.map(|(margin, _)| margin)),
    );
    put(&mut summary, "stability_margin_at", json!(largest.map(|(_, key)| key)));
    let tracks = result.tracks.iter().zip(&result.compositions).enumerate();
    let tracks = tracks.map(|(index, (track, composition))| {
        let seen = |row: usize| track[row].map(|mode| mode_entry(&mode, result.spins[row]));
        let mut rows = 0..track.len();
        let first = rows.find_map(seen);
        let last = (0..track.len()).rev().find_map(seen);
        let mut entry = Summary::new();
        put(&mut entry, "mode", json!(index + 1));
        put(&mut entry, "first", json!(first));
        put(&mut entry, "last", json!(last));
        put_composition(&mut entry, composition);
        Value::Object(entry)
    });
    put(&mut summary, "modes", tracks.collect());
    counted(
        &mut summary,
        [result.unknowns, result.constraints],
        result.newton_iterations,
    );
    put(&mut summary, "steps", json!(result.keys.len()));
    seconds(&mut summary, result.seconds);
    put(&mut summary, "agreement", json!(result.agreement));
    put(&mut summary, "notes", notes(model, &result.warnings));
    summary
}

/// Where the frequencies are seen.
const REFERENCE: &str =
    "re, im, damping_ratio and whirl: reference frame, which turns with the system; inertial: one that does not";

fn mode_entry(mode: &SeenMode, spin: f64) -> Summary {
    let mut entry = Summary::new();
    let values = [
        ("inertial [rad/s]", json!(mode.inertial_frequencies(spin))),
        ("inertial_damping_ratio", json!(mode.inertial_damping_ratios(spin))),
        ("logarithmic_decrement", json!(mode.logarithmic_decrements(spin))),
        ("inertial_whirl", json!(mode.inertial_whirl(spin).name())),
        ("re [1/s]", json!(mode.re)),
        ("im [rad/s]", json!(mode.im)),
        ("damping_ratio", json!(mode.damping_ratio())),
        ("whirl", json!(mode.whirl.name())),
        ("circulation", json!(mode.circulation)),
    ];
    for (key, value) in values {
        put(&mut entry, key, value);
    }
    entry
}

/// Parts of the kinetic energy.
fn put_composition(entry: &mut Summary, composition: &Composition) {
    let motions = composition.motions.iter();
    let motions = motions.map(|(motion, part)| (motion.name().to_owned(), json!(part)));
    put(entry, "motions", Value::Object(motions.collect()));
    let bodies = composition
        .bodies
        .iter()
        .map(|(name, part)| (name.clone(), json!(part)));
    put(entry, "bodies", Value::Object(bodies.collect()));
}

fn criticals(key: &Column, critical: &[Critical]) -> Value {
    let entry = |critical: &Critical| {
        json!({
            key.head().as_str(): critical.value,
            "within": critical.within,
            "no_equilibrium": critical.open,
            "directions": critical.change,
        })
    };
    critical.iter().map(entry).collect()
}

/// What was asked of equilibria.
fn equilibrium(model: &dyn AnyModel, summary: &mut Summary, settings: &EquilibriumSettings, t: f64) {
    put(summary, "formulation", json!("rncf"));
    put(summary, "joints", json!(joints(Joints::Eliminated)));
    put(summary, "at", json!(t));
    if let Some(range) = settings.range {
        let param = &model.params()[range.param];
        let [from, to] = [range.from, range.to].map(|value| in_unit(param, value));
        put(summary, "continued", json!(format!("{} = {from} .. {to}", param.name)));
    }
    put(summary, "continuation_steps", json!(settings.steps));
}

fn counted(summary: &mut Summary, [unknowns, constraints]: [usize; 2], newton_iterations: u64) {
    put(summary, "unknowns", json!(unknowns));
    put(summary, "constraints", json!(constraints));
    put(summary, "newton_iterations", json!(newton_iterations));
}

/// Checksums of what parameters that name files have read: 0 for a table of the build.
pub(in crate::app) fn checksums(model: &dyn AnyModel) -> Summary {
    let params = model.params().iter().enumerate();
    let files = params.filter(|(_, param)| matches!(param.kind, ParamKind::Table(_)));
    files
        .map(|(index, param)| {
            (
                param.name.to_owned(),
                json!(format!("{:013x}", model.get(index) as u64)),
            )
        })
        .collect()
}

pub(in crate::app) fn head(model: &dyn AnyModel, command: &str) -> Summary {
    let mut summary = Summary::new();
    put(&mut summary, "model", json!(model.name()));
    put(&mut summary, "command", json!(command));
    put(&mut summary, "rncf_version", json!(env!("CARGO_PKG_VERSION")));
    put(&mut summary, "date", json!(date::now()));
    let parameters = model.params().iter().enumerate().map(|(index, param)| {
        let value = model.get(index);
        let value = match param.kind {
            ParamKind::Count => json!(value as u64),
            ParamKind::Quantity => json!(value),
            ParamKind::Table(_) => json!(in_unit(param, value)),
        };
        (param.name.to_owned(), value)
    });
    put(&mut summary, "parameters", Value::Object(parameters.collect()));
    let given = model.params().iter().enumerate().map(|(index, param)| {
        let value = json!(in_unit(param, model.get(index)));
        (param.name.to_owned(), value)
    });
    put(&mut summary, "parameters_in_units", Value::Object(given.collect()));
    let files = checksums(model);
    if !files.is_empty() {
        put(&mut summary, "checksums_of_tables", Value::Object(files));
    }
    put(
        &mut summary,
        "model_hash",
        json!(format!("{:016x}", hash(model.source()))),
    );
    put(
        &mut summary,
        "equations_hash",
        json!(format!("{:016x}", model.equations_hash())),
    );
    put(&mut summary, "model_text", json!(model.source()));
    summary
}

/// The line that makes the result again, behind the command.
pub(in crate::app) fn command_line(summary: &mut Summary, line: &str) {
    summary.shift_insert(2, "command_line".into(), json!(line));
}

pub(in crate::app) fn outcome(summary: &mut Summary, reason: Option<String>) {
    put(summary, "completed", json!(reason.is_none()));
    put(summary, "reason", json!(reason));
}

pub(in crate::app) fn settings(summary: &mut Summary, settings: &RunSettings) {
    put(summary, "formulation", json!(settings.formulation.name()));
    put(summary, "joints", json!(joints(settings.joints)));
    put(summary, "start", json!(settings.start.map(Start::name)));
    if !settings.fidelity.is_empty() {
        put(summary, "fidelity", json!(described(&settings.fidelity)));
    }
    put(summary, "integrator", json!(settings.method.name()));
    if let Some(own) = settings.method.parameter() {
        put(summary, own.name, json!(own.value));
    }
    put(summary, "stabilised", json!(settings.options.stabilised));
    put(summary, "rtol", json!(settings.options.rtol));
    put(summary, "proportional", json!(settings.options.proportional));
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
    put(summary, "pictures", json!(settings.pictures));
    put(summary, "judged", json!(settings.judged.name()));
    if let Some(count) = settings.options.renewed_after {
        put(summary, "renewed_after", json!(count));
    }
}

/// `rod=rigid,beam=modal(3)`, as it is typed.
pub(in crate::app) fn described(fidelity: &[(String, Fidelity)]) -> String {
    let words: Vec<String> = fidelity.iter().map(|(body, how)| format!("{body}={how}")).collect();
    words.join(",")
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
        ("shortened_steps", json!(s.shortened_steps)),
        ("steps_at_ceiling", json!(bounded.then_some(s.steps_at_ceiling))),
        ("share_at_ceiling", json!(share)),
        ("smallest_step", json!(s.smallest_step)),
        ("largest_step", json!(s.largest_step)),
        ("newton_iterations", json!(s.newton_iterations)),
        ("residual_evaluations", json!(s.residual_evaluations)),
        ("jacobian_evaluations", json!(s.jacobian_evaluations)),
        ("factorizations", json!(s.factorizations)),
        ("steps_per_factorization", json!(s.steps_per_factorization())),
        ("solves", json!(s.solves)),
    ];
    for (key, value) in values {
        put(summary, key, value);
    }
}

pub(in crate::app) fn seconds(summary: &mut Summary, seconds: Seconds) {
    put(summary, "cpu_seconds", json!(seconds.cpu));
    let clock = if seconds.cpu_is_measured { "process" } else { "wall" };
    put(summary, "cpu_clock", json!(clock));
    put(summary, "wall_seconds", json!(seconds.wall));
}

fn tail(model: &dyn AnyModel, summary: &mut Summary, history: &History, notes_of_run: &[String]) {
    put(summary, "rows", json!(history.rows()));
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
    put(summary, "notes", notes(model, notes_of_run));
}

/// What the generator and the scene have to say.
pub(in crate::app) fn notes(model: &dyn AnyModel, warnings: &[String]) -> Value {
    let all = model.notes().iter().copied().chain(warnings.iter().map(String::as_str));
    all.map(|text| json!(text)).collect()
}
