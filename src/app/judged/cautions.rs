//! Cautions of a model: sentences that stand with the results that they are about.

use crate::{AnyModel, Caution, Warning};

/// Each caution in one sentence, with the outputs that it is about before it.
pub(in crate::app) fn sentences(model: &dyn AnyModel, cautions: &[Caution]) -> Vec<String> {
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
pub(in crate::app) fn cautioned(model: &dyn AnyModel, warnings: Vec<Warning>) -> Vec<String> {
    let mut all = sentences(model, &model.cautions(0.0));
    all.extend(texts(warnings));
    all
}

/// The sentences of warnings.
pub(in crate::app) fn texts(warnings: Vec<Warning>) -> Vec<String> {
    warnings.into_iter().map(|warning| warning.text).collect()
}

/// Adds a warning, or puts it in the place of one that differs in its numbers only and weighs less.
pub(in crate::app) fn meet(warnings: &mut Vec<Warning>, warning: Warning) {
    let words = without_numbers(&warning.text);
    match warnings.iter_mut().find(|given| without_numbers(&given.text) == words) {
        Some(given) if warning.weight > given.weight => *given = warning,
        Some(_) => {}
        None => warnings.push(warning),
    }
}

/// What stays of a warning from row to row.
fn without_numbers(text: &str) -> String {
    text.chars()
        .filter(|c| !(c.is_ascii_digit() || "-.".contains(*c)))
        .collect()
}
