//! Fixed sparsity patterns in compressed-column form.

use std::any::Any;
use std::sync::{Arc, OnceLock};

/// A sparsity pattern in compressed-column form; rows ascend within a column. Copies share what they hold, and what is found
/// of it.
#[derive(Clone, Debug)]
pub struct Pattern {
    rows: usize,
    starts: Arc<[usize]>,
    indices: Arc<[usize]>,
    found: Arc<Found>,
}

/// What is found of a pattern when it is first asked for.
#[derive(Debug, Default)]
struct Found {
    /// Of how many rows and columns, and these.
    leading: OnceLock<(usize, Pattern)>,
    other: OnceLock<Box<dyn Any + Send + Sync>>,
}

impl PartialEq for Pattern {
    fn eq(&self, other: &Self) -> bool {
        self.rows == other.rows && self.starts == other.starts && self.indices == other.indices
    }
}

impl Eq for Pattern {}

impl Default for Pattern {
    /// Of no rows and columns.
    fn default() -> Self {
        Self::new(0, 0, [])
    }
}

impl Pattern {
    /// The pattern of the given entries `(row, column)`; duplicates are merged.
    ///
    /// # Panics
    /// If an entry lies outside: a defect of the caller, not of a user's model.
    pub fn new(rows: usize, columns: usize, entries: impl IntoIterator<Item = (usize, usize)>) -> Self {
        // The work is compiled once, not for each of fifty kinds of iterators.
        Self::of_list(rows, columns, entries.into_iter().collect())
    }

    fn of_list(rows: usize, columns: usize, entries: Vec<(usize, usize)>) -> Self {
        // Sorted by counting, by rows and then by columns: large scenes have millions of entries, most of them several
        // times.
        let mut row_starts = vec![0; rows + 1];
        for &(row, column) in &entries {
            assert!(
                row < rows && column < columns,
                "entry ({row}, {column}) outside {rows} x {columns}"
            );
            row_starts[row + 1] += 1;
        }
        accumulate(&mut row_starts);
        let mut places = row_starts.clone();
        let mut by_row = vec![0; entries.len()];
        for (row, column) in entries {
            by_row[places[row]] = column;
            places[row] += 1;
        }
        // Each entry once: its column has not seen its row, which would be the last that it saw.
        let mut last = vec![usize::MAX; columns];
        let mut starts = vec![0; columns + 1];
        let mut kept = 0;
        for row in 0..rows {
            let first = kept;
            for place in row_starts[row]..row_starts[row + 1] {
                let column = by_row[place];
                if last[column] != row {
                    last[column] = row;
                    starts[column + 1] += 1;
                    by_row[kept] = column;
                    kept += 1;
                }
            }
            row_starts[row] = first;
        }
        row_starts[rows] = kept;
        accumulate(&mut starts);
        let mut places = starts.clone();
        let mut indices = vec![0; kept];
        for row in 0..rows {
            for &column in &by_row[row_starts[row]..row_starts[row + 1]] {
                indices[places[column]] = row;
                places[column] += 1;
            }
        }
        Self::of(rows, starts, indices)
    }

    fn of(rows: usize, starts: Vec<usize>, indices: Vec<usize>) -> Self {
        Self {
            rows,
            starts: starts.into(),
            indices: indices.into(),
            found: Arc::default(),
        }
    }

    /// What `find` finds of the pattern, which is asked once for all copies. Only one thing is kept.
    ///
    /// # Panics
    /// If something else was found before: a defect of the caller.
    pub(super) fn found<V: Any + Send + Sync>(&self, find: impl FnOnce(&Self) -> V) -> &V {
        let found = self.found.other.get_or_init(|| Box::new(find(self)));
        found.downcast_ref().expect("one type is asked for")
    }

    /// The first `size` rows and columns of a square pattern.
    pub(super) fn leading(&self, size: usize) -> Self {
        if size == self.columns() {
            return self.clone();
        }
        let (known, pattern) = self.found.leading.get_or_init(|| (size, self.cut(size)));
        if *known == size {
            pattern.clone()
        } else {
            self.cut(size)
        }
    }

