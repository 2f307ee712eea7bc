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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::turning::circulation::Whirling;
    use crate::space::Vector;

    const Z: Vector = Vector::new(0.0, 0.0, 1.0);

    fn circulation(points: &[[Vector; 2]], axis: Vector) -> Option<f64> {
        let mut whirling = Whirling::about(Some(axis));
        for point in points {
            whirling.add(point, point);
            whirling.add_whole(point.iter().map(|part| part.dot(part)).sum());
        }
        whirling.sums()?.sense()
    }

    #[test]
    fn a_circle_with_the_spin_is_forward() {
        // (cos t, sin t) = Re((1, -i) exp(i t))
        let forward = [Vector::new(1.0, 0.0, 0.3), -Vector::y()];
        let backward = [Vector::x(), Vector::y()];
        assert_eq!(circulation(&[forward], Z), Some(1.0));
        assert_eq!(circulation(&[backward], Z), Some(-1.0));
        assert_eq!(circulation(&[forward, backward], Z), Some(0.0));
        // About the opposite axis.
        assert_eq!(circulation(&[forward], Vector::new(0.0, 0.0, -1.0)), Some(-1.0));
    }

    #[test]
    fn what_does_not_whirl_has_no_sense() {
        assert_eq!(circulation(&[[Vector::z(), Vector::zeros()]], Z), None);
        // A torsion with the round-off of a circle across the axis.
        assert_eq!(
            circulation(&[[Vector::new(1e-9, 0.0, 1.0), Vector::new(0.0, 1e-9, 0.0)]], Z),
            None
        );
        assert_eq!(Whirling::about(None).sums(), None);
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
