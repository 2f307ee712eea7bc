//! What loads per length do to a body and its frame, summed over elements; their axes, and lanes of numbers.

use crate::scene::pieces::density::{Evaluated, ROWS};
use crate::space::{Matrix, Vector};

/// What one density does to its body and frame, summed over the elements; frame axes.
#[derive(Default)]
pub(crate) struct Total {
    /// Force and moment on the frame.
    pub rows: [Vector; 2],
    /// dQ/dvalues, components x values, rows first.
    pub by_values: Vec<f64>,
    /// d(force, moment)/dq for every component.
    pub frame_by_q: Vec<[f64; ROWS]>,
    /// d(force, moment)/dvalues for every value.
    pub frame_by_values: Vec<[f64; ROWS]>,
}

impl Total {
    /// Nothing yet, of so many components and values.
    pub fn clear(&mut self, count: usize, k: usize) {
        self.rows = [Vector::zeros(); 2];
        self.by_values.clear();
        self.by_values.resize(count * k, 0.0);
        self.frame_by_q.clear();
        self.frame_by_q.resize(count, [0.0; ROWS]);
        self.frame_by_values.clear();
        self.frame_by_values.resize(k, [0.0; ROWS]);
    }

    /// Adds force and moment of one of four elements and their derivatives.
    pub fn add_frame(&mut self, places: &[usize], of: &Evaluated, factor: f64, lane: usize) {
        for (i, rows) in self.rows.iter_mut().enumerate() {
            *rows = Vector::from_fn(|j, _| rows[j] + factor * of.rows[3 * i + j][lane]);
        }
        let n = places.len();
        for (c, &place) in places.iter().enumerate() {
            for (row, sum) in self.frame_by_q[place].iter_mut().enumerate() {
                *sum += factor * of.rows_by_q[row * n + c][lane];
            }
        }
        let k = self.frame_by_values.len();
        for (c, sums) in self.frame_by_values.iter_mut().enumerate() {
            for (row, sum) in sums.iter_mut().enumerate() {
                *sum += factor * of.rows_by_values[row * k + c][lane];
            }
        }
    }

    /// Adds derivatives of forces by values, n x k, rows first.
    pub fn add_values(&mut self, places: &[usize], factor: f64, by_values: impl Fn(usize) -> f64) {
        let k = self.frame_by_values.len();
        for (row, &place) in places.iter().enumerate() {
            for (value, sum) in self.by_values[place * k..(place + 1) * k].iter_mut().enumerate() {
                *sum += factor * by_values(row * k + value);
            }
        }
    }
}

/// Axes of a frame among the components of nodal vectors in inertial axes.
pub(crate) struct Axes {
    pub d: usize,
    pub rotation: Matrix,
}

impl Axes {
    /// Turns a vector from inertial axes (`back`) to those of the frame, or the other way.
    pub fn vector(&self, vector: &mut [f64], back: bool) {
        let old: [f64; 3] = std::array::from_fn(|i| vector.get(i).copied().unwrap_or(0.0));
        for (i, value) in vector.iter_mut().enumerate() {
            let entry = |j: usize| {
                if back {
                    self.rotation[(j, i)]
                } else {
                    self.rotation[(i, j)]
                }
            };
            *value = (0..self.d).map(|j| entry(j) * old[j]).sum();
        }
    }

    /// Turns the rows of a matrix of `width` columns to inertial axes.
    pub fn rows(&self, matrix: &mut [f64], width: usize) {
        if width == 0 {
            return;
        }
        for block in matrix.chunks_exact_mut(self.d * width) {
            for column in 0..width {
                let mut vector: [f64; 3] =
                    std::array::from_fn(|i| if i < self.d { block[i * width + column] } else { 0.0 });
                self.vector(&mut vector[..self.d], false);
                (0..self.d).for_each(|i| block[i * width + column] = vector[i]);
            }
        }
    }

    /// Turns rows and columns of a square matrix to inertial axes.
    pub fn matrix(&self, matrix: &mut [f64], size: usize) {
        self.rows(matrix, size);
        matrix
            .chunks_exact_mut(self.d)
            .for_each(|vector| self.vector(vector, false));
    }
}
