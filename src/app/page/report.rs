//! The report: one page of HTML that needs nothing but itself.

use std::fmt::Write;

use serde_json::Value;

use super::cautions;
use super::charts::{Chart, LINES, Line, figure};
use super::compare::Beside;
use super::critical::{critical_lines, marks};
use super::summary::{SETTINGS, STATISTICS};
use super::{card, section_table};
use crate::app::results::equilibria::Equilibria;
use crate::app::results::history::History;
use crate::app::results::run::{RunResult, StepTaken};
use crate::app::writing::entries::Summary;
use crate::app::writing::html::escape;
use crate::app::writing::numbers::{digits, in_unit};
use crate::modes::Critical;
use crate::{AnyModel, Caution, Output};

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// The page of a command; `results` is what it found.
pub(in crate::app) fn page(model: &dyn AnyModel, what: &str, summary: &Summary, results: &str) -> String {
    let title = format!("{}: {what}", model.name());
    let mut page = String::new();
    page += "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    let _ = write!(
        page,
        "<title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n",
        escape(&title)
    );
    header(model, &mut page, &title, summary);
    page += &card::part(summary, model);
    page += "<h2>Results</h2>\n";
    page += results;
    page += &section_table::table(summary);
    page += "<h2>Parameters</h2>\n";
    parameters(&mut page, model, summary);
    page += "<div class=\"tables\">\n";
    for (head, keys) in [("Method", SETTINGS), ("Statistics", STATISTICS)] {
        let _ = write!(page, "<section><h2>{head}</h2>\n{}</section>\n", values(summary, keys));
    }
    page += "</div>\n";
    let _ = write!(page, "<h2>Model</h2>\n<pre>{}</pre>\n", escape(model.source().trim()));
    let version = env!("CARGO_PKG_VERSION");
    let _ = writeln!(
        page,
        "<footer>rncf {version}; all values in SI units unless a unit is given.</footer>"
    );
    let _ = write!(page, "<script>\n{SCRIPT}</script>\n</body>\n</html>\n");
    page
}

/// Outputs and steps of a run in time, with those of another run beside.
///
/// # Errors
/// A chart that cannot be drawn.
pub(in crate::app) fn run_part(
    model: &dyn AnyModel,
    result: &RunResult,
    beside: Option<&Beside>,
) -> Result<String, String> {
    let mut part = cautions::above(&result.cautions);
    part += &beside.map_or_else(String::new, Beside::table);
    results(model, &mut part, &result.history, (&[], &result.cautions), beside)?;
    if !result.steps.is_empty() {
        step_chart(&mut part, &result.steps)?;
    }
    Ok(part)
}

/// Outputs over what is continued; critical values are marked.
///
/// # Errors
/// A chart that cannot be drawn.
pub(in crate::app) fn equilibria_part(model: &dyn AnyModel, result: &Equilibria) -> Result<String, String> {
    let mut part = cautions::above(&result.cautions);
    for line in critical_lines(&result.history.key, &result.critical, BUCKLING) {
        let _ = writeln!(part, "<p>{}</p>", escape(&line));
    }
    results(
        model,
        &mut part,
        &result.history,
        (&result.critical, &result.cautions),
        None,
    )?;
    Ok(part)
}

/// What happens where the stiffness of a static equilibrium changes its sign.
pub(in crate::app) const BUCKLING: &str = "Critical value (buckling, snap-through or a return from them)";

fn header(model: &dyn AnyModel, page: &mut String, title: &str, summary: &Summary) {
    let _ = writeln!(page, "<h1>{}</h1>", escape(title));
    for paragraph in model.doc().trim().split("\n\n").filter(|text| !text.is_empty()) {
        let _ = writeln!(page, "<p class=\"doc\">{}</p>", escape(paragraph));
    }
    let reason = summary.get("reason").and_then(Value::as_str);
    let notes = notes(model, summary);
    let (class, head, text) = match reason {
        Some(reason) => ("status bad", "Stopped before the end", format!(": {}", escape(reason))),
        None if notes.is_empty() => ("status", "Complete", String::new()),
        None => ("status noted", "Complete", ", with notes:".into()),
    };
    let _ = writeln!(page, "<div class=\"{class}\"><p><b>{head}</b>{text}</p>");
    if !notes.is_empty() {
        let items: String = notes
            .iter()
            .map(|note| format!("<li>{}</li>\n", escape(note)))
            .collect();
        let _ = writeln!(page, "<ul>\n{items}</ul>");
    }
    if let Some(agreement) = summary.get("agreement").and_then(Value::as_str) {
        let _ = writeln!(page, "<p>{}</p>", escape(agreement));
    }
    page.push_str("</div>\n");
    page.push_str("<dl class=\"facts\">\n");
    let facts = [
        "points",
        "points_failed",
        "formulation",
        "integrator",
        "unknowns",
        "constraints",
        "steps",
        "rejected_steps",
        "factorizations",
        "spin",
        "stability_margin",
        "cpu_seconds",
    ];
    for key in facts {
        if let Some(value) = summary.get(key) {
            let _ = writeln!(page, "<div><dt>{}</dt><dd>{}</dd></div>", label(key), shown(key, value));
        }
    }
    page.push_str("</dl>\n");
}

