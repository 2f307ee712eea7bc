//! Fixed sparsity patterns in compressed-column form.

/// A sparsity pattern in compressed-column form; rows ascend within a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    rows: usize,
    starts: Vec<usize>,
    indices: Vec<usize>,
}

impl Pattern {
    /// The pattern of the given entries `(row, column)`; duplicates are merged.
    ///
    /// # Panics
    /// If an entry lies outside: a defect of the caller, not of a user's model.
    pub fn new(rows: usize, columns: usize, entries: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut entries: Vec<(usize, usize)> = entries.into_iter().map(|(row, column)| (column, row)).collect();
        entries.sort_unstable();
        entries.dedup();
        let mut starts = vec![0; columns + 1];
        for &(column, row) in &entries {
            assert!(
                row < rows && column < columns,
                "entry ({row}, {column}) outside {rows} x {columns}"
            );
            starts[column + 1] += 1;
        }
        for column in 0..columns {
            starts[column + 1] += starts[column];
        }
        Self {
            rows,
            starts,
            indices: entries.into_iter().map(|(_, row)| row).collect(),
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of stored entries.
    pub fn entries(&self) -> usize {
        self.indices.len()
    }

    /// Start of every column in [`Pattern::indices`], and the number of entries at the end.
    pub fn starts(&self) -> &[usize] {
        &self.starts
    }

    /// Row of every entry, column after column.
    pub fn indices(&self) -> &[usize] {
        &self.indices
    }

    /// Place of the entry `(row, column)`, if stored.
    pub fn find(&self, row: usize, column: usize) -> Option<usize> {
        let (start, end) = (self.starts[column], self.starts[column + 1]);
        self.indices[start..end]
            .binary_search(&row)
            .ok()
            .map(|place| start + place)
    }

    /// `out += alpha * A x` with the values of A on this pattern.
    pub fn multiply_add(&self, alpha: f64, values: &[f64], x: &[f64], out: &mut [f64]) {
        for (ends, x) in self.starts.windows(2).zip(x) {
            let factor = alpha * x;
            let own = ends[0]..ends[1];
            for (&row, value) in self.indices[own.clone()].iter().zip(&values[own]) {
                out[row] += value * factor;
            }
        }
    }

    /// `out += alpha * A^T x` with the values of A on this pattern.
    pub fn transpose_multiply_add(&self, alpha: f64, values: &[f64], x: &[f64], out: &mut [f64]) {
        for column in 0..self.columns() {
            let mut sum = 0.0;
            for place in self.starts[column]..self.starts[column + 1] {
                sum += values[place] * x[self.indices[place]];
            }
            out[column] += alpha * sum;
        }
    }
}
