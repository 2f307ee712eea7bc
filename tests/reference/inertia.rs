//! Inertia of the element in a frame of prescribed motion (THEORY 2), and the whole element's residual and Jacobian.
//!
//! ```text
//! R_a = d^a A^T r'' + M^ab (q''_b + 2 w x q'_b + w' x q_b + w x (w x q_b)) + F_e^a
//! ```

use crate::Result;
use crate::element::{Data, ElasticForce, VECTORS, Weights};

/// Motion of the frame at one instant, in the frame's own components. Planar elements use x, y of the origin's
/// acceleration and z of the rotations.
#[derive(Clone, Copy, Debug, Default)]
pub struct Frame {
    /// Angular velocity w, rad/s.
    pub spin: [f64; 3],
    /// Its derivative w', rad/s^2.
    pub spin_rate: [f64; 3],
    /// `A^T r''` of the origin, m/s^2 (subtract gravity here, THEORY 2).
    pub origin_acceleration: [f64; 3],
}

/// Coordinates of an element with their first two derivatives, each `4 dimension` long.
#[derive(Clone, Copy, Debug)]
pub struct State<'s> {
    /// Positions and slopes q.
    pub q: &'s [f64],
    /// q'.
    pub qd: &'s [f64],
    /// q''.
    pub qdd: &'s [f64],
}

/// Mass moments of an element.
#[derive(Clone, Debug)]
pub struct Inertia {
    dimension: usize,
    first: [f64; VECTORS],
    second: [[f64; VECTORS]; VECTORS],
}

/// The matrix `[u]` with `[u] v = u x v`.
pub fn skew(u: [f64; 3]) -> [[f64; 3]; 3] {
    [[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]]
}

/// `G = [w'] + [w][w]`.
pub fn centrifugal_and_euler(frame: &Frame) -> [[f64; 3]; 3] {
    let (w, mut g) = (skew(frame.spin), skew(frame.spin_rate));
    for i in 0..3 {
        for j in 0..3 {
            for k in 0..3 {
                g[i][j] += w[i][k] * w[k][j];
            }
        }
    }
    g
}

impl Inertia {
    /// Mass moments of the element with these data.
    ///
    /// # Errors
    /// As [`Data::check`].
    pub fn new(data: &Data) -> Result<Self> {
        data.check()?;
        Ok(Self {
            dimension: data.dimension,
            first: data.first_moments()?,
            second: data.second_moments()?,
        })
    }

    /// Second mass moments `M^ab`.
    pub fn second_moments(&self) -> &[[f64; VECTORS]; VECTORS] {
        &self.second
    }

    /// Adds `d^a A^T r'' + M^ab a_b` to `residual` (`4 dimension` entries).
    pub fn add_residual(&self, state: State, frame: &Frame, residual: &mut [f64]) {
        let n = self.dimension;
        let (w, g) = (skew(frame.spin), centrifugal_and_euler(frame));
        for b in 0..VECTORS {
            let mut acceleration = [0.0; 3];
            for k in 0..n {
                acceleration[k] = state.qdd[n * b + k];
                for m in 0..n {
                    acceleration[k] += 2.0 * w[k][m] * state.qd[n * b + m] + g[k][m] * state.q[n * b + m];
                }
            }
            for a in 0..VECTORS {
                for k in 0..n {
                    residual[n * a + k] += self.second[a][b] * acceleration[k];
                }
            }
        }
        for a in 0..VECTORS {
            for k in 0..n {
                residual[n * a + k] += self.first[a] * frame.origin_acceleration[k];
            }
        }
    }

    /// Adds `acceleration M + velocity 2 M [w] + position M ([w'] + [w][w])` to `tangent` (row after row).
    pub fn add_tangent(&self, frame: &Frame, weights: Weights, tangent: &mut [f64]) {
        let n = self.dimension;
        let size = n * VECTORS;
        let (w, g) = (skew(frame.spin), centrifugal_and_euler(frame));
        let mut block = [[0.0; 3]; 3];
        for k in 0..n {
            block[k][k] = weights.acceleration;
            for m in 0..n {
                block[k][m] += weights.velocity * 2.0 * w[k][m] + weights.position * g[k][m];
            }
        }
        for a in 0..VECTORS {
            for b in 0..VECTORS {
                for k in 0..n {
                    for m in 0..n {
                        tangent[(n * a + k) * size + n * b + m] += self.second[a][b] * block[k][m];
                    }
                }
            }
        }
    }
}

/// Sets `residual` to the element's whole residual `R(q, q', q'')` without loads.
pub fn residual(elastic: &impl ElasticForce, inertia: &Inertia, state: State, frame: &Frame, residual: &mut [f64]) {
    residual.fill(0.0);
    inertia.add_residual(state, frame, residual);
    elastic.add_force(state.q, state.qd, residual);
}

/// Sets `residual` as [`residual`](fn@residual) does, and `jacobian` (row after row) to its derivative
/// `acceleration dR/dq'' + velocity dR/dq' + position dR/dq`.
pub fn residual_and_jacobian(
    elastic: &impl ElasticForce,
    inertia: &Inertia,
    state: State,
    frame: &Frame,
    weights: Weights,
    residual: &mut [f64],
    jacobian: &mut [f64],
) {
    residual.fill(0.0);
    jacobian.fill(0.0);
    inertia.add_residual(state, frame, residual);
    inertia.add_tangent(frame, weights, jacobian);
    elastic.add_force_and_tangent(state.q, state.qd, weights, residual, jacobian);
}
