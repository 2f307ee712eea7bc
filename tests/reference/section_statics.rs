//! Static and relative equilibria of chains of ten-vector elements by Newton's method with load steps (THEORY 5.2, 8.1).

use crate::Result;
use crate::banded::Banded;
use crate::inertia::{Frame, centrifugal_and_euler};
use crate::section_chain::{Chain, Slot, Supports};

/// A load on a node.
#[derive(Clone, Copy, Debug)]
pub enum Load {
    /// Dead force, N.
    Force(usize, [f64; 3]),
    /// Moment about the planar normal, on r_y by exact virtual work, N m (THEORY 5.2.1); planar only.
    Moment(usize, f64),
    /// Torque about the tangent, on both directors, N m; spatial only.
    Torque(usize, f64),
}

/// A supported, loaded chain, at rest or turning steadily about an axis through the origin.
#[derive(Clone, Debug)]
pub struct Problem {
    /// The elements.
    pub chain: Chain,
    /// What is held.
    pub supports: Supports,
    /// Loads at scale 1.
    pub loads: Vec<Load>,
    /// Angular velocity at scale 1, rad/s.
    pub spin: [f64; 3],
}

impl Problem {
    /// Coordinates of the equilibrium, from the stress-free shape in `steps` equal steps of loads and spin.
    ///
    /// # Errors
    /// If Newton's method fails; the message names the step.
    pub fn solve(&self, steps: usize) -> Result<Vec<f64>> {
        let mut q = self.chain.stress_free().to_vec();
        for step in 1..=steps {
            self.newton(step as f64 / steps as f64, &mut q)
                .map_err(|error| format!("load step {step} of {steps}: {error}"))?;
        }
        Ok(q)
    }

    /// Newton's method at one scale of loads and spin, from the equilibrium `q`.
    ///
    /// # Errors
    /// If the tangent is singular or 60 iterations do not suffice.
    pub fn newton(&self, scale: f64, q: &mut [f64]) -> Result<()> {
        let mut last = f64::INFINITY;
        for _ in 0..60 {
            let (residual, tangent) = self.residual(scale, q)?;
            let step = tangent.solve(&residual)?;
            if step.iter().any(|x| !x.is_finite()) {
                return Err("the iteration left the numbers: check the loads, take more load steps".into());
            }
            let size = step.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
            // Steps that turn directors by more than half a radian lead astray.
            let shorten = (0.5 / size).min(1.0);
            let back: Vec<f64> = step.iter().map(|x| -shorten * x).collect();
            self.supports.move_by(&back, q);
            // Quadratic convergence until round-off, which shows as no further gain.
            if size < 1e-8 && (size < 1e-13 || size > 0.1 * last) {
                return Ok(());
            }
            last = size;
        }
        Err(format!(
            "not converged, the last step was {last:e}: take more load steps"
        ))
    }

    /// Residual `F_e + M w x (w x q) - Q` and its derivative.
    ///
    /// # Errors
    /// As [`Chain::second_moments`].
    pub fn residual(&self, scale: f64, q: &[f64]) -> Result<(Vec<f64>, Banded)> {
        let forces = self.chain.forces(q, &self.supports);
        let (mut residual, mut tangent) = (forces.force, forces.tangent);
        let n = self.chain.dimension();
        let g = centrifugal_and_euler(&self.frame(scale));
        for (a, b, m) in self.chain.second_moments()? {
            for i in 0..n {
                for j in 0..n {
                    self.supports.add(n * a + i, m * g[i][j] * q[n * b + j], &mut residual);
                    self.supports.add_pair(n * a + i, n * b + j, m * g[i][j], &mut tangent);
                }
            }
        }
        for load in &self.loads {
            self.add_load(*load, scale, q, &mut residual, &mut tangent);
        }
        Ok((residual, tangent))
    }

    fn frame(&self, scale: f64) -> Frame {
        Frame {
            spin: self.spin.map(|w| scale * w),
            ..Frame::default()
        }
    }

    fn add_load(&self, load: Load, scale: f64, q: &[f64], residual: &mut [f64], tangent: &mut Banded) {
        let (n, s) = (self.chain.dimension(), &self.supports);
        match load {
            Load::Force(node, force) => {
                let r = self.chain.vector(node, Slot::Position);
                (0..n).for_each(|k| s.add(n * r + k, -scale * force[k], residual));
            }
            Load::Moment(node, moment) => {
                let at = n * self.chain.vector(node, Slot::Y);
                let (b, turned) = ([q[at], q[at + 1]], [-q[at + 1], q[at]]);
                let (square, moment) = (b[0] * b[0] + b[1] * b[1], scale * moment);
                let quarter = [[0.0, -1.0], [1.0, 0.0]];
                for i in 0..2 {
                    s.add(at + i, -moment * turned[i] / square, residual);
                    for j in 0..2 {
                        let slope = quarter[i][j] / square - 2.0 * turned[i] * b[j] / (square * square);
                        s.add_pair(at + i, at + j, -moment * slope, tangent);
                    }
                }
            }
            Load::Torque(node, torque) => {
                let (y, z) = (
                    n * self.chain.vector(node, Slot::Y),
                    n * self.chain.vector(node, Slot::Z),
                );
                let half = 0.5 * scale * torque;
                for k in 0..n {
                    s.add(y + k, -half * q[z + k], residual);
                    s.add(z + k, half * q[y + k], residual);
                    s.add_pair(y + k, z + k, -half, tangent);
                    s.add_pair(z + k, y + k, half, tangent);
                }
            }
        }
    }
}
