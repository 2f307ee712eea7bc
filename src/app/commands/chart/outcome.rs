//! What a chart has found, as a summary and as a part of the report.

use std::fmt::Write;

use serde_json::{Value, json};

use super::judged::{Judged, time};
use super::picture;
use super::select::front;
use super::table::{Outcome, Point};
use crate::app::line::chart::method_name;
use crate::app::page::summary;
use crate::app::results::run::times;
use crate::app::writing::entries::{Summary, put};
use crate::app::writing::html::escape;
use crate::app::writing::numbers::digits;
use crate::{AnyModel, ParamKind};

/// The summary; `reason` says why it is not complete.
pub(super) fn summary(model: &dyn AnyModel, judged: &Judged<'_>, reason: Option<String>, notes: &[String]) -> Summary {
    let mut summary = summary::head(model, "chart");
    summary::outcome(&mut summary, reason);
    let grid = judged.grid;
    // The parameters of which several values are tried have no single one.
    for key in ["parameters", "parameters_in_units"] {
        let Some(Value::Object(parameters)) = summary.get_mut(key) else {
            continue;
        };
        for &(param, _) in &grid.meshes[0].counts {
            let mut values: Vec<f64> = (grid.meshes.iter().flat_map(|mesh| &mesh.counts))
                .filter(|count| count.0 == param)
                .map(|count| count.1)
                .collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            assert!(model.params()[param].kind == ParamKind::Count);
            let values: Vec<u64> = values.into_iter().map(|value| value as u64).collect();
            parameters.insert(model.params()[param].name.into(), json!(values));
        }
    }
    let (t_end, every) = times(&grid.base);
    let count = |outcome: fn(&Outcome) -> bool| judged.points().filter(|point| outcome(&point.outcome)).count();
    let cheapest = judged.wanted.iter().map(|&wanted| {
        let point = judged.cheapest(wanted).map(|point| entry(judged, point));
        json!({ "wanted": wanted, "cheapest": point })
    });
    let times = judged.times().into_iter().map(|(name, times)| {
        let seconds = judged.wanted.iter().zip(times);
        let seconds = seconds.map(|(wanted, time)| json!({ "wanted": wanted, "cpu_seconds": time }));
        json!({ "name": name, "times": seconds.collect::<Value>() })
    });
    let entries = [
        ("t_end", json!(t_end)),
        ("every", json!(every)),
        ("stabilised", json!(grid.base.options.stabilised)),
        ("reference", json!(judged.references.name)),
        ("uncertainty", json!(judged.measure.uncertainty)),
        ("outputs", json!(judged.measure.names)),
        ("points", json!(judged.found.len())),
        ("complete", json!(count(|outcome| *outcome == Outcome::Complete))),
        ("failed", json!(count(|outcome| matches!(outcome, Outcome::Failed(_))))),
        (
            "too_long",
            json!(count(|outcome| matches!(outcome, Outcome::TooLong(_)))),
        ),
        ("cheapest", cheapest.collect()),
        ("times", times.collect()),
        ("notes", summary::notes(model, notes)),
    ];
    for (key, value) in entries {
        put(&mut summary, key, value);
    }
    summary
}

fn entry(judged: &Judged<'_>, point: &Point) -> Value {
    let (setting, counts) = (&point.setting, &point.counts);
    json!({
        "formulation": setting.formulation.name(),
        "mesh": judged.grid.meshes[setting.mesh].name,
        "integrator": method_name(setting.method),
        "rtol": setting.rtol,
        "error": judged.error(point),
        "time_error": judged.time_error(point),
        "cpu_seconds": point.cpu,
        "steps": counts.steps,
        "residual_evaluations": counts.residuals,
        "jacobian_evaluations": counts.tangents,
        "factorizations": counts.factorizations,
        "solves": counts.solves,
    })
}

/// Cheapest settings, charts, the time to each wanted error, and all points.
pub(super) fn part(judged: &Judged<'_>) -> String {
    let mut part = format!("<p>{}</p>\n<ul>\n", escape(&what(judged)));
    for line in judged.lines() {
        let _ = writeln!(part, "<li>{}</li>", escape(&line));
    }
    part += "</ul>\n";
    part += &picture::part(judged);
    part += "<h2>Processor time to an error</h2>\n";
    part += "<p>On the front of each kind, between two settings where it lies there.</p>\n<div class=\"scroll\"><table>\n<tr><th></th>";
    for wanted in judged.wanted {
        let _ = write!(part, "<th class=\"n\">{wanted:e}</th>");
    }
    part += "</tr>\n";
    for (name, times) in judged.times() {
        let _ = write!(part, "<tr><td>{}</td>", escape(&name));
        for seconds in times {
            let _ = write!(part, "<td class=\"n\">{}</td>", seconds.map_or("-".into(), time));
        }
        part += "</tr>\n";
    }
    part += "</table></div>\n<h2>Points</h2>\n";
    points(&mut part, judged);
    part
}

