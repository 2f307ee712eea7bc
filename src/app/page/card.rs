//! The model card of the report: what a reader checks before the results, from the summary.

use std::f64::consts::TAU;
use std::fmt::Write;

use serde_json::{Value, json};

use super::mass_table;
use crate::AnyModel;
use crate::app::equilibria::way::at_the_end;
use crate::app::modal::modes::{Look, first};
use crate::app::results::equilibria::{Equilibria, EquilibriumSettings};
use crate::app::results::modes::growth;
use crate::app::results::run::{RunResult, times};
use crate::app::writing::entries::Summary;
use crate::app::writing::html::escape;
use crate::app::writing::numbers::digits;
use crate::equilibrium::Kind;
use crate::model::{DescribedBody, Fidelity};

/// Unknowns up to which frequencies are cheap beside a run.
const CHEAP: usize = 200;
/// Number of frequencies.
const COUNT: usize = 5;

/// Adds how bodies are described.
pub(in crate::app) fn put_bodies(summary: &mut Summary, bodies: &[DescribedBody]) {
    let entry = |body: &DescribedBody| {
        json!({
            "name": body.name, "repetitions": body.repetitions, "elements": body.elements, "described": how(body.fidelity),
        })
    };
    summary.insert("described_bodies".into(), bodies.iter().map(entry).collect());
}

/// Adds how the bodies of a run are described, and its first frequencies: `first_frequencies`, or why there are none.
pub(in crate::app) fn put(summary: &mut Summary, model: &dyn AnyModel, result: &RunResult) {
    put_bodies(summary, &result.bodies);
    let found = match frequencies(model, result) {
        Ok(found) => found,
        Err(why) => json!({ "none": why }),
    };
    summary.insert("first_frequencies".into(), found);
}

/// Adds the bodies and masses at the last equilibrium, and the first frequencies about it.
pub(in crate::app) fn put_equilibria(summary: &mut Summary, model: &dyn AnyModel, result: &Equilibria) {
    put_bodies(summary, &result.bodies);
    mass_table::put(summary, &result.masses);
    let found = frequencies_at_the_end(model, result).unwrap_or_else(|why| json!({ "none": why }));
    summary.insert("first_frequencies".into(), found);
}

fn how(fidelity: Fidelity) -> String {
    match fidelity {
        Fidelity::Full => "all nodal vectors".into(),
        other => other.to_string(),
    }
}

/// About the equilibrium at the run's end.
fn frequencies(model: &dyn AnyModel, result: &RunResult) -> Result<Value, String> {
    if result.incomplete.is_some() {
        return Err("the run is not complete".into());
    }
    affordable(result.unknowns)?;
    if !result.settings.fidelity.is_empty() {
        return Err("equilibria take the bodies as they are declared, and this run does not".into());
    }
    let (t_end, _) = times(&result.settings);
    let settings = EquilibriumSettings {
        at: Some(t_end),
        count: COUNT,
        judged: result.settings.judged,
        ..EquilibriumSettings::default()
    };
    about(model, &settings, Look::Short)
}

/// About the last of some equilibria.
fn frequencies_at_the_end(model: &dyn AnyModel, result: &Equilibria) -> Result<Value, String> {
    if result.incomplete.is_some() {
        return Err("the way ended early".into());
    }
    affordable(result.unknowns)?;
    let settings = EquilibriumSettings {
        count: COUNT,
        range: None,
        ..result.settings
    };
    let last = at_the_end(model, &result.settings);
    let found = about(last.as_ref(), &settings, Look::Long)?;
    if result.kind == Kind::Static && found["spin"].as_f64() != Some(0.0) {
        return Err(
            "they are known about relative equilibria, and these rest; the command `modes` finds those of the rotation"
                .into(),
        );
    }
    Ok(found)
}

fn affordable(unknowns: usize) -> Result<(), String> {
    if unknowns <= CHEAP {
        return Ok(());
    }
    Err(format!(
        "with {unknowns} unknowns they cost more than a look; the command `modes` finds them"
    ))
}

