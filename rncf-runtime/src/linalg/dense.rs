//! LU factorization of a small full matrix, equilibrated, with complete pivoting: for matrices that
//! are neither definite nor well scaled, such as Schur complements of saddle points.

use pulp::Arch;

use super::block_kernels::{Vectorised, dispatch};
use super::scalar::Scalar;

/// Pivots of the equilibrated matrix up to here are round-off, as are left null vectors' parts.
const SMALLEST_PIVOT: f64 = 64.0 * f64::EPSILON;
/// Part of the largest entry of a null vector from which on a row takes part in it.
const TAKES_PART: f64 = 1e-2;
/// Rounds of equilibration; each about halves the exponents of what is left.
const ROUNDS: usize = 6;
/// Maxima that are taken beside each other.
const LANES: usize = 4;

/// LU factorization with complete pivoting of a full square matrix, in the field `T` (`f64` or
/// `c64`). Filled by [`Dense::add`], then factored in place.
#[derive(Clone, Debug)]
pub struct Dense<T> {
    size: usize,
    /// Row after row.
    values: Vec<T>,
    /// Sizes of the terms of which every entry is the sum: round-off is relative to them.
    terms: Vec<f64>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    /// Row and column at every place of the elimination.
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Largest size in every row of what is left to eliminate.
    peaks: Vec<f64>,
    work: Vec<T>,
}

impl<T: Scalar> Dense<T> {
    /// A matrix of zeros of the given size.
    pub fn new(size: usize) -> Self {
        Self {
            size,
            values: vec![T::default(); size * size],
            terms: vec![0.0; size * size],
            row_scale: vec![1.0; size],
            column_scale: vec![1.0; size],
            rows: (0..size).collect(),
            columns: (0..size).collect(),
            peaks: vec![0.0; size],
            work: vec![T::default(); size],
        }
    }

    /// Sets all entries to zero, to be filled anew.
    pub fn clear(&mut self) {
        self.values.fill(T::default());
        self.terms.fill(0.0);
    }

    /// Adds a value to an entry; `terms` is the sum of the sizes of what the value was summed from.
    pub fn add(&mut self, row: usize, column: usize, value: T, terms: f64) {
        self.values[row * self.size + column] += value;
        self.terms[row * self.size + column] += terms;
    }

    /// Factors in place.
    ///
    /// # Errors
    /// The row that follows from rows before it up to round-off (or is empty, or not finite).
    pub fn factor(&mut self) -> Result<(), usize> {
        self.row_scale.fill(1.0);
        self.column_scale.fill(1.0);
        self.factor_scaled()
    }

    /// [`Dense::factor`], with the equilibration begun from the given scales of rows and columns. Blocks of zeros leave more
    /// than one equilibrium of scales, in which pivots differ.
    ///
    /// # Errors
    /// As of [`Dense::factor`].
    pub fn factor_from(&mut self, scales: &[f64]) -> Result<(), usize> {
        self.row_scale.copy_from_slice(scales);
        self.column_scale.copy_from_slice(scales);
        self.factor_scaled()
    }

    fn factor_scaled(&mut self) -> Result<(), usize> {
        dispatch(Arch::new(), Factored(self))
    }

    #[inline(always)]
    fn eliminate(&mut self) -> Result<(), usize> {
        let n = self.size;
        for k in 0..n {
            self.rows[k] = k;
            self.columns[k] = k;
        }
        for k in 0..n {
            let (row, size) = self.largest(k);
            if !size.is_finite() {
                return Err(self.rows[row]);
            }
            let left = &self.values[row * n + k..(row + 1) * n];
            let column = k + left.iter().position(|value| value.size() == size).unwrap_or(0);
            self.exchange(k, row, column);
            if size <= SMALLEST_PIVOT {
                return Err(self.dependent(k));
            }
            let (upper, lower) = self.values.split_at_mut((k + 1) * n);
            let top = &mut upper[k * n..];
            let inverse = top[k].inverse();
            top[k] = inverse;
            let above = &top[k + 1..];
            for (row, peak) in lower.chunks_exact_mut(n).zip(&mut self.peaks[k + 1..]) {
                // Nothing changes in the row, nor did its largest leave it.
                if row[k] == T::default() {
                    continue;
                }
                let factor = row[k] * inverse;
                row[k] = factor;
                *peak = subtract(factor, above, &mut row[k + 1..]);
            }
        }
        Ok(())
    }

    /// Scales rows and columns such that the largest terms of each are near 1; a row or column
    /// without any is the error. Leaves the largest of every row.
    #[inline(always)]
    fn equilibrate(&mut self) -> Result<(), usize> {
        let n = self.size;
        for _ in 0..ROUNDS {
            // The largest of the columns, row by row.
            self.peaks.fill(0.0);
            for i in 0..n {
                let row = &self.terms[i * n..(i + 1) * n];
                let largest = peak(n, |j| row[j] * self.column_scale[j]);
                let scale = near(self.row_scale[i], largest).ok_or(i)?;
                self.row_scale[i] = scale;
                for (largest, term) in self.peaks.iter_mut().zip(row) {
                    *largest = larger(*largest, term * scale);
                }
            }
            for (j, (scale, &largest)) in self.column_scale.iter_mut().zip(&self.peaks).enumerate() {
                *scale = near(*scale, largest).ok_or(j)?;
            }
        }
        for i in 0..n {
            let (row, row_scale) = (&mut self.values[i * n..(i + 1) * n], self.row_scale[i]);
            for (value, column_scale) in row.iter_mut().zip(&self.column_scale) {
                *value = value.times(row_scale * column_scale);
            }
            self.peaks[i] = peak(n, |j| row[j].size());
        }
        Ok(())
    }

