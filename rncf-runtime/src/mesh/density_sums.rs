//! What loads per length do to a body and its frame, summed over elements; their axes, and lanes of numbers.

use super::evaluate::MAX_SIZE;
use super::repeated::LANES;
use super::scene::MeshBody;
use crate::vector::{Vector, add, cross};

/// Rows of force and moment, frame axes.
pub(super) const ROWS: usize = 6;

/// What one density does to its body and frame, summed over the elements; frame axes, rows first.
pub(super) struct Total {
    /// Force and moment on the frame.
    pub rows: [Vector; 2],
    /// dQ/dvalues, components x values.
    pub by_values: Vec<f64>,
    /// d(force, moment)/dq, 6 x components.
    pub frame_by_q: Vec<f64>,
    /// d(force, moment)/dvalues, 6 x values.
    pub frame_by_values: Vec<f64>,
}

/// Force and moment of generalised forces on the frame, frame axes.
pub(super) fn on_frame(body: &MeshBody, q: &[f64], force: &[f64]) -> [Vector; 2] {
    let mut rows = [[0.0; 3]; 2];
    for (a, nodal) in body.spec.nodal.iter().enumerate() {
        let [at, force] = [q, force].map(|all| vector_of(body, all, a));
        if nodal.is_position() {
            rows[0] = add(rows[0], force);
        }
        rows[1] = add(rows[1], cross(at, force));
    }
    rows
}

/// Vector `a` of an element's components, frame axes.
fn vector_of(body: &MeshBody, all: &[f64], a: usize) -> Vector {
    let d = body.spec.dimension();
    body.spread(std::array::from_fn(|c| if c < d { all[a * d + c] } else { 0.0 }))
}

impl Total {
    /// Nothing yet, of so many components and values.
    pub fn new(count: usize, k: usize) -> Self {
        Self {
            rows: [[0.0; 3]; 2],
            by_values: vec![0.0; count * k],
            frame_by_q: vec![0.0; ROWS * count],
            frame_by_values: vec![0.0; ROWS * k],
        }
    }

    /// Adds force and moment of one element and their derivatives: `dF = c_a dQ^a`,
    /// `dM = q_a x dQ^a + dq_a x Q^a`.
    pub fn add_frame(&mut self, body: &MeshBody, q: &[f64], places: &[usize], [force, by_q, by_values]: [&[f64]; 3]) {
        let (n, d) = (force.len(), body.spec.dimension());
        let k = by_values.len() / n;
        let count = self.frame_by_q.len() / ROWS;
        let rows = on_frame(body, q, force);
        self.rows = std::array::from_fn(|i| add(self.rows[i], rows[i]));
        let column = |matrix: &[f64], width: usize, column: usize| -> [f64; MAX_SIZE] {
            std::array::from_fn(|row| matrix.get(row * width + column).map_or(0.0, |value| *value))
        };
        for (c, &place) in places.iter().enumerate() {
            let [by_force, mut moment] = on_frame(body, q, &column(by_q, n, c));
            let mut unit = [0.0; 3];
            unit[body.spec.axes[c % d]] = 1.0;
            moment = add(moment, cross(unit, vector_of(body, force, c / d)));
            for i in 0..3 {
                self.frame_by_q[i * count + place] += by_force[i];
                self.frame_by_q[(3 + i) * count + place] += moment[i];
            }
        }
        for value in 0..k {
            let [by_force, moment] = on_frame(body, q, &column(by_values, k, value));
            for i in 0..3 {
                self.frame_by_values[i * k + value] += by_force[i];
                self.frame_by_values[(3 + i) * k + value] += moment[i];
            }
        }
    }
}

/// Axes of a frame among the components of nodal vectors in inertial axes.
pub(super) struct Axes {
    pub d: usize,
    pub rotation: [[f64; 3]; 3],
}

impl Axes {
    /// Turns a vector from inertial axes (`back`) to those of the frame, or the other way.
    pub fn vector(&self, vector: &mut [f64], back: bool) {
        let old: [f64; 3] = std::array::from_fn(|i| vector.get(i).copied().unwrap_or(0.0));
        for (i, value) in vector.iter_mut().enumerate() {
            let entry = |j: usize| if back { self.rotation[j][i] } else { self.rotation[i][j] };
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

/// Declaration and number of the repetition of what has this number, where declarations are repeated so many times.
pub fn declared(counts: &[usize], number: usize) -> (usize, usize) {
    let mut rest = number;
    for (declaration, &count) in counts.iter().enumerate() {
        match rest.checked_sub(count) {
            Some(beyond) => rest = beyond,
            None => return (declaration, rest),
        }
    }
    (counts.len(), rest)
}

/// One of four elements' numbers.
pub fn lane<const N: usize>(all: &[[f64; LANES]], lane: usize) -> [f64; N] {
    std::array::from_fn(|place| all[place][lane])
}

/// Adds the numbers of one of four elements.
pub fn add_lane(all: &mut [[f64; LANES]], lane: usize, own: &[f64]) {
    for (sum, value) in all.iter_mut().zip(own) {
        sum[lane] += value;
    }
}
