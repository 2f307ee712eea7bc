//! Bending modes of a rotating uniform cantilever on a hub, by Galerkin's method (THEORY 8.2).
//!
//! `(EI w'')'' - (T w')' = mu^2 w` over the unit length, `T = eta^2 int_x^1 (hub + s) ds`; flapping as it stands,
//! lagging `mu^2 - eta^2` (the centrifugal force's part along w). The second derivatives of the trial functions are
//! Legendre polynomials, so that the bending stiffness is diagonal.

use crate::Result;
use crate::dense::Matrix;
use crate::quadrature::gauss_legendre;
use crate::symmetric;

/// A rotating cantilever in non-dimensional form.
#[derive(Clone, Copy, Debug)]
pub struct Rotor {
    /// `Omega sqrt(rho A L^4 / EI)`.
    pub eta: f64,
    /// Hub radius over length.
    pub hub: f64,
    /// Number of trial functions.
    pub terms: usize,
}

impl Rotor {
    /// Frequencies `nu sqrt(rho A L^4 / EI)` of flapping (out of the plane of rotation), ascending; the first third
    /// of them is accurate.
    ///
    /// # Errors
    /// If there are no terms, or the stiffness is not positive definite (a hub ratio below -1/2 compresses).
    pub fn flap(&self) -> Result<Vec<f64>> {
        let n = self.terms;
        let (mut stiffness, mut mass) = (Matrix::zero(n), Matrix::zero(n));
        for point in gauss_legendre(n + 4)? {
            let x = point.xi;
            let tension = self.eta * self.eta * (self.hub * (1.0 - x) + 0.5 * (1.0 - x * x));
            let [w, w_x, w_xx] = trial(n, x);
            for i in 0..n {
                for j in 0..n {
                    stiffness.add(i, j, point.weight * (w_xx[i] * w_xx[j] + tension * w_x[i] * w_x[j]));
                    mass.add(i, j, point.weight * w[i] * w[j]);
                }
            }
        }
        // The other way round the lowest frequencies are the largest values: accurate though the mass is nearly singular.
        let inverse = symmetric::generalised(&mass, &stiffness)?;
        Ok(inverse
            .into_iter()
            .rev()
            .filter(|&s| s > 0.0)
            .map(|s| s.sqrt().recip())
            .collect())
    }

    /// Frequencies of lagging (in the plane of rotation) of an inextensible beam, ascending.
    ///
    /// # Errors
    /// As [`flap`](Self::flap).
    pub fn lag(&self) -> Result<Vec<f64>> {
        let below = self.eta * self.eta;
        Ok(self.flap()?.into_iter().map(|mu| (mu * mu - below).sqrt()).collect())
    }
}

/// Trial functions at `x`: values, first and second derivatives; value and slope vanish at 0.
fn trial(terms: usize, x: f64) -> [Vec<f64>; 3] {
    // Legendre polynomials of 2 x - 1.
    let (t, mut p) = (2.0 * x - 1.0, vec![1.0, 2.0 * x - 1.0]);
    for k in 2..terms + 2 {
        let n = k as f64;
        p.push(((2.0 * n - 1.0) * t * p[k - 1] - (n - 1.0) * p[k - 2]) / n);
    }
    // The integral from 0 of the k-th polynomial is half the difference of its neighbours over 2 k + 1.
    let integral = |p: &[f64], first: f64| {
        let mut sums = vec![first];
        for k in 1..p.len() - 1 {
            sums.push(0.5 * (p[k + 1] - p[k - 1]) / (2 * k + 1) as f64);
        }
        sums
    };
    let w_x = integral(&p, x);
    let w = integral(&w_x, 0.5 * x * x);
    [w, w_x, p]
}
