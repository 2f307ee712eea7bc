//! Acceleration of a Newton iteration with a matrix that is not the true one (Anderson 1965).
//!
//! With one tangent for several stages, or an older one, a few motions may contract badly or not at
//! all: those of light frames, whose inertia is a small difference of large ones, and those that
//! constraints hardly hold near a singular configuration. Each earlier iteration tells what the matrix
//! makes of one direction; the increment is replaced by the combination that would have been smallest.

/// Iterations that are remembered: motions that may contract badly.
const DEPTH: usize = 6;
/// Part of a difference, relative to itself, that must be left beside the newer ones.
const INDEPENDENT: f64 = 1e-4;

/// Iterates and increments so far.
pub(super) struct Acceleration {
    /// Last iterate and its increment as the matrix gave it.
    last: (Vec<f64>, Vec<f64>),
    known: bool,
    /// Differences of successive iterates and of their increments, newest last.
    differences: Vec<(Vec<f64>, Vec<f64>)>,
    /// Memory of differences that were dropped.
    spare: Vec<(Vec<f64>, Vec<f64>)>,
}

impl Acceleration {
    /// For iterates of `size` numbers.
    pub(super) fn new(size: usize) -> Self {
        let pair = || (vec![0.0; size], vec![0.0; size]);
        Self {
            last: pair(),
            known: false,
            differences: Vec::with_capacity(DEPTH),
            spare: (0..DEPTH).map(|_| pair()).collect(),
        }
    }

    /// Forgets all: another matrix, or another step.
    pub(super) fn restart(&mut self) {
        self.known = false;
        self.spare.append(&mut self.differences);
    }

    /// Notes the iterate and the increment that the matrix gives there.
    pub(super) fn note(&mut self, iterate: &[f64], increment: &[f64]) {
        if self.known {
            if self.differences.len() == DEPTH {
                self.spare.push(self.differences.remove(0));
            }
            if let Some((mut moved, mut changed)) = self.spare.pop() {
                for i in 0..iterate.len() {
                    moved[i] = iterate[i] - self.last.0[i];
                    changed[i] = increment[i] - self.last.1[i];
                }
                self.differences.push((moved, changed));
            }
        }
        self.last.0.copy_from_slice(iterate);
        self.last.1.copy_from_slice(increment);
        self.known = true;
    }

    /// Replaces the increment noted last by the accelerated one, `f - sum gamma_j (dy_j + df_j)` with the least
    /// `f - sum gamma_j df_j`. What has no entry in `weights` follows without being measured.
    pub(super) fn accelerate(&self, weights: &[f64], increment: &mut [f64]) {
        let measured = |y: &[f64]| -> Vec<f64> { y.iter().zip(weights).map(|(y, weight)| y * weight).collect() };
        // Gram and Schmidt from the newest on: pairs (direction, combination of differences).
        let mut basis: Vec<(Vec<f64>, Vec<f64>)> = Vec::with_capacity(self.differences.len());
        let mut rest = measured(increment);
        let mut gamma = vec![0.0; self.differences.len()];
        for (place, (_, changed)) in self.differences.iter().enumerate().rev() {
            let mut direction = measured(changed);
            let mut combination = vec![0.0; gamma.len()];
            combination[place] = 1.0;
            let whole = dot(&direction, &direction).sqrt();
            for _ in 0..2 {
                for (other, parts) in &basis {
                    let along = dot(other, &direction);
                    subtract(along, other, &mut direction);
                    subtract(along, parts, &mut combination);
                }
            }
            let size = dot(&direction, &direction).sqrt();
            if size.is_nan() || size <= INDEPENDENT * whole {
                continue;
            }
            direction.iter_mut().for_each(|y| *y /= size);
            combination.iter_mut().for_each(|y| *y /= size);
            let along = dot(&direction, &rest);
            subtract(along, &direction, &mut rest);
            subtract(-along, &combination, &mut gamma);
            basis.push((direction, combination));
        }
        for ((moved, changed), gamma) in self.differences.iter().zip(gamma) {
            subtract(gamma, moved, increment);
            subtract(gamma, changed, increment);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `y -= factor x`
fn subtract(factor: f64, x: &[f64], y: &mut [f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y -= factor * x);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_bad_directions_no_longer_matter() {
        // y <- y + f(y) with f = -(1 - c_i) (y_i - 1): all contract by 1e-3 but three, which diverge.
        let factor = |i: usize| match i {
            3 => 2.5,
            7 => -3.0,
            11 => 0.9,
            _ => 1e-3,
        };
        let size = 20;
        let weights = vec![1.0; size - 1];
        let (mut y, mut acceleration) = (vec![0.0; size], Acceleration::new(size));
        for _ in 0..6 {
            let mut f: Vec<f64> = (0..size).map(|i| (factor(i) - 1.0) * (y[i] - 1.0)).collect();
            acceleration.note(&y, &f);
            acceleration.accelerate(&weights, &mut f);
            y.iter_mut().zip(&f).for_each(|(y, f)| *y += f);
        }
        assert!(y[..size - 1].iter().all(|y| (y - 1.0).abs() < 1e-9), "{y:?}");
        acceleration.restart();
        let mut f = vec![0.5; size];
        acceleration.note(&y, &f);
        acceleration.accelerate(&weights, &mut f);
        assert!(f.iter().all(|f| *f == 0.5), "nothing is known after a restart");
    }
}
