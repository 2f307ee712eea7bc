//! Coefficients of Radau IIA with S stages (THEORY 7.5) and of its spectral decomposition.
//!
//! Whatever the number of stages, all of them follow from the nodes c: with the nodes and 0 as places of interpolation, the derivative of a
//! polynomial of degree S that vanishes at 0 is `A^-1` times its values at the nodes. Nothing of this loses digits.

use std::f64::consts::TAU;

use crate::linalg::{Dense, c64, general_eigen};

/// Distance of inverse iteration from an eigenvalue, relative to it.
const BESIDE: f64 = 1e-9;

/// Nodes, inverse of the Runge-Kutta matrix and its spectral decomposition
/// `A^-1 = right diag(real, complex pairs) left`.
#[derive(Clone, Debug)]
pub(super) struct Coefficients<const S: usize> {
    /// Nodes c.
    pub(super) nodes: [f64; S],
    /// A^-1, rows first.
    pub(super) inverse: [[f64; S]; S],
    /// Real eigenvalue of A^-1.
    pub(super) real: f64,
    /// Right and left eigenvectors of the real eigenvalue; their product is 1.
    pub(super) real_right: [f64; S],
    pub(super) real_left: [f64; S],
    /// Complex eigenvalues of A^-1, one of each conjugate pair.
    pub(super) pairs: Vec<Pair<S>>,
    /// Weights e of the embedded formula: error ~ e . stage increments.
    pub(super) embedded: [f64; S],
}

/// A complex eigenvalue with its vectors.
#[derive(Clone, Debug)]
pub(super) struct Pair<const S: usize> {
    /// The eigenvalue with positive imaginary part.
    pub(super) value: c64,
    /// Right and left eigenvectors; their product, without conjugation, is 1.
    pub(super) right: [c64; S],
    pub(super) left: [c64; S],
}

impl<const S: usize> Coefficients<S> {
    pub(super) fn new() -> Self {
        let nodes = nodes();
        let weights = barycentric(&nodes);
        let inverse: [[f64; S]; S] = std::array::from_fn(|i| derivative(&nodes, &weights, i + 1));
        let mut found = decomposed(&inverse);
        let real = found.remove(0);
        Self {
            nodes,
            inverse,
            real: real.value.re,
            real_right: real.right.map(|value| value.re),
            real_left: real.left.map(|value| value.re),
            pairs: found,
            // It compares the derivative at the start with that of the polynomial there.
            embedded: derivative(&nodes, &weights, 0).map(|value| -value),
        }
    }

    /// Values at `at` (in steps) of the Lagrange polynomials on 0 and the nodes, that of 0 apart.
    pub(super) fn with_start(&self, at: f64) -> (f64, [f64; S]) {
        let first = self.nodes.iter().map(|node| (at - node) / -node).product();
        let others = self.on_nodes(at);
        (first, std::array::from_fn(|i| others[i] * at / self.nodes[i]))
    }

    /// Values at `at` (in steps) of the Lagrange polynomials on the nodes.
    pub(super) fn on_nodes(&self, at: f64) -> [f64; S] {
        let nodes = &self.nodes;
        std::array::from_fn(|i| {
            (0..S)
                .filter(|&j| j != i)
                .map(|j| (at - nodes[j]) / (nodes[i] - nodes[j]))
                .product()
        })
    }
}

/// The zeros of `P_S(x) - P_(S-1)(x)` with x = 2 c - 1, the last one 1, by Newton's method from those of Chebyshev's polynomials.
fn nodes<const S: usize>() -> [f64; S] {
    std::array::from_fn(|i| {
        let from_the_end = (S - 1 - i) as f64;
        if from_the_end == 0.0 {
            return 1.0;
        }
        let mut x = (TAU * from_the_end / (2 * S - 1) as f64).cos();
        for _ in 0..8 {
            // Legendre's polynomials of the degrees n - 1 and n.
            let (mut before, mut own) = (1.0, x);
            let mut older = 0.0;
            for n in 2..=S {
                let n = n as f64;
                (older, before, own) = (before, own, ((2.0 * n - 1.0) * x * own - (n - 1.0) * before) / n);
            }
            let s = S as f64;
            let slope = |n: f64, own: f64, before: f64| n * (x * own - before) / (x * x - 1.0);
            x -= (own - before) / (slope(s, own, before) - slope(s - 1.0, before, older));
        }
        0.5 + 0.5 * x
    })
}

/// Place k of interpolation: 0 and the nodes.
fn place<const S: usize>(nodes: &[f64; S], k: usize) -> f64 {
    if k == 0 { 0.0 } else { nodes[k - 1] }
}

/// Barycentric weights of 0, and of the nodes.
fn barycentric<const S: usize>(nodes: &[f64; S]) -> (f64, [f64; S]) {
    let of = |k: usize| -> f64 {
        let others = (0..=S).filter(|&j| j != k);
        1.0 / others.map(|j| place(nodes, k) - place(nodes, j)).product::<f64>()
    };
    (of(0), std::array::from_fn(|i| of(i + 1)))
}

/// The derivative at place k of a polynomial that vanishes at 0, by its values at the nodes.
fn derivative<const S: usize>(nodes: &[f64; S], (first, weights): &(f64, [f64; S]), k: usize) -> [f64; S] {
    let at = place(nodes, k);
    let own = if k == 0 { *first } else { weights[k - 1] };
    std::array::from_fn(|j| {
        if j + 1 != k {
            return weights[j] / own / (at - nodes[j]);
        }
        // The Lagrange polynomial of this place.
        (0..=S).filter(|&j| j != k).map(|j| 1.0 / (at - place(nodes, j))).sum()
    })
}

