//! The flags of `chart`, and those that it shares with `advise`, read and checked.

use std::path::PathBuf;

use clap::{Arg, ArgAction, ArgMatches};

use super::parameters::time;
use super::words::{text, value};
use crate::app::writing::numbers::short;
use crate::nearest::nearest;
use crate::{AnyModel, Formulation, Method, Output};

/// Tolerances, loosest first, where none are given.
const RTOLS: &str = "1e-3..1e-9";
/// Integrators where none are given.
const INTEGRATORS: &str = "radau,hht:-0.05,generalized-alpha:0.8";
/// Wanted relative errors where none are given.
const WANTED: [f64; 3] = [1e-3, 1e-5, 1e-7];
/// Processor time after which a single run is ended, s, where none is given.
const LIMIT: f64 = 60.0;

/// What is compared and against what.
#[derive(Clone, Debug, Default)]
pub(in crate::app) struct ChartSettings {
    pub formulations: Vec<Formulation>,
    pub methods: Vec<Method>,
    /// The loosest first.
    pub rtols: Vec<f64>,
    /// A history that counts as exact.
    pub reference: Option<PathBuf>,
    /// Points of other codes.
    pub beside: Option<PathBuf>,
    /// Columns whose errors count; `None`: all that change.
    pub outputs: Option<Vec<usize>>,
    /// Relative errors for which the cheapest setting is named, the largest first.
    pub wanted: Vec<f64>,
    /// Processor time after which a single run is ended, s.
    pub limit: f64,
    pub is_fresh: bool,
}

/// The flags for the command line.
pub(in crate::app) fn flags() -> Vec<Arg> {
    vec![
        value("formulations", "LIST", "Coordinates to compare (default rncf,ancf)"),
        value(
            "integrators",
            "LIST",
            "Methods to compare, e.g. radau,hht:-0.3 (default radau,hht:-0.05,generalized-alpha:0.8)",
        ),
        value(
            "rtols",
            "LIST",
            "Tolerances, 1e-4,1e-6 or a decade each, 1e-3..1e-9 (default)",
        ),
        value(
            "reference",
            "FILE",
            "A history.csv that counts as exact (default: a converged run on the finest mesh)",
        ),
        value(
            "beside",
            "FILE",
            "Points of other codes: code,setting,output,error_max,error_rms,cpu_s,steps",
        ),
        value(
            "outputs",
            "LIST",
            "Outputs whose error counts, e.g. u,tip.x (default: all)",
        ),
        value(
            "wanted",
            "LIST",
            "Wanted errors relative to the largest change of an output (default 1e-3,1e-5,1e-7)",
        ),
        value(
            "limit",
            "TIME",
            "Processor time after which a single run is ended (default 60 s)",
        ),
        Arg::new("fresh")
            .long("fresh")
            .action(ArgAction::SetTrue)
            .help("Begin anew, whatever an earlier call has found"),
    ]
}

/// Coordinates of `--formulations`, both without it.
///
/// # Errors
/// The word and what would be right.
pub(in crate::app) fn formulations(matches: &ArgMatches) -> Result<Vec<Formulation>, String> {
    let all = [Formulation::Rncf, Formulation::Ancf];
    let one = |word: &str| {
        let found = all.into_iter().find(|formulation| formulation.name() == word);
        found.ok_or_else(|| unknown("formulations", word, &all.map(Formulation::name)))
    };
    list(matches, "formulations", "rncf,ancf", one)
}

/// Methods of `--integrators`.
///
/// # Errors
/// The word and what would be right.
pub(in crate::app) fn integrators(matches: &ArgMatches) -> Result<Vec<Method>, String> {
    list(matches, "integrators", INTEGRATORS, integrator)
}

/// A method with its parameter behind a colon.
fn integrator(word: &str) -> Result<Method, String> {
    let (name, parameter) = match word.split_once(':') {
        Some((name, parameter)) => (name, Some(parameter)),
        None => (word, None),
    };
    let Some(method) = Method::named(name) else {
        return Err(unknown("integrators", name, &Method::ALL.map(Method::name)));
    };
    let Some(parameter) = parameter else { return Ok(method) };
    let Some(own) = method.parameter() else {
        return Err(format!("`--integrators {word}`: {name} has no parameter"));
    };
    match parameter.parse::<f64>() {
        Ok(value) if own.allows(value) => Ok(method.with(value)),
        _ => {
            let [low, high] = own.bounds();
            Err(format!(
                "`--integrators {word}`: the number lies between {low} and {high}, e.g. `{name}:{}`",
                own.value
            ))
        }
    }
}

/// The word that stands for a method in lists, files and charts: `hht:-0.05`.
pub(in crate::app) fn method_name(method: Method) -> String {
    match method.parameter() {
        Some(own) => format!("{}:{}", method.name(), short(own.value)),
        None => method.name().into(),
    }
}

