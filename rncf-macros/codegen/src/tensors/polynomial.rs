//! Polynomials in xi with rational coefficients.

use super::rational::Rational;

/// A polynomial in xi on the unit element; lowest power first, no trailing zeros.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial {
    coefficients: Vec<Rational>,
}

impl Polynomial {
    /// From coefficients, lowest power first.
    pub fn new(mut coefficients: Vec<Rational>) -> Self {
        while coefficients.last().is_some_and(|last| last.is_zero()) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// From whole coefficients, lowest power first.
    pub fn whole(coefficients: &[i128]) -> Self {
        Self::new(coefficients.iter().map(|&value| Rational::whole(value)).collect())
    }

    /// Zero.
    pub fn zero() -> Self {
        Self::new(Vec::new())
    }

    /// Degree; 0 for constants and zero.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Coefficients, lowest power first.
    pub fn coefficients(&self) -> &[Rational] {
        &self.coefficients
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let length = self.coefficients.len().max(other.coefficients.len());
        let at = |list: &[Rational], i: usize| list.get(i).copied().unwrap_or(Rational::ZERO);
        Self::new(
            (0..length)
                .map(|i| at(&self.coefficients, i) + at(&other.coefficients, i))
                .collect(),
        )
    }

    /// The multiple.
    #[must_use]
    pub fn times(&self, factor: Rational) -> Self {
        Self::new(self.coefficients.iter().map(|&value| value * factor).collect())
    }

    /// The product.
    #[must_use]
    pub fn product(&self, other: &Self) -> Self {
        if self.coefficients.is_empty() || other.coefficients.is_empty() {
            return Self::zero();
        }
        let mut result = vec![Rational::ZERO; self.coefficients.len() + other.coefficients.len() - 1];
        for (i, &a) in self.coefficients.iter().enumerate() {
            for (j, &b) in other.coefficients.iter().enumerate() {
                result[i + j] = result[i + j] + a * b;
            }
        }
        Self::new(result)
    }

    /// The derivative of the given order.
    #[must_use]
    pub fn derivative(&self, order: usize) -> Self {
        let mut result = self.clone();
        for _ in 0..order {
            let coefficients = result.coefficients.iter().enumerate().skip(1);
            result = Self::new(
                coefficients
                    .map(|(i, &value)| value * Rational::whole(i as i128))
                    .collect(),
            );
        }
        result
    }

    /// The remainder of the division by `divisor`.
    ///
    /// # Panics
    /// If `divisor` is zero.
    #[must_use]
    pub fn remainder(&self, divisor: &Self) -> Self {
        let (degree, leading) = (
            divisor.degree(),
            *divisor.coefficients.last().expect("division by zero"),
        );
        let mut rest = self.coefficients.clone();
        while rest.len() > degree {
            let factor = rest[rest.len() - 1].divide(leading);
            let shift = rest.len() - 1 - degree;
            for (i, &value) in divisor.coefficients.iter().enumerate() {
                rest[shift + i] = rest[shift + i] - factor * value;
            }
            rest.pop();
        }
        Self::new(rest)
    }

    /// The integral over [0, 1].
    pub fn integral(&self) -> Rational {
        let terms = self.coefficients.iter().enumerate();
        terms.fold(Rational::ZERO, |sum, (i, &value)| {
            sum + value * Rational::new(1, i as i128 + 1)
        })
    }

    /// The value at xi in f64 (Horner).
    pub fn at(&self, xi: f64) -> f64 {
        self.coefficients
            .iter()
            .rev()
            .fold(0.0, |sum, value| sum * xi + value.to_f64())
    }
}
