//! Whether a deflection is beyond what linear elastic forces describe: the whole body, under a load that they balance there, resists otherwise.
//! Only the work of that load is held, for other modes of the whole body move with it, as one along its axis does with the square of the slope.
//! A cantilever resists more with the square of its slope, a body that is held at both ends with the square of its deflection over the size of its section.

use std::fmt;

use super::body::ModalBody;
use super::locking::{LEAST, RELAXED};
use crate::scene::bodies::described::Elements;

/// Part of a deflection that may be off without a report.
const TOLD: f64 = 0.01;
/// Part of the deflection at which the balance is looked for. The difference grows with its square; the whole body may have no balance at
/// all of it. Half of it follows, up to so many times, until both agree.
const FIRST: f64 = 0.5;
const MOST_PARTS: usize = 5;
/// By how much half the part may differ in what grows so. Round-off grows with the third power the other way.
const ALIKE: f64 = 3.0;

/// A deflection that linear forces get wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct BeyondLinear {
    /// Body.
    pub body: String,
    /// Number of its modes.
    pub modes: usize,
    /// By which part the deflection is too large; negative where it is too small.
    pub off: f64,
}

impl fmt::Display for BeyondLinear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { body, modes, off } = self;
        let (percent, way) = (100.0 * off.abs(), if *off > 0.0 { "large" } else { "small" });
        write!(
            f,
            "body `{body}`: its deflection is beyond the linear elastic forces of small({modes}), and about {percent:.0} % too {way}: leave `small` out to use the whole body"
        )
    }
}

/// s of `s + more s^3 = 1`, to first order where the whole body is softer.
fn balance(more: f64) -> f64 {
    if more < 0.0 {
        return 1.0 - more;
    }
    let mut s = 1.0;
    // Newton's method falls towards the only root from above.
    for _ in 0..40 {
        s -= (s + more * s * s * s - 1.0) / (1.0 + 3.0 * more * s * s);
    }
    s
}

impl ModalBody {
    /// What grows with the deflection p, if the elastic forces are linear: their work, J.
    pub fn linear_work(&self, p: &[f64]) -> Option<f64> {
        let moved = p.iter().zip(&self.sizes).any(|(p, size)| p.abs() > LEAST * size);
        (moved && !self.moves()).then(|| self.linear_energy(p))
    }

    /// How far the deflection p is off, if it is by much. Under a load that linear forces balance at p, the whole body deflects by a part s
    /// of it with `s + more s^3 = 1`.
    pub fn beyond_linear(&self, elements: &dyn Elements, p: &[f64]) -> Option<BeyondLinear> {
        let mut more = self.more_than_linear(elements, p, FIRST);
        let mut part = FIRST;
        for _ in 0..MOST_PARTS {
            let half = self.more_than_linear(elements, p, 0.5 * part);
            if let (Some(more), Some(half)) = (more, half) {
                let off = 1.0 / balance(more) - 1.0;
                if off.abs() <= TOLD {
                    return None;
                }
                if (1.0 / ALIKE..ALIKE).contains(&(half / more)) {
                    return Some(BeyondLinear {
                        body: self.nodal.name.clone(),
                        modes: self.modes(),
                        off,
                    });
                }
            }
            (more, part) = (half, 0.5 * part);
        }
        None
    }

    /// What the whole body resists more at a part of the deflection p, over what linear forces do and the square of the part.
    fn more_than_linear(&self, elements: &dyn Elements, p: &[f64], part: f64) -> Option<f64> {
        let p: Vec<f64> = p.iter().map(|p| part * p).collect();
        let [q, _] = self.full(&p, &vec![0.0; p.len()]);
        let linear = 2.0 * self.linear_energy(&p);
        let (_, load) = self.relaxed(elements, q, RELAXED * TOLD * linear, &self.work_along(&p))?;
        Some((load[0] - 1.0) / (part * part))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emitted::Fidelity;
    use crate::modal::tests::cable::cantilever;

    /// A force F across the end of a cantilever: `w / L` of the elastica is 0.30174, 0.49346, 0.81061 at `F L^2 / EI = 1`, 2 and 10
    /// (Bisshopp and Drucker 1945), a third of this number where all is linear.
    #[test]
    fn small_modes_tell_deflections_beyond_them() {
        // Twelve modes are some along the axis, too, which shortens as it bends.
        for modes in [4, 12] {
            deflections_beyond(modes);
        }
    }

    fn deflections_beyond(modes: usize) {
        let (nodal, cable) = cantilever(2, 6, 1e5, 0.0, 0.0);
        let body = ModalBody::new(nodal, Fidelity::Small(modes), &cable).unwrap();
        let tip = body.mode_row(2 * 6 * 2 + 1).to_vec();
        let off = |force: f64| {
            let modes = tip.iter().zip(&body.frequencies);
            let p: Vec<f64> = modes.map(|(phi, w)| force * phi / (w * w)).collect();
            let end: f64 = tip.iter().zip(&p).map(|(phi, p)| phi * p).sum();
            assert!((end - force / 3.0).abs() < 1e-3 * force, "{end}");
            body.beyond_linear(&cable, &p)
        };
        assert_eq!(off(0.2), None);
        for (force, w, within) in [(1.0, 0.30174, 0.1), (2.0, 0.49346, 0.2), (10.0, 0.81061, 0.5)] {
            let found = off(force).unwrap();
            let truth = force / 3.0 / w - 1.0;
            assert!((found.off / truth - 1.0).abs() < within, "{} {truth}", found.off);
        }
        assert!(off(1.0).unwrap().to_string().contains("body `arm`"));
    }
}
