//! Sizes of increments in the units of their unknowns, and where the largest stands.

use pulp::Arch;

use crate::linalg::{Singular, Vectorised, dispatch, total};

/// Row of a singularity: unknowns first, then constraints.
pub(super) fn row(singular: Singular, unknowns: usize) -> Option<usize> {
    match singular {
        Singular::Unknown(index) => Some(index),
        Singular::Constraint(index) => Some(unknowns + index),
        Singular::Somewhere => None,
    }
}

/// Index of the largest `|y_i * factor_i|`, the last of equal ones; `None` without unknowns.
pub(super) fn largest(y: &[f64], factors: &[f64]) -> Option<usize> {
    let size = |i: usize| (y[i] * factors[i]).abs();
    (0..y.len()).max_by(|&i, &j| size(i).total_cmp(&size(j)))
}

/// Root of the mean square of `y_i * factor_i`; 0 without unknowns.
pub(super) fn norm(y: &[f64], factors: &[f64]) -> f64 {
    // In four lanes: one sum waits for the other.
    let ((whole, rest), (factors, of_rest)) = (y.as_chunks::<4>(), factors.as_chunks::<4>());
    let lanes = dispatch(Arch::new(), Squares(whole, factors));
    let rest: f64 = rest.iter().zip(of_rest).map(|(y, factor)| (y * factor).powi(2)).sum();
    let sum = total(lanes) + rest;
    (sum / y.len().max(1) as f64).sqrt()
}

/// Sums of the squares of products, lane by lane.
struct Squares<'a>(&'a [[f64; 4]], &'a [[f64; 4]]);

impl Vectorised for Squares<'_> {
    type Output = [f64; 4];

    #[inline(always)]
    fn run<const F: bool>(self) -> [f64; 4] {
        let mut lanes = [0.0; 4];
        for (y, factors) in self.0.iter().zip(self.1) {
            for lane in 0..4 {
                lanes[lane] += (y[lane] * factors[lane]).powi(2);
            }
        }
        lanes
    }
}
