//! Rules of integration on [0, 1].

use std::fmt;

use super::polynomial::Polynomial;
use super::rational::Rational;

/// Points and weights of a quadrature rule on [0, 1].
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Points, ascending.
    pub points: Vec<f64>,
    /// Weights; their sum is one.
    pub weights: Vec<f64>,
}

/// Where a part of an energy is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampling {
    /// At this many Gauss points.
    Gauss(usize),
    /// At two or three nodes, the third in the middle: what acts on the vectors of single nodes and leaves the element between them.
    Nodes(usize),
}

impl Sampling {
    /// Number of points.
    pub fn count(self) -> usize {
        match self {
            Self::Gauss(count) | Self::Nodes(count) => count,
        }
    }

    /// Points and weights.
    pub fn rule(self) -> Rule {
        let [points, weights] = match self {
            Self::Gauss(count) => return gauss_rule(count),
            Self::Nodes(3) => [vec![0.0, 0.5, 1.0], vec![1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0]],
            Self::Nodes(_) => [vec![0.0, 1.0], vec![0.5, 0.5]],
        };
        Rule { points, weights }
    }

    /// The name of its table for an element, in generated code.
    pub fn table_of(self, element: &str) -> String {
        format!("{element}_{}", self.word()).to_uppercase()
    }

    /// Part of names of functions in generated code.
    pub fn word(self) -> String {
        match self {
            Self::Gauss(count) => format!("points{count}"),
            Self::Nodes(count) => format!("nodes{count}"),
        }
    }
}

impl fmt::Display for Sampling {
    fn fmt(&self, text: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Gauss(count) => write!(text, "{count} Gauss points"),
            Self::Nodes(count) => write!(text, "{count} nodes"),
        }
    }
}

/// The Legendre polynomial of the given degree, shifted to [0, 1].
pub fn shifted_legendre(degree: usize) -> Polynomial {
    // (k + 1) P_{k+1} = (2k + 1) (2 xi - 1) P_k - k P_{k-1}
    let argument = Polynomial::whole(&[-1, 2]);
    let (mut previous, mut current) = (Polynomial::zero(), Polynomial::whole(&[1]));
    for k in 0..degree as i128 {
        let next = argument.product(&current).times(Rational::new(2 * k + 1, k + 1));
        let next = next.plus(&previous.times(Rational::new(-k, k + 1)));
        (previous, current) = (current, next);
    }
    current
}

/// The Gauss-Legendre rule with `points` points, exact to degree `2 points - 1`.
pub fn gauss_rule(points: usize) -> Rule {
    // On [-1, 1] by the three-term recurrence: a power basis would lose digits.
    let n = points as f64;
    let legendre = |x: f64| {
        let (mut previous, mut current) = (0.0, 1.0);
        for k in 0..points {
            let k = k as f64;
            (previous, current) = (current, ((2.0 * k + 1.0) * x * current - k * previous) / (k + 1.0));
        }
        (current, n * (x * current - previous) / (x * x - 1.0))
    };
    let mut rule = Rule {
        points: Vec::new(),
        weights: Vec::new(),
    };
    for i in (0..points).rev() {
        let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).cos();
        if 2 * i + 1 == points {
            x = 0.0;
        } else {
            for _ in 0..20 {
                let (value, slope) = legendre(x);
                x -= value / slope;
            }
        }
        let (_, slope) = legendre(x);
        rule.points.push(0.5 * (1.0 + x));
        rule.weights.push(1.0 / ((1.0 - x * x) * slope * slope));
    }
    rule
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Quadrature;
    use crate::tensors::integrate;

    /// Reduced rules computed exactly agree with their floating-point sums, also beyond the degree
    /// of exactness.
    #[test]
    fn exact_reduced_rules_equal_gauss_sums() {
        let polynomial = Polynomial::whole(&[3, -7, 1, 0, 5, -2, 9, 4, -11]);
        for points in 1..=7 {
            let rule = gauss_rule(points);
            let sum: f64 = rule
                .points
                .iter()
                .zip(&rule.weights)
                .map(|(&x, &w)| w * polynomial.at(x))
                .sum();
            let exact = integrate(&polynomial, Quadrature::Gauss(points)).to_f64();
            assert!((sum - exact).abs() < 1e-14 * 40.0, "{points} points: {sum} {exact}");
        }
        assert_eq!(integrate(&polynomial, Quadrature::Gauss(5)), polynomial.integral());
        assert_ne!(integrate(&polynomial, Quadrature::Gauss(4)), polynomial.integral());
    }
}