/// Eigenvalues, the real one first, and their vectors.
fn decomposed<const S: usize>(matrix: &[[f64; S]; S]) -> Vec<Pair<S>> {
    let entries: Vec<f64> = matrix.iter().flatten().copied().collect();
    let (mut values, _) = general_eigen(S, &entries).expect("A^-1 has eigenvalues");
    values.retain(|value| value.im >= 0.0);
    values.sort_by(|a, b| a.im.total_cmp(&b.im));
    let of = |value: c64| {
        let right = null_vector(value, |i, j| matrix[i][j]);
        let left = null_vector(value, |i, j| matrix[j][i]);
        let scale = product(&left, &right);
        let left = left.map(|value| value / scale);
        // Of second order in the errors of both vectors.
        let image = std::array::from_fn(|i| (0..S).map(|j| right[j] * matrix[i][j]).sum::<c64>());
        let value = product(&left, &image);
        Pair { value, right, left }
    };
    values.into_iter().map(of).collect()
}

/// The vector of an eigenvalue by inverse iteration.
fn null_vector<const S: usize>(value: c64, matrix: impl Fn(usize, usize) -> f64) -> [c64; S] {
    let beside = value * (1.0 + BESIDE);
    let mut shifted = Dense::new(S);
    for i in 0..S {
        for j in 0..S {
            let diagonal = if i == j { beside } else { c64::default() };
            shifted.add(i, j, c64::new(matrix(i, j), 0.0) - diagonal, matrix(i, j).abs());
        }
    }
    shifted.factor().expect("it is regular beside an eigenvalue");
    let mut vector = [c64::new(1.0, 0.0); S];
    for _ in 0..3 {
        shifted.solve(&mut vector);
        let size = vector.iter().map(|value| value.norm()).fold(0.0, f64::max);
        vector = vector.map(|value| value / size);
    }
    vector
}

fn product<const S: usize>(a: &[c64; S], b: &[c64; S]) -> c64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_stages_are_those_of_the_literature() {
        let c = Coefficients::<3>::new();
        let s = 6_f64.sqrt();
        // Hairer, Wanner, Solving Ordinary Differential Equations II, IV.8.
        assert!((c.real - 3.637_834_252_744_496).abs() < 1e-14);
        assert!((c.pairs[0].value - c64::new(2.681_082_873_627_752, 3.050_430_199_247_41)).norm() < 1e-14);
        let near = |a: &[f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14);
        assert!(near(&c.nodes, [(4.0 - s) / 10.0, (4.0 + s) / 10.0, 1.0]));
        assert!(near(
            &c.embedded,
            [-(13.0 + 7.0 * s) / 3.0, (-13.0 + 7.0 * s) / 3.0, -1.0 / 3.0]
        ));
    }

    /// Conditions that have one solution.
    fn assert_is_radau<const S: usize>(real: f64) {
        let c = Coefficients::<S>::new();
        assert!((c.real - real).abs() < 1e-13 * real, "{}", c.real);
        assert_eq!(c.pairs.len(), S / 2);
        for i in 0..S {
            for power in 1..=S as i32 {
                // Derivatives of powers at the nodes, and at the start by the embedded formula.
                let of: f64 = (0..S).map(|j| c.inverse[i][j] * c.nodes[j].powi(power)).sum();
                assert!(
                    (of - f64::from(power) * c.nodes[i].powi(power - 1)).abs() < 1e-12,
                    "{of}"
                );
                let at_start: f64 = (0..S).map(|j| c.embedded[j] * c.nodes[j].powi(power)).sum();
                assert!((at_start + f64::from(u8::from(power == 1))).abs() < 1e-12, "{at_start}");
            }
            // Vectors of seven stages lose three digits, which Newton's matrix can do without.
            for j in 0..S {
                let complex: f64 = c.pairs.iter().map(|p| (p.right[i] * p.value * p.left[j]).re).sum();
                let value = c.real_right[i] * c.real * c.real_left[j] + 2.0 * complex;
                assert!(
                    (value - c.inverse[i][j]).abs() < 1e-10,
                    "{S} {i} {j}: {:e}",
                    value - c.inverse[i][j]
                );
            }
        }
        let (first, others) = c.with_start(0.3);
        let sum = |power: i32| (0..S).map(|j| others[j] * c.nodes[j].powi(power)).sum::<f64>();
        assert!((first + sum(0) - 1.0).abs() < 1e-13 && (sum(S as i32) - 0.3_f64.powi(S as i32)).abs() < 1e-13);
        // Zeros of the polynomial of the nodes are orthogonal to all powers below S - 1.
        let mut polynomial = vec![1.0];
        for node in c.nodes {
            let lower = polynomial.iter().map(|value| -node * value).chain([0.0]);
            let higher = [0.0].iter().chain(&polynomial).copied();
            polynomial = lower.zip(higher).map(|(a, b)| a + b).collect();
        }
        for power in 0..S - 1 {
            let terms = polynomial.iter().enumerate();
            let moment: f64 = terms.map(|(k, value)| value / (k + power + 1) as f64).sum();
            assert!(moment.abs() < 1e-15, "{moment}");
        }
    }

    #[test]
    fn decompositions_give_the_inverse_back() {
        // The real eigenvalues of the program RADAU of Hairer and Wanner.
        assert_is_radau::<3>(3.637_834_252_744_496);
        assert_is_radau::<5>(6.286_704_751_729_277);
        assert_is_radau::<7>(8.936_832_788_405_216);
    }
}
