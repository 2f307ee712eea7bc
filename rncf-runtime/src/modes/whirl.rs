//! In which sense a mode whirls about the axis of the spin.

/// Circulation from which on a mode counts as whirling.
const CLEAR: f64 = 0.1;

/// Sense in which the points of the bodies circulate about the axis, seen in the co-rotating axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whirl {
    /// With the spin.
    Forward,
    /// Against the spin.
    Backward,
    /// Without clear sense: paths are nearly straight, or some points go one way and some the other.
    Mixed,
    /// Nothing spins, nothing moves across the axis, or the mode does not oscillate.
    None,
}

impl Whirl {
    /// The sense of a mode of frequency `im` with the circulation of
    /// [`Scene::circulation`](crate::model::Scene::circulation).
    pub fn of(im: f64, circulation: Option<f64>) -> Self {
        match circulation {
            Some(circulation) if im > 0.0 => match circulation {
                c if c > CLEAR => Whirl::Forward,
                c if c < -CLEAR => Whirl::Backward,
                _ => Whirl::Mixed,
            },
            _ => Whirl::None,
        }
    }

    /// The name in tables: `forward`, `backward`, `mixed` or `none`.
    pub fn name(self) -> &'static str {
        match self {
            Whirl::Forward => "forward",
            Whirl::Backward => "backward",
            Whirl::Mixed => "mixed",
            Whirl::None => "none",
        }
    }

    /// Angular velocity of the whirl in inertial axes, rad/s, positive with the spin, of a mode of frequency
    /// `im` (co-rotating axes) about an axisymmetric, balanced equilibrium that turns with `spin` (rad/s,
    /// not negative). `None` where the mode does not whirl in one sense: it then appears at two
    /// frequencies, `spin + im` and `|spin - im|` (THEORY 8.1).
    pub fn inertial(self, im: f64, spin: f64) -> Option<f64> {
        match self {
            Whirl::Forward => Some(spin + im),
            Whirl::Backward => Some(spin - im),
            Whirl::Mixed | Whirl::None => None,
        }
    }
}

/// `sum 2 Im(u_1 conj(u_2)) / sum (|u_1|^2 + |u_2|^2)` of displacements u across an axis, where `first`,
/// `second` and the axis are right-handed unit vectors: 1 where all points go about it on circles in its
/// sense, -1 against it, 0 on straight lines. `None` where nothing moves across.
pub(crate) fn circulation(displacements: &[[[f64; 2]; 3]], first: [f64; 3], second: [f64; 3]) -> Option<f64> {
    let (mut turning, mut size, mut whole) = (0.0, 0.0, 0.0);
    for point in displacements {
        let along =
            |axis: [f64; 3]| -> [f64; 2] { std::array::from_fn(|part| (0..3).map(|i| axis[i] * point[i][part]).sum()) };
        let ([re1, im1], [re2, im2]) = (along(first), along(second));
        turning += 2.0 * (im1 * re2 - re1 * im2);
        size += re1 * re1 + im1 * im1 + re2 * re2 + im2 * im2;
        whole += point.iter().flatten().map(|value| value * value).sum::<f64>();
    }
    // Motion along the axis and what round-off adds to it.
    let across = size > ALONG * whole;
    (across && turning.is_finite()).then(|| (turning / size).clamp(-1.0, 1.0))
}

/// Part of the squared displacements across the axis that is round-off beside those along it.
const ALONG: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::*;

    const X: [f64; 3] = [1.0, 0.0, 0.0];
    const Y: [f64; 3] = [0.0, 1.0, 0.0];

    #[test]
    fn a_circle_with_the_spin_is_forward() {
        // (cos t, sin t) = Re((1, -i) exp(i t))
        let forward = [[1.0, 0.0], [0.0, -1.0], [0.3, 0.0]];
        let backward = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
        assert_eq!(circulation(&[forward], X, Y), Some(1.0));
        assert_eq!(circulation(&[backward], X, Y), Some(-1.0));
        assert_eq!(circulation(&[forward, backward], X, Y), Some(0.0));
        // About the opposite axis.
        assert_eq!(circulation(&[forward], Y, X), Some(-1.0));
    }

    #[test]
    fn what_does_not_whirl_has_no_sense() {
        assert_eq!(circulation(&[[[0.0; 2], [0.0; 2], [1.0, 0.0]]], X, Y), None);
        assert_eq!(Whirl::of(2.0, None), Whirl::None);
        assert_eq!(Whirl::of(0.0, Some(1.0)), Whirl::None);
        assert_eq!(Whirl::of(2.0, Some(0.05)), Whirl::Mixed);
        assert_eq!(Whirl::Mixed.inertial(2.0, 3.0), None);
    }

    #[test]
    fn inertial_whirl_adds_the_spin() {
        // A shaft with w0 = 5 at 7 rad/s: seen co-rotating, both of its whirls go backward.
        let backward = Whirl::of(12.0, Some(-1.0));
        assert_eq!(backward.inertial(12.0, 7.0), Some(-5.0));
        assert_eq!(Whirl::of(2.0, Some(-1.0)).inertial(2.0, 7.0), Some(5.0));
        assert_eq!(Whirl::of(2.0, Some(1.0)).inertial(2.0, 3.0), Some(5.0));
    }
}