    /// Row and size of the largest entry of what is left at step `k`; NaN is larger than all.
    #[inline(always)]
    fn largest(&self, k: usize) -> (usize, f64) {
        let mut best = (k, -1.0);
        for (row, &size) in self.peaks.iter().enumerate().skip(k) {
            if size > best.1 {
                best = (row, size);
            } else if size.is_nan() {
                return (row, size);
            }
        }
        best
    }

    fn exchange(&mut self, k: usize, row: usize, column: usize) {
        let n = self.size;
        if row != k {
            let (upper, lower) = self.values.split_at_mut(row * n);
            upper[k * n..(k + 1) * n].swap_with_slice(&mut lower[..n]);
            self.rows.swap(k, row);
            self.peaks.swap(k, row);
        }
        if column != k {
            for row in self.values.chunks_exact_mut(n) {
                row.swap(k, column);
            }
            self.columns.swap(k, column);
        }
    }

    /// The last of the rows that combine to zero with the one at place `k`, where elimination ended:
    /// the solution w of `w^T L = e_k^T`.
    fn dependent(&mut self, k: usize) -> usize {
        let n = self.size;
        self.work[k] = T::real(1.0);
        for j in (0..k).rev() {
            let mut sum = T::default();
            for i in j + 1..=k {
                sum += self.work[i] * self.values[i * n + j];
            }
            self.work[j] = -sum;
        }
        let largest = self.work[..=k].iter().map(|w| w.size()).fold(0.0, f64::max);
        (0..=k)
            .filter(|&i| self.work[i].size() >= TAKES_PART * largest)
            .map(|i| self.rows[i])
            .max()
            .unwrap_or(self.rows[k])
    }

    /// Solves in place with the factors of the last successful [`Dense::factor`].
    pub fn solve(&mut self, x: &mut [T]) {
        let (n, work) = (self.size, &mut self.work);
        for k in 0..n {
            let row = self.rows[k];
            let mut sum = x[row].times(self.row_scale[row]);
            for (&value, &known) in self.values[k * n..k * n + k].iter().zip(&*work) {
                sum -= value * known;
            }
            work[k] = sum;
        }
        for k in (0..n).rev() {
            let mut sum = work[k];
            for (&value, &known) in self.values[k * n + k + 1..(k + 1) * n].iter().zip(&work[k + 1..]) {
                sum -= value * known;
            }
            work[k] = sum * self.values[k * n + k];
        }
        for (&column, &value) in self.columns.iter().zip(work.iter()) {
            x[column] = value.times(self.column_scale[column]);
        }
    }
}

/// A matrix to be equilibrated and factored.
struct Factored<'a, T>(&'a mut Dense<T>);

impl<T: Scalar> Vectorised for Factored<'_, T> {
    type Output = Result<(), usize>;

    #[inline(always)]
    fn run<const F: bool>(self) -> Self::Output {
        self.0.equilibrate()?;
        self.0.eliminate()
    }
}

/// Subtracts `factor` times `above` from what is left of a row: the largest size of the difference.
#[inline(always)]
fn subtract<T: Scalar>(factor: T, above: &[T], row: &mut [T]) -> f64 {
    let (mut largest, n) = ([0.0; LANES], row.len() / LANES * LANES);
    let (tops, last_top) = above.split_at(n);
    let (values, last) = row.split_at_mut(n);
    for (values, tops) in values.chunks_exact_mut(LANES).zip(tops.chunks_exact(LANES)) {
        for lane in 0..LANES {
            values[lane] -= factor * tops[lane];
            largest[lane] = larger(largest[lane], values[lane].size());
        }
    }
    let mut largest = largest.into_iter().fold(0.0, larger);
    for (value, &top) in last.iter_mut().zip(last_top) {
        *value -= factor * top;
        largest = larger(largest, value.size());
    }
    largest
}

/// The largest of `n` values that are not negative; NaN if any is.
#[inline(always)]
fn peak(n: usize, value: impl Fn(usize) -> f64) -> f64 {
    let (mut largest, whole) = ([0.0; LANES], n / LANES * LANES);
    for first in (0..whole).step_by(LANES) {
        for (lane, largest) in largest.iter_mut().enumerate() {
            *largest = larger(*largest, value(first + lane));
        }
    }
    let largest = largest.into_iter().fold(0.0, larger);
    (whole..n).fold(largest, |largest, i| larger(largest, value(i)))
}

/// The larger one; NaN if any is.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// The scale after a round at which the largest scaled term was `largest * scale`.
fn near(scale: f64, largest: f64) -> Option<f64> {
    let next = (scale / largest).sqrt();
    (next > 0.0 && next.is_finite()).then_some(next)
}

#[cfg(test)]
#[path = "dense_tests.rs"]
mod tests;
