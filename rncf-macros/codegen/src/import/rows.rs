//! Tables of numbers in CSV: a line of names with units, `x [m], EI [N*m^2]`, and lines of numbers. What a unit is, is left to whom
//! they are read for.

use std::fmt;
use std::path::Path;

/// Part of the entries on the diagonal by which the two triangles of a symmetric matrix may differ.
const ROUND_OFF: f64 = 1e-12;

/// Whether two numbers for one entry of a symmetric matrix differ by more than the arithmetic that made it; `diagonal` has the entries in its row and column.
pub fn beyond_round_off([one, other]: [f64; 2], [i, j]: [f64; 2]) -> bool {
    (one - other).abs() > ROUND_OFF * (i * j).abs().sqrt()
}

/// A cell of the first line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Head<'t> {
    /// Name of the column.
    pub name: &'t str,
    /// What stands in brackets behind it, or nothing.
    pub unit: &'t str,
}

/// A text that is a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows<'t> {
    /// The first line.
    pub heads: Vec<Head<'t>>,
    /// Numbers of the other lines in the text, from 1 on.
    lines: Vec<usize>,
    /// Their cells, as many a line as there are heads.
    cells: Vec<&'t str>,
}

/// Why a text is no table, told as a sentence that stands behind the name of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mistake<'t> {
    /// No line but empty ones and comments.
    Empty,
    /// A cell of the first line is a number.
    NoNames {
        /// Number of the line.
        line: usize,
        /// The cell.
        cell: &'t str,
    },
    /// A cell of the first line is empty.
    NoName {
        /// Number of the line.
        line: usize,
        /// Number of the cell, from 1 on.
        column: usize,
    },
    /// A cell of the first line is no name with a unit.
    Head {
        /// Number of the line.
        line: usize,
        /// The cell.
        cell: &'t str,
    },
    /// A quotation mark is not closed where its line ends.
    Quote {
        /// Number of the line.
        line: usize,
    },
    /// A line has not as many cells as the first one.
    Cells {
        /// Number of the line.
        line: usize,
        /// Number of its cells.
        cells: usize,
        /// Number of those of the first one.
        heads: usize,
        /// What stands between cells.
        separator: char,
    },
    /// A cell is no number.
    Number {
        /// Number of the line.
        line: usize,
        /// Name of the column.
        name: &'t str,
        /// The cell.
        cell: &'t str,
    },
}

/// Why places of rows are none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Disorder {
    /// There are less than two.
    TooFew,
    /// A row does not follow the one before.
    Order(usize),
    /// The first two or the last two are at one place.
    StepAtEnd,
}

/// The text of a file; `start` says where paths begin.
///
/// # Errors
/// Why it cannot be read and what to do, as the end of a sentence.
pub fn text(path: &Path, start: &str) -> Result<String, String> {
    String::from_utf8(super::bytes(path, start)?).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
        format!("line {line} is no text in UTF-8; save the file as UTF-8")
    })
}

impl<'t> Rows<'t> {
    /// The lines of a text without empty ones and those that begin with `#`. Between cells stand semicolons or tabs, if the first line
    /// has any, or else commas. A cell may stand in double quotes; empty cells behind the last column are left out.
    ///
    /// # Errors
    /// All but [`Mistake::Number`].
    pub fn read(text: &'t str) -> Result<Self, Mistake<'t>> {
        let text = text.trim_start_matches('\u{feff}');
        // Old files end their lines with a carriage return alone.
        let end = if text.contains('\n') { '\n' } else { '\r' };
        let mut lines = (text.split(end).enumerate())
            .map(|(at, line)| (at + 1, line.trim_end_matches('\r')))
            .filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with('#'));
        let (line, first) = lines.next().ok_or(Mistake::Empty)?;
        let separator = [';', '\t']
            .into_iter()
            .find(|&mark| first.contains(mark))
            .unwrap_or(',');
        let mut heads = Vec::new();
        split(first, separator, &mut heads).ok_or(Mistake::Quote { line })?;
        while heads.pop_if(|head| head.is_empty()).is_some() {}
        match heads[..] {
            [] => return Err(Mistake::NoName { line, column: 1 }),
            // Blanks stand between the columns.
            [cell] if cell.contains(char::is_whitespace) && !cell.contains('[') => {
                return Err(Mistake::Head { line, cell });
            }
            _ => {}
        }
        let heads: Result<Vec<_>, _> = (heads.into_iter().enumerate())
            .map(|(at, cell)| Head::read(cell, line, at + 1))
            .collect();
        let mut rows = Self {
            heads: heads?,
            lines: Vec::new(),
            cells: Vec::new(),
        };
        let mut cells = Vec::new();
        for (line, text) in lines {
            cells.clear();
            split(text, separator, &mut cells).ok_or(Mistake::Quote { line })?;
            while cells.len() > rows.heads.len() && cells.pop_if(|cell| cell.is_empty()).is_some() {}
            if cells.iter().all(|cell| cell.is_empty()) {
                continue;
            }
            if cells.len() != rows.heads.len() {
                return Err(Mistake::Cells {
                    line,
                    cells: cells.len(),
                    heads: rows.heads.len(),
                    separator,
                });
            }
            rows.lines.push(line);
            rows.cells.append(&mut cells);
        }
        Ok(rows)
    }

