//! Differences, norms and repeatable random states that the checks share.

/// Derivatives of `f` by each coordinate of `x`, columns of the result, by sixth-order central differences of step `h`.
pub fn jacobian(f: impl Fn(&[f64]) -> Vec<f64>, x: &[f64], h: f64) -> Vec<Vec<f64>> {
    const WEIGHTS: [f64; 3] = [45.0 / 60.0, -9.0 / 60.0, 1.0 / 60.0];
    let column = |k: usize| {
        let shifted = |by: f64| {
            let mut x = x.to_vec();
            x[k] += by;
            f(&x)
        };
        let mut sum = vec![0.0; f(x).len()];
        for (n, weight) in WEIGHTS.iter().enumerate() {
            let by = h * (n + 1) as f64;
            for (sum, (up, down)) in sum.iter_mut().zip(shifted(by).iter().zip(shifted(-by))) {
                *sum += weight * (up - down) / h;
            }
        }
        sum
    };
    (0..x.len()).map(column).collect()
}

/// Largest absolute entry.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values
        .into_iter()
        .map(f64::abs)
        .fold(0.0, |a, b| if b.is_nan() { b } else { a.max(b) })
}

/// Largest difference of two lists, relative to the largest entry of the second.
pub fn relative(actual: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(actual.len(), expected.len());
    largest(actual.iter().zip(expected).map(|(a, b)| a - b)) / largest(expected.iter().copied())
}

/// Numbers in (-1, 1) from a linear congruential generator: the same in every run.
pub struct Random(pub u64);

impl Random {
    /// The next number.
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// `count` numbers in (-size, size).
    pub fn list(&mut self, count: usize, size: f64) -> Vec<f64> {
        (0..count).map(|_| size * self.next()).collect()
    }
}
