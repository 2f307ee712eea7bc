//! LU factorization of a banded matrix with partial pivoting, row by row in one array.

use super::scalar::Scalar;

/// A banded matrix with equal lower and upper half-bandwidth b, then its factors. A row holds the
/// columns i - b .. i + 2b: the last b of them are room for the fill-in of row exchanges.
#[derive(Clone, Debug)]
pub(super) struct Banded<T> {
    size: usize,
    half: usize,
    width: usize,
    values: Vec<T>,
    pivots: Vec<usize>,
    inverses: Vec<T>,
}

impl<T: Scalar> Banded<T> {
    pub(super) fn new(size: usize, half: usize) -> Self {
        let width = 3 * half + 1;
        Self {
            size,
            half,
            width,
            values: vec![T::default(); size * width],
            pivots: vec![0; size],
            inverses: vec![T::default(); size],
        }
    }

    /// Place of entry `(row, column)` in [`Banded::values`]; `column` within `half` of `row`.
    pub(super) fn place(&self, row: usize, column: usize) -> usize {
        row * self.width + column + self.half - row
    }

    /// The entries by [`Banded::place`], to be filled from zero before [`Banded::factor`].
    pub(super) fn values(&mut self) -> &mut [T] {
        &mut self.values
    }

    /// Factors in place; the column at which no pivot exceeds `smallest`, if any (NaN included).
    pub(super) fn factor(&mut self, smallest: f64) -> Result<(), usize> {
        for k in 0..self.size {
            let last = (k + self.half).min(self.size - 1);
            let (pivot, size) = self.largest(k, last);
            if !(size > smallest && size.is_finite()) {
                return Err(k);
            }
            let length = (2 * self.half + 1).min(self.size - k);
            if pivot != k {
                let (upper, lower) = self.values.split_at_mut(pivot * self.width);
                let top = k * self.width + self.half;
                let start = k + self.half - pivot;
                upper[top..top + length].swap_with_slice(&mut lower[start..start + length]);
            }
            self.pivots[k] = pivot;
            let inverse = self.values[self.place(k, k)].inverse();
            self.inverses[k] = inverse;
            let (upper, lower) = self.values.split_at_mut((k + 1) * self.width);
            let top = &upper[k * self.width + self.half + 1..][..length - 1];
            for row in k + 1..=last {
                let start = (row - k - 1) * self.width + k + self.half - row;
                let factor = lower[start] * inverse;
                lower[start] = factor;
                if factor != T::default() {
                    for (value, &above) in lower[start + 1..start + length].iter_mut().zip(top) {
                        *value -= factor * above;
                    }
                }
            }
        }
        Ok(())
    }

    fn largest(&self, column: usize, last: usize) -> (usize, f64) {
        let mut best = (column, self.values[self.place(column, column)].size());
        for row in column + 1..=last {
            let size = self.values[self.place(row, column)].size();
            // A NaN anywhere must not be passed over.
            if size > best.1 || size.is_nan() {
                best = (row, size);
            }
        }
        best
    }

    /// Solves in place with the factors.
    pub(super) fn solve(&self, x: &mut [T]) {
        for k in 0..self.size {
            x.swap(k, self.pivots[k]);
            let known = x[k];
            if known != T::default() {
                for row in k + 1..(k + self.half + 1).min(self.size) {
                    x[row] -= self.values[self.place(row, k)] * known;
                }
            }
        }
        for k in (0..self.size).rev() {
            let length = (2 * self.half + 1).min(self.size - k);
            let row = &self.values[k * self.width + self.half + 1..][..length - 1];
            let mut sum = x[k];
            for (&value, &known) in row.iter().zip(&x[k + 1..k + length]) {
                sum -= value * known;
            }
            x[k] = sum * self.inverses[k];
        }
    }
}

impl Banded<f64> {
    /// Whether the determinant of what was factored is negative.
    pub(super) fn is_determinant_negative(&self) -> bool {
        let exchanged = (0..self.size).filter(|&k| self.pivots[k] != k).count();
        let negative = self.inverses.iter().filter(|inverse| **inverse < 0.0).count();
        !(exchanged + negative).is_multiple_of(2)
    }
}