    /// Number in the text of a row's line.
    pub fn line(&self, row: usize) -> usize {
        self.lines[row]
    }

    /// Values of some columns, each by its place in the first line; `number` makes one of the cell of such a column, which is a decimal
    /// number.
    ///
    /// # Errors
    /// [`Mistake::Number`] at the first cell that is none, or of which it makes none, no finite one, or zero where it is not.
    pub fn columns(
        &self,
        wanted: &[usize],
        number: impl Fn(usize, &str) -> Option<f64>,
    ) -> Result<Vec<Vec<f64>>, Mistake<'t>> {
        let mut columns = vec![Vec::with_capacity(self.lines.len()); wanted.len()];
        for (&line, cells) in self.lines.iter().zip(self.cells.chunks_exact(self.heads.len())) {
            for (at, (&place, column)) in wanted.iter().zip(&mut columns).enumerate() {
                let cell = cells[place];
                let mistake = Mistake::Number {
                    line,
                    name: self.heads[place].name,
                    cell,
                };
                let mantissa = decimal(cell).ok_or(mistake)?;
                let is_kept = |value: &f64| {
                    value.is_finite() && (*value != 0.0 || !mantissa.contains(|digit| ('1'..='9').contains(&digit)))
                };
                column.push(number(at, cell).filter(is_kept).ok_or(mistake)?);
            }
        }
        Ok(columns)
    }
}

/// The cells of a line; `None`: a quotation mark is not closed.
fn split<'t>(line: &'t str, separator: char, cells: &mut Vec<&'t str>) -> Option<()> {
    if !line.contains('"') {
        cells.extend(line.split(separator).map(str::trim));
        return Some(());
    }
    let (mut start, mut is_quoted, mut is_new) = (0, false, true);
    for (at, mark) in line.char_indices() {
        if mark == '"' && (is_new || is_quoted) {
            is_quoted = !is_quoted;
            // Two of them inside are one that belongs to the text.
            is_new = !is_quoted && line[at + 1..].starts_with('"');
        } else if mark == separator && !is_quoted {
            cells.push(unquoted(&line[start..at]));
            start = at + mark.len_utf8();
            is_new = true;
        } else {
            is_new &= mark == ' ';
        }
    }
    cells.push(unquoted(&line[start..]));
    (!is_quoted).then_some(())
}

fn unquoted(cell: &str) -> &str {
    let cell = cell.trim();
    let inside = cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"'));
    inside.unwrap_or(cell).trim()
}

/// The digits of a decimal number with their point, without sign and exponent.
fn decimal(cell: &str) -> Option<&str> {
    let unsigned = cell.strip_prefix(['+', '-']).unwrap_or(cell);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (unsigned, None),
    };
    let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let is_exponent = |text: &str| {
        let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
        !digits.is_empty() && are_digits(digits)
    };
    let is_whole = are_digits(whole) && are_digits(part) && whole.len() + part.len() > 0;
    (is_whole && exponent.is_none_or(is_exponent)).then_some(mantissa)
}

