//! Extrapolation of accelerations and multipliers from accepted steps: where Newton starts.

use crate::archive::{Archive, Keep};
use crate::system::State;

/// Up to two states before the last accepted one, newest first.
#[derive(Default)]
pub(super) struct History {
    past: [Point; 2],
    known: usize,
    /// Degree of the polynomial that is used.
    degree: usize,
}

/// Accelerations and multipliers at one time.
#[derive(Default)]
struct Point {
    t: f64,
    a: Vec<f64>,
    lambda: Vec<f64>,
}

impl Keep for History {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { past, known, degree } = self;
        for Point { t, a, lambda } in past {
            t.keep(archive);
            archive.fixed(a);
            archive.fixed(lambda);
        }
        known.keep(archive);
        degree.keep(archive);
        if *known > 2 || *degree > 2 {
            archive.misfit();
        }
    }
}

impl History {
    /// An empty history of `n` unknowns and `m` multipliers.
    pub(super) fn new(n: usize, m: usize) -> Self {
        let point = || Point {
            t: 0.0,
            a: vec![0.0; n],
            lambda: vec![0.0; m],
        };
        Self {
            past: [point(), point()],
            known: 0,
            degree: 0,
        }
    }

    /// Forgets everything: the solution is not smooth across a restart.
    pub(super) fn restart(&mut self) {
        self.known = 0;
        self.degree = 0;
    }

    /// Takes in that `now` followed `last`: chooses the degree that would have predicted it best,
    /// and remembers `last`. Stiff modes that the steps do not resolve alternate in sign; a parabola
    /// through them leads astray.
    pub(super) fn remember(&mut self, last: &State, now: &State, inverse_sizes: &[f64]) {
        let factors: [[f64; 3]; 3] = std::array::from_fn(|degree| match degree <= self.known {
            true => self.factors(degree, last.t, now.t),
            false => [0.0; 3],
        });
        let mut misses = [0.0; 3];
        let past = self.past[0].a.iter().zip(&self.past[1].a);
        let present = last.a.iter().zip(&now.a).zip(inverse_sizes);
        for (((zero, now), size), (one, two)) in present.zip(past) {
            for (sum, [a, b, c]) in misses.iter_mut().zip(factors) {
                let miss = (now - (a * zero + b * one + c * two)) * size;
                *sum += miss * miss;
            }
        }
        let mut best = f64::INFINITY;
        for (degree, &miss) in misses.iter().enumerate().take(self.known + 1) {
            if miss < best {
                best = miss;
                self.degree = degree;
            }
        }
        if self.degree == self.known {
            self.degree += 1; // as good as it could be: try what comes next
        }
        self.past.swap(0, 1);
        self.past[0].t = last.t;
        self.past[0].a.copy_from_slice(&last.a);
        self.past[0].lambda.copy_from_slice(&last.lambda);
        self.known = (self.known + 1).min(2);
        self.degree = self.degree.min(self.known);
    }

    /// Accelerations and multipliers of `out` at its time from `last` and the history; false if
    /// there is none.
    pub(super) fn extrapolate(&self, last: &State, out: &mut State) -> bool {
        if self.known == 0 {
            return false;
        }
        let factors = self.factors(self.degree, last.t, out.t);
        for i in 0..out.a.len() {
            out.a[i] = self.combined(factors, i, |point| &point.a, &last.a);
        }
        for i in 0..out.lambda.len() {
            out.lambda[i] = self.combined(factors, i, |point| &point.lambda, &last.lambda);
        }
        true
    }

    /// Weights at `t` of the last state, at `t0`, and of the history: Lagrange's polynomials.
    fn factors(&self, degree: usize, t0: f64, t: f64) -> [f64; 3] {
        let (t1, t2) = (self.past[0].t, self.past[1].t);
        match degree {
            0 => [1.0, 0.0, 0.0],
            1 => [(t - t1) / (t0 - t1), (t - t0) / (t1 - t0), 0.0],
            _ => [
                (t - t1) * (t - t2) / ((t0 - t1) * (t0 - t2)),
                (t - t0) * (t - t2) / ((t1 - t0) * (t1 - t2)),
                (t - t0) * (t - t1) / ((t2 - t0) * (t2 - t1)),
            ],
        }
    }

    fn combined(&self, factors: [f64; 3], i: usize, of: impl Fn(&Point) -> &Vec<f64>, last: &[f64]) -> f64 {
        let [one, two] = &self.past;
        factors[0] * last[i] + factors[1] * of(one)[i] + factors[2] * of(two)[i]
    }
}
