//! The spin-up beam in the inertial frame (absolute nodal coordinates, THEORY 3.3) as a first-order system.
//!
//! The root's position and the direction of its slope are prescribed by reduction, `q = E(t) x + q0(t)`: the slope is
//! `u t(t)` with the unit vector `t` along the turned x axis and its norm `u` unknown. No multiplier is left.
//!
//! ```text
//! E^T M E x'' = - E^T ( M (2 E' x' + E'' x + q0'') + F_e(q, q') )
//! ```

use crate::Result;
use crate::beam::{Beam, Chain, Root};
use crate::dense::{Cholesky, Matrix};
use crate::element::Weights;
use crate::inertia::{Frame, State};
use crate::spin_up::{Motion, SpinUp};
use crate::system::System;

/// States `(x, x')`; `x` is the slope's norm `u` where the root is clamped, then the free coordinates of the chain.
#[derive(Clone, Debug)]
pub struct InertialBeam {
    chain: Chain,
    motion: SpinUp,
    mass: Matrix,
    /// First coordinate of the chain that is free as it stands; all after it are.
    first_free: usize,
}

/// The turned x axis and its first two derivatives.
struct Axis {
    direction: [f64; 3],
    rate: [f64; 3],
    acceleration: [f64; 3],
}

impl InertialBeam {
    /// Beam that starts straight along x, its root at `(hub_radius, 0)`, and is turned about z by `motion`.
    ///
    /// # Errors
    /// As [`Chain::new`].
    pub fn new(beam: Beam, motion: SpinUp) -> Result<Self> {
        let chain = Chain::new(beam)?;
        let n = chain.dimension();
        let first_free = if beam.root == Root::Pinned { n } else { 2 * n };
        // A wrong mass must show here, not in the middle of an integration.
        Cholesky::new(&chain.mass())?;
        Ok(Self {
            mass: chain.mass(),
            chain,
            motion,
            first_free,
        })
    }

    /// The chain behind it.
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// States of the straight beam at rest.
    pub fn rest(&self) -> Vec<f64> {
        let (straight, n) = (self.chain.straight(), self.chain.dimension());
        let mut y: Vec<f64> = self.norm().map(|_| 1.0).into_iter().collect();
        for place in self.first_free..straight.len() {
            // x of every position lies behind the hub.
            let offset = if place % (2 * n) == 0 {
                self.chain.beam().hub_radius
            } else {
                0.0
            };
            y.push(straight[place] + offset);
        }
        y.resize(self.size(), 0.0);
        y
    }

    /// All inertial coordinates and their rates.
    pub fn coordinates(&self, t: f64, y: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (q, qd, _) = self.expand(t, y);
        (q, qd)
    }

    /// Tip position in the turned axes minus the undeformed one: (u, v, w), m; w = 0 in the plane.
    pub fn tip(&self, t: f64, y: &[f64]) -> [f64; 3] {
        let (q, _, _) = self.expand(t, y);
        let (n, (sin, cos)) = (self.chain.dimension(), self.motion.at(t).angle.sin_cos());
        let tip = q.len() - 2 * n;
        let [x, y] = [q[tip] - q[0], q[tip + 1] - q[1]];
        let w = if n == 3 { q[tip + 2] - q[2] } else { 0.0 };
        [cos * x + sin * y - self.chain.beam().length, -sin * x + cos * y, w]
    }

    /// Place of the slope's norm among the unknowns, where it is one.
    fn norm(&self) -> Option<usize> {
        (self.chain.beam().root == Root::Clamped).then_some(0)
    }

    /// Number of unknowns x.
    fn unknowns(&self) -> usize {
        self.chain.coordinates() - self.first_free + usize::from(self.norm().is_some())
    }

    /// The turned x axis at time `t`.
    fn axis(&self, t: f64) -> Axis {
        let turn = self.motion.at(t);
        let (sin, cos) = turn.angle.sin_cos();
        let square = turn.rate * turn.rate;
        Axis {
            direction: [cos, sin, 0.0],
            rate: [-turn.rate * sin, turn.rate * cos, 0.0],
            acceleration: [
                -turn.acceleration * sin - square * cos,
                turn.acceleration * cos - square * sin,
                0.0,
            ],
        }
    }

