//! Acceleration of a Newton iteration with a matrix that is not the true one (Anderson 1965).
//!
//! With one tangent for several stages, or an older one, a few motions may contract badly or not at
//! all: those of light frames, whose inertia is a small difference of large ones, and those that
//! constraints hardly hold near a singular configuration. Each earlier iteration tells what the matrix
//! makes of one direction; the increment is replaced by the combination that would have been smallest.

use pulp::Arch;

use crate::linalg::{Vectorised, dispatch, dot};

/// Iterations that are remembered: motions that may contract badly.
const DEPTH: usize = 6;
/// Part of a difference, relative to itself, that must be left beside the newer ones.
const INDEPENDENT: f64 = 1e-4;

/// What the iterations so far tell.
pub(super) struct Acceleration {
    /// Last increment as the matrix gave it, and as it was applied.
    given: Vec<f64>,
    applied: Vec<f64>,
    known: bool,
    /// Oldest first.
    differences: Vec<Difference>,
    /// Memory of differences that were dropped.
    spare: Vec<Difference>,
    /// Weights of what is measured of an increment.
    weights: Vec<f64>,
    /// The increment by weights.
    weighed: Vec<f64>,
}

/// What changed from one iteration to the next.
struct Difference {
    /// Of the iterate and its increment together.
    moved: Vec<f64>,
    /// Of the increment, by weights.
    weighed: Vec<f64>,
    /// Inner products of `weighed` with those of the older differences and itself.
    products: [f64; DEPTH],
}

impl Acceleration {
    /// For increments of `size` numbers, of which the first ones have weights.
    pub(super) fn new(size: usize, weights: Vec<f64>) -> Self {
        let measured = weights.len();
        let difference = || Difference {
            moved: vec![0.0; size],
            weighed: vec![0.0; measured],
            products: [0.0; DEPTH],
        };
        Self {
            given: vec![0.0; size],
            applied: vec![0.0; size],
            known: false,
            differences: Vec::with_capacity(DEPTH),
            spare: (0..DEPTH).map(|_| difference()).collect(),
            weighed: vec![0.0; measured],
            weights,
        }
    }

    /// Forgets all: another matrix, or another step.
    pub(super) fn restart(&mut self) {
        self.known = false;
        self.spare.append(&mut self.differences);
    }

    /// Takes the increment that the matrix gives, and replaces it, where that is wanted, by the accelerated one,
    /// `f - sum gamma_j (dy_j + df_j)` with the least `f - sum gamma_j df_j`. What has no weight follows without
    /// being measured.
    pub(super) fn follow(&mut self, increment: &mut [f64], is_wanted: bool) {
        dispatch(Arch::new(), Followed(self, increment, is_wanted));
    }

    #[inline(always)]
    fn note(&mut self, increment: &[f64]) {
        if self.differences.len() == DEPTH {
            self.spare.push(self.differences.remove(0));
            for difference in &mut self.differences {
                difference.products.rotate_left(1);
            }
        }
        let Some(mut new) = self.spare.pop() else { return };
        let n = increment.len();
        let (moved, given, applied) = (&mut new.moved[..n], &self.given[..n], &self.applied[..n]);
        for i in 0..n {
            moved[i] = increment[i] - given[i];
        }
        for ((weighed, moved), weight) in new.weighed.iter_mut().zip(&*moved).zip(&self.weights) {
            *weighed = moved * weight;
        }
        for i in 0..n {
            moved[i] += applied[i];
        }
        for (product, old) in new.products.iter_mut().zip(&self.differences) {
            *product = dot(&old.weighed, &new.weighed);
        }
        new.products[self.differences.len()] = dot(&new.weighed, &new.weighed);
        self.differences.push(new);
    }

    /// Factors of the differences, by Cholesky's method from the newest on; what depends on newer ones is left out.
    #[inline(always)]
    fn factors(&self) -> [f64; DEPTH] {
        // Rows of the factor by the places of the differences, and what is on the right.
        let (mut rows, mut right) = ([[0.0; DEPTH]; DEPTH], [0.0; DEPTH]);
        let mut used = [false; DEPTH];
        let count = self.differences.len();
        for place in (0..count).rev() {
            let own = &self.differences[place];
            let whole = own.products[place];
            let (mut left, mut side) = (whole, dot(&own.weighed, &self.weighed));
            for newer in (place + 1..count).rev().filter(|&newer| used[newer]) {
                let mut part = self.differences[newer].products[place];
                for between in (newer + 1..count).filter(|&between| used[between]) {
                    part -= rows[place][between] * rows[newer][between];
                }
                part /= rows[newer][newer];
                rows[place][newer] = part;
                left -= part * part;
                side -= part * right[newer];
            }
            used[place] = left > INDEPENDENT * INDEPENDENT * whole;
            if used[place] {
                rows[place][place] = left.sqrt();
                right[place] = side / rows[place][place];
            }
        }
        let mut factors = [0.0; DEPTH];
        for place in (0..count).filter(|&place| used[place]) {
            let older: f64 = (0..place).map(|older| rows[older][place] * factors[older]).sum();
            factors[place] = (right[place] - older) / rows[place][place];
        }
        factors
    }

    #[inline(always)]
    fn advance(&mut self, increment: &mut [f64], is_wanted: bool) {
        if self.known {
            self.note(increment);
        }
        self.given.copy_from_slice(increment);
        self.known = true;
        if is_wanted {
            let weighed = self.weighed.iter_mut().zip(&self.weights).zip(&*increment);
            weighed.for_each(|((weighed, weight), y)| *weighed = weight * y);
            let factors = self.factors();
            for (difference, factor) in self.differences.iter().zip(factors) {
                let by = difference.moved.iter();
                increment.iter_mut().zip(by).for_each(|(y, moved)| *y -= factor * moved);
            }
        }
        self.applied.copy_from_slice(increment);
    }
}

struct Followed<'a>(&'a mut Acceleration, &'a mut [f64], bool);

impl Vectorised for Followed<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const F: bool>(self) {
        self.0.advance(self.1, self.2);
    }
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
        let (mut y, mut acceleration) = (vec![0.0; size], Acceleration::new(size, vec![1.0; size - 1]));
        for _ in 0..6 {
            let mut f: Vec<f64> = (0..size).map(|i| (factor(i) - 1.0) * (y[i] - 1.0)).collect();
            acceleration.follow(&mut f, true);
            y.iter_mut().zip(&f).for_each(|(y, f)| *y += f);
        }
        assert!(y[..size - 1].iter().all(|y| (y - 1.0).abs() < 1e-9), "{y:?}");
        acceleration.restart();
        let mut f = vec![0.5; size];
        acceleration.follow(&mut f, true);
        assert!(f.iter().all(|f| *f == 0.5), "nothing is known after a restart");
    }
}
