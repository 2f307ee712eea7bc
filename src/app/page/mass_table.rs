//! Masses of the bodies at the start, in the summary and as a table of the report.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::app::writing::entries::Summary;
use crate::app::writing::html::escape;
use crate::app::writing::numbers::digits;
use crate::model::MassProperties;
use crate::space::rows;

/// Adds the masses to a summary; nothing where nothing has mass.
pub(in crate::app) fn put(summary: &mut Summary, masses: &[MassProperties]) {
    if masses.is_empty() {
        return;
    }
    let entry = |one: &MassProperties| json!({ "name": one.name, "mass": one.mass, "centre": one.centre.as_slice(), "inertia": rows(&one.inertia) });
    summary.insert("masses".into(), masses.iter().map(entry).collect());
}

/// The table of the report; repeated bodies of one name share a row. Empty where the summary has no masses.
pub(in crate::app) fn table(summary: &Summary) -> String {
    let Some(Value::Array(masses)) = summary.get("masses") else {
        return String::new();
    };
    let mut text = String::from("<h3>Masses</h3>\n");
    let _ = writeln!(
        text,
        "<p class=\"doc\">{}, in inertial axes; inertia about the centre of mass.</p>",
        moment(summary)
    );
    text += "<div class=\"scroll\"><table>\n<tr><th>Body</th><th class=\"n\">Mass [kg]</th><th>Centre of mass [m]</th>\
        <th>Inertia xx, yy, zz [kg m²]</th><th>xy, xz, yz</th></tr>\n";
    for group in masses.chunk_by(|a, b| repeated(a).is_some() && repeated(a) == repeated(b)) {
        match group {
            [one] => row(&mut text, one),
            _ => group_row(&mut text, group),
        }
    }
    text + "</table></div>\n"
}

/// When the masses are where they are.
pub(in crate::app) fn moment(summary: &Summary) -> &'static str {
    match summary.get("command").and_then(Value::as_str) {
        Some("modes") => "At the equilibrium",
        Some("steady" | "static" | "campbell") => "At the last equilibrium",
        _ => "At the start",
    }
}

/// The name before the number of a repetition.
pub(in crate::app) fn repeated(entry: &Value) -> Option<&str> {
    let (name, _) = entry["name"].as_str()?.split_once('[')?;
    Some(name)
}

fn row(text: &mut String, entry: &Value) {
    let name = match entry["name"].as_str().unwrap_or_default() {
        "" => "<b>all</b>".to_owned(),
        name => escape(name),
    };
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let inertia = |row: usize, column: usize| number(&entry["inertia"][row][column]);
    let size = (0..3).fold(0.0_f64, |most, axis| most.max(inertia(axis, axis).abs()));
    // What is left of a symmetry after round-off is none.
    let shown = |value: f64| digits(if value.abs() < 1e-12 * size { 0.0 } else { value }, 5);
    let diagonal = [0, 1, 2].map(|axis| shown(inertia(axis, axis)));
    let products = [(0, 1), (0, 2), (1, 2)].map(|(row, column)| shown(inertia(row, column)));
    let centre = [0, 1, 2].map(|axis| digits(number(&entry["centre"][axis]), 5));
    let _ = writeln!(
        text,
        "<tr><td>{name}</td><td class=\"n\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
        digits(number(&entry["mass"]), 6),
        centre.join(", "),
        diagonal.join(", "),
        products.join(", "),
    );
}

/// Many bodies of one name: their number and sum.
fn group_row(text: &mut String, group: &[Value]) {
    let masses = group.iter().map(|entry| entry["mass"].as_f64().unwrap_or(f64::NAN));
    let masses: Vec<f64> = masses.collect();
    let (low, high) = masses.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), mass| {
        (low.min(*mass), high.max(*mass))
    });
    let each = if high - low <= 1e-9 * high {
        format!("{} kg each", digits(high, 6))
    } else {
        format!("{} to {} kg each", digits(low, 6), digits(high, 6))
    };
    let _ = writeln!(
        text,
        "<tr><td>{} ({})</td><td class=\"n\">{}</td><td colspan=\"3\">{each}</td></tr>",
        escape(group.first().and_then(repeated).unwrap_or_default()),
        group.len(),
        digits(masses.iter().sum(), 6),
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::{Vector, from_rows};

    fn body(name: &str, mass: f64) -> MassProperties {
        MassProperties {
            name: name.into(),
            mass,
            centre: Vector::new(0.5, 0.0, 0.0),
            inertia: from_rows(&[[1.0, 1e-17, 0.0], [1e-17, 2.0, 0.0], [0.0, 0.0, 2.5]]),
        }
    }

    #[test]
    fn repeated_bodies_share_a_row_and_round_off_is_nothing() {
        let mut summary = Summary::new();
        put(&mut summary, &[]);
        assert!(table(&summary).is_empty());
        put(
            &mut summary,
            &[
                body("hub", 3.0),
                body("arm[0]", 1.0),
                body("arm[1]", 1.0),
                body("", 5.0),
            ],
        );
        let text = table(&summary);
        assert!(
            text.contains("<td>arm (2)</td><td class=\"n\">2</td><td colspan=\"3\">1 kg each</td>"),
            "{text}"
        );
        assert!(text.contains("<td>hub</td>") && text.contains("<b>all</b>"), "{text}");
        assert!(text.contains("<td>1, 2, 2.5</td><td>0, 0, 0</td>"), "{text}");
        assert_eq!(summary["masses"][0]["centre"][0], 0.5);
    }
}
