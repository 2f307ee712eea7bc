//! Exact polynomials on the unit element, Gauss rules, and the constant tensors built from them.

mod gauss;
mod polynomial;
mod rational;

pub use gauss::{Rule, Sampling, gauss_rule, shifted_legendre};
pub use polynomial::Polynomial;
pub use rational::Rational;

use crate::model::Quadrature;

/// Integral over the unit element by the chosen rule, exactly.
///
/// An n-point Gauss sum of a polynomial equals the exact integral of its remainder modulo the
/// Legendre polynomial P_n, so that reduced rules are rational too.
pub fn integrate(polynomial: &Polynomial, quadrature: Quadrature) -> Rational {
    match quadrature {
        Quadrature::Exact => polynomial.integral(),
        Quadrature::Gauss(points) => polynomial.remainder(&shifted_legendre(points)).integral(),
    }
}
