//! Gauss's rules on [0, 1]: places and weights.

/// Gauss's rule with five points, place and weight: exact for a cubic force per length times a cubic lever.
pub(crate) const FIVE: [(f64, f64); 5] = [
    (0.046_910_077_030_668_02, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_24),
    (0.5, 0.284_444_444_444_444_45),
    (0.769_234_655_052_841_6, 0.239_314_335_249_683_24),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Gauss's rule with eight points in [0, 1], place and weight: its first four points, the others mirror them.
pub(crate) const EIGHT: [(f64, f64); 4] = [
    (0.019_855_071_751_231_884, 0.050_614_268_145_188_13),
    (0.101_666_761_293_186_63, 0.111_190_517_226_687_24),
    (0.237_233_795_041_835_5, 0.156_853_322_938_943_64),
    (0.408_282_678_752_175_1, 0.181_341_891_689_181),
];

/// Gauss's rule with this many points on [0, 1], places ascending and weights: zeros of Legendre's polynomial by Newton's iteration.
pub(crate) fn legendre(points: usize) -> Vec<(f64, f64)> {
    let count = points as f64;
    let rule = (0..points).rev().map(|at| {
        let mut x = (std::f64::consts::PI * (at as f64 + 0.75) / (count + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            let (mut before, mut value) = (1.0, x);
            for order in 2..=points {
                let order = order as f64;
                (before, value) = (
                    value,
                    ((2.0 * order - 1.0) * x * value - (order - 1.0) * before) / order,
                );
            }
            slope = count * (before - x * value) / (1.0 - x * x);
            x -= value / slope;
        }
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    });
    rule.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_exact_up_to_twice_their_points() {
        for points in 1..=8 {
            let rule = legendre(points);
            for power in 0..2 * points as i32 {
                let sum: f64 = rule.iter().map(|(x, weight)| weight * x.powi(power)).sum();
                assert!(
                    (sum * f64::from(power + 1) - 1.0).abs() < 1e-14,
                    "{points} {power}: {sum}"
                );
            }
        }
        let [five, eight] = [legendre(5), legendre(8)];
        assert!(
            FIVE.iter()
                .zip(&five)
                .all(|(a, b)| (a.0 - b.0).abs() < 1e-15 && (a.1 - b.1).abs() < 1e-15)
        );
        assert!(
            EIGHT
                .iter()
                .zip(&eight)
                .all(|(a, b)| (a.0 - b.0).abs() < 1e-15 && (a.1 - b.1).abs() < 1e-15)
        );
    }
}
