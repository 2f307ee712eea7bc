//! Small dense matrices: what the references need, no more.

use crate::Result;

/// Square matrix, row after row.
#[derive(Clone, Debug)]
pub struct Matrix {
    size: usize,
    entries: Vec<f64>,
}

impl Matrix {
    /// Zero matrix of the given number of rows and columns.
    pub fn zero(size: usize) -> Self {
        Self {
            size,
            entries: vec![0.0; size * size],
        }
    }

    /// Number of rows and of columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Entry in row `i`, column `j`.
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.entries[i * self.size + j]
    }

    /// Sets the entry in row `i`, column `j`.
    pub fn set(&mut self, i: usize, j: usize, value: f64) {
        self.entries[i * self.size + j] = value;
    }

    /// Adds to the entry in row `i`, column `j`.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        self.entries[i * self.size + j] += value;
    }

    /// Sets every entry to zero.
    pub fn clear(&mut self) {
        self.entries.fill(0.0);
    }

    /// Adds `self * x` to `out`; both of length `size`.
    pub fn add_product(&self, x: &[f64], out: &mut [f64]) {
        for i in 0..self.size {
            for j in 0..self.size {
                out[i] += self.get(i, j) * x[j];
            }
        }
    }

    /// Solves `self * x = right` by elimination with row pivoting.
    ///
    /// # Errors
    /// If the matrix is singular to working precision; the message names the column.
    pub fn solve(&self, right: &[f64]) -> Result<Vec<f64>> {
        let n = self.size;
        let (mut a, mut x) = (self.clone(), right.to_vec());
        for k in 0..n {
            let pivot = (k..n)
                .max_by(|&i, &j| a.get(i, k).abs().total_cmp(&a.get(j, k).abs()))
                .unwrap_or(k);
            if a.get(pivot, k).is_nan() || a.get(pivot, k) == 0.0 {
                return Err(format!(
                    "the matrix is singular at column {k}: a coordinate is neither held nor loaded"
                ));
            }
            for j in 0..n {
                let swapped = a.get(k, j);
                a.set(k, j, a.get(pivot, j));
                a.set(pivot, j, swapped);
            }
            x.swap(k, pivot);
            for i in k + 1..n {
                let factor = a.get(i, k) / a.get(k, k);
                for j in k..n {
                    a.add(i, j, -factor * a.get(k, j));
                }
                x[i] -= factor * x[k];
            }
        }
        for k in (0..n).rev() {
            for j in k + 1..n {
                x[k] -= a.get(k, j) * x[j];
            }
            x[k] /= a.get(k, k);
        }
        Ok(x)
    }
}

/// Cholesky factor of a symmetric positive definite matrix; zeros outside the band are skipped.
#[derive(Clone, Debug)]
pub struct Cholesky {
    lower: Matrix,
    /// First nonzero column of each row.
    first: Vec<usize>,
}

impl Cholesky {
    /// Factors the matrix; only its lower triangle is read.
    ///
    /// # Errors
    /// If it is not positive definite; the message names the row.
    pub fn new(matrix: &Matrix) -> Result<Self> {
        let n = matrix.size();
        let mut lower = matrix.clone();
        let first: Vec<usize> = (0..n)
            .map(|i| (0..i).find(|&j| matrix.get(i, j) != 0.0).unwrap_or(i))
            .collect();
        for i in 0..n {
            for j in first[i]..=i {
                let mut sum = matrix.get(i, j);
                for k in first[i].max(first[j])..j {
                    sum -= lower.get(i, k) * lower.get(j, k);
                }
                if i == j {
                    if sum.is_nan() || sum <= 0.0 {
                        return Err(format!(
                            "the mass matrix is not positive definite at row {i}: check mass and length"
                        ));
                    }
                    lower.set(i, i, sum.sqrt());
                } else {
                    lower.set(i, j, sum / lower.get(j, j));
                }
            }
        }
        Ok(Self { lower, first })
    }

    /// Replaces `x`, of length `size`, by the solution of `lower * solution = x`.
    pub fn forward(&self, x: &mut [f64]) {
        for i in 0..self.lower.size() {
            for j in self.first[i]..i {
                x[i] -= self.lower.get(i, j) * x[j];
            }
            x[i] /= self.lower.get(i, i);
        }
    }

    /// Replaces `x`, of length `size`, by the solution of `matrix * solution = x`.
    pub fn solve(&self, x: &mut [f64]) {
        self.forward(x);
        for i in (0..self.lower.size()).rev() {
            x[i] /= self.lower.get(i, i);
            for j in self.first[i]..i {
                x[j] -= self.lower.get(i, j) * x[i];
            }
        }
    }
}
