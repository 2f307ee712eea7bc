//! The table of outputs: rows over time, or over what is continued of equilibria.

use super::sketch::Sketch;
use crate::app::writing::csv::push_number;
use crate::app::writing::numbers::digits;
use crate::archive::{Archive, Keep};
use crate::{AnyModel, Output};

/// The name of the history.
pub(in crate::app) const HISTORY: &str = "history.csv";

/// Most rows of a table that is written to disk as it grows: those that pictures need.
pub(in crate::app) const SKETCHED: usize = 1 << 13;

/// Values of all outputs, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// First column: `t [s]`; of equilibria `spin [rad/s]`, `load_factor [1]`, or a parameter in its
    /// declared unit.
    pub key: Column,
    /// One column for each component of each output, in the order of the declaration.
    pub columns: Vec<Column>,
    /// Values of the first column in its unit, in the order of the way.
    pub keys: Vec<f64>,
    /// Values row by row, SI; `columns.len()` for each of [`History::keys`].
    pub values: Vec<f64>,
    /// Number of rows met.
    rows: u64,
    /// Smallest and largest value of every column, once a row is met.
    extremes: Vec<(Extreme, Extreme)>,
    /// Thins the rows where the whole table is on disk.
    sketch: Option<Sketch>,
}

/// Head of a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name, with the component for vectors: `tip.x`.
    pub name: String,
    /// Unit of the values: SI but for a parameter in the first column.
    pub unit: &'static str,
}

/// The smallest or largest value of a column.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extreme {
    /// The value, SI.
    pub value: f64,
    /// Where in the first column.
    pub at: f64,
}

impl Keep for Extreme {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { value, at } = self;
        value.keep(archive);
        at.keep(archive);
    }
}

/// The rows; heads are known.
impl Keep for History {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            key: _,
            columns,
            keys,
            values,
            rows,
            extremes,
            sketch,
        } = self;
        keys.keep(archive);
        values.keep(archive);
        rows.keep(archive);
        extremes.keep(archive);
        if let Some(sketch) = sketch {
            sketch.keep(archive);
        }
        if values.len() != keys.len() * columns.len() || !extremes.is_empty() && extremes.len() != columns.len() {
            archive.misfit();
        }
    }
}

impl Column {
    /// The first column of a run in time.
    pub(in crate::app) fn time() -> Self {
        Self {
            name: "t".into(),
            unit: "s",
        }
    }

    /// The head as it stands in files and on axes: `tip.x [m]`.
    pub fn head(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }

    /// A value with its unit, in so many digits: `3.2 m`.
    pub(in crate::app) fn quantity(&self, value: f64, places: usize) -> String {
        let value = digits(value, places);
        match self.unit {
            "1" => value,
            unit => format!("{value} {unit}"),
        }
    }

    /// The same with its name: `load = 3.2 N`.
    pub(in crate::app) fn at(&self, value: f64, places: usize) -> String {
        format!("{} = {}", self.name, self.quantity(value, places))
    }
}

impl History {
    /// An empty table for the outputs of `M`.
    pub(in crate::app) fn new(model: &dyn AnyModel, key: Column) -> Self {
        Self {
            key,
            columns: model.outputs().iter().flat_map(columns).collect(),
            keys: Vec::new(),
            values: Vec::new(),
            rows: 0,
            extremes: Vec::new(),
            sketch: None,
        }
    }

    /// Keeps from now on what pictures need: a bounded number of rows, of which each pair has the least and greatest values
    /// of several.
    pub(in crate::app) fn thin(&mut self) {
        self.sketch = Some(Sketch::new(SKETCHED));
    }

    /// Number of rows of the whole table.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Adds a row.
    ///
    /// # Errors
    /// The first value that is not finite; the row is then left out.
    pub(in crate::app) fn push(&mut self, key: f64, row: &[f64]) -> Result<(), String> {
        if let Some(index) = row.iter().position(|value| !value.is_finite()) {
            return Err(format!(
                "output `{}` is not finite at {} = {key} {}: a function or table in it is outside its range, or a divisor or a section is zero",
                self.columns[index].name, self.key.name, self.key.unit
            ));
        }
        self.rows += 1;
        self.meet(key, row);
        match &mut self.sketch {
            Some(sketch) => sketch.add(&mut self.keys, &mut self.values, key, row),
            None => {
                self.keys.push(key);
                self.values.extend_from_slice(row);
            }
        }
        Ok(())
    }

