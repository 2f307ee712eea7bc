//! In which sense what moves in a mode goes round the axis of the spin.

/// Part of the kinetic energy below which what goes across the axis tells no sense of whirl: the round-off of a torsion
/// does, and what an unbalance couples to it.
const ALONG: f64 = 1e-3;
/// Sense from which on what goes round does so on circles.
pub const ROUND: f64 = 0.999;
/// Part that is left of forces that balance each other: round-off.
const BALANCED: f64 = 1e-3;

/// Sums over what moves in a mode, weighted with masses; the first three each a Hermitian form of its shape.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Circulating {
    /// `sum 2 Im(u_1 conj(u_2))` of displacements u across the axis of the rotation: positive for what goes round with the spin.
    pub turning: f64,
    /// `sum |u_1|^2 + |u_2|^2`.
    pub across: f64,
    /// The same of all that moves, along the axis, too.
    pub whole: f64,
    /// What the axis feels of masses beside it.
    pub beside: Beside,
}

/// Force and moment on the axis of all masses beside it, as of blades, and of which kind they are.
///
/// The points of a mode in which blades flap or lag one after the other go on straight lines. What they do to the hub goes round.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Beside {
    /// Square of what goes round with the spin: the part of the force across the axis, and of the moment over the distance of the farthest of these masses.
    pub forward: f64,
    /// The same of what goes round against it.
    pub backward: f64,
    /// The same of what acts along the axis.
    pub along: f64,
    /// Square of the sum of the sizes of all forces.
    pub gross: f64,
    /// Part of [`Circulating::whole`] that moves beside the axis.
    pub energy: f64,
}

/// What a mode's masses beside the axis do to it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Felt {
    /// A force or moment across the axis alone, and how round it goes: 1 on circles with the spin, -1 against it.
    Across(f64),
    /// Nothing across the axis.
    NotAcross,
}

impl Circulating {
    /// How the mode goes round the axis, as a bearing on it feels: 1 on circles with the spin, -1 against it, 0 on straight lines or without a
    /// common sense; `None` where hardly anything moves across the axis, or what does balances.
    pub fn sense(&self) -> Option<f64> {
        let is_across = self.across > ALONG * self.whole && self.turning.is_finite();
        let points = is_across.then(|| (self.turning / self.across).clamp(-1.0, 1.0));
        if points.is_some_and(|sense| sense.abs() > ROUND) || self.beside.energy <= ALONG * self.whole {
            return points;
        }
        match self.felt() {
            Some(Felt::Across(sense)) => Some(sense),
            Some(Felt::NotAcross) => None,
            None => points,
        }
    }

    /// What the axis feels of masses beside it; `None` where that is a force along the axis as well as one across it, as of a single blade.
    fn felt(&self) -> Option<Felt> {
        let Beside {
            forward,
            backward,
            along,
            gross,
            energy,
        } = self.beside;
        let across = forward + backward;
        if across + along <= BALANCED * BALANCED * gross {
            return (energy > (1.0 - ALONG) * self.whole).then_some(Felt::NotAcross);
        }
        let is_only = |part: f64| part > ROUND * (across + along);
        match (is_only(across), is_only(along)) {
            (true, _) => Some(Felt::Across((forward - backward) / across)),
            (_, true) => Some(Felt::NotAcross),
            _ => None,
        }
    }
}
