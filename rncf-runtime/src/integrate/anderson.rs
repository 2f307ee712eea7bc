//! Acceleration of a Newton iteration with a matrix that is not the true one (Anderson 1965).
//!
//! With one tangent for several stages, or an older one, a few motions may contract badly or not at
//! all: those of light frames, whose inertia is a small difference of large ones, and those that
//! constraints hardly hold near a singular configuration. Each earlier iteration tells what the matrix
//! makes of one direction; the increment is replaced by the combination that would have been smallest.

use pulp::Arch;

use crate::linalg::{Vectorised, dispatch};

/// Iterations that are remembered: motions that may contract badly.
const DEPTH: usize = 6;
/// Part of a difference, relative to itself, that must be left beside the newer ones.
const INDEPENDENT: f64 = 1e-4;
/// Part that must be left for a direction to be free of the newer ones after one subtraction; else there is another.
const CLEAN: f64 = 0.5;

/// Iterates and increments so far.
pub(super) struct Acceleration {
    /// Last iterate and its increment as the matrix gave it.
    last: (Vec<f64>, Vec<f64>),
    known: bool,
    /// Differences of successive iterates and of their increments, newest last.
    differences: Vec<(Vec<f64>, Vec<f64>)>,
    /// Memory of differences that were dropped.
    spare: Vec<(Vec<f64>, Vec<f64>)>,
    /// Memory of an acceleration.
    basis: Vec<Direction>,
    rest: Vec<f64>,
}

/// A direction of length 1 in which increments have differed, and the combination of differences that it is.
struct Direction {
    along: Vec<f64>,
    parts: [f64; DEPTH],
}

impl Acceleration {
    /// For iterates of `size` numbers.
    pub(super) fn new(size: usize) -> Self {
        let pair = || (vec![0.0; size], vec![0.0; size]);
        let direction = || Direction {
            along: vec![0.0; size],
            parts: [0.0; DEPTH],
        };
        Self {
            last: pair(),
            known: false,
            differences: Vec::with_capacity(DEPTH),
            spare: (0..DEPTH).map(|_| pair()).collect(),
            basis: (0..DEPTH).map(|_| direction()).collect(),
            rest: vec![0.0; size],
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
    pub(super) fn accelerate(&mut self, weights: &[f64], increment: &mut [f64]) {
        dispatch(Arch::new(), Accelerated(self, weights, increment));
    }

    #[inline(always)]
    fn replace(&mut self, weights: &[f64], increment: &mut [f64]) {
        let measured = weights.len();
        let rest = &mut self.rest[..measured];
        weigh(increment, weights, rest);
        let mut gamma = [0.0; DEPTH];
        // Gram and Schmidt from the newest on.
        let mut count = 0;
        for (place, (_, changed)) in self.differences.iter().enumerate().rev() {
            let (known, unknown) = self.basis.split_at_mut(count);
            let Some(Direction { along, parts }) = unknown.first_mut() else {
                break;
            };
            let along = &mut along[..measured];
            weigh(changed, weights, along);
            *parts = [0.0; DEPTH];
            parts[place] = 1.0;
            let whole = dot(along, along).sqrt();
            let mut size = whole;
            for _ in 0..2 {
                for other in &*known {
                    let part = dot(&other.along[..measured], along);
                    subtract(part, &other.along[..measured], along);
                    subtract(part, &other.parts, parts);
                }
                size = dot(along, along).sqrt();
                if size > CLEAN * whole {
                    break;
                }
            }
            if size.is_nan() || size <= INDEPENDENT * whole {
                continue;
            }
            along.iter_mut().for_each(|y| *y /= size);
            parts.iter_mut().for_each(|y| *y /= size);
            let part = dot(along, rest);
            subtract(part, along, rest);
            subtract(-part, parts, &mut gamma);
            count += 1;
        }
        for ((moved, changed), gamma) in self.differences.iter().zip(gamma) {
            for ((y, moved), changed) in increment.iter_mut().zip(moved).zip(changed) {
                *y = *y - gamma * moved - gamma * changed;
            }
        }
    }
}

struct Accelerated<'a>(&'a mut Acceleration, &'a [f64], &'a mut [f64]);

impl Vectorised for Accelerated<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        self.0.replace(self.1, self.2);
    }
}

/// `out = y weights`, one by one.
#[inline(always)]
fn weigh(y: &[f64], weights: &[f64], out: &mut [f64]) {
    for ((out, y), weight) in out.iter_mut().zip(y).zip(weights) {
        *out = y * weight;
    }
}

/// Inner product, summed in four lanes.
#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut lanes = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..4 {
            lanes[lane] += a[lane] * b[lane];
        }
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]) + rest
}

/// `y -= factor x`
#[inline(always)]
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
