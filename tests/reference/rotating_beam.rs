//! The spin-up beam in the rotating frame (THEORY 2, prescribed motion; 9.1) as a first-order system.
//!
//! The root's conditions hold constant coordinates there, so that reduction is a choice of coordinates.

use crate::Result;
use crate::beam::{Beam, Chain, Root};
use crate::dense::{Cholesky, Matrix};
use crate::element::Weights;
use crate::inertia::{Frame, State};
use crate::spin_up::{Motion, SpinUp};
use crate::system::System;

/// States `(x, x')` with `x` the free coordinates of the chain in the rotating frame.
///
/// `M x'' = - (2 M [w] x' + M ([w'] + [w][w]) q + F_e + d A^T r'')`, rows of the free coordinates.
#[derive(Clone, Debug)]
pub struct RotatingBeam<M = SpinUp> {
    chain: Chain,
    motion: M,
    /// Places of the free coordinates in the chain.
    free: Vec<usize>,
    straight: Vec<f64>,
    factor: Cholesky,
    /// `diag(I, M)`.
    mass: Matrix,
}

impl<M: Motion> RotatingBeam<M> {
    /// Beam that starts straight along x of a frame which turns about z by `motion`.
    ///
    /// # Errors
    /// As [`Chain::new`].
    pub fn new(beam: Beam, motion: M) -> Result<Self> {
        let chain = Chain::new(beam)?;
        let n = chain.dimension();
        let held = match beam.root {
            Root::Pinned => 0..n,
            // The free norm is the slope's x: along the beam.
            Root::Clamped => n + 1..2 * n,
            Root::ClampedFully => n..2 * n,
        };
        let free: Vec<usize> = (n..chain.coordinates()).filter(|k| !held.contains(k)).collect();
        let (full, size) = (chain.mass(), free.len());
        let (mut reduced, mut mass) = (Matrix::zero(size), Matrix::zero(2 * size));
        for i in 0..size {
            mass.set(i, i, 1.0);
            for j in 0..size {
                reduced.set(i, j, full.get(free[i], free[j]));
                mass.set(size + i, size + j, full.get(free[i], free[j]));
            }
        }
        Ok(Self {
            straight: chain.straight(),
            factor: Cholesky::new(&reduced)?,
            chain,
            motion,
            free,
            mass,
        })
    }

    /// The chain behind it.
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// The prescribed motion.
    pub fn motion(&self) -> &M {
        &self.motion
    }

    /// States of the straight beam at rest in the frame.
    pub fn rest(&self) -> Vec<f64> {
        let mut y = vec![0.0; self.size()];
        for (k, &place) in self.free.iter().enumerate() {
            y[k] = self.straight[place];
        }
        y
    }

    /// All coordinates and their rates in the frame.
    pub fn coordinates(&self, y: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (mut q, mut qd) = (self.straight.clone(), vec![0.0; self.straight.len()]);
        for (k, &place) in self.free.iter().enumerate() {
            q[place] = y[k];
            qd[place] = y[self.free.len() + k];
        }
        (q, qd)
    }

    /// Tip position in the frame minus the undeformed one: (u, v, w), m; w = 0 in the plane.
    pub fn tip(&self, y: &[f64]) -> [f64; 3] {
        let (q, _) = self.coordinates(y);
        let n = self.chain.dimension();
        let tip = q.len() - 2 * n;
        std::array::from_fn(|k| {
            if k < n {
                q[tip + k] - self.straight[tip + k]
            } else {
                0.0
            }
        })
    }

    /// The frame's motion at time `t`.
    fn frame(&self, t: f64) -> Frame {
        let (turn, radius) = (self.motion.at(t), self.chain.beam().hub_radius);
        Frame {
            spin: [0.0, 0.0, turn.rate],
            spin_rate: [0.0, 0.0, turn.acceleration],
            origin_acceleration: [-radius * turn.rate * turn.rate, radius * turn.acceleration, 0.0],
        }
    }
}

impl RotatingBeam<SpinUp> {
    /// Relative equilibrium at the final spin (THEORY 8): states with `x' = 0` that balance, by Newton's method from the
    /// straight beam.
    ///
    /// # Errors
    /// If the tangent is singular (a pinned spatial root swings freely out of the plane without spin) or ten steps do
    /// not converge.
    pub fn equilibrium(&self) -> Result<Vec<f64>> {
        let (size, t) = (self.free.len(), 2.0 * self.motion.duration());
        let mut y = self.rest();
        let (mut load, mut jacobian) = (vec![0.0; 2 * size], Matrix::zero(2 * size));
        for _ in 0..10 {
            self.load(t, &y, &mut load);
            self.load_jacobian(t, &y, &mut jacobian);
            let mut stiffness = Matrix::zero(size);
            for i in 0..size {
                for j in 0..size {
                    stiffness.set(i, j, jacobian.get(size + i, j));
                }
            }
            let step = stiffness.solve(&load[size..])?;
            for k in 0..size {
                y[k] -= step[k];
            }
            if step.iter().all(|d| d.abs() < 1e-12 * self.chain.beam().length) {
                return Ok(y);
            }
        }
        Err("the relative equilibrium did not converge in ten Newton steps: lower the spin".into())
    }
}

impl<M: Motion> System for RotatingBeam<M> {
    fn size(&self) -> usize {
        2 * self.free.len()
    }

    fn rate(&self, t: f64, y: &[f64], rate: &mut [f64]) {
        self.load(t, y, rate);
        self.factor.solve(&mut rate[self.free.len()..]);
    }

    fn mass(&self) -> Option<&Matrix> {
        Some(&self.mass)
    }

    fn load(&self, t: f64, y: &[f64], load: &mut [f64]) {
        let size = self.free.len();
        let (q, qd) = self.coordinates(y);
        let (qdd, mut residual) = (vec![0.0; q.len()], vec![0.0; q.len()]);
        self.chain.residual(
            State {
                q: &q,
                qd: &qd,
                qdd: &qdd,
            },
            &self.frame(t),
            &mut residual,
        );
        for (k, &place) in self.free.iter().enumerate() {
            load[k] = y[size + k];
            load[size + k] = -residual[place];
        }
    }

    fn load_jacobian(&self, t: f64, y: &[f64], jacobian: &mut Matrix) {
        let size = self.free.len();
        let (q, qd) = self.coordinates(y);
        let qdd = vec![0.0; q.len()];
        let state = State {
            q: &q,
            qd: &qd,
            qdd: &qdd,
        };
        let mut tangent = Matrix::zero(q.len());
        jacobian.clear();
        for (column, weights) in [(0, Weights::POSITION), (size, Weights::VELOCITY)] {
            self.chain.tangent(state, &self.frame(t), weights, &mut tangent);
            for i in 0..size {
                for j in 0..size {
                    jacobian.set(size + i, column + j, -tangent.get(self.free[i], self.free[j]));
                }
            }
        }
        for k in 0..size {
            jacobian.set(k, size + k, 1.0);
        }
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        let size = self.free.len();
        let mut pattern: Vec<_> = (0..size).map(|k| (k, size + k)).collect();
        for i in 0..size {
            for j in (0..size).filter(|&j| self.chain.coupled(self.free[i], self.free[j])) {
                pattern.extend([(size + i, j), (size + i, size + j)]);
            }
        }
        pattern
    }
}
