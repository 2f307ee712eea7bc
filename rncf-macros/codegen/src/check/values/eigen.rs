//! Eigenvalues of small symmetric matrices.

/// Sweeps of the Jacobi method; it converges quadratically, a handful is enough.
const SWEEPS: usize = 30;

/// Eigenvalues of a symmetric matrix and its eigenvectors as columns (Jacobi's method: accurate to
/// round-off of the largest entry).
pub fn symmetric<const N: usize>(mut a: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut vectors: [[f64; N]; N] = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    for _ in 0..SWEEPS {
        for p in 0..N {
            for q in p + 1..N {
                if a[p][q] != 0.0 {
                    rotate(&mut a, &mut vectors, p, q);
                }
            }
        }
    }
    (std::array::from_fn(|i| a[i][i]), vectors)
}

/// The rotation in the plane of two axes that makes their product of inertia vanish.
fn rotate<const N: usize>(a: &mut [[f64; N]; N], vectors: &mut [[f64; N]; N], p: usize, q: usize) {
    let angle = 0.5 * (2.0 * a[p][q]).atan2(a[q][q] - a[p][p]);
    let (sine, cosine) = angle.sin_cos();
    let turn = |row: &mut [f64; N]| {
        let (x, y) = (row[p], row[q]);
        row[p] = cosine * x - sine * y;
        row[q] = sine * x + cosine * y;
    };
    a.iter_mut().for_each(turn);
    vectors.iter_mut().for_each(turn);
    for column in 0..N {
        let (x, y) = (a[p][column], a[q][column]);
        a[p][column] = cosine * x - sine * y;
        a[q][column] = sine * x + cosine * y;
    }
    a[p][q] = 0.0;
    a[q][p] = 0.0;
}

#[cfg(test)]
mod tests {
    use super::symmetric;

    #[test]
    fn eigenvectors_are_orthonormal_and_reproduce_the_matrix() {
        let a = [[2.0, -1.0, 0.3], [-1.0, 3.0, 0.7], [0.3, 0.7, -4.0]];
        let (values, vectors) = symmetric(a);
        for i in 0..3 {
            for j in 0..3 {
                let dot: f64 = (0..3).map(|k| vectors[k][i] * vectors[k][j]).sum();
                assert!((dot - f64::from(i == j)).abs() < 1e-15 * 10.0);
                let back: f64 = (0..3).map(|k| vectors[i][k] * values[k] * vectors[j][k]).sum();
                assert!((back - a[i][j]).abs() < 1e-14);
            }
        }
    }
}