    /// Takes in values between rows: of these only what is least and greatest is kept. What is not finite counts in rows alone.
    pub(in crate::app) fn meet(&mut self, key: f64, values: &[f64]) {
        let extreme = |&value: &f64| Extreme { value, at: key };
        if self.extremes.is_empty() {
            self.extremes = values.iter().map(|value| (extreme(value), extreme(value))).collect();
        }
        let pairs = self.extremes.iter_mut().zip(values);
        for ((low, high), value) in pairs.filter(|(_, value)| value.is_finite()) {
            if *value < low.value {
                *low = extreme(value);
            }
            if *value > high.value {
                *high = extreme(value);
            }
        }
    }

    /// Values of one column, SI.
    pub fn column(&self, index: usize) -> impl Iterator<Item = f64> + '_ {
        self.values
            .iter()
            .skip(index)
            .step_by(self.columns.len().max(1))
            .copied()
    }

    /// Index of the column with this name, e.g. `v` or `tip.x`.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name == name)
    }

    /// Smallest and largest value of a column, and where they stand; `None` without rows. Of a run in time those of its rows
    /// and, where no row is within a step, of the step's end.
    pub fn extremes(&self, index: usize) -> Option<(Extreme, Extreme)> {
        self.extremes.get(index).copied()
    }

    /// The table as comma-separated text, 17 significant digits.
    pub fn to_csv(&self) -> String {
        let mut text = self.csv_head();
        text.push('\n');
        let width = self.columns.len();
        for (row, &key) in self.keys.iter().enumerate() {
            push_csv(&mut text, key, &self.values[row * width..(row + 1) * width]);
            text.push('\n');
        }
        text
    }

    /// The head line of that text.
    pub(in crate::app) fn csv_head(&self) -> String {
        let heads = self.columns.iter().map(Column::head);
        std::iter::once(self.key.head())
            .chain(heads)
            .collect::<Vec<_>>()
            .join(",")
    }
}

/// Adds a row of comma-separated text.
pub(in crate::app) fn push_csv(text: &mut String, key: f64, row: &[f64]) {
    push_number(text, key);
    for &value in row {
        text.push(',');
        push_number(text, value);
    }
}

fn columns(output: &Output) -> Vec<Column> {
    let column = |name| Column {
        name,
        unit: output.unit,
    };
    if output.components.is_empty() {
        return vec![column(output.name.into())];
    }
    let names = output
        .components
        .iter()
        .map(|suffix| format!("{}.{suffix}", output.name));
    names.map(column).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::Rotor;

    fn table() -> History {
        let mut history = History::new(&Rotor::default(), Column::time());
        history.push(0.0, &[1.0, 2.0, 0.1]).unwrap();
        history.push(0.5, &[-1.0, 2.0, 0.25]).unwrap();
        history
    }

    #[test]
    fn text_has_heads_units_and_as_many_digits_as_needed() {
        let expected = "t [s],tip.x [m],tip.y [m],pull [N]\n\
            0.0,1.0,2.0,0.1\n\
            0.5,-1.0,2.0,0.25\n";
        assert_eq!(table().to_csv(), expected);
    }

    #[test]
    fn every_number_reads_back_to_the_same_bits() {
        let mut history = History::new(&Rotor::default(), Column::time());
        let row = [1.0 / 3.0, -2.0e-308, f64::MAX];
        history.push(0.1 + 0.2, &row).unwrap();
        let text = history.to_csv();
        let read: Vec<f64> = text
            .lines()
            .nth(1)
            .unwrap()
            .split(',')
            .map(|n| n.parse().unwrap())
            .collect();
        assert_eq!(read[0], 0.1 + 0.2);
        assert_eq!(read[1..], row);
    }

    #[test]
    fn extremes_carry_their_times() {
        let (low, high) = table().extremes(0).unwrap();
        assert_eq!((low.value, low.at, high.value, high.at), (-1.0, 0.5, 1.0, 0.0));
        assert_eq!(History::new(&Rotor::default(), Column::time()).extremes(0), None);
        assert_eq!(table().find("tip.y"), Some(1));
    }

    #[test]
    fn a_value_that_is_not_finite_is_refused_by_name() {
        let error = table().push(1.0, &[0.0, f64::NAN, 0.0]).unwrap_err();
        assert_eq!(
            error,
            "output `tip.y` is not finite at t = 1 s: a function or table in it is outside its range, or a divisor or a section is zero"
        );
    }
}
