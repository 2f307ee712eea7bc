//! In which sense what moves in a mode goes round the axis of the spin.

/// Part of the kinetic energy below which what goes across the axis tells no sense of whirl: the round-off of a torsion
/// does, and what an unbalance couples to it.
const ALONG: f64 = 1e-3;

/// Sums over what moves in a mode, weighted with masses; each a Hermitian form of its shape.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Circulating {
    /// `sum 2 Im(u_1 conj(u_2))` of displacements u across the axis of the rotation: positive for what goes round with the spin.
    pub turning: f64,
    /// `sum |u_1|^2 + |u_2|^2`.
    pub across: f64,
    /// The same of all that moves, along the axis, too.
    pub whole: f64,
}

impl Circulating {
    /// 1 where all points go round with the spin on circles, -1 against it, 0 on straight lines or without a common sense; `None` where
    /// hardly anything moves across the axis.
    pub fn sense(&self) -> Option<f64> {
        let is_across = self.across > ALONG * self.whole && self.turning.is_finite();
        is_across.then(|| (self.turning / self.across).clamp(-1.0, 1.0))
    }
}
