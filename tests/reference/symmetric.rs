//! Eigenvalues of dense symmetric matrices by Jacobi's rotations.

use crate::Result;
use crate::dense::{Cholesky, Matrix};

/// Eigenvalues of a symmetric matrix, ascending.
pub fn eigenvalues(matrix: &Matrix) -> Vec<f64> {
    const SWEEPS: usize = 40;
    let n = matrix.size();
    let mut a = matrix.clone();
    for _ in 0..SWEEPS {
        let square = |i: usize, j: usize| a.get(i, j) * a.get(i, j);
        let off: f64 = (0..n).map(|i| (0..i).map(|j| square(i, j)).sum::<f64>()).sum();
        let all: f64 = (0..n).map(|i| (0..n).map(|j| square(i, j)).sum::<f64>()).sum();
        if off <= 1e-34 * all {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                rotate(&mut a, p, q);
            }
        }
    }
    let mut values: Vec<f64> = (0..n).map(|k| a.get(k, k)).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// Turns the plane of `p` and `q` so that their entry vanishes.
fn rotate(a: &mut Matrix, p: usize, q: usize) {
    let coupling = a.get(p, q);
    if coupling == 0.0 {
        return;
    }
    let ratio = 0.5 * (a.get(q, q) - a.get(p, p)) / coupling;
    let tangent = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = tangent * cosine;
    for k in 0..a.size() {
        let (left, right) = (a.get(k, p), a.get(k, q));
        a.set(k, p, cosine * left - sine * right);
        a.set(k, q, sine * left + cosine * right);
    }
    for k in 0..a.size() {
        let (left, right) = (a.get(p, k), a.get(q, k));
        a.set(p, k, cosine * left - sine * right);
        a.set(q, k, sine * left + cosine * right);
    }
}

/// Eigenvalues of `a x = value b x`, ascending; `a` symmetric, `b` symmetric and positive definite.
///
/// # Errors
/// If `b` is not positive definite.
pub fn generalised(a: &Matrix, b: &Matrix) -> Result<Vec<f64>> {
    let n = a.size();
    let factor = Cholesky::new(b)?;
    // L^-1 a L^-T: rows first, then columns, each by forward substitution.
    let mut half = Matrix::zero(n);
    for j in 0..n {
        let mut column: Vec<f64> = (0..n).map(|i| a.get(i, j)).collect();
        factor.forward(&mut column);
        (0..n).for_each(|i| half.set(i, j, column[i]));
    }
    let mut whole = Matrix::zero(n);
    for i in 0..n {
        let mut row: Vec<f64> = (0..n).map(|j| half.get(i, j)).collect();
        factor.forward(&mut row);
        (0..n).for_each(|j| whole.set(i, j, row[j]));
    }
    for i in 0..n {
        for j in 0..i {
            let mean = 0.5 * (whole.get(i, j) + whole.get(j, i));
            whole.set(i, j, mean);
            whole.set(j, i, mean);
        }
    }
    Ok(eigenvalues(&whole))
}
