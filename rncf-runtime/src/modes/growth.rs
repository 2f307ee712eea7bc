//! Whether modes may grow at all.

use super::pencil::Pencil;
use crate::linalg::negative_eigenvalues;

/// Difference of two entries across the diagonal, of the largest ones of their rows, that is round-off.
const SKEW: f64 = 1e-9;
/// Damping that is round-off, of the largest.
const ROUND_OFF: f64 = 1e-12;

/// Whether anything can feed a motion: forces of a place that come from no energy, gyroscopic ones beside damping, or damping that is negative in
/// some direction. Beside a symmetric stiffness and damping that takes energy alone only what diverges grows.
pub(super) fn may_feed(pencil: &Pencil) -> bool {
    let [_, mut damping, stiffness] = pencil.dense();
    let n = pencil.unknowns();
    if is_skew(n, &stiffness) || is_skew(n, &damping) {
        return true;
    }
    let largest = damping.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    for i in 0..n {
        damping[i * n + i] += ROUND_OFF * largest;
    }
    largest > 0.0 && negative_eigenvalues(n, &damping).is_ok_and(|negative| negative > 0)
}

fn is_skew(n: usize, matrix: &[f64]) -> bool {
    let largest = |row: &[f64]| row.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
    let rows: Vec<f64> = matrix.chunks_exact(n.max(1)).map(largest).collect();
    let mut pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs.any(|(i, j)| (matrix[i * n + j] - matrix[j * n + i]).abs() > SKEW * (rows[i] * rows[j]).sqrt())
}