/// One chart for each output; components of a vector share theirs.
fn results(
    model: &dyn AnyModel,
    page: &mut String,
    history: &History,
    (critical, cautions): (&[Critical], &[Caution]),
    beside: Option<&Beside>,
) -> Result<(), String> {
    let mut column = 0;
    for (index, output) in model.outputs().iter().enumerate() {
        let count = output.width();
        let named = |index: usize| {
            let name = output.components.get(index - column).copied().unwrap_or_default();
            match beside {
                Some(_) => format!("{name} this run").trim_start().to_owned(),
                None => name.to_owned(),
            }
        };
        let line = |index: usize| {
            let points = history.keys.iter().copied().zip(history.column(index));
            Line::new(points, index - column).named(named(index))
        };
        let other = |index: usize| {
            let name = output.components.get(index - column).copied().unwrap_or_default();
            let color = count + index - column;
            let points = beside?.curve(index)?;
            Some(
                Line::new(points, color)
                    .named(format!("{name} the other").trim_start())
                    .dashed(),
            )
        };
        // Over time the table below the chart is enough.
        let of_equilibria = history.key.name != "t";
        let peak = |index: usize| {
            let (low, high) = history.extremes(index)?;
            let largest = if low.value.abs() > high.value.abs() { low } else { high };
            let dot = Line::dots([(largest.at, largest.value)], index - column).named(named(index));
            (of_equilibria && low.value != high.value).then_some(dot)
        };
        let chart = Chart {
            x: history.key.head(),
            y: format!("{} [{}]", output.name, output.unit),
            lines: (column..column + count)
                .map(line)
                .chain((column..column + count).filter_map(other))
                .chain((column..column + count).filter_map(peak))
                .collect(),
            marks: marks(critical),
            ..Chart::default()
        };
        let caption = format!("{}<span>{}</span>", escape(output.name), escape(output.doc.trim()));
        let below = extremes(output, history, column) + &cautions::below(cautions, index);
        figure(page, &caption, &chart, &below)?;
        column += count;
    }
    Ok(())
}

/// Least and greatest value of each component, with its colour where there are several.
fn extremes(output: &Output, history: &History, first: usize) -> String {
    let mut text = String::new();
    for line in 0..output.width() {
        let Some((low, high)) = history.extremes(first + line) else {
            continue;
        };
        let key = match output.components.get(line) {
            Some(component) => format!("<i class=\"key k{}\"></i>{}: ", line % LINES.len(), escape(component)),
            None => String::new(),
        };
        let at = |place: f64| format!("at {}", history.key.at(place, 7));
        let _ = writeln!(
            text,
            "<p class=\"extremes\">{key}least {} {unit} {}; greatest {} {unit} {}</p>",
            digits(low.value, 7),
            escape(&at(low.at)),
            digits(high.value, 7),
            escape(&at(high.at)),
            unit = escape(output.unit),
        );
    }
    text
}

fn step_chart(page: &mut String, steps: &[StepTaken]) -> Result<(), String> {
    let line = steps
        .iter()
        .flat_map(|step| [(step.t - step.h, step.h), (step.t, step.h)]);
    let chart = Chart {
        x: "t [s]".into(),
        y: "h [s]".into(),
        logarithmic: true,
        lines: vec![Line::new(line, 0)],
        ..Chart::default()
    };
    figure(page, "Step size<span>of the accepted steps</span>", &chart, "")
}

