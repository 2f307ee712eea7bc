//! A mean and one oscillation in a history, by least squares.

use crate::dense::Matrix;

/// `mean + amplitude cos(frequency t + phase)`.
#[derive(Clone, Copy, Debug)]
pub struct Wave {
    /// Unit of the values.
    pub mean: f64,
    /// Unit of the values.
    pub amplitude: f64,
    /// rad/s.
    pub frequency: f64,
}

impl std::fmt::Display for Wave {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{:.6e} m and {:.3e} m at {:.4} rad/s",
            self.mean, self.amplitude, self.frequency
        )
    }
}

/// The wave of a given frequency that fits best, and the weighted sum of squares that it leaves. The weights vanish
/// smoothly at both ends, so that other frequencies hardly leak in.
fn at_frequency(times: &[f64], values: &[f64], frequency: f64) -> (Wave, f64) {
    let count = values.len();
    let level = values.iter().sum::<f64>() / count as f64;
    let (mut matrix, mut right, mut squares) = ([[0.0; 3]; 3], [0.0; 3], 0.0);
    for (k, (t, value)) in times.iter().zip(values).enumerate() {
        let weight = (std::f64::consts::PI * (k as f64 + 0.5) / count as f64).sin().powi(2);
        let (phase, value) = (frequency * (t - times[0]), value - level);
        let row = [1.0, phase.cos(), phase.sin()];
        for i in 0..3 {
            for j in 0..3 {
                matrix[i][j] += weight * row[i] * row[j];
            }
            right[i] += weight * row[i] * value;
        }
        squares += weight * value * value;
    }
    let found = solve(matrix, right);
    let wave = Wave {
        mean: level + found[0],
        amplitude: found[1].hypot(found[2]),
        frequency,
    };
    let explained: f64 = found.iter().zip(right).map(|(x, b)| x * b).sum();
    (wave, squares - explained)
}

/// Solution of three equations.
fn solve(matrix: [[f64; 3]; 3], right: [f64; 3]) -> [f64; 3] {
    let mut system = Matrix::zero(3);
    for (i, row) in matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            system.set(i, j, *entry);
        }
    }
    let found = system.solve(&right).expect("more than one period in the history");
    std::array::from_fn(|i| found[i])
}

/// Frequencies that a first search looks at, rad/s.
const SEARCH: std::ops::Range<u32> = 20..1500;

/// The wave, of whatever frequency, that fits best: no frequency is given to the search.
pub fn strongest(times: &[f64], values: &[f64]) -> Wave {
    let rest = |frequency: f64| at_frequency(times, values, frequency).1;
    let span = times[times.len() - 1] - times[0];
    // A peak is some 4 pi / span wide.
    let coarse = std::f64::consts::FRAC_PI_2 / span;
    let count = (f64::from(SEARCH.end - SEARCH.start) / coarse) as u32;
    let (_, near) = (0..count)
        .map(|k| f64::from(SEARCH.start) + coarse * f64::from(k))
        .map(|frequency| (rest(frequency), frequency))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .expect("the range is not empty");
    let (mut low, mut high) = (near - coarse, near + coarse);
    for _ in 0..50 {
        let third = (high - low) / 3.0;
        if rest(low + third) < rest(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    at_frequency(times, values, 0.5 * (low + high)).0
}

/// Rate of growth (1/s) of the wave of a given frequency: logarithm of its amplitudes in the first and last third.
pub fn growth(times: &[f64], values: &[f64], frequency: f64) -> f64 {
    let third = times.len() / 3;
    let amplitude = |from: usize| {
        at_frequency(&times[from..from + third], &values[from..from + third], frequency)
            .0
            .amplitude
    };
    (amplitude(2 * third) / amplitude(0)).ln() / (times[2 * third] - times[0])
}
