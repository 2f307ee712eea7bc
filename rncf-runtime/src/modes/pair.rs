//! Pairs of eigenvalue and eigenvector, and what the ways to them share.

use super::pencil::Pencil;
use crate::linalg::c64;

/// Part of the shift below which eigenvalues may be zeros.
pub(super) const SLOW: f64 = 0.05;

/// Parts of the shift that the lowest frequency may be.
const FITTING: std::ops::Range<f64> = 0.2..20.0;

/// Eigenvalues closer than this, relative to their distance from the shift, may be one.
pub(super) const CLOSE: f64 = 1e-6;

/// An eigenvalue and the unknowns of its vector, relative to the pencil's sizes.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub s: c64,
    pub x: Vec<c64>,
}

/// Why modes were not found. Rows count unknowns first, then constraints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Failure {
    /// The pencil is singular whatever the eigenvalue.
    Singular(Option<usize>),
    /// An entry is not finite.
    NotFinite,
    /// The iteration for eigenvalues of a full matrix did not converge.
    NotFound,
    /// Arnoldi's iteration did not converge beyond this number of modes.
    Slow(usize),
    /// The mode of this number does not satisfy its equation.
    Inexact(usize),
    /// Beyond this number of modes some were lost to round-off.
    Lost(usize),
    /// No mode was found though this number of motions is free.
    Nothing(usize),
}

/// A shift that suits the given approximate pairs better than the present one: near the lowest frequency
/// that is not zero.
pub(super) fn better_shift(pencil: &Pencil, shift: f64, pairs: impl Iterator<Item = Pair>) -> Option<f64> {
    let none = vec![c64::default(); pencil.constraints()];
    // Either estimate may be off: that of the inverse by its round-off, the other by a stiff part.
    let speed = |pair: Pair| pair.s.norm().min(pencil.residual(pair.s, &pair.x, &none).1.norm());
    // Beside a stiff part the round-off of zeros is no small part of the shift: towards it the pencil becomes singular.
    let lowest = pairs
        .filter(|pair| pair.s.norm() > SLOW * shift || !pencil.is_still(&pair.x, CLOSE * shift))
        .map(speed)
        .filter(|&speed| speed > CLOSE * shift)
        .fold(f64::INFINITY, f64::min);
    (lowest.is_finite() && !FITTING.contains(&(lowest / shift))).then_some(0.5 * lowest)
}

/// Scales the vector such that its first entry of the largest size is 1.
pub(super) fn normalise(x: &mut [c64], lambda: &mut [c64]) {
    let largest = x.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let entry = x.iter().copied().find(|value| value.norm() >= (1.0 - CLOSE) * largest);
    if let Some(entry) = entry.filter(|entry| entry.norm() > 0.0) {
        x.iter_mut().chain(lambda).for_each(|value| *value /= entry);
    }
}

/// By size, then by growth, then the one that turns ahead.
pub(super) fn order(a: c64, b: c64) -> std::cmp::Ordering {
    a.norm()
        .total_cmp(&b.norm())
        .then(a.re.total_cmp(&b.re))
        .then(b.im.total_cmp(&a.im))
}