fn parameters(page: &mut String, model: &dyn AnyModel, summary: &Summary) {
    let given = summary.get("parameters_in_units");
    page.push_str("<div class=\"scroll\"><table>\n");
    page.push_str("<tr><th>Name</th><th>Value</th><th>Default</th><th></th></tr>\n");
    for param in model.params() {
        let value = match given.map(|given| &given[param.name]) {
            Some(Value::String(value)) => value.clone(),
            Some(Value::Array(values)) => values.iter().map(Value::to_string).collect::<Vec<_>>().join(", "),
            _ => String::new(),
        };
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"doc\">{}</td></tr>",
            escape(param.name),
            escape(&value),
            escape(&in_unit(param, param.default)),
            escape(param.doc.trim()),
        );
    }
    page.push_str("</table></div>\n");
}

fn values(summary: &Summary, keys: &[&str]) -> String {
    let mut text = String::from("<table>\n");
    for key in keys {
        if let Some(value) = summary.get(*key) {
            let _ = writeln!(
                text,
                "<tr><td>{}</td><td class=\"n\">{}</td></tr>",
                label(key),
                shown(key, value)
            );
        }
    }
    text + "</table>\n"
}

/// What the command told of these results; what was chosen of the model stands below.
fn notes<'s>(model: &dyn AnyModel, summary: &'s Summary) -> Vec<&'s str> {
    let notes = summary.get("notes").and_then(Value::as_array);
    let texts = notes.into_iter().flatten().filter_map(Value::as_str);
    texts.filter(|note| !model.notes().contains(note)).collect()
}

/// A key as words: `cpu_seconds` is the processor time.
fn label(key: &str) -> String {
    let words = match key {
        "rtol" => "relative tolerance",
        "of" => "each point computes",
        "rho_inf" => "spectral radius at infinity",
        "rejected_by_newton" => "rejected by Newton",
        "shortened_steps" => "steps shortened to meet pulses",
        "cpu_seconds" => "processor time",
        "cpu_clock" => "clock of the processor time",
        "wall_seconds" => "wall time",
        "t_end" => "end time",
        "at" => "time whose spin and loads hold",
        "stability_margin" => "stability margin (largest re)",
        "circular_whirl" => "modes whirl on circles",
        "every" => "time between rows",
        "max_step" => "step ceiling",
        "energy_error" => "deviation of the energy over the largest kinetic energy",
        "max_constraint_residual" => "largest constraint residual",
        "jacobian_evaluations" => "Jacobian evaluations",
        "newton_iterations" => "Newton iterations",
        "share_at_ceiling" => "share of steps at the ceiling",
        _ => return key.replace('_', " "),
    };
    words.into()
}

/// A value for people: times with their unit, absence with its reason.
fn shown(key: &str, value: &Value) -> String {
    let absent = match key {
        "energy_error" => "not conserved by the model",
        "max_constraint_residual" => "no constraints",
        "max_step" | "steps_at_ceiling" | "share_at_ceiling" => "no ceiling",
        _ => "none",
    };
    let unit = match key {
        "cpu_seconds" | "wall_seconds" | "t_end" | "at" | "every" | "smallest_step" | "largest_step" | "max_step"
        | "step" => " s",
        "spin" => " rad/s",
        "stability_margin" => " 1/s",
        _ => "",
    };
    match value {
        Value::Null => format!("<span class=\"doc\">{absent}</span>"),
        Value::String(text) => escape(text),
        Value::Number(number) if number.is_u64() => number.to_string(),
        Value::Number(number) => {
            let value = number.as_f64().unwrap_or(f64::NAN);
            format!("{}{unit}", digits(value, 6))
        }
        other => escape(&other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::app::testing::Rotor;

    /// Who reads a page from above learns what is wrong with its numbers before them.
    #[test]
    fn notes_stand_before_all_numbers() {
        let mut summary = Summary::new();
        let page_of = |summary: &Summary| page(&Rotor::default(), "run", summary, "");
        assert!(page_of(&summary).contains("<b>Complete</b></p>"));
        summary.insert("notes".into(), json!(["`u` is off by 3 %, < all."]));
        summary.insert("agreement".into(), json!("Compared, <"));
        let noted = page_of(&summary);
        let note = noted.find("<li>`u` is off by 3 %, &lt; all.</li>").unwrap();
        assert!(noted.find("<b>Complete</b>, with notes:").unwrap() < note);
        let agreement = noted.find("<p>Compared, &lt;</p>").unwrap();
        assert!(note < agreement && agreement < noted.find("class=\"facts\"").unwrap());
        summary.insert("reason".into(), json!("Newton"));
        assert!(page_of(&summary).contains("<b>Stopped before the end</b>: Newton"));
    }
}
