//! What an iteration may leave of motions that nothing brings back.
//!
//! A remainder `e` of the positions of a step is an error of velocity near `e / h`. A vibration damps it away or turns it round. A
//! body that flies or turns freely keeps it: in a turning frame momentum is not linear in the unknowns, so that every
//! iterate misses some, in the same direction step after step. The remainder of the mean acceleration of a step, `a`, acts like
//! a force that is not there. Over a run of length T it moves the body by `a T^2 / 2`: that, not the remainder of one step, is
//! measured by the tolerance. Poses of free frames and rigid bodies are measured so. Nodal vectors are not: their
//! remainders are in stiff vibrations, which the method damps, and no affordable iteration makes them that small.

use crate::archive::{Archive, Keep};
use crate::system::System;

/// Smallest amplification that is expected of an iteration before its contraction is seen.
const LEAST: f64 = 0.02;
/// Increments that fall by less than this in three iterations are noise.
const STAGNANT: f64 = 0.5;
/// Noise that was seen is remembered over some fifty steps, and exceeded.
const FORGETTING: f64 = 0.98;
const EXCEEDED: f64 = 2.0;

/// The remainder of an iteration in the poses, as displacements by the end of the run over the tolerance.
#[derive(Clone, Debug)]
pub(super) struct Lasting {
    /// First unknown of the poses.
    first: usize,
    /// `T^2 / 2` over the weight of each of them.
    factors: Vec<f64>,
    /// Contraction over one less contraction, of the present iteration or the last one.
    amplification: f64,
    /// Sizes of the last increments, newest first.
    sizes: [f64; 4],
    count: usize,
    /// Size of the step, s.
    h: f64,
    /// Size at which increments did not fall any more.
    noise: f64,
    /// Size of the step in which that was, s.
    noise_at: f64,
}

impl Keep for Lasting {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            first: _,
            factors: _,
            amplification,
            sizes,
            count,
            h,
            noise,
            noise_at,
        } = self;
        amplification.keep(archive);
        sizes.keep(archive);
        count.keep(archive);
        h.keep(archive);
        noise.keep(archive);
        noise_at.keep(archive);
    }
}

impl Lasting {
    /// For a run of `span` seconds and the tolerance `rtol` of its result relative to the sizes of the unknowns.
    pub(super) fn new(system: &dyn System, rtol: f64, span: f64) -> Self {
        let first = system.unknowns() - system.border();
        let factor = 0.5 * span * span / rtol;
        Self {
            first,
            factors: system.sizes()[first..].iter().map(|size| factor / size).collect(),
            amplification: 1.0,
            sizes: [f64::INFINITY; 4],
            count: 0,
            h: 0.0,
            noise: 0.0,
            noise_at: 0.0,
        }
    }

    /// Begins the iteration of another step, of `h` s, or with another matrix.
    pub(super) fn begin(&mut self, h: f64) {
        self.count = 0;
        self.h = h;
    }

    /// Forgets the contraction that was seen: another matrix.
    pub(super) fn restart(&mut self) {
        self.count = 0;
        self.amplification = 1.0;
    }

    /// Notes an increment by what it changes of the mean acceleration over the step, of an unknown by its number.
    pub(super) fn note(&mut self, acceleration: impl Fn(usize) -> f64) {
        let size = |(i, factor): (usize, &f64)| (acceleration(self.first + i) * factor).abs();
        let size = self.factors.iter().enumerate().map(size).fold(0.0, f64::max);
        self.sizes.rotate_right(1);
        self.sizes[0] = size;
        self.count += 1;
        self.amplification = match self.count {
            1 => self.amplification.clamp(LEAST, 1.0),
            _ => match size / self.sizes[1] {
                ratio if ratio < 1.0 => ratio / (1.0 - ratio),
                _ => f64::INFINITY,
            },
        };
    }

    /// Whether what is left moves no pose by more than the tolerance until the end of the run, or is noise.
    pub(super) fn is_settled(&self) -> bool {
        let size = self.sizes[0];
        self.factors.is_empty() || size <= self.expected_noise() || size == 0.0 || size * self.amplification <= 1.0
    }

    /// What is expected of noise in this step. That of places is an acceleration of `1 / h^2` as much: seen in a short step, it is little in a long one.
    fn expected_noise(&self) -> f64 {
        self.noise * (self.noise_at / self.h).powi(2).min(1.0)
    }

    /// Whether the increments do not fall any more.
    pub(super) fn is_stagnant(&self) -> bool {
        self.count >= 4 && self.sizes[..3].iter().all(|size| *size > STAGNANT * self.sizes[3])
    }

    /// The iteration is accepted as it is: at noise where it stagnates.
    pub(super) fn accept(&mut self) {
        self.noise *= FORGETTING;
        if !self.is_settled() {
            (self.noise, self.noise_at) = (EXCEEDED * self.sizes[0], self.h);
        }
    }
}
