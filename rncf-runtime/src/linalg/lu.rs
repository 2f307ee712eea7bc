//! LU factorization of a square matrix on a fixed pattern, equilibrated by rows and columns.

use std::sync::Arc;

use super::analysis::{Analysis, LARGEST_BANDWIDTH, Shape};
use super::banded::Banded;
use super::blocks::{Blocks, Failure};
use super::chain::Chain;
use super::order::half_bandwidth;
use super::pattern::Pattern;
use super::scalar::Scalar;
use super::sparse::Sparse;

/// Pivots of the equilibrated matrix up to here are round-off of its entries, which are at most 1.
const SMALLEST_PIVOT: f64 = 8.0 * f64::EPSILON;

/// LU factorization with pivoting of a square matrix on a fixed pattern, in the field `T` (`f64` or
/// `c64`). The pattern is analysed once, for all its copies, and decides how:
///
/// - chains (meshes of lines) are block-tridiagonal, without row exchanges; values for which this is not safe are banded;
/// - other narrow matrices are banded, with partial pivoting;
/// - large wide ones are factored by the node blocks that the pattern shows, with pivots inside the
///   blocks; values for which these do not suffice go to faer;
/// - others go to faer (partial pivoting).
///
/// Later calls do not allocate, but for those that go to faer.
#[derive(Debug)]
pub struct Lu<T: Scalar> {
    pattern: Pattern,
    factors: Factors<T>,
    /// With row exchanges, for values that need them: made when it is first needed, and whether it holds the factors.
    fallback: Option<Box<Lu<T>>>,
    is_fallback_used: bool,
    /// Whether the last [`Lu::factor`] succeeded.
    is_regular: bool,
    /// Place of every unknown in the order of elimination of the banded factors.
    place: Arc<[usize]>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    work: Vec<T>,
    /// Starts of the columns of the pattern.
    starts: Vec<usize>,
}

#[derive(Debug)]
enum Factors<T: Scalar> {
    Chain(Box<Chain<T>>),
    /// Banded, and the place of every entry of the pattern in it.
    Banded(Banded<T>, Vec<usize>),
    Sparse(Box<Sparse<T>>),
    Blocks(Box<Blocks<T>>),
}

impl<T: Scalar> Lu<T> {
    /// Analyses a square pattern.
    ///
    /// # Panics
    /// If the pattern is not square: a defect of the caller.
    pub fn new(pattern: &Pattern) -> Self {
        let analysis = pattern.found(Analysis::new);
        let factors = match &analysis.shape {
            Shape::Narrow(links) => links
                .as_ref()
                .and_then(|links| Chain::new(pattern, links))
                .map(|chain| Factors::Chain(Box::new(chain))),
            Shape::Wide => sparse(pattern),
            Shape::Large(structure) => structure
                .as_ref()
                .map(|structure| Factors::Blocks(Box::new(Blocks::new(Arc::clone(structure))))),
        };
        let place = Arc::clone(&analysis.place);
        Self::with(pattern, factors.unwrap_or_else(|| banded(pattern, &place)), place)
    }

    /// Of a square pattern whose values need row exchanges, with the place of every unknown in an order with a small
    /// bandwidth: banded where it is narrow, else by faer.
    pub(super) fn exchanging(pattern: &Pattern, place: Vec<usize>) -> Self {
        let is_narrow = half_bandwidth(pattern, &place) <= LARGEST_BANDWIDTH;
        let factors = if is_narrow { None } else { sparse(pattern) };
        Self::with(
            pattern,
            factors.unwrap_or_else(|| banded(pattern, &place)),
            place.into(),
        )
    }