/// Tolerances of `--rtols`, the loosest first.
///
/// # Errors
/// The word and what would be right.
pub(in crate::app) fn rtols(matches: &ArgMatches) -> Result<Vec<f64>, String> {
    let given = text(matches, "rtols").unwrap_or(RTOLS);
    let one = |word: &str| match word.trim().parse::<f64>() {
        Ok(rtol) if rtol > 0.0 && rtol < 1.0 => Ok(rtol),
        _ => Err(format!(
            "`--rtols {given}`: a tolerance lies between 0 and 1, e.g. `--rtols 1e-3..1e-9` or `--rtols 1e-4,1e-6`"
        )),
    };
    let mut rtols = match given.split_once("..") {
        None => given.split(',').map(one).collect::<Result<Vec<f64>, String>>()?,
        Some((from, to)) => {
            let (from, to) = (one(from)?, one(to)?);
            let (loose, tight) = (from.max(to), from.min(to));
            let decades = (loose / tight).log10();
            let count = (decades + 1e-9).floor() as i32;
            // Decimal, not by repeated division: the tolerances are named as they are typed.
            (0..=count)
                .map(|k| format!("{:.12e}", loose * 10f64.powi(-k)).parse().unwrap_or(loose))
                .collect()
        }
    };
    rtols.sort_by(|a, b| b.total_cmp(a));
    if let Some(pair) = rtols.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(format!("`--rtols {given}`: {:e} is given twice", pair[0]));
    }
    Ok(rtols)
}

/// Wanted relative errors of `--wanted`, the largest first.
///
/// # Errors
/// The word and what would be right.
pub(in crate::app) fn wanted(matches: &ArgMatches) -> Result<Vec<f64>, String> {
    let Some(given) = text(matches, "wanted") else {
        return Ok(WANTED.to_vec());
    };
    let one = |word: &str| match word.trim().parse::<f64>() {
        Ok(error) if error > 0.0 && error < 1.0 => Ok(error),
        _ => Err(format!(
            "`--wanted {given}`: an error relative to the largest change lies between 0 and 1, e.g. `--wanted 1e-4`"
        )),
    };
    let mut wanted = given.split(',').map(one).collect::<Result<Vec<f64>, String>>()?;
    wanted.sort_by(|a, b| b.total_cmp(a));
    wanted.dedup();
    Ok(wanted)
}

/// Processor time after which a single run is ended, s.
///
/// # Errors
/// What would be right.
pub(in crate::app) fn limit(matches: &ArgMatches) -> Result<f64, String> {
    text(matches, "limit").map_or(Ok(LIMIT), |given| time("--limit", given, "60 s"))
}

/// Whether `--fresh` is given.
pub(in crate::app) fn fresh(matches: &ArgMatches) -> bool {
    matches.get_flag("fresh")
}

/// Columns of the history that `--outputs` names, whole outputs or components; `None` without it.
///
/// # Errors
/// The name and what would be right.
pub(in crate::app) fn outputs(model: &dyn AnyModel, matches: &ArgMatches) -> Result<Option<Vec<usize>>, String> {
    let Some(given) = text(matches, "outputs") else {
        return Ok(None);
    };
    let names = column_names(model.outputs());
    let mut columns = Vec::new();
    for word in given.split(',').map(str::trim) {
        let before = columns.len();
        let belongs = |(output, name): &(&str, String)| *output == word || name == word;
        columns.extend((0..names.len()).filter(|&index| belongs(&names[index])));
        if columns.len() == before {
            let known = names.iter().flat_map(|(output, name)| [*output, name.as_str()]);
            let known: Vec<&str> = known.collect();
            return Err(unknown("outputs", word, &known));
        }
    }
    columns.sort_unstable();
    columns.dedup();
    Ok(Some(columns))
}

/// For each column of a history its output and its own name.
pub(in crate::app) fn column_names(outputs: &'static [Output]) -> Vec<(&'static str, String)> {
    let mut names = Vec::new();
    for output in outputs {
        if output.components.is_empty() {
            names.push((output.name, output.name.to_owned()));
        }
        for component in output.components {
            names.push((output.name, format!("{}.{component}", output.name)));
        }
    }
    names
}

/// The parts of a comma-separated list, each once.
fn list<T: PartialEq>(
    matches: &ArgMatches,
    flag: &str,
    default: &str,
    one: impl Fn(&str) -> Result<T, String>,
) -> Result<Vec<T>, String> {
    let given = text(matches, flag).unwrap_or(default);
    let mut values = Vec::new();
    for word in given.split(',').map(str::trim) {
        let value = one(word)?;
        if values.contains(&value) {
            return Err(format!("`--{flag} {given}`: `{word}` is given twice"));
        }
        values.push(value);
    }
    Ok(values)
}

fn unknown(flag: &str, word: &str, known: &[&str]) -> String {
    let mut all: Vec<&str> = Vec::new();
    for name in known {
        if !all.contains(name) {
            all.push(name);
        }
    }
    match nearest(word, all.iter().copied()) {
        Some(near) => format!("`--{flag} {word}`: did you mean `{near}`?"),
        None => format!("`--{flag} {word}`: there are {}", all.join(", ")),
    }
}

/// Reads the flags.
///
/// # Errors
/// The flag and what would be right.
pub(in crate::app) fn settings(model: &dyn AnyModel, matches: &ArgMatches) -> Result<ChartSettings, String> {
    Ok(ChartSettings {
        formulations: formulations(matches)?,
        methods: integrators(matches)?,
        rtols: rtols(matches)?,
        reference: text(matches, "reference").map(PathBuf::from),
        beside: text(matches, "beside").map(PathBuf::from),
        outputs: outputs(model, matches)?,
        wanted: wanted(matches)?,
        limit: limit(matches)?,
        is_fresh: fresh(matches),
    })
}