impl<'t> Head<'t> {
    fn read(cell: &'t str, line: usize, column: usize) -> Result<Self, Mistake<'t>> {
        if cell.is_empty() {
            return Err(Mistake::NoName { line, column });
        }
        if decimal(cell).is_some() {
            return Err(Mistake::NoNames { line, cell });
        }
        let Some((name, unit)) = cell.split_once('[') else {
            // Other programs write units in parentheses.
            return match cell.ends_with(')') && !cell.starts_with('_') {
                true => Err(Mistake::Head { line, cell }),
                false => Ok(Self { name: cell, unit: "" }),
            };
        };
        match unit.strip_suffix(']') {
            Some(unit) if !unit.contains(['[', ']']) && !unquoted(name).is_empty() => Ok(Self {
                name: unquoted(name),
                unit: unit.trim(),
            }),
            _ => Err(Mistake::Head { line, cell }),
        }
    }

    /// Whether the column is a note, which nothing reads.
    pub fn is_note(&self) -> bool {
        self.name.starts_with('_')
    }

    /// The unit as the language writes it: nothing of a plain number, and `inch` for `in`, which is a word of Rust.
    pub fn spelled(&self) -> String {
        if ["-", "1"].contains(&self.unit) {
            return String::new();
        }
        let words = self.unit.split_inclusive(|c: char| !c.is_alphanumeric());
        let spelled = words.map(|word| match word.strip_prefix("in") {
            Some(rest) if !rest.starts_with(char::is_alphanumeric) => format!("inch{rest}"),
            _ => word.to_string(),
        });
        spelled.collect()
    }
}

impl fmt::Display for Mistake<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Mistake::Empty => write!(f, "it is empty; its first line names the columns, `x [m], EI [N*m^2]`"),
            Mistake::NoNames { line, cell } => write!(
                f,
                "line {line}: `{cell}` is no name of a column; the first line that is no comment names the columns, `x [m], EI [N*m^2]`"
            ),
            Mistake::NoName { line, column } => write!(
                f,
                "line {line}: column {column} has no name; take it out, or call it `_` and what it is, which is not read"
            ),
            Mistake::Head { line, cell } => write!(
                f,
                "line {line}: `{cell}` is no name with a unit, `EI [N*m^2]`; between columns stand commas, semicolons or tabs"
            ),
            Mistake::Quote { line } => write!(f, "line {line}: a quotation mark is not closed in this line"),
            Mistake::Cells {
                line,
                cells,
                heads,
                separator,
            } => {
                let marks = match separator {
                    ';' => "semicolons",
                    '\t' => "tabs",
                    _ => "commas",
                };
                write!(
                    f,
                    "line {line} has {cells} cells, and the header {heads} columns; give each column its cell, with {marks} between them and points in decimals"
                )
            }
            Mistake::Number { line, name, cell: "" } => write!(
                f,
                "line {line}: there is nothing in column `{name}`; give every row its number"
            ),
            Mistake::Number { line, name, cell } => {
                write!(
                    f,
                    "line {line}: `{cell}` in column `{name}` is no finite number{}",
                    cure(cell)
                )
            }
        }
    }
}

/// What is usually meant by a cell that is no number.
fn cure(cell: &str) -> &'static str {
    let is_decimal = |other: String| decimal(&other).is_some();
    let first = cell.split_whitespace().next().unwrap_or(cell);
    if decimal(cell).is_some() {
        "; it is too large or too small"
    } else if is_decimal(cell.replacen(',', ".", 1)) {
        "; decimals have a point"
    } else if is_decimal(cell.replacen(['d', 'D'], "e", 1)) {
        "; an exponent is written with `e`"
    } else if is_decimal(cell.replacen('\u{2212}', "-", 1)) {
        "; its sign is no `-`"
    } else if cell.contains('#') {
        "; a comment has a line of its own"
    } else if first.len() < cell.len() && decimal(first).is_some() {
        "; units stand in the header, and between cells commas, semicolons or tabs"
    } else {
        ""
    }
}

/// Checks places of rows: they ascend, and two at one place are a step, which points in space have not and which stands between others.
///
/// # Errors
/// The first row that is out of order.
pub fn in_order(places: &[f64], is_points: bool) -> Result<(), Disorder> {
    if places.len() < 2 {
        return Err(Disorder::TooFew);
    }
    for at in 1..places.len() {
        let is_step = places[at] == places[at - 1] && !is_points && (at < 2 || places[at] > places[at - 2]);
        if !(places[at] > places[at - 1] || is_step) {
            return Err(Disorder::Order(at));
        }
    }
    match places[0] == places[1] || places[places.len() - 1] == places[places.len() - 2] {
        true => Err(Disorder::StepAtEnd),
        false => Ok(()),
    }
}

/// Sums of the chords between points, as parts of the whole.
pub fn chords([x, y, z]: [&[f64]; 3]) -> Vec<f64> {
    let mut places = vec![0.0];
    for at in 1..x.len() {
        let chord = (x[at] - x[at - 1]).hypot(y[at] - y[at - 1]).hypot(z[at] - z[at - 1]);
        places.push(places[at - 1] + chord);
    }
    let last = places.len() - 1;
    let whole = places[last];
    for place in &mut places {
        *place /= whole;
    }
    places[last] = 1.0;
    places
}