    fn with(pattern: &Pattern, factors: Factors<T>, place: Arc<[usize]>) -> Self {
        let size = pattern.columns();
        let (scaled, work) = match &factors {
            Factors::Chain(_) | Factors::Blocks(_) => (0, 0),
            Factors::Banded(..) => (size, size),
            Factors::Sparse(_) => (size, size.max(pattern.entries())),
        };
        Self {
            pattern: pattern.clone(),
            factors,
            fallback: None,
            is_fallback_used: false,
            is_regular: false,
            place,
            row_scale: vec![1.0; scaled],
            column_scale: vec![1.0; scaled],
            work: vec![T::default(); work],
            starts: pattern.starts().to_vec(),
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
        let starts = std::mem::take(&mut self.starts);
        let factored = self.factor_from(values, &starts);
        self.starts = starts;
        self.is_regular = factored.is_ok();
        factored
    }

    /// Factors the values with row exchanges.
    ///
    /// # Errors
    /// The unknown at which no pivot of the equilibrated matrix exceeds `smallest`, or a value is not finite.
    pub(super) fn factor_above(&mut self, values: &[T], smallest: f64) -> Result<(), usize> {
        let starts = std::mem::take(&mut self.starts);
        let factored = self.factor_exchanging(values, &starts, smallest);
        self.starts = starts;
        factored
    }

    /// Factors values of which those of column j begin at `starts[j]`: the matrix may be a part of
    /// another one.
    ///
    /// # Errors
    /// As of [`Lu::factor`].
    pub(super) fn factor_from(&mut self, values: &[T], starts: &[usize]) -> Result<(), usize> {
        self.is_fallback_used = false;
        let row_exchanges: fn(&Pattern, &[usize]) -> Factors<T> = match &mut self.factors {
            Factors::Chain(chain) => {
                if chain.factor(&self.pattern, values, starts) {
                    return Ok(());
                }
                banded
            }
            Factors::Blocks(blocks) => {
                match blocks.factor(&self.pattern, values, starts, SMALLEST_PIVOT) {
                    Ok(()) => return Ok(()),
                    Err(Failure::Line(unknown)) => return Err(unknown),
                    Err(Failure::Unsuited) => {}
                }
                |pattern: &Pattern, place: &[usize]| sparse(pattern).unwrap_or_else(|| banded(pattern, place))
            }
            Factors::Banded(..) | Factors::Sparse(_) => return self.factor_exchanging(values, starts, SMALLEST_PIVOT),
        };
        self.is_fallback_used = true;
        let (pattern, place) = (&self.pattern, &self.place);
        self.fallback
            .get_or_insert_with(|| Box::new(Self::with(pattern, row_exchanges(pattern, place), Arc::clone(place))))
            .factor_exchanging(values, starts, SMALLEST_PIVOT)
    }

    /// [`Lu::factor_from`] with row exchanges, and pivots above `smallest`.
    fn factor_exchanging(&mut self, values: &[T], starts: &[usize], smallest: f64) -> Result<(), usize> {
        self.equilibrate(values, starts)?;
        let indices = self.pattern.indices();
        let scaled = |entry: usize, from: usize, column: usize| {
            values[starts[column] + entry - from].times(self.row_scale[indices[entry]] * self.column_scale[column])
        };
        let columns = self.pattern.starts().windows(2).enumerate();
        match &mut self.factors {
            Factors::Banded(banded, places) => {
                let target = banded.values();
                target.fill(T::default());
                for (column, ends) in columns {
                    for entry in ends[0]..ends[1] {
                        target[places[entry]] = scaled(entry, ends[0], column);
                    }
                }
                banded.factor(smallest).map_err(|at| {
                    let unknown = self.place.iter().position(|&place| place == at);
                    unknown.unwrap_or(at)
                })
            }
            Factors::Sparse(sparse) => {
                let target = &mut self.work[..indices.len()];
                for (column, ends) in columns {
                    for entry in ends[0]..ends[1] {
                        target[entry] = scaled(entry, ends[0], column);
                    }
                }
                sparse.factor(&self.pattern, target, smallest)
            }
            Factors::Chain(_) | Factors::Blocks(_) => Err(0),
        }
    }

    /// Scales such that the largest entry of every row, then of every column, is 1.
    fn equilibrate(&mut self, values: &[T], starts: &[usize]) -> Result<(), usize> {
        let (ends, indices) = (self.pattern.starts(), self.pattern.indices());
        let column = |column: usize| {
            let rows = &indices[ends[column]..ends[column + 1]];
            rows.iter().zip(&values[starts[column]..][..rows.len()])
        };
        self.row_scale.fill(0.0);
        for (&row, &value) in (0..self.place.len()).flat_map(column) {
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
        for index in 0..self.place.len() {
            let sizes = column(index).map(|(&row, value)| value.size() * self.row_scale[row]);
            let scale = 1.0 / sizes.fold(0.0, f64::max);
            if !scale.is_finite() {
                return Err(index);
            }
            self.column_scale[index] = scale;
        }
        Ok(())
    }

    /// What holds the factors.
    fn used(&self) -> &Self {
        match &self.fallback {
            Some(fallback) if self.is_fallback_used => fallback,
            _ => self,
        }
    }

    /// Solves in place with the factors of the last successful [`Lu::factor`].
    pub fn solve(&mut self, x: &mut [T]) {
        if let (true, Some(fallback)) = (self.is_fallback_used, &mut self.fallback) {
            return fallback.solve(x);
        }
        match &mut self.factors {
            Factors::Chain(chain) => chain.solve(x),
            Factors::Blocks(blocks) => blocks.solve(x),
            Factors::Banded(banded, _) => {
                let work = &mut self.work[..x.len()];
                for (row, &value) in x.iter().enumerate() {
                    work[self.place[row]] = value.times(self.row_scale[row]);
                }
                banded.solve(work);
                for (column, value) in x.iter_mut().enumerate() {
                    *value = work[self.place[column]].times(self.column_scale[column]);
                }
            }
            Factors::Sparse(sparse) => {
                let work = &mut self.work[..x.len()];
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

    /// [`Lu::solve`] for `count` right sides: `x` holds those of the first unknown, then those of the
    /// second, and so on (n x `count`, row after row).
    pub fn solve_many(&mut self, x: &mut [T], count: usize) {
        if let (Factors::Blocks(blocks), false) = (&mut self.factors, self.is_fallback_used) {
            return blocks.solve_many(x, count);
        }
        let mut column = vec![T::default(); self.place.len()];
        for side in 0..count {
            for (value, row) in column.iter_mut().zip(x.chunks_exact(count)) {
                *value = row[side];
            }
            self.solve(&mut column);
            for (value, row) in column.iter().zip(x.chunks_exact_mut(count)) {
                row[side] = *value;
            }
        }
    }
}

/// Sparse factors, to be filled; `None` if the ordering fails (memory).
fn sparse<T: Scalar>(pattern: &Pattern) -> Option<Factors<T>> {
    Sparse::new(pattern).map(|sparse| Factors::Sparse(Box::new(sparse)))
}

/// Banded factors, to be filled.
fn banded<T: Scalar>(pattern: &Pattern, place: &[usize]) -> Factors<T> {
    let size = pattern.columns();
    let banded = Banded::new(size, half_bandwidth(pattern, place));
    let places = (0..size)
        .flat_map(|column| {
            pattern.indices()[pattern.starts()[column]..pattern.starts()[column + 1]]
                .iter()
                .map(move |&row| (row, column))
        })
        .map(|(row, column)| banded.place(place[row], place[column]))
        .collect();
    Factors::Banded(banded, places)
}

impl Lu<f64> {
    /// Whether the determinant of the matrix of the last [`Lu::factor`] is negative; not of one that was singular.
    pub fn is_determinant_negative(&self) -> bool {
        // What is left of factors that were not finished cannot be read.
        if !self.is_regular {
            return false;
        }
        match &self.used().factors {
            Factors::Chain(chain) => chain.is_determinant_negative(),
            // Rows and columns have the same order there.
            Factors::Banded(banded, _) => banded.is_determinant_negative(),
            Factors::Sparse(sparse) => sparse.is_determinant_negative(),
            Factors::Blocks(blocks) => blocks.is_determinant_negative(),
        }
    }
}

#[cfg(test)]
#[path = "lu_tests.rs"]
pub(super) mod tests;
