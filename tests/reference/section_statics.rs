//! Static and relative equilibria of chains of ten-vector elements by Newton's method with load steps (THEORY 5.2, 8.1).

use crate::Result;
use crate::banded::Banded;
use crate::dense::Matrix;
use crate::inertia::{Frame, centrifugal_and_euler, skew};
use crate::section_chain::{Chain, Slot, Supports};
use crate::symmetric;

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
            let size = step
                .iter()
                .fold(0.0, |a: f64, x| if x.is_nan() { f64::NAN } else { a.max(x.abs()) });
            if size.is_nan() {
                return Err("the iteration left the numbers: take more load steps".into());
            }
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

    /// Frequencies (rad/s, ascending, in the turning frame) of small undamped motions about the equilibrium `q` at
    /// scale 1: `M x'' + 2 M [w] x' + K x = 0` with positive definite K, by Meirovitch's symmetric form.
    ///
    /// # Errors
    /// If K or M is not positive definite: the equilibrium is no minimum of the energy in the turning frame.
    pub fn frequencies(&self, q: &[f64]) -> Result<Vec<f64>> {
        let (k, m, g) = self.linearised(q)?;
        let n = k.size();
        // y = (x', x), diag(M, K) y' + [[G, K], [-K, 0]] y = 0; squared: nu^2 diag(M, K) y = S^T diag(M, K)^-1 S y.
        let (mut weight, mut skewed) = (Matrix::zero(2 * n), Matrix::zero(2 * n));
        for i in 0..n {
            for j in 0..n {
                weight.set(i, j, m.get(i, j));
                weight.set(n + i, n + j, k.get(i, j));
                skewed.set(i, j, g.get(i, j));
                skewed.set(i, n + j, k.get(i, j));
                skewed.set(n + i, j, -k.get(i, j));
            }
        }
        // With half = L^-1 S the square is half^T half.
        let factor = crate::dense::Cholesky::new(&weight)?;
        let columns: Vec<Vec<f64>> = (0..2 * n)
            .map(|j| {
                let mut column: Vec<f64> = (0..2 * n).map(|i| skewed.get(i, j)).collect();
                factor.forward(&mut column);
                column
            })
            .collect();
        let mut squared = Matrix::zero(2 * n);
        for i in 0..2 * n {
            for j in 0..2 * n {
                squared.set(i, j, columns[i].iter().zip(&columns[j]).map(|(a, b)| a * b).sum());
            }
        }
        // Every frequency comes twice; the lowest are the largest values the other way round.
        let inverse = symmetric::generalised(&weight, &squared)?;
        Ok(inverse.into_iter().rev().step_by(2).map(|s| s.sqrt().recip()).collect())
    }

    /// Speeds (rad/s, ascending) about the direction of `spin` at which `K - Omega^2 M P` of the stress-free shape
    /// becomes singular: critical speeds of a balanced rotor (THEORY 8.2).
    ///
    /// # Errors
    /// If the supports leave a rigid motion.
    pub fn critical_speeds(&self) -> Result<Vec<f64>> {
        let q = self.chain.stress_free().to_vec();
        let size = self.spin.iter().map(|w| w * w).sum::<f64>().sqrt();
        let unit = Self {
            spin: self.spin.map(|w| w / size),
            ..self.clone()
        };
        let (turning, ..) = unit.linearised(&q)?;
        let still = Self {
            spin: [0.0; 3],
            ..self.clone()
        };
        let (k, ..) = still.linearised(&q)?;
        let mut softening = Matrix::zero(k.size());
        for i in 0..k.size() {
            for j in 0..k.size() {
                softening.set(i, j, k.get(i, j) - turning.get(i, j));
            }
        }
        let inverse = symmetric::generalised(&softening, &k)?;
        let bent = inverse.into_iter().rev().filter(|&s| s > 0.0);
        Ok(bent.map(|s| s.sqrt().recip()).collect())
    }

    /// Stiffness with the centrifugal part, mass and gyroscopic matrix about `q`, dense.
    fn linearised(&self, q: &[f64]) -> Result<(Matrix, Matrix, Matrix)> {
        let (n, w) = (self.chain.dimension(), skew(self.spin));
        let (_, k) = self.residual(1.0, q)?;
        let (mut m, mut g) = (self.supports.matrix(), self.supports.matrix());
        for (a, b, moment) in self.chain.second_moments()? {
            for i in 0..n {
                self.supports.add_pair(n * a + i, n * b + i, moment, &mut m);
                for j in 0..n {
                    let twice = 2.0 * moment * w[i][j];
                    self.supports.add_pair(n * a + i, n * b + j, twice, &mut g);
                }
            }
        }
        Ok((dense(&k), dense(&m), dense(&g)))
    }
}

/// The matrix with its zeros.
pub fn dense(banded: &Banded) -> Matrix {
    let mut full = Matrix::zero(banded.size());
    for i in 0..banded.size() {
        for j in 0..banded.size() {
            full.set(i, j, banded.get(i, j));
        }
    }
    full
}
