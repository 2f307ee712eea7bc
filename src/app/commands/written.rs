//! The files that every command writes: its table, the summary and the report.

use crate::app::line::arguments::Arguments;
use crate::app::machine::files;
use crate::app::page::{report, summary};
use crate::app::results::failure::{FAILURE, Failure};
use crate::app::writing::entries::{Summary, to_text};

/// Writes the table, the summary and the report; their paths, one a line.
pub(in crate::app) fn write(
    arguments: &Arguments,
    what: &str,
    (name, table): (&str, String),
    summary: &Summary,
    part: Result<String, String>,
) -> Result<String, Failure> {
    files::write(&arguments.out, name, &table).map_err(|text| Failure::new(FAILURE, text))?;
    let told = write_told(arguments, what, summary, part)?;
    Ok(format!("  {}\n{told}", arguments.out.join(name).display()))
}

/// Writes the summary and the report.
pub(in crate::app) fn write_told(
    arguments: &Arguments,
    what: &str,
    summary: &Summary,
    part: Result<String, String>,
) -> Result<String, Failure> {
    let written = || {
        let mut summary = summary.clone();
        summary::command_line(&mut summary, &arguments.line);
        let page = report::page(arguments.model(), what, &summary, &part?);
        let contents = [("summary.json", to_text(&summary)), ("report.html", page)];
        let mut paths = Vec::new();
        for (name, text) in contents {
            files::write(&arguments.out, name, &text)?;
            paths.push(format!("  {}", arguments.out.join(name).display()));
        }
        Ok(paths.join("\n"))
    };
    written().map_err(|text: String| Failure::new(FAILURE, text))
}
