//! The whole ten-vector element in a frame of prescribed motion (THEORY 2): inertia, elastic and damping forces.

use crate::Result;
use crate::element::Weights;
use crate::inertia::{Frame, State, centrifugal_and_euler, skew};
use crate::quadrature::{Point, gauss_legendre};
use crate::section_beam::{Element, VECTORS, particle, residual_and_jacobian as elastic};

/// An element with its mass moments, and room for its tangents.
#[derive(Clone, Debug)]
pub struct MovingElement {
    element: Element,
    first: [f64; VECTORS],
    second: [[f64; VECTORS]; VECTORS],
    k: Vec<f64>,
    c: Vec<f64>,
}

impl MovingElement {
    /// The element with its mass moments, exact.
    ///
    /// # Errors
    /// As [`gauss_legendre`].
    pub fn new(element: Element) -> Result<Self> {
        let (p, size) = (element.properties(), element.coordinates());
        let mut first = [0.0; VECTORS];
        for Point { xi, weight } in gauss_legendre(2)? {
            let [row, ..] = particle(p.dimension, xi, p.length);
            for a in 0..VECTORS {
                first[a] += weight * p.length * p.mass[0] * row[a];
            }
        }
        Ok(Self {
            first,
            second: element.second_moments()?,
            k: vec![0.0; size * size],
            c: vec![0.0; size * size],
            element,
        })
    }

    /// First mass moments `d^a`: kg on positions, kg m on slopes, zero on directors.
    pub fn first_moments(&self) -> &[f64; VECTORS] {
        &self.first
    }

    /// Sets `residual` to `d^a A^T r'' + M^ab a_b + F_e^a`, and `jacobian` (row after row) to
    /// `acceleration dR/dq'' + velocity dR/dq' + position dR/dq`.
    pub fn residual_and_jacobian(
        &mut self,
        state: State,
        frame: &Frame,
        weights: Weights,
        residual: &mut [f64],
        jacobian: &mut [f64],
    ) {
        elastic(state.q, state.qd, &self.element, residual, &mut self.k, &mut self.c);
        for at in 0..jacobian.len() {
            jacobian[at] = weights.position * self.k[at] + weights.velocity * self.c[at];
        }
        let (n, size) = (self.element.properties().dimension, self.element.coordinates());
        let vectors = size / n;
        let (w, g) = (skew(frame.spin), centrifugal_and_euler(frame));
        for b in 0..vectors {
            let mut acceleration = [0.0; 3];
            for k in 0..n {
                acceleration[k] = state.qdd[n * b + k];
                for m in 0..n {
                    acceleration[k] += 2.0 * w[k][m] * state.qd[n * b + m] + g[k][m] * state.q[n * b + m];
                }
            }
            for a in 0..vectors {
                let moment = self.second[a][b];
                for k in 0..n {
                    residual[n * a + k] += moment * acceleration[k];
                    for m in 0..n {
                        let unit = if k == m { weights.acceleration } else { 0.0 };
                        let block = unit + weights.velocity * 2.0 * w[k][m] + weights.position * g[k][m];
                        jacobian[size * (n * a + k) + n * b + m] += moment * block;
                    }
                }
            }
        }
        for a in 0..vectors {
            for k in 0..n {
                residual[n * a + k] += self.first[a] * frame.origin_acceleration[k];
            }
        }
    }
}
