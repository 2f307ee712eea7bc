//! The compiler's report as text: `.stderr` files.

/// One error.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Report {
    /// The line of the program.
    pub line: String,
    /// The text above the `^`s.
    pub underlined: String,
    /// What follows `error: `.
    pub message: String,
}

/// All errors of a report, sorted.
///
/// ```text
/// error: unknown unit `Gpa`: did you mean `GPa`?
///  --> compile_fail/units/unknown.rs
///   |
///   |         material steel { young = 210 Gpa; }
///   |                                      ^^^
/// ```
pub fn reports(stderr: &str) -> Vec<Report> {
    let mut reports: Vec<Report> = stderr.split("\n\n").filter_map(report).collect();
    reports.sort();
    reports
}

/// One error; `None` for a block that is none.
fn report(block: &str) -> Option<Report> {
    let lines: Vec<&str> = block.trim_start().lines().collect();
    let message = lines
        .first()?
        .strip_prefix("error")?
        .trim_start_matches(": ")
        .to_string();
    let carets = lines
        .iter()
        .position(|line| line.trim_matches([' ', '|', '^']).is_empty() && line.contains('^'))?;
    let (_, source) = lines[carets - 1].split_once("| ")?;
    let shift = lines[carets].find("| ")? + 2;
    let mark = &lines[carets][shift..];
    let (from, count) = (mark.find('^')?, mark.matches('^').count());
    Some(Report {
        line: source.trim().to_string(),
        underlined: source.chars().skip(from).take(count).collect(),
        message,
    })
}

/// A report as it stands in the files: without numbers of lines, summary and the empty line at the end.
pub fn without_numbers(report: &str) -> String {
    let end = report.find("error: aborting due to").unwrap_or(report.len());
    let mut text = String::new();
    for line in report[..end].trim_end().lines() {
        let rest = line.trim_start_matches(|letter: char| letter == ' ' || letter.is_ascii_digit());
        match rest.strip_prefix("--> ") {
            Some(place) => {
                let file = place.split_once(':').map_or(place, |(file, _)| file);
                text += &format!(" --> {file}");
            }
            None if rest.starts_with('|') => text += &format!("  {rest}"),
            None => text += line,
        }
        text.push('\n');
    }
    text
}
