//! Rows thinned while they come, so that their memory stays bounded and no peak is lost: for the pictures of long runs.

use crate::archive::{Archive, Keep};

/// How many rows one kept row stands for.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Sketch {
    /// Most kept rows; a multiple of four.
    most: usize,
    /// Rows of a block; blocks of more than one are kept as two rows, the least and the greatest values of the columns, with
    /// the first and the last key.
    block: u64,
    /// Rows in the last block so far.
    filled: u64,
}

impl Keep for Sketch {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { most: _, block, filled } = self;
        block.keep(archive);
        filled.keep(archive);
    }
}

impl Sketch {
    /// Keeps at most `most` rows, at least four.
    pub fn new(most: usize) -> Self {
        Self {
            most: (most / 4).max(1) * 4,
            block: 1,
            filled: 0,
        }
    }

    /// Adds a row to the kept ones.
    pub fn add(&mut self, keys: &mut Vec<f64>, values: &mut Vec<f64>, key: f64, row: &[f64]) {
        if keys.len() >= self.most && self.filled == self.block {
            self.halve(keys, values, row.len());
        }
        if self.filled == self.block || keys.is_empty() {
            self.filled = 1;
            for _ in 0..self.block.min(2) {
                keys.push(key);
                values.extend_from_slice(row);
            }
            return;
        }
        self.filled += 1;
        let last = keys.len() - 1;
        keys[last] = key;
        let (low, high) = values[(last - 1) * row.len()..].split_at_mut(row.len());
        for (i, &value) in row.iter().enumerate() {
            low[i] = low[i].min(value);
            high[i] = high[i].max(value);
        }
    }

    /// Makes two rows of every four.
    fn halve(&mut self, keys: &mut Vec<f64>, values: &mut Vec<f64>, width: usize) {
        let groups = keys.len() / 4;
        for group in 0..groups {
            let of = |row: usize, column: usize| values[(4 * group + row) * width + column];
            let extremes: Vec<[f64; 2]> = (0..width)
                .map(|column| {
                    let column = [0, 1, 2, 3].map(|row| of(row, column));
                    [
                        column.into_iter().fold(f64::INFINITY, f64::min),
                        column.into_iter().fold(f64::NEG_INFINITY, f64::max),
                    ]
                })
                .collect();
            let ends = [keys[4 * group], keys[4 * group + 3]];
            for side in 0..2 {
                let row = 2 * group + side;
                keys[row] = ends[side];
                for (value, extremes) in values[row * width..(row + 1) * width].iter_mut().zip(&extremes) {
                    *value = extremes[side];
                }
            }
        }
        keys.truncate(2 * groups);
        values.truncate(2 * groups * width);
        self.block = if self.block == 1 { 4 } else { 2 * self.block };
        self.filled = self.block;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sketch(rows: usize, most: usize) -> (Vec<f64>, Vec<f64>) {
        let (mut sketch, mut keys, mut values) = (Sketch::new(most), Vec::new(), Vec::new());
        for k in 0..rows {
            let spike = if k == 777 { 9.0 } else { 0.0 };
            sketch.add(
                &mut keys,
                &mut values,
                k as f64,
                &[(k as f64 * 0.01).sin() + spike, -(k as f64)],
            );
        }
        (keys, values)
    }

    #[test]
    fn few_rows_are_kept_as_they_are() {
        let (keys, values) = sketch(16, 16);
        assert_eq!(keys, (0..16).map(f64::from).collect::<Vec<_>>());
        assert_eq!(
            values[1..].iter().step_by(2).copied().collect::<Vec<_>>(),
            (0..16).map(|k| -f64::from(k)).collect::<Vec<_>>()
        );
    }

    #[test]
    fn many_rows_stay_bounded_and_keep_ends_order_and_peaks() {
        for rows in [17, 1000, 1001, 4096, 12_345] {
            let (keys, values) = sketch(rows, 64);
            assert!((32..=66).contains(&keys.len()) || rows < 64, "{rows}: {}", keys.len());
            assert!(keys.is_sorted());
            assert_eq!((keys[0], keys[keys.len() - 1]), (0.0, (rows - 1) as f64));
            let column = |index: usize| values.iter().skip(index).step_by(2).copied();
            let exact = |k: usize| (k as f64 * 0.01).sin() + if k == 777 { 9.0 } else { 0.0 };
            let greatest = (0..rows).map(exact).fold(f64::NEG_INFINITY, f64::max);
            assert_eq!(column(0).fold(f64::NEG_INFINITY, f64::max), greatest);
            assert_eq!(column(1).fold(f64::INFINITY, f64::min), -((rows - 1) as f64));
        }
    }
}
