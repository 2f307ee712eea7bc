//! Gauss-Legendre rules on the unit interval, any number of points.

use crate::Result;

/// One Gauss point of the unit interval.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Position xi in (0, 1).
    pub xi: f64,
    /// Weight; the weights of a rule add up to 1.
    pub weight: f64,
}

/// The rule with `count` points, exact for polynomials of degree `2 count - 1` on `[0, 1]`, in ascending order.
///
/// The nodes are the roots of the Legendre polynomial, by Newton's method from the usual cosine estimate.
///
/// # Errors
/// If `count` is zero.
pub fn gauss_legendre(count: usize) -> Result<Vec<Point>> {
    if count == 0 {
        return Err("a Gauss rule needs at least one point: ask for count >= 1".into());
    }
    let n = count as f64;
    let rule = (0..count).rev().map(|k| {
        let mut x = (std::f64::consts::PI * (k as f64 + 0.75) / (n + 0.5)).cos();
        // Quadratic convergence from this start: six steps are beyond round-off for every count.
        for _ in 0..6 {
            let (value, slope) = legendre(count, x);
            x -= value / slope;
        }
        let slope = legendre(count, x).1;
        Point {
            xi: 0.5 * (1.0 + x),
            weight: 1.0 / ((1.0 - x * x) * slope * slope),
        }
    });
    Ok(rule.collect())
}

/// Legendre polynomial of the given degree and its derivative at `x` in (-1, 1), by the three-term recurrence.
fn legendre(degree: usize, x: f64) -> (f64, f64) {
    let (mut previous, mut current) = (1.0, x);
    for k in 2..=degree {
        let k = k as f64;
        (previous, current) = (current, ((2.0 * k - 1.0) * x * current - (k - 1.0) * previous) / k);
    }
    (current, degree as f64 * (x * current - previous) / (x * x - 1.0))
}
