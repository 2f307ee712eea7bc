//! Sizes of increments in the units of their unknowns, and where the largest stands.

use crate::linalg::Singular;

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
    let mut lanes = [0.0; 4];
    for (y, factors) in whole.iter().zip(factors) {
        for lane in 0..4 {
            lanes[lane] += (y[lane] * factors[lane]).powi(2);
        }
    }
    let rest: f64 = rest.iter().zip(of_rest).map(|(y, factor)| (y * factor).powi(2)).sum();
    let sum = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]) + rest;
    (sum / y.len().max(1) as f64).sqrt()
}
