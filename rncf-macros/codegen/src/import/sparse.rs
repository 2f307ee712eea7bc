//! Square sparse matrices, row by row.

/// A square matrix.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sparse {
    /// Of every row the columns, ascending, with their values; what is zero is left out.
    pub rows: Vec<Vec<(usize, f64)>>,
}

impl Sparse {
    /// From entries in any order; those of one place are added.
    pub fn new(size: usize, entries: impl IntoIterator<Item = (usize, usize, f64)>) -> Self {
        let mut rows = vec![Vec::new(); size];
        for (row, column, value) in entries {
            if value != 0.0 {
                rows[row].push((column, value));
            }
        }
        for row in &mut rows {
            row.sort_by_key(|&(column, _)| column);
            row.dedup_by(|next, kept| {
                let is_same = next.0 == kept.0;
                if is_same {
                    kept.1 += next.1;
                }
                is_same
            });
        }
        Self { rows }
    }

    /// From all entries, rows first.
    pub fn dense(size: usize, values: &[f64]) -> Self {
        let entries = values.iter().enumerate();
        Self::new(size, entries.map(|(at, value)| (at / size, at % size, *value)))
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.rows.len()
    }

    /// An entry.
    pub fn at(&self, row: usize, column: usize) -> f64 {
        let own = &self.rows[row];
        own.binary_search_by_key(&column, |&(column, _)| column)
            .map_or(0.0, |place| own[place].1)
    }

    /// `A x`
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let row = |row: &Vec<(usize, f64)>| row.iter().map(|&(column, value)| value * x[column]).sum();
        self.rows.iter().map(row).collect()
    }

    /// Whether it is finite, symmetric to `round_off`, and nowhere negative on its diagonal.
    ///
    /// # Errors
    /// What is wrong, after `name`.
    pub fn check(&self, name: &str, round_off: f64) -> Result<(), String> {
        for (row, entries) in self.rows.iter().enumerate() {
            for &(column, value) in entries {
                let place = format!("in row {}, column {}", row + 1, column + 1);
                if !value.is_finite() {
                    return Err(format!("{name} has a value that is not finite {place}"));
                }
                let other = self.at(column, row);
                // Against what both rows hold: small entries of large ones are differences.
                let size = self
                    .at(row, row)
                    .abs()
                    .max(self.at(column, column).abs())
                    .max(value.abs());
                if (value - other).abs() > round_off * size {
                    return Err(format!(
                        "{name} is not symmetric: {value:e} {place}, and {other:e} across the diagonal"
                    ));
                }
                if row == column && value < 0.0 {
                    return Err(format!(
                        "{name} has {value:e} on its diagonal {place}, and no body has that"
                    ));
                }
            }
        }
        Ok(())
    }
}