fn points(part: &mut String, judged: &Judged<'_>) {
    let competing = judged.competing(|point| point.cpu, |_| true);
    let costs: Vec<(f64, f64)> = competing.iter().map(|entry| entry.1).collect();
    let on_front: Vec<u64> = front(&costs).into_iter().map(|index| competing[index].0.key).collect();
    *part += "<p>Errors are relative to the largest change of the output, the worst output counts: against the reference, and against the converged run on the same mesh.</p>\n";
    *part += "<div class=\"scroll\"><table>\n<tr><th>Setting</th>";
    for head in [
        "error",
        "same mesh",
        "time",
        "steps",
        "rejected",
        "residuals",
        "tangents",
        "factorizations",
        "solves",
    ] {
        let _ = write!(part, "<th class=\"n\">{head}</th>");
    }
    *part += "<th></th></tr>\n";
    for point in judged.points() {
        let _ = write!(part, "<tr><td>{}</td>", escape(&judged.grid.name(&point.setting)));
        let error = |error: Option<f64>| error.map_or("-".into(), |error| format!("{error:.1e}"));
        let c = &point.counts;
        let cells = [
            error(judged.error(point)),
            error(judged.time_error(point)),
            point.cpu.map_or("-".into(), time),
            c.steps.to_string(),
            c.rejected.to_string(),
            c.residuals.to_string(),
            c.tangents.to_string(),
            c.factorizations.to_string(),
            c.solves.to_string(),
        ];
        for cell in cells {
            let _ = write!(part, "<td class=\"n\">{cell}</td>");
        }
        let note = match &point.outcome {
            Outcome::Failed(reason) => reason.clone(),
            Outcome::TooLong(limit) => format!("ended after {} s", digits(*limit, 4)),
            Outcome::Complete if on_front.contains(&point.key) => "on the front".into(),
            Outcome::Complete if judged.is_hollow(point) => "below the uncertainty of the reference".into(),
            Outcome::Complete => String::new(),
        };
        let _ = writeln!(part, "<td class=\"doc\">{}</td></tr>", escape(&note));
    }
    for peer in judged.peers {
        let _ = writeln!(
            part,
            "<tr><td>{}, {}</td><td class=\"n\">{:.1e}</td><td class=\"n\">-</td><td class=\"n\">{}</td><td class=\"n\">{}</td>{}<td class=\"doc\">another code</td></tr>",
            escape(&peer.code),
            escape(&peer.setting),
            peer.error,
            time(peer.cpu),
            peer.steps,
            "<td class=\"n\">-</td>".repeat(5),
        );
    }
    *part += "</table></div>\n";
}

/// What is compared with what, in a sentence.
pub(super) fn what(judged: &Judged<'_>) -> String {
    let uncertainty = match judged.measure.uncertainty {
        Some(uncertainty) => format!("uncertain by {uncertainty:.1e}"),
        None => "its uncertainty is not known".into(),
    };
    format!(
        "{} points; largest error of {}, relative to the largest change, against: {}; {uncertainty}",
        judged.points().count(),
        judged.measure.names.join(", "),
        judged.references.name,
    )
}

/// What a reader must know of points that are missing.
pub(super) fn notes(judged: &Judged<'_>, refused: &[String]) -> Vec<String> {
    let mut notes = refused.to_vec();
    let measure = judged.measure;
    if !measure.still.is_empty() {
        notes.push(format!(
            "Left out of the errors because they change by no more than the reference is uncertain: {}.",
            measure.still.join(", ")
        ));
    }
    for point in judged.points() {
        let name = judged.grid.name(&point.setting);
        match &point.outcome {
            Outcome::Failed(reason) => notes.push(format!("{name}: {reason}")),
            Outcome::TooLong(limit) => notes.push(format!(
                "{name}: ended after {} s of processor time (`--limit`); tighter tolerances of it are left out.",
                digits(*limit, 4)
            )),
            Outcome::Complete => {}
        }
    }
    if judged.grid.meshes.len() > 1 && judged.measure.uncertainty.is_some() {
        let finest = &judged.grid.meshes[judged.grid.finest()].name;
        notes.push(format!(
            "Errors of the meshes are those against {finest}, whose own error of the mesh is not in them."
        ));
    }
    notes
}
