//! Tables of numbers in CSV: a line of names with units, `x [m], EI [N*m^2]`, and lines of numbers. What a unit is, and in which
//! words a mistake is told, is left to whom they are read for.

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
    /// The others with their numbers in the text, from 1 on.
    lines: Vec<(usize, Vec<&'t str>)>,
}

/// Why a text is no table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mistake<'t> {
    /// No line but empty ones and comments.
    Empty,
    /// A line has not as many cells as the first one.
    Cells {
        /// Number of the line.
        line: usize,
        /// Number of its cells.
        cells: usize,
        /// Number of those of the first one.
        heads: usize,
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

impl<'t> Rows<'t> {
    /// The lines of a text without empty ones and those that begin with `#`.
    ///
    /// # Errors
    /// [`Mistake::Empty`] and [`Mistake::Cells`].
    pub fn read(text: &'t str) -> Result<Self, Mistake<'t>> {
        let text = text.trim_start_matches('\u{feff}');
        let mut lines = (text.lines().enumerate())
            .map(|(at, line)| (at + 1, line.trim()))
            .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
            .map(|(number, line)| (number, line.split(',').map(str::trim).collect::<Vec<_>>()));
        let (_, first) = lines.next().ok_or(Mistake::Empty)?;
        let lines: Vec<_> = lines.collect();
        if let Some((line, cells)) = lines.iter().find(|(_, cells)| cells.len() != first.len()) {
            return Err(Mistake::Cells {
                line: *line,
                cells: cells.len(),
                heads: first.len(),
            });
        }
        let head = |cell: &'t str| match cell.split_once('[') {
            Some((name, unit)) => Head {
                name: name.trim(),
                unit: unit.trim_end_matches(']').trim(),
            },
            None => Head { name: cell, unit: "" },
        };
        Ok(Self {
            heads: first.into_iter().map(head).collect(),
            lines,
        })
    }

    /// Number in the text of a row's line.
    pub fn line(&self, row: usize) -> usize {
        self.lines[row].0
    }

    /// Values of some columns, each by its place in the first line; `number` makes one of the cell of such a column.
    ///
    /// # Errors
    /// [`Mistake::Number`] at the first cell of which it makes none, or no finite one.
    pub fn columns(
        &self,
        wanted: &[usize],
        number: impl Fn(usize, &str) -> Option<f64>,
    ) -> Result<Vec<Vec<f64>>, Mistake<'t>> {
        let mut columns = vec![Vec::with_capacity(self.lines.len()); wanted.len()];
        for (line, cells) in &self.lines {
            for (at, (&place, column)) in wanted.iter().zip(&mut columns).enumerate() {
                let cell = cells[place];
                let value = number(at, cell).filter(|value| value.is_finite());
                column.push(value.ok_or(Mistake::Number {
                    line: *line,
                    name: self.heads[place].name,
                    cell,
                })?);
            }
        }
        Ok(columns)
    }
}

impl Head<'_> {
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
