//! Small motions of chains of ten-vector elements about relative equilibria (THEORY 8.2):
//! `M x'' + (2 M [w] + C) x' + (K_T + M [w]^2) x = 0`.

use crate::Result;
use crate::banded::Banded;
use crate::dense::{Cholesky, Matrix};
use crate::inertia::skew;
use crate::section_statics::Problem;
use crate::symmetric;

/// A complex number: real and imaginary part.
pub type Complex = [f64; 2];

/// What damps a small motion.
#[derive(Clone, Copy, Debug)]
pub enum Damping {
    /// The elements' own damping of the strain measures, `c B^T D B` (THEORY 5.2).
    Measures,
    /// `c K_T`, stresses included: another law where the equilibrium is stressed. THEORY 9.3 has its numbers.
    Stiffness(f64),
}

/// Stiffness with the centrifugal part, mass, gyroscopic matrix, damping.
struct Linearised {
    k: Matrix,
    m: Matrix,
    g: Matrix,
    c: Matrix,
}

impl Problem {
    /// Frequencies (rad/s, ascending, in the turning frame) of small undamped motions about the equilibrium `q` at
    /// scale 1: `M x'' + 2 M [w] x' + K x = 0` with positive definite K, by Meirovitch's symmetric form.
    ///
    /// # Errors
    /// If K or M is not positive definite: the equilibrium is no minimum of the energy in the turning frame.
    pub fn frequencies(&self, q: &[f64]) -> Result<Vec<f64>> {
        let Linearised { k, m, g, .. } = self.linearised(q)?;
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
        let factor = Cholesky::new(&weight)?;
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
        let turning = unit.linearised(&q)?.k;
        let still = Self {
            spin: [0.0; 3],
            ..self.clone()
        };
        let k = still.linearised(&q)?.k;
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

    /// The eigenvalue `s` (1/s) nearest to a guess, of motions `exp(s t)` about the equilibrium `q` at scale 1 with
    /// gyroscopic and damping terms: inverse iteration at the guess, then Newton's method on the eigenvalue.
    ///
    /// # Errors
    /// If the iteration does not settle.
    pub fn eigenvalue_near(&self, q: &[f64], damping: Damping, guess: Complex) -> Result<Complex> {
        let mut matrices = self.linearised(q)?;
        if let Damping::Stiffness(factor) = damping {
            let tangent = dense(&self.chain.forces(q, &self.supports).tangent);
            matrices.c.clear();
            let n = tangent.size();
            (0..n * n).for_each(|at| matrices.c.set(at / n, at % n, factor * tangent.get(at / n, at % n)));
        }
        let n = matrices.k.size();
        // Real parts, then imaginary ones; no mode is orthogonal to such a vector.
        let mut shape: Vec<f64> = (0..2 * n).map(|i| (1.0 + i as f64).sin()).collect();
        let mut s = guess;
        for iteration in 0..60 {
            let right = matrices.product(s, &shape);
            let next = matrices.pencil(s).solve(&right)?;
            // <shape, shape> / <shape, next> is the distance to the eigenvalue.
            let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
            let (re, im) = (
                dot(&shape, &next),
                dot(&shape[..n], &next[n..]) - dot(&shape[n..], &next[..n]),
            );
            let own = dot(&shape, &shape) / (re * re + im * im);
            let (d_re, d_im) = (own * re, -own * im);
            let norm = dot(&next, &next).sqrt();
            shape = next.iter().map(|x| x / norm).collect();
            if iteration < 8 {
                continue;
            }
            s = [s[0] - d_re, s[1] - d_im];
            // Convergence is quadratic: the step after this one would be lost in round-off.
            if d_re.hypot(d_im) < 1e-8 * guess[0].hypot(guess[1]) {
                return Ok(s);
            }
        }
        Err(format!("no eigenvalue found near {guess:?}: start closer"))
    }

    fn linearised(&self, q: &[f64]) -> Result<Linearised> {
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
        let c = self.chain.forces(q, &self.supports).damping;
        Ok(Linearised {
            k: dense(&k),
            m: dense(&m),
            g: dense(&g),
            c: dense(&c),
        })
    }
}

impl Linearised {
    /// `s^2 M + s (G + C) + K` as a real matrix over real and imaginary parts.
    fn pencil(&self, s: Complex) -> Matrix {
        let n = self.k.size();
        let square = [s[0] * s[0] - s[1] * s[1], 2.0 * s[0] * s[1]];
        let mut out = Matrix::zero(2 * n);
        for i in 0..n {
            for j in 0..n {
                let (m, d) = (self.m.get(i, j), self.g.get(i, j) + self.c.get(i, j));
                let re = square[0] * m + s[0] * d + self.k.get(i, j);
                let im = square[1] * m + s[1] * d;
                out.set(i, j, re);
                out.set(n + i, n + j, re);
                out.set(i, n + j, -im);
                out.set(n + i, j, im);
            }
        }
        out
    }

    /// `(2 s M + G + C) x`: the derivative of the pencil by s.
    fn product(&self, s: Complex, x: &[f64]) -> Vec<f64> {
        let n = self.k.size();
        let mut out = vec![0.0; 2 * n];
        for i in 0..n {
            for j in 0..n {
                let re = 2.0 * s[0] * self.m.get(i, j) + self.g.get(i, j) + self.c.get(i, j);
                let im = 2.0 * s[1] * self.m.get(i, j);
                out[i] += re * x[j] - im * x[n + j];
                out[n + i] += im * x[j] + re * x[n + j];
            }
        }
        out
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
