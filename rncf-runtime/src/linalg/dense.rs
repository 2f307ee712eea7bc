//! LU factorization of a small full matrix, equilibrated, with complete pivoting: for matrices that
//! are neither definite nor well scaled, such as Schur complements of saddle points.

use super::scalar::Scalar;

/// Pivots of the equilibrated matrix up to here are round-off, as are left null vectors' parts.
const SMALLEST_PIVOT: f64 = 64.0 * f64::EPSILON;
/// Part of the largest entry of a null vector from which on a row takes part in it.
const TAKES_PART: f64 = 1e-2;
/// Rounds of equilibration; each about halves the exponents of what is left.
const ROUNDS: usize = 6;

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
        self.equilibrate()?;
        let n = self.size;
        for k in 0..n {
            self.rows[k] = k;
            self.columns[k] = k;
        }
        for k in 0..n {
            let (row, column, size) = self.largest(k);
            if !size.is_finite() {
                return Err(self.rows[row]);
            }
            self.exchange(k, row, column);
            if size <= SMALLEST_PIVOT {
                return Err(self.dependent(k));
            }
            let (upper, lower) = self.values.split_at_mut((k + 1) * n);
            let top = &mut upper[k * n..];
            let inverse = top[k].inverse();
            top[k] = inverse;
            for row in lower.chunks_exact_mut(n) {
                let factor = row[k] * inverse;
                row[k] = factor;
                if factor != T::default() {
                    for (value, &above) in row[k + 1..].iter_mut().zip(&top[k + 1..]) {
                        *value -= factor * above;
                    }
                }
            }
        }
        Ok(())
    }

    /// Scales rows and columns such that the largest terms of each are near 1; a row or column
    /// without any is the error.
    fn equilibrate(&mut self) -> Result<(), usize> {
        let n = self.size;
        for _ in 0..ROUNDS {
            for i in 0..n {
                let row = &self.terms[i * n..(i + 1) * n];
                let scaled = row.iter().zip(&self.column_scale).map(|(term, scale)| term * scale);
                self.row_scale[i] = near(self.row_scale[i], scaled.fold(0.0, larger)).ok_or(i)?;
            }
            for j in 0..n {
                let scaled = (0..n).map(|i| self.terms[i * n + j] * self.row_scale[i]);
                self.column_scale[j] = near(self.column_scale[j], scaled.fold(0.0, larger)).ok_or(j)?;
            }
        }
        for i in 0..n {
            for j in 0..n {
                let value = &mut self.values[i * n + j];
                *value = value.times(self.row_scale[i] * self.column_scale[j]);
            }
        }
        Ok(())
    }

    /// Place and size of the largest entry of what is left at step `k`; NaN is larger than all.
    fn largest(&self, k: usize) -> (usize, usize, f64) {
        let mut best = (k, k, -1.0);
        for row in k..self.size {
            for (column, value) in self.values[row * self.size..(row + 1) * self.size]
                .iter()
                .enumerate()
                .skip(k)
            {
                let size = value.size();
                if size > best.2 {
                    best = (row, column, size);
                } else if size.is_nan() {
                    return (row, column, size);
                }
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
            for j in 0..k {
                sum -= self.values[k * n + j] * work[j];
            }
            work[k] = sum;
        }
        for k in (0..n).rev() {
            let mut sum = work[k];
            for j in k + 1..n {
                sum -= self.values[k * n + j] * work[j];
            }
            work[k] = sum * self.values[k * n + k];
        }
        for (&column, &value) in self.columns.iter().zip(work.iter()) {
            x[column] = value.times(self.column_scale[column]);
        }
    }
}

/// The larger one; NaN if any is.
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