    /// `q`, `q'`, and `q''` for `x'' = 0`.
    fn expand(&self, t: f64, y: &[f64]) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let (n, size, axis) = (self.chain.dimension(), self.unknowns(), self.axis(t));
        let radius = self.chain.beam().hub_radius;
        let full = self.chain.coordinates();
        let (mut q, mut qd, mut qdd) = (vec![0.0; full], vec![0.0; full], vec![0.0; full]);
        // The slope's norm and its rate; a fully clamped slope keeps norm 1.
        let (u, ud) = self.norm().map_or((1.0, 0.0), |k| (y[k], y[size + k]));
        for k in 0..n {
            q[k] = radius * axis.direction[k];
            qd[k] = radius * axis.rate[k];
            qdd[k] = radius * axis.acceleration[k];
            q[n + k] = u * axis.direction[k];
            qd[n + k] = ud * axis.direction[k] + u * axis.rate[k];
            qdd[n + k] = 2.0 * ud * axis.rate[k] + u * axis.acceleration[k];
        }
        let shift = size - (full - self.first_free);
        for place in self.first_free..full {
            let k = place - self.first_free + shift;
            (q[place], qd[place], qdd[place]) = (y[k], y[size + k], 0.0);
        }
        (q, qd, qdd)
    }

    /// `E^T f`.
    fn project(&self, axis: &Axis, full: &[f64]) -> Vec<f64> {
        let n = self.chain.dimension();
        let along = self
            .norm()
            .map(|_| (0..n).map(|k| axis.direction[k] * full[n + k]).sum());
        along
            .into_iter()
            .chain(full[self.first_free..].iter().copied())
            .collect()
    }

    /// Columns of `matrix` combined by E, or for its derivatives by the given change of the axis; only the norm's
    /// column changes with time.
    fn column(&self, matrix: &Matrix, k: usize, axis: &[f64; 3]) -> Vec<f64> {
        let (n, rows) = (self.chain.dimension(), 0..matrix.size());
        if self.norm() == Some(k) {
            return rows
                .map(|i| (0..n).map(|m| matrix.get(i, n + m) * axis[m]).sum())
                .collect();
        }
        let place = self.first_free + k - usize::from(self.norm().is_some());
        rows.map(|i| matrix.get(i, place)).collect()
    }

    /// Factor of `E^T M E`.
    fn factor(&self, axis: &Axis) -> Option<Cholesky> {
        let size = self.unknowns();
        let mut reduced = Matrix::zero(size);
        for k in 0..size {
            let column = self.project(axis, &self.column(&self.mass, k, &axis.direction));
            for i in 0..size {
                reduced.set(i, k, column[i]);
            }
        }
        // E has full column rank and M was factored at the start: this only fails on a time that is not finite.
        Cholesky::new(&reduced).ok()
    }

    /// Solves with `E^T M E`; NaN, which the integrator reports, if there is no factor.
    fn solve(factor: &Option<Cholesky>, right: &mut [f64]) {
        match factor {
            Some(factor) => factor.solve(right),
            None => right.fill(f64::NAN),
        }
    }
}

impl System for InertialBeam {
    fn size(&self) -> usize {
        2 * self.unknowns()
    }

    fn rate(&self, t: f64, y: &[f64], rate: &mut [f64]) {
        let (size, axis) = (self.unknowns(), self.axis(t));
        let (q, qd, qdd) = self.expand(t, y);
        let mut residual = vec![0.0; q.len()];
        self.chain.residual(
            State {
                q: &q,
                qd: &qd,
                qdd: &qdd,
            },
            &Frame::default(),
            &mut residual,
        );
        let projected = self.project(&axis, &residual);
        for k in 0..size {
            rate[k] = y[size + k];
            rate[size + k] = -projected[k];
        }
        Self::solve(&self.factor(&axis), &mut rate[size..]);
    }

    fn load_jacobian(&self, t: f64, y: &[f64], jacobian: &mut Matrix) {
        let (size, axis) = (self.unknowns(), self.axis(t));
        let (q, qd, qdd) = self.expand(t, y);
        let state = State {
            q: &q,
            qd: &qd,
            qdd: &qdd,
        };
        let (mut stiffness, mut damping) = (Matrix::zero(q.len()), Matrix::zero(q.len()));
        self.chain
            .tangent(state, &Frame::default(), Weights::POSITION, &mut stiffness);
        self.chain
            .tangent(state, &Frame::default(), Weights::VELOCITY, &mut damping);
        let factor = self.factor(&axis);
        jacobian.clear();
        for k in 0..size {
            let mut by_x = self.column(&stiffness, k, &axis.direction);
            let mut by_v = self.column(&damping, k, &axis.direction);
            if self.norm() == Some(k) {
                let turned = self.column(&self.mass, k, &axis.acceleration);
                let dragged = self.column(&damping, k, &axis.rate);
                let coriolis = self.column(&self.mass, k, &axis.rate);
                for i in 0..q.len() {
                    by_x[i] += turned[i] + dragged[i];
                    by_v[i] += 2.0 * coriolis[i];
                }
            }
            jacobian.set(k, size + k, 1.0);
            for (column, full) in [(k, by_x), (size + k, by_v)] {
                let mut rate = self.project(&axis, &full);
                Self::solve(&factor, &mut rate);
                for i in 0..size {
                    jacobian.set(size + i, column, -rate[i]);
                }
            }
        }
    }
}
