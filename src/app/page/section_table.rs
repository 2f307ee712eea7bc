//! Envelopes of bodies in the summary, and as a table of the report.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use super::mass_table::repeated;
use crate::app::results::envelopes::{AXIAL, BodyEnvelope, Envelopes, Peak};
use crate::app::writing::entries::Summary;
use crate::app::writing::html::escape;
use crate::app::writing::numbers::{digits, with_prefix};

/// Columns of the table: key in the summary, head, unit.
const COLUMNS: [(&str, &str, &str); 5] = [
    ("axial_force", "Axial force", "N"),
    ("shear_force", "Shear force", "N"),
    ("torque", "Torque", "N m"),
    ("bending_moment", "Bending moment", "N m"),
    ("stress", "Stress", "Pa"),
];

/// Adds the envelopes to a summary: `bodies`, and in `bodies_over` what `at` is in them. Nothing where there
/// are no flexible bodies.
pub(in crate::app) fn put(summary: &mut Summary, envelopes: &Envelopes) {
    if envelopes.bodies.is_empty() {
        return;
    }
    summary.insert("bodies_over".into(), json!(envelopes.key.head()));
    summary.insert("bodies".into(), envelopes.bodies.iter().map(entry).collect());
}

fn entry(envelope: &BodyEnvelope) -> Value {
    let body = &envelope.body;
    let mut entry = Map::new();
    entry.insert("name".into(), json!(body.name));
    entry.insert("length".into(), json!(body.length));
    let peaks = [
        envelope.axial_force,
        envelope.shear_force,
        envelope.torque,
        envelope.bending_moment,
        envelope.stress,
    ];
    for ((key, ..), found) in COLUMNS.into_iter().zip(peaks) {
        entry.insert(key.into(), json!(found.map(peak)));
    }
    entry.insert("stress_is".into(), json!(envelope.stress_name()));
    entry.insert("material".into(), json!(body.material));
    entry.insert("yield_stress".into(), json!(envelope.yield_stress));
    entry.insert("yielding".into(), json!(envelope.yielding.map(peak)));
    Value::Object(entry)
}

fn peak(peak: Peak) -> Value {
    json!({ "value": peak.value, "at": peak.at, "x": peak.x })
}

/// The table of the report; empty where the summary has no bodies.
pub(in crate::app) fn table(summary: &Summary) -> String {
    let (Some(Value::Array(bodies)), Some(Value::String(over))) = (summary.get("bodies"), summary.get("bodies_over"))
    else {
        return String::new();
    };
    let mut text = String::from("<h2>Section forces and stresses</h2>\n");
    let _ = writeln!(
        text,
        "<p class=\"doc\">Largest magnitudes, with their place: {} and arclength x.</p>",
        escape(over)
    );
    text.push_str("<div class=\"scroll\"><table>\n<tr><th>Body</th>");
    for (_, head, _) in COLUMNS {
        let _ = write!(text, "<th>{head}</th>");
    }
    text.push_str("<th>Yield stress</th></tr>\n");
    let name = over.split(" [").next().unwrap_or(over);
    for group in bodies.chunk_by(|a, b| repeated(a).is_some() && repeated(a) == repeated(b)) {
        match (group, group.first().and_then(repeated)) {
            (group, Some(of_all)) if group.len() > 1 => {
                let _ = write!(text, "<tr><td>{} ({})</td>", escape(of_all), group.len());
            }
            (group, _) => {
                let _ = write!(text, "<tr><td>{}</td>", escape(&named(&group[0])));
            }
        }
        for (key, _, unit) in COLUMNS {
            let _ = write!(text, "<td>{}</td>", largest(group, key, unit, name));
        }
        let _ = writeln!(text, "<td>{}</td></tr>", first_yielding(group, name));
    }
    text.push_str("</table></div>\n");
    let axial = bodies.iter().filter(|body| body["stress_is"] == AXIAL);
    let mut axial: Vec<String> = axial
        .map(|body| repeated(body).map_or_else(|| named(body), str::to_owned))
        .collect();
    axial.dedup();
    if !axial.is_empty() {
        let _ = writeln!(
            text,
            "<p class=\"doc\">Stress is the {AXIAL} for {}, whose section does not say where its outermost fibres are: give <code>extent_y</code> and in space <code>extent_z</code>, or a section of known shape.</p>",
            escape(&axial.join(", "))
        );
    }
    text
}

