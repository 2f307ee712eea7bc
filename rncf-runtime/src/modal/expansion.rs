//! Elastic forces of a body in modes: those of its elements, or their expansion in the modal coordinates.

use crate::linalg::times;

/// How the forces are found.
#[derive(Clone, Debug)]
pub enum Elastic {
    /// From constants.
    Expanded {
        /// d force/dp at rest.
        stiffness: Expansion,
        /// d force/dp', where something damps.
        damping: Option<Expansion>,
    },
    /// From the elements.
    Elements,
}

/// A k x k matrix that is a quadratic polynomial of p:
/// `A = A0 + sum_l p_l A1_l + sum_lm p_l p_m A2_lm`.
#[derive(Clone, Debug)]
pub struct Expansion {
    pub constant: Vec<f64>,
    /// k matrices one after the other; empty for a constant matrix.
    pub linear: Vec<f64>,
    /// k x k matrices, symmetric in l and m; empty for a constant matrix.
    pub quadratic: Vec<f64>,
}

impl Expansion {
    pub fn constant(constant: Vec<f64>) -> Self {
        Self {
            constant,
            linear: Vec::new(),
            quadratic: Vec::new(),
        }
    }

    /// Coefficients from values of the matrix at zero, at one and at two displaced coordinates.
    pub fn of(steps: &[f64], mut matrix: impl FnMut(&[f64]) -> Vec<f64>) -> Self {
        let k = steps.len();
        let square = k * k;
        let mut at = |places: &[(usize, f64)]| {
            let mut p = vec![0.0; k];
            places.iter().for_each(|&(place, sign)| p[place] += sign * steps[place]);
            matrix(&p)
        };
        let constant = at(&[]);
        let mut linear = vec![0.0; k * square];
        let mut quadratic = vec![0.0; square * square];
        for l in 0..k {
            let (up, down) = (at(&[(l, 1.0)]), at(&[(l, -1.0)]));
            for entry in 0..square {
                linear[l * square + entry] = (up[entry] - down[entry]) / (2.0 * steps[l]);
                let bend = up[entry] - 2.0 * constant[entry] + down[entry];
                quadratic[(l * k + l) * square + entry] = bend / (2.0 * steps[l] * steps[l]);
            }
        }
        for l in 0..k {
            for m in 0..l {
                let (both, apart) = (at(&[(l, 1.0), (m, 1.0)]), at(&[(l, 1.0), (m, -1.0)]));
                let (back, behind) = (at(&[(l, -1.0), (m, 1.0)]), at(&[(l, -1.0), (m, -1.0)]));
                for entry in 0..square {
                    let twist = both[entry] - apart[entry] - back[entry] + behind[entry];
                    let value = twist / (8.0 * steps[l] * steps[m]);
                    quadratic[(l * k + m) * square + entry] = value;
                    quadratic[(m * k + l) * square + entry] = value;
                }
            }
        }
        Self {
            constant,
            linear,
            quadratic,
        }
    }

    /// `A0 + first sum_l p_l A1_l + second sum_lm p_l p_m A2_lm`
    pub fn weighted(&self, p: &[f64], first: f64, second: f64) -> Vec<f64> {
        let mut sum = self.constant.clone();
        let mut add = |factor: f64, matrix: &[f64]| {
            if factor != 0.0 {
                sum.iter_mut()
                    .zip(matrix)
                    .for_each(|(sum, entry)| *sum += factor * entry);
            }
        };
        let square = self.constant.len();
        for (l, matrix) in self.linear.chunks_exact(square).enumerate() {
            add(first * p[l], matrix);
        }
        for (pair, matrix) in self.quadratic.chunks_exact(square).enumerate() {
            add(second * p[pair / p.len()] * p[pair % p.len()], matrix);
        }
        sum
    }

    /// `A(p)`
    pub fn at(&self, p: &[f64]) -> Vec<f64> {
        self.weighted(p, 1.0, 1.0)
    }

    /// The vector that is zero at p = 0 and has the derivative A(p).
    pub fn integral(&self, p: &[f64]) -> Vec<f64> {
        times(p.len(), &self.weighted(p, 0.5, 1.0 / 3.0), p)
    }

    /// Adds `d(A(p) v)/dp`.
    pub fn add_derivative(&self, p: &[f64], v: &[f64], out: &mut [f64]) {
        let (k, square) = (p.len(), self.constant.len());
        for (l, matrix) in self.linear.chunks_exact(square).enumerate() {
            for (row, value) in times(k, matrix, v).into_iter().enumerate() {
                out[row * k + l] += value;
            }
        }
        for (pair, matrix) in self.quadratic.chunks_exact(square).enumerate() {
            for (row, value) in times(k, matrix, v).into_iter().enumerate() {
                out[row * k + pair / k] += 2.0 * p[pair % k] * value;
            }
        }
    }
}