fn about(model: &dyn AnyModel, settings: &EquilibriumSettings, look: Look) -> Result<Value, String> {
    let found = first(model, settings, look).map_err(|error| match look {
        Look::Short => format!("{error}; the command `modes` looks longer"),
        Look::Long => error.to_string(),
    })?;
    let own: Vec<f64> = found.modes.iter().map(|mode| mode.im).collect();
    if own.is_empty() {
        return Err("no motion is free".into());
    }
    let mut entry = json!({
        "at": found.t, "spin": found.spin, "im [rad/s]": own, "is_unstable": growth(&found.modes).is_some(),
    });
    if let Some(coarse) = found.coarse {
        entry["coarse"] = coarse.into();
    }
    Ok(entry)
}

/// The card; where the summary tells no unknowns, what was chosen alone.
pub(in crate::app) fn part(summary: &Summary, model: &dyn AnyModel) -> String {
    let Some(unknowns) = summary.get("unknowns").and_then(Value::as_u64) else {
        return match chosen(model) {
            chosen if chosen.is_empty() => chosen,
            chosen => format!("<section class=\"card\">\n{chosen}</section>\n"),
        };
    };
    let constraints = summary.get("constraints").and_then(Value::as_u64).unwrap_or(0);
    let mut text = String::from("<section class=\"card\">\n<h2>Model card</h2>\n<table>\n");
    let mut row = |head: &str, told: &str| {
        let _ = writeln!(text, "<tr><th>{head}</th><td>{told}</td></tr>");
    };
    let with = match constraints {
        0 => "no constraints with multipliers".to_owned(),
        1 => "one constraint with a multiplier".to_owned(),
        count => format!("{count} constraints with multipliers"),
    };
    row("Unknowns", &format!("{unknowns}, {with}"));
    if let Some(bodies) = summary.get("described_bodies").and_then(Value::as_array)
        && !bodies.is_empty()
    {
        let told: Vec<String> = bodies.iter().map(body).collect();
        row("Flexible bodies", &told.join("<br>"));
    }
    if let Some(all) = summary
        .get("masses")
        .and_then(Value::as_array)
        .and_then(|masses| masses.last())
    {
        let number = |value: &Value| digits(value.as_f64().unwrap_or(f64::NAN), 6);
        let centre: Vec<String> = (0..3).map(|axis| number(&all["centre"][axis])).collect();
        row(
            "Mass",
            &format!(
                "{} kg, its centre at {} m {}",
                number(&all["mass"]),
                centre.join(", "),
                mass_table::moment(summary).to_lowercase()
            ),
        );
    }
    if let Some(found) = summary.get("first_frequencies") {
        row("First frequencies", &told(found));
    }
    text += "</table>\n";
    text += &mass_table::table(summary);
    text += &chosen(model);
    text + "</section>\n"
}

/// What the macro chose and left out; empty where it did not.
fn chosen(model: &dyn AnyModel) -> String {
    let notes = model.notes();
    if notes.is_empty() {
        return String::new();
    }
    let mut text = String::from("<details><summary>What was chosen and left out, and why</summary>\n<ul>\n");
    for note in notes {
        let _ = writeln!(text, "<li>{}</li>", escape(note));
    }
    text + "</ul></details>\n"
}

/// `beam: 6 elements, all nodal vectors`
fn body(entry: &Value) -> String {
    let name = escape(entry["name"].as_str().unwrap_or_default());
    let elements = entry["elements"].as_u64().unwrap_or(0);
    let described = escape(entry["described"].as_str().unwrap_or_default());
    let count = if elements == 1 {
        "one element".to_owned()
    } else {
        format!("{elements} elements")
    };
    match entry["repetitions"].as_u64() {
        Some(repetitions) => format!("{name}: {repetitions} of them, {count} in all, {described}"),
        None => format!("{name}: {count}, {described}"),
    }
}

