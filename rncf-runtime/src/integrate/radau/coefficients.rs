//! Coefficients of Radau IIA with three stages (THEORY 7.5) and of its spectral decomposition.

use crate::linalg::c64;
use crate::space::{from_rows, rows};

/// A vector or a matrix over the stages.
pub(super) type Row = [f64; 3];
type Matrix = [Row; 3];

/// Nodes, inverse of the Runge-Kutta matrix and its spectral decomposition
/// `A^-1 = right diag(real, complex, conj complex) left`.
#[derive(Clone, Debug)]
pub(super) struct Coefficients {
    /// Nodes c.
    pub(super) nodes: Row,
    /// A^-1, rows first.
    pub(super) inverse: Matrix,
    /// Real eigenvalue of A^-1.
    pub(super) real: f64,
    /// Complex eigenvalue of A^-1 with positive imaginary part.
    pub(super) complex: c64,
    /// Right and left eigenvectors of the real eigenvalue; their product is 1.
    pub(super) real_right: Row,
    pub(super) real_left: Row,
    /// The same of the complex one, without conjugation.
    pub(super) complex_right: [c64; 3],
    pub(super) complex_left: [c64; 3],
    /// Weights e of the embedded formula: error ~ e . stage increments.
    pub(super) embedded: Row,
}

impl Coefficients {
    pub(super) fn new() -> Self {
        let s = 6_f64.sqrt();
        let matrix = [
            [
                (88.0 - 7.0 * s) / 360.0,
                (296.0 - 169.0 * s) / 1800.0,
                (-2.0 + 3.0 * s) / 225.0,
            ],
            [
                (296.0 + 169.0 * s) / 1800.0,
                (88.0 + 7.0 * s) / 360.0,
                (-2.0 - 3.0 * s) / 225.0,
            ],
            [(16.0 - s) / 36.0, (16.0 + s) / 36.0, 1.0 / 9.0],
        ];
        // Eigenvalues of A: (6 + r - q)/30 and (12 - r + q)/60 +- i (r + q) sqrt(3)/60.
        let (r, q) = (81_f64.cbrt(), 9_f64.cbrt());
        let real = 30.0 / (6.0 + r - q);
        let (alpha, beta) = ((12.0 - r + q) / 60.0, (r + q) * 3_f64.sqrt() / 60.0);
        let square = alpha * alpha + beta * beta;
        let complex = c64::new(alpha / square, beta / square);
        let inverse = from_rows(&matrix).try_inverse().expect("A is regular");
        let inverse = rows(&inverse);
        let (real_right, real_left) = eigenvectors(&inverse, c64::new(real, 0.0));
        let (complex_right, complex_left) = eigenvectors(&inverse, complex);
        Self {
            nodes: [(4.0 - s) / 10.0, (4.0 + s) / 10.0, 1.0],
            inverse,
            real,
            complex,
            real_right: real_right.map(|value| value.re),
            real_left: real_left.map(|value| value.re),
            complex_right,
            complex_left,
            embedded: [-(13.0 + 7.0 * s) / 3.0, (-13.0 + 7.0 * s) / 3.0, -1.0 / 3.0],
        }
    }

    /// Values at `at` (in steps) of the Lagrange polynomials on 0 and the nodes; the first one
    /// belongs to 0.
    pub(super) fn cubic(&self, at: f64) -> [f64; 4] {
        let [a, b, c] = self.nodes;
        lagrange([0.0, a, b, c], at)
    }

    /// Values at `at` (in steps) of the Lagrange polynomials on the nodes.
    pub(super) fn quadratic(&self, at: f64) -> Row {
        lagrange(self.nodes, at)
    }
}

fn lagrange<const N: usize>(nodes: [f64; N], at: f64) -> [f64; N] {
    std::array::from_fn(|i| {
        (0..N)
            .filter(|&j| j != i)
            .map(|j| (at - nodes[j]) / (nodes[i] - nodes[j]))
            .product()
    })
}

fn cross<T: crate::linalg::Scalar>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot<T: crate::linalg::Scalar>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn transpose<T: Copy>(m: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

/// Right and left eigenvector of a simple eigenvalue, of product 1: the null space of a matrix of
/// rank 2 is the cross product of two of its rows.
fn eigenvectors(m: &Matrix, eigenvalue: c64) -> ([c64; 3], [c64; 3]) {
    let shifted: [[c64; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| c64::new(m[i][j], 0.0) - if i == j { eigenvalue } else { c64::new(0.0, 0.0) })
    });
    let columns = transpose(&shifted);
    let right = cross(shifted[0], shifted[1]);
    let left = cross(columns[0], columns[1]);
    let product = dot(right, left);
    (right, left.map(|value| value / product))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decomposition_gives_the_inverse_back() {
        let c = Coefficients::new();
        assert!((c.real - 3.637_834_252_744_496).abs() < 1e-14);
        assert!((c.complex - c64::new(2.681_082_873_627_752, 3.050_430_199_247_41)).norm() < 1e-14);
        for i in 0..3 {
            // A^-1 c = 1 and A^-1 c^2 = 2 c, by the stage order.
            let of = |power: i32| (0..3).map(|j| c.inverse[i][j] * c.nodes[j].powi(power)).sum::<f64>();
            assert!((of(1) - 1.0).abs() < 1e-13 && (of(2) - 2.0 * c.nodes[i]).abs() < 1e-13);
            for j in 0..3 {
                let complex = c.complex_right[i] * c.complex * c.complex_left[j];
                let value = c.real_right[i] * c.real * c.real_left[j] + 2.0 * complex.re;
                assert!((value - c.inverse[i][j]).abs() < 1e-12, "{i} {j}: {value}");
            }
        }
    }
}
