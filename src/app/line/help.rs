//! What the help says of a model.

use super::command::Command;
use crate::AnyModel;
use crate::app::writing::numbers::{in_unit, short};

/// The model in a sentence.
pub(in crate::app) fn about(model: &dyn AnyModel) -> String {
    let doc = model.doc().trim();
    if doc.is_empty() {
        model.name().into()
    } else {
        format!("{}: {doc}", model.name())
    }
}

/// Commands, parameters and outputs; `more` stands at the end.
pub(in crate::app) fn after_help(model: &dyn AnyModel, default: Command, more: &str) -> String {
    let rows = Command::ALL.map(|command| {
        let mark = if command == default { " (default)" } else { "" };
        [command.name().into(), String::new(), format!("{}{mark}", command.doc())]
    });
    let mut text = table("Commands:", rows.to_vec()).trim_start().to_owned();
    let params = model.params();
    let rows = params
        .iter()
        .map(|p| [p.name.into(), in_unit(p, p.default), p.doc.into()]);
    text += &table("Parameters, with defaults:", rows.collect());
    let outputs = model.outputs();
    let unit = |o: &crate::Output| match o.components {
        [] => format!("[{}]", o.unit),
        components => format!("[{}] ({})", o.unit, components.join(", ")),
    };
    let rows = outputs.iter().map(|o| [o.name.into(), unit(o), o.doc.into()]);
    text += &table("Outputs:", rows.collect());
    let run = model.boxed().run();
    let (t_end, every) = (short(run.t_end), short(run.every));
    text += &format!("\nThe model runs to {t_end} s with a row every {every} s.");
    text += more;
    text
}

/// Lines of three columns under a title; nothing without rows.
fn table(title: &str, rows: Vec<[String; 3]>) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let (first, second) = (width(0), width(1));
    let mut text = format!("\n{title}\n");
    for [name, value, doc] in &rows {
        let doc = doc.split_whitespace().collect::<Vec<_>>().join(" ");
        let value = if second > 0 {
            format!("{value:second$}  ")
        } else {
            String::new()
        };
        let line = format!("  {name:first$}  {value}{doc}");
        text += line.trim_end();
        text.push('\n');
    }
    text
}
