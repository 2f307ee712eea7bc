//! Banded matrices: what long chains of elements need.

use crate::Result;

/// Square matrix whose entries lie within `half` of the diagonal.
#[derive(Clone, Debug)]
pub struct Banded {
    size: usize,
    half: usize,
    /// Row after row, columns `i - half ..= i + 2 half`: room for what row exchanges fill in.
    entries: Vec<f64>,
}

impl Banded {
    /// Zero matrix.
    pub fn zero(size: usize, half: usize) -> Self {
        Self {
            size,
            half,
            entries: vec![0.0; size * (3 * half + 1)],
        }
    }

    fn place(&self, i: usize, j: usize) -> usize {
        i * (3 * self.half + 1) + j + self.half - i
    }

    /// Number of rows and of columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Entry in row `i`, column `j`; zero outside the band.
    pub fn get(&self, i: usize, j: usize) -> f64 {
        if i.abs_diff(j) > self.half {
            return 0.0;
        }
        self.entries[self.place(i, j)]
    }

    /// Adds to the entry in row `i`, column `j` of the band.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let place = self.place(i, j);
        self.entries[place] += value;
    }

    /// Solves `self * x = right` by elimination with row pivoting.
    ///
    /// # Errors
    /// If the matrix is singular to working precision; the message names the column.
    pub fn solve(mut self, right: &[f64]) -> Result<Vec<f64>> {
        let (n, half) = (self.size, self.half);
        let mut x = right.to_vec();
        for k in 0..n {
            let (last_row, last) = ((k + half).min(n - 1), (k + 2 * half).min(n - 1));
            let size = |i: usize| self.entries[self.place(i, k)].abs();
            let pivot = (k..=last_row).max_by(|&i, &j| size(i).total_cmp(&size(j))).unwrap_or(k);
            if size(pivot).is_nan() || size(pivot) == 0.0 {
                return Err(format!(
                    "the matrix is singular at column {k}: a coordinate is neither held nor loaded"
                ));
            }
            if pivot != k {
                for j in k..=last {
                    let (here, there) = (self.place(k, j), self.place(pivot, j));
                    self.entries.swap(here, there);
                }
                x.swap(k, pivot);
            }
            for i in k + 1..=last_row {
                let factor = self.entries[self.place(i, k)] / self.entries[self.place(k, k)];
                if factor != 0.0 {
                    let (from, to) = (self.place(k, k), self.place(i, k));
                    for j in 0..=last - k {
                        self.entries[to + j] -= factor * self.entries[from + j];
                    }
                    x[i] -= factor * x[k];
                }
            }
        }
        for k in (0..n).rev() {
            for j in k + 1..=(k + 2 * half).min(n - 1) {
                x[k] -= self.entries[self.place(k, j)] * x[j];
            }
            x[k] /= self.entries[self.place(k, k)];
        }
        Ok(x)
    }
}