    fn cut(&self, size: usize) -> Self {
        let (mut starts, mut indices) = (Vec::with_capacity(size + 1), Vec::with_capacity(self.entries()));
        starts.push(0);
        for column in 0..size {
            let own = &self.indices[self.starts[column]..self.starts[column + 1]];
            indices.extend_from_slice(&own[..own.partition_point(|&row| row < size)]);
            starts.push(indices.len());
        }
        Self::of(size, starts, indices)
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

    /// Those of the given rows that have an entry on the diagonal, each with its place.
    pub fn diagonal(&self, rows: impl IntoIterator<Item = usize>) -> impl Iterator<Item = (usize, usize)> {
        rows.into_iter().filter_map(|row| Some((row, self.find(row, row)?)))
    }

    /// Row and column of every entry, in the order of the values.
    pub fn places(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.columns()).flat_map(|column| {
            let own = self.starts[column]..self.starts[column + 1];
            self.indices[own].iter().map(move |&row| (row, column))
        })
    }

    /// As [`Pattern::find`]; tried first is the place behind that of another entry of the column.
    pub fn find_behind(&self, other: Option<usize>, row: usize, column: usize) -> Option<usize> {
        let next = other.map(|other| other + 1);
        let is_it = |&place: &usize| place < self.starts[column + 1] && self.indices[place] == row;
        next.filter(is_it).or_else(|| self.find(row, column))
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

/// Of counts behind a leading zero: the sums up to each.
pub(super) fn accumulate(counts: &mut [usize]) {
    for place in 1..counts.len() {
        counts[place] += counts[place - 1];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_ascend_and_occur_once() {
        let entries = [(2, 1), (0, 3), (2, 1), (0, 1), (3, 0), (2, 3), (0, 1), (2, 1), (0, 3)];
        let pattern = Pattern::new(4, 5, entries);
        assert_eq!(pattern.starts(), [0, 1, 3, 3, 5, 5]);
        assert_eq!(pattern.indices(), [3, 0, 2, 0, 2]);
        assert_eq!((pattern.rows(), pattern.columns(), pattern.entries()), (4, 5, 5));
        assert_eq!(Pattern::new(3, 0, []).starts(), [0]);
        assert_eq!(Pattern::new(0, 2, []).starts(), [0, 0, 0]);
    }

    #[test]
    fn copies_share_what_is_found() {
        let square = || Pattern::new(3, 3, (0..3).flat_map(|i| [(i, i), (i, 0), (0, i)]));
        let (pattern, other) = (square(), square());
        let copy = pattern.clone();
        assert_eq!(pattern, other);
        let count = |pattern: &Pattern| std::ptr::from_ref(pattern.found(Pattern::entries));
        assert_eq!(count(&pattern), count(&copy));
        assert_ne!(count(&pattern), count(&other));
        assert_eq!(count(&pattern.leading(2)), count(&copy.leading(2)));
        // Of another size they are found anew.
        assert_eq!(copy.leading(2), Pattern::new(2, 2, [(0, 0), (1, 1), (1, 0), (0, 1)]));
        assert_eq!(copy.leading(1), Pattern::new(1, 1, [(0, 0)]));
        assert_eq!(copy.leading(3), pattern);
    }

    #[test]
    fn entries_are_found_from_anywhere() {
        let pattern = Pattern::new(5, 2, [(0, 0), (1, 0), (3, 0), (0, 1), (4, 1)]);
        for (row, column) in (0..5).flat_map(|row| [(row, 0), (row, 1)]) {
            let places = (0..pattern.entries()).filter(|place| *place >= pattern.starts()[column]);
            for other in places
                .filter(|place| *place < pattern.starts()[column + 1])
                .map(Some)
                .chain([None])
            {
                assert_eq!(pattern.find_behind(other, row, column), pattern.find(row, column));
            }
        }
    }

    #[test]
    #[should_panic(expected = "entry (4, 1) outside 4 x 5")]
    fn entries_outside_are_refused() {
        Pattern::new(4, 5, [(0, 0), (4, 1)]);
    }
}
