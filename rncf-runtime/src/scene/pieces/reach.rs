//! The way from the start of an element to a place on it: what sections carry there is linear in what acts on the nodal
//! vectors, with coefficients that depend on shape functions and length alone.
//!
//! What acts on nodal vectors, `f_b`, is that of a force per length which is interpolated as the vectors are: `f_b = int s_b s_c dx
//! p_c`. That itself where it is at most cubic, as inertia is; else the nearest to it, with the same force and moment. From the start
//! up to xi it sums to
//!
//! ```text
//! F = sum_b I_b f_b,   M = sum_ab G_ab q_a x f_b - r x F
//! ```

use crate::emitted::{BodySpec, FIVE, Interpolant, LANES, Parts, legendre};
use crate::linalg::Cholesky;

/// A body of a model.
#[derive(Clone, Copy)]
pub(crate) struct Body<'a> {
    pub parts: &'a dyn Parts,
    pub index: usize,
    pub spec: &'a BodySpec,
}

/// Weights of an element's nodal vectors in what it interpolates at a place, zeros where it does not; sums up to there.
#[derive(Clone, Debug)]
pub(crate) struct Reach {
    /// The place, in [0, 1].
    pub xi: f64,
    pub position: Vec<f64>,
    pub slope: Vec<f64>,
    /// Of r_y and r_z.
    pub axes: [Vec<f64>; 2],
    /// I, and G with rows first.
    pub forces: Vec<f64>,
    pub levers: Vec<f64>,
}

/// Reaches on the elements of a body, as they were asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reaches {
    lengths: Vec<OfLength>,
    /// Among them, that of the element begun last.
    at: usize,
    /// Memory of what reads four elements at a time: zeros along axes that the body does not have.
    pub four: Vec<[f64; LANES]>,
}

impl Reaches {
    /// For an element of a body, which is always the same one.
    pub fn begin(&mut self, body: Body<'_>, element: usize) {
        let length = body.spec.element_length(element);
        let is_it = |of: &OfLength| of.length == length;
        if self.lengths.get(self.at).is_some_and(is_it) {
            return;
        }
        // Elements are mostly read in their order.
        self.at += 1;
        if !self.lengths.get(self.at).is_some_and(is_it) {
            let known = self.lengths.iter().position(is_it);
            self.at = known.unwrap_or_else(|| {
                self.lengths.push(OfLength::new(body, element, length));
                self.lengths.len() - 1
            });
        }
    }

    /// That up to `xi` of the element begun last.
    pub fn to(&mut self, body: Body<'_>, xi: f64) -> &Reach {
        self.lengths[self.at].to(body, xi)
    }

    /// The same of a place that may be another one each time.
    pub fn once(&self, body: Body<'_>, xi: f64) -> Reach {
        self.lengths[self.at].made(body, xi)
    }
}

/// Reaches on elements of one length.
#[derive(Clone, Debug)]
struct OfLength {
    /// One of the elements, and its length, m.
    element: usize,
    length: f64,
    /// Inverse of `int s_a s_b dx`, rows first; zeros for vectors of different interpolants.
    inverse: Vec<f64>,
    known: Vec<Reach>,
}

/// A rule that is exact for products of two of so many shape functions: polynomials of a degree less than their number.
fn rule(functions: usize) -> Vec<(f64, f64)> {
    if functions <= FIVE.len() {
        FIVE.to_vec()
    } else {
        legendre(functions)
    }
}

const INTERPOLANTS: [Interpolant; 3] = [Interpolant::Position, Interpolant::SectionY, Interpolant::SectionZ];

impl OfLength {
    fn new(body: Body<'_>, element: usize, length: f64) -> Self {
        let count = body.spec.nodal.len();
        let mut of_length = Self {
            element,
            length,
            inverse: vec![0.0; count * count],
            known: Vec::new(),
        };
        for of in INTERPOLANTS {
            of_length.invert(body, of);
        }
        of_length
    }

    /// Fills in the inverse of one interpolant.
    fn invert(&mut self, body: Body<'_>, of: Interpolant) {
        let nodal = body.spec.nodal;
        let own: Vec<usize> = (0..nodal.len()).filter(|&vector| nodal[vector].of == of).collect();
        let mut matrix = vec![0.0; own.len() * own.len()];
        for (xi, weight) in rule(own.len()) {
            let shapes = self.shapes(body, of, 0, xi);
            for (place, entry) in matrix.iter_mut().enumerate() {
                let (row, column) = (own[place / own.len()], own[place % own.len()]);
                *entry += self.length * weight * shapes[row] * shapes[column];
            }
        }
        // Shape functions are independent.
        let Ok(factor) = Cholesky::new(own.len(), &matrix) else {
            return;
        };
        for (place, &vector) in own.iter().enumerate() {
            let mut column = vec![0.0; own.len()];
            column[place] = 1.0;
            factor.solve(&mut column);
            for (&row, value) in own.iter().zip(column) {
                self.inverse[row * nodal.len() + vector] = value;
            }
        }
    }

    fn shapes(&self, body: Body<'_>, of: Interpolant, order: usize, xi: f64) -> Vec<f64> {
        let mut weights = vec![0.0; body.spec.nodal.len()];
        if body.spec.interpolates(of) {
            body.parts.shapes(body.index, self.element, of, order, xi, &mut weights);
        }
        weights
    }

    fn to(&mut self, body: Body<'_>, xi: f64) -> &Reach {
        let known = self.known.iter().position(|reach| reach.xi == xi);
        let place = known.unwrap_or_else(|| {
            self.known.push(self.made(body, xi));
            self.known.len() - 1
        });
        &self.known[place]
    }

    fn made(&self, body: Body<'_>, xi: f64) -> Reach {
        let count = body.spec.nodal.len();
        // Of the force per length at its nodal values.
        let (mut forces, mut levers) = (vec![0.0; count], vec![0.0; count * count]);
        let functions = |of| body.spec.nodal.iter().filter(|vector| vector.of == of).count();
        for (point, weight) in rule(INTERPOLANTS.map(functions).into_iter().fold(0, usize::max)) {
            let part = xi * weight * self.length;
            for of in INTERPOLANTS {
                let shapes = self.shapes(body, of, 0, xi * point);
                for (row, &by) in shapes.iter().enumerate() {
                    for (column, shape) in shapes.iter().enumerate() {
                        levers[row * count + column] += part * by * shape;
                    }
                    if of == Interpolant::Position {
                        forces[row] += part * by;
                    }
                }
            }
        }
        let on_vectors = |row: &[f64]| -> Vec<f64> {
            let column = |b: usize| (0..count).map(|c| row[c] * self.inverse[c * count + b]).sum();
            (0..count).map(column).collect()
        };
        Reach {
            xi,
            position: self.shapes(body, Interpolant::Position, 0, xi),
            slope: self.shapes(body, Interpolant::Position, 1, xi),
            axes: [Interpolant::SectionY, Interpolant::SectionZ].map(|of| self.shapes(body, of, 0, xi)),
            forces: on_vectors(&forces),
            levers: levers.chunks_exact(count).flat_map(on_vectors).collect(),
        }
    }
}
