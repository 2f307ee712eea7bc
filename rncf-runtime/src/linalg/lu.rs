//! LU factorization of a square matrix on a fixed pattern, equilibrated by rows and columns.

use super::Pattern;
use super::banded::Banded;
use super::order::{half_bandwidth, reverse_cuthill_mckee};
use super::scalar::Scalar;
use super::sparse::Sparse;

/// Pivots of the equilibrated matrix up to here are round-off of its entries, which are at most 1.
const SMALLEST_PIVOT: f64 = 8.0 * f64::EPSILON;

/// Half-bandwidth up to which the banded factorization is used; with this and fewer unknowns a
/// full matrix is a banded one.
const LARGEST_BANDWIDTH: usize = 40;

/// LU factorization with partial pivoting of a square matrix on a fixed pattern, in the field `T`
/// (`f64` or `c64`). Narrow matrices (chains of elements) are factored as banded ones, others by
/// faer. The pattern is analysed once; later calls do not allocate (faer's may, when the pivots
/// change).
#[derive(Debug)]
pub struct Lu<T> {
    pattern: Pattern,
    factors: Factors<T>,
    /// Place of every unknown in the order of elimination.
    place: Vec<usize>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    work: Vec<T>,
}

#[derive(Debug)]
enum Factors<T> {
    /// Banded, and the place of every entry of the pattern in it.
    Banded(Banded<T>, Vec<usize>),
    Sparse(Box<Sparse<T>>),
}

impl<T: Scalar> Lu<T> {
    /// Analyses a square pattern.
    ///
    /// # Panics
    /// If the pattern is not square: a defect of the caller.
    pub fn new(pattern: &Pattern) -> Self {
        Self::with_bandwidth_limit(pattern, LARGEST_BANDWIDTH)
    }

    fn with_bandwidth_limit(pattern: &Pattern, limit: usize) -> Self {
        assert_eq!(pattern.rows(), pattern.columns(), "the pattern is square");
        let size = pattern.columns();
        let mut place = vec![0; size];
        for (new, &old) in reverse_cuthill_mckee(pattern).iter().enumerate() {
            place[old] = new;
        }
        let half = half_bandwidth(pattern, &place);
        let sparse = if half > limit { Sparse::new(pattern) } else { None };
        let (factors, work) = match sparse {
            Some(sparse) => (Factors::Sparse(Box::new(sparse)), size.max(pattern.entries())),
            None => {
                let banded = Banded::new(size, half);
                let places = (0..size)
                    .flat_map(|column| {
                        pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]]
                            .iter()
                            .map(move |&row| (row, column))
                    })
                    .map(|(row, column)| banded.place(place[row], place[column]))
                    .collect();
                (Factors::Banded(banded, places), size)
            }
        };
        Self {
            pattern: pattern.clone(),
            factors,
            place,
            row_scale: vec![1.0; size],
            column_scale: vec![1.0; size],
            work: vec![T::default(); work],
        }
    }

    /// The analysed pattern.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// Factors the values on the pattern.
    ///
    /// # Errors
    /// The unknown at which the matrix is singular, or holds a value that is not finite.
    pub fn factor(&mut self, values: &[T]) -> Result<(), usize> {
        self.equilibrate(values)?;
        let (starts, indices) = (self.pattern.starts(), self.pattern.indices());
        let scaled = |entry: usize, column: usize| {
            values[entry].times(self.row_scale[indices[entry]] * self.column_scale[column])
        };
        match &mut self.factors {
            Factors::Banded(banded, places) => {
                let target = banded.values();
                target.fill(T::default());
                for column in 0..self.place.len() {
                    for entry in starts[column]..starts[column + 1] {
                        target[places[entry]] = scaled(entry, column);
                    }
                }
                banded.factor(SMALLEST_PIVOT).map_err(|at| {
                    let unknown = self.place.iter().position(|&place| place == at);
                    unknown.unwrap_or(at)
                })
            }
            Factors::Sparse(sparse) => {
                let target = &mut self.work[..indices.len()];
                for column in 0..self.place.len() {
                    for entry in starts[column]..starts[column + 1] {
                        target[entry] = scaled(entry, column);
                    }
                }
                sparse.factor(&self.pattern, target, SMALLEST_PIVOT)
            }
        }
    }

    /// Scales such that the largest entry of every row, then of every column, is 1.
    fn equilibrate(&mut self, values: &[T]) -> Result<(), usize> {
        let (starts, indices) = (self.pattern.starts(), self.pattern.indices());
        self.row_scale.fill(0.0);
        for (&row, &value) in indices.iter().zip(values) {
            let size = value.size();
            if !size.is_finite() {
                return Err(row);
            }
            self.row_scale[row] = size.max(self.row_scale[row]);
        }
        for (row, scale) in self.row_scale.iter_mut().enumerate() {
            *scale = 1.0 / *scale;
            if !scale.is_finite() {
                return Err(row);
            }
        }
        for column in 0..self.place.len() {
            let largest = (starts[column]..starts[column + 1])
                .map(|entry| values[entry].size() * self.row_scale[indices[entry]])
                .fold(0.0, f64::max);
            let scale = 1.0 / largest;
            if !scale.is_finite() {
                return Err(column);
            }
            self.column_scale[column] = scale;
        }
        Ok(())
    }

    /// Solves in place with the factors of the last successful [`Lu::factor`].
    pub fn solve(&mut self, x: &mut [T]) {
        let work = &mut self.work[..x.len()];
        match &mut self.factors {
            Factors::Banded(banded, _) => {
                for (row, &value) in x.iter().enumerate() {
                    work[self.place[row]] = value.times(self.row_scale[row]);
                }
                banded.solve(work);
                for (column, value) in x.iter_mut().enumerate() {
                    *value = work[self.place[column]].times(self.column_scale[column]);
                }
            }
            Factors::Sparse(sparse) => {
                for (row, &value) in x.iter().enumerate() {
                    work[row] = value.times(self.row_scale[row]);
                }
                sparse.solve(work);
                for (column, value) in x.iter_mut().enumerate() {
                    *value = work[column].times(self.column_scale[column]);
                }
            }
        }
    }
}

impl Lu<f64> {
    /// Whether the determinant of the matrix of the last successful [`Lu::factor`] is negative.
    pub fn is_determinant_negative(&self) -> bool {
        match &self.factors {
            // Rows and columns have the same order there.
            Factors::Banded(banded, _) => banded.is_determinant_negative(),
            Factors::Sparse(sparse) => sparse.is_determinant_negative(),
        }
    }
}

#[cfg(test)]
#[path = "lu_tests.rs"]
pub(super) mod tests;