/// Frequencies in both units, and about what.
fn told(found: &Value) -> String {
    if let Some(why) = found["none"].as_str() {
        return format!("<span class=\"doc\">Not computed: {}</span>", escape(why));
    }
    let all = found["im [rad/s]"].as_array().map(Vec::as_slice).unwrap_or_default();
    let all: Vec<f64> = all.iter().filter_map(Value::as_f64).collect();
    let joined = |factor: f64| {
        let values: Vec<String> = all.iter().map(|value| digits(value * factor, 5)).collect();
        values.join(", ")
    };
    let (at, spin) = (
        found["at"].as_f64().unwrap_or(0.0),
        found["spin"].as_f64().unwrap_or(0.0),
    );
    let about = if spin == 0.0 {
        format!("about the equilibrium at t = {} s", digits(at, 6))
    } else {
        format!(
            "about the relative equilibrium at t = {} s, which turns with {} rad/s, and seen from it",
            digits(at, 6),
            digits(spin, 6)
        )
    };
    let unstable = if found["is_unstable"] == true {
        "; <b>it is unstable</b>"
    } else {
        ""
    };
    let coarse = found["coarse"].as_str().map_or(String::new(), |coarse| {
        format!("<p class=\"caution\">{}</p>", escape(coarse))
    });
    format!(
        "{} rad/s ({} Hz)<br><span class=\"doc\">{about}{unstable}</span>{coarse}",
        joined(1.0),
        joined(1.0 / TAU)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::page::summary::of_run;
    use crate::app::results::run::RunSettings;
    use crate::app::runs::run::run;
    use crate::app::testing::Rotor;

    fn card(model: &Rotor, settings: &RunSettings) -> (Summary, String) {
        let result = run(model, settings).unwrap();
        let mut summary = of_run(model, &result);
        put(&mut summary, model, &result);
        let text = part(&summary, model);
        (summary, text)
    }

    #[test]
    fn frequencies_stand_with_their_equilibrium() {
        let rotor = Rotor {
            omega: 3.0,
            loss: 0.0,
            ..Rotor::default()
        };
        let (summary, text) = card(&rotor, &RunSettings::default());
        // A spring of 50 N/m and 1 kg in a frame that turns: sqrt(50) -+ 3.
        let own = summary["first_frequencies"]["im [rad/s]"].as_array().unwrap();
        let own: Vec<f64> = own.iter().filter_map(Value::as_f64).collect();
        for (own, wanted) in own.iter().zip([50f64.sqrt() - 3.0, 50f64.sqrt() + 3.0]) {
            assert!((own - wanted).abs() < 1e-9, "{own} {wanted}");
        }
        assert!(text.contains("4.0711, 10.071 rad/s (0.64793, 1.6029 Hz)"), "{text}");
        assert!(text.contains("which turns with 3 rad/s, and seen from it"), "{text}");
        assert!(text.contains("<td>2, no constraints with multipliers</td>"), "{text}");
        assert!(text.contains("<li>The spring has no mass.</li>"), "{text}");
    }

    /// At 5 rad/s the mass of 1 kg rests at 50 * 2 / (50 - 25) m, and the frequencies are sqrt(50) -+ 5.
    #[test]
    fn the_card_of_equilibria_is_about_the_last_of_them() {
        let settings = EquilibriumSettings {
            range: Some(crate::app::Range {
                param: 0,
                from: 1.0,
                to: 5.0,
            }),
            ..EquilibriumSettings::default()
        };
        let rotor = Rotor {
            loss: 0.0,
            ..Rotor::default()
        };
        let result = crate::app::steady(&rotor, &settings).unwrap();
        let mut summary = crate::app::page::summary::of_equilibria(&rotor, &result);
        put_equilibria(&mut summary, &rotor, &result);
        let own = summary["first_frequencies"]["im [rad/s]"].as_array().unwrap();
        let own: Vec<f64> = own.iter().filter_map(Value::as_f64).collect();
        for (own, wanted) in own.iter().zip([50f64.sqrt() - 5.0, 50f64.sqrt() + 5.0]) {
            assert!((own - wanted).abs() < 1e-9, "{own} {wanted}");
        }
        assert!(part(&summary, &rotor).contains("which turns with 5 rad/s"));
    }

    #[test]
    fn where_there_is_no_equilibrium_the_card_says_why() {
        let rotor = Rotor {
            fail_at: 2.0,
            ..Rotor::default()
        };
        let settings = RunSettings {
            t_end: Some(1.0),
            ..RunSettings::default()
        };
        let result = run(&rotor, &settings).unwrap();
        let broken = Rotor {
            stiffness: 2.0 * 9.0,
            ..rotor
        };
        // The spring's stiffness is that of the rotation: nothing holds the mass.
        let mut summary = of_run(&broken, &result);
        put(&mut summary, &broken, &result);
        let why = summary["first_frequencies"]["none"].as_str().unwrap().to_owned();
        assert!(!why.is_empty());
        assert!(part(&summary, &broken).contains("Not computed: "), "{why}");
    }
}