fn named(body: &Value) -> String {
    body["name"].as_str().unwrap_or("").to_owned()
}

/// The largest peak of equal bodies, with the one that has it.
fn largest(group: &[Value], key: &str, unit: &str, name: &str) -> String {
    let size = |body: &Value| body[key]["value"].as_f64().map_or(-1.0, f64::abs);
    let mut most = &group[0];
    for body in group {
        if size(body) > size(most) {
            most = body;
        }
    }
    let told = cell(&most[key], unit, name);
    if group.len() == 1 || size(most) < 0.0 {
        return told;
    }
    format!("{told}<br><span class=\"doc\">{}</span>", escape(&named(most)))
}

/// The first of equal bodies whose stress passes its limit.
fn first_yielding(group: &[Value], name: &str) -> String {
    let at = |body: &&Value| body["yielding"]["at"].as_f64();
    let yielded = group.iter().filter(|body| at(body).is_some());
    let first = yielded.min_by(|a, b| at(a).unwrap_or(0.0).total_cmp(&at(b).unwrap_or(0.0)));
    match first {
        Some(body) if group.len() > 1 => {
            format!(
                "{}<br><span class=\"doc\">{}</span>",
                yielding(body, name),
                escape(&named(body))
            )
        }
        Some(body) => yielding(body, name),
        None => yielding(&group[0], name),
    }
}

/// A peak with its place; a dash where there is none.
fn cell(peak: &Value, unit: &str, name: &str) -> String {
    let [Some(value), Some(at), Some(x)] = ["value", "at", "x"].map(|key| peak[key].as_f64()) else {
        return "–".into();
    };
    format!(
        "{}<br><span class=\"doc\">{} = {}, x = {} m</span>",
        with_prefix(value, unit),
        escape(name),
        digits(at, 6),
        digits(x, 4)
    )
}

/// The yield stress, and where it is passed.
fn yielding(body: &Value, name: &str) -> String {
    let Some(limit) = body["yield_stress"].as_f64() else {
        return "–".into();
    };
    let limit = with_prefix(limit, "Pa");
    match body["yielding"]["at"].as_f64() {
        Some(at) => format!("{limit}<br><b>passed at {} = {}</b>", escape(name), digits(at, 6)),
        None => limit,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_says_what_is_known_and_where() {
        let found = |value: f64| json!({ "value": value, "at": 1.5, "x": 0.25 });
        let mut summary = Summary::new();
        assert_eq!(table(&summary), "");
        summary.insert("bodies_over".into(), json!("t [s]"));
        summary.insert(
            "bodies".into(),
            json!([
                { "name": "shaft", "axial_force": found(-1250.0), "shear_force": null, "torque": null,
                  "bending_moment": found(0.5), "stress": found(362.1e6), "stress_is": "largest von Mises stress",
                  "yield_stress": 355e6, "yielding": found(356e6) },
                { "name": "a<b", "axial_force": found(1.0), "stress_is": AXIAL },
            ]),
        );
        let text = table(&summary);
        for part in [
            "<td>-1.25 kN<br><span class=\"doc\">t = 1.5, x = 0.25 m</span></td><td>–</td><td>–</td><td>0.5 N m<br>",
            "362.1 MPa<br>",
            "355 MPa<br><b>passed at t = 1.5</b>",
            "<td>a&lt;b</td>",
            "alone for a&lt;b, whose section",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[test]
    fn equal_bodies_share_a_row_with_the_one_that_carries_most() {
        let body = |number: usize, force: f64| json!({ "name": format!("arm[{number}]"), "axial_force": { "value": force, "at": 1.0, "x": 2.0 }, "yield_stress": 1e6 });
        let mut late = body(1, -30.0);
        late["yielding"] = json!({ "value": 2e6, "at": 3.0, "x": 0.0 });
        let mut summary = Summary::new();
        summary.insert("bodies_over".into(), json!("t [s]"));
        summary.insert("bodies".into(), json!([body(0, 20.0), late, body(2, 10.0)]));
        let text = table(&summary);
        assert_eq!(text.matches("<tr><td>").count(), 1, "{text}");
        for part in [
            "<tr><td>arm (3)</td><td>-30 N<br><span class=\"doc\">t = 1, x = 2 m</span><br><span class=\"doc\">arm[1]</span></td>",
            "<b>passed at t = 3</b><br><span class=\"doc\">arm[1]</span>",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
}
