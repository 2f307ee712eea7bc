//! Cautions of a model: sentences that stand with the results that they are about.

use std::fmt::Write;

use super::report::escape;
use crate::{AnyModel, Caution, Warning};

/// Each caution in one sentence, with the outputs that it is about before it.
pub(super) fn sentences(model: &dyn AnyModel, cautions: &[Caution]) -> Vec<String> {
    let sentence = |caution: &Caution| {
        let names = caution.outputs.iter().filter_map(|&index| model.outputs().get(index));
        let names: Vec<&str> = names.map(|output| output.name).collect();
        match names[..] {
            [] => caution.text.to_string(),
            _ => format!("{}: {}", names.join(", "), caution.text),
        }
    };
    cautions.iter().map(sentence).collect()
}

/// What a model says of equilibria and modes, before what the scene warns of.
pub(super) fn cautioned(model: &dyn AnyModel, warnings: Vec<Warning>) -> Vec<String> {
    let mut all = sentences(model, &model.cautions(0.0));
    all.extend(texts(warnings));
    all
}

/// The sentences of warnings.
pub(super) fn texts(warnings: Vec<Warning>) -> Vec<String> {
    warnings.into_iter().map(|warning| warning.text).collect()
}

/// Adds a warning, or puts it in the place of one that differs in its numbers only and weighs less.
pub(super) fn meet(warnings: &mut Vec<Warning>, warning: Warning) {
    let words = without_numbers(&warning.text);
    match warnings.iter_mut().find(|given| without_numbers(&given.text) == words) {
        Some(given) if warning.weight > given.weight => *given = warning,
        Some(_) => {}
        None => warnings.push(warning),
    }
}

/// The first `most` of some parts of a sentence, and how many more there are; `None` without any.
pub(super) fn listed(parts: &[String], most: usize) -> Option<String> {
    let shown = parts[..parts.len().min(most)].join(", ");
    match parts.len().saturating_sub(most) {
        _ if parts.is_empty() => None,
        0 => Some(shown),
        more => Some(format!("{shown}, and {more} more")),
    }
}

/// What stays of a warning from row to row.
fn without_numbers(text: &str) -> String {
    text.chars()
        .filter(|c| !(c.is_ascii_digit() || "-.".contains(*c)))
        .collect()
}

/// What stands below the chart of an output, as paragraphs of the page.
pub(super) fn below(cautions: &[Caution], output: usize) -> String {
    paragraphs(cautions.iter().filter(|caution| caution.outputs.contains(&output)))
}

/// What stands above all charts.
pub(super) fn above(cautions: &[Caution]) -> String {
    paragraphs(cautions.iter().filter(|caution| caution.outputs.is_empty()))
}

fn paragraphs<'a>(cautions: impl Iterator<Item = &'a Caution>) -> String {
    let mut text = String::new();
    for caution in cautions {
        let _ = writeln!(text, "<p class=\"caution\">{}</p>", escape(caution.text));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::report::run_part;
    use super::super::summary;
    use super::super::testing::Rotor;
    use super::super::{RunSettings, run};
    use crate::AnyModel;

    #[test]
    fn a_caution_stands_where_its_condition_holds() {
        let settings = RunSettings {
            t_end: Some(0.5),
            ..RunSettings::default()
        };
        let calm = run(&Rotor::default(), &settings).unwrap();
        assert!(calm.cautions.is_empty() && calm.warnings.is_empty());
        let rotor = Rotor {
            coils: 7,
            ..Rotor::default()
        };
        let result = run(&rotor, &settings).unwrap();
        let sentence = format!("{}: seven coils touch <each other>", Rotor::default().outputs()[0].name);
        // The warnings of the scene itself follow.
        assert_eq!(result.warnings[..2], [sentence.clone(), "seven is many".into()]);
        let summary = summary::of_run(&rotor, &result);
        assert_eq!(summary["notes"][1], sentence.as_str());
        let page = run_part(&Rotor::default(), &result, None).unwrap();
        let chart = "<p class=\"caution\">seven coils touch &lt;each other&gt;</p>";
        assert_eq!(page.matches(chart).count(), 1);
        let figure = page.find("</figure>").unwrap();
        assert!(page.find(chart).unwrap() < figure);
        assert!(page.starts_with("<p class=\"caution\">seven is many</p>"));
    }
}
