//! Whether modes hinder a deflection that the whole body would not: a point of a bending body also
//! moves along it, by the square of the slope, and modes that do not contain this motion stretch the
//! body instead. They are then far too stiff, from deflections of the section's radius of gyration on.

use std::fmt;

use super::{Elements, ModalBody};

/// Part of a deflection that may be missing without a report.
const MISSING: f64 = 0.05;
/// Part of the modes' sizes below which round-off decides.
const LEAST: f64 = 1e-6;

/// Modes that hinder a deflection.
#[derive(Clone, Debug, PartialEq)]
pub struct Locking {
    /// Body.
    pub body: String,
    /// Number of its modes.
    pub modes: usize,
    /// Part of the deflection that is missing, roughly.
    pub missing: f64,
}

impl fmt::Display for Locking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { body, modes, missing } = self;
        let percent = 100.0 * missing;
        write!(
            f,
            "body `{body}`: its deflection is too large for its {modes} modes, which stretch it where the whole body only bends, so that about {percent:.0} % of the deflection are missing: leave `modal` out to use the whole body"
        )
    }
}

impl ModalBody {
    /// Modes that hinder the deflection p, if they do: the strain energy that a static displacement
    /// by all motions left out would release, with the stiffness at rest, is compared with half the
    /// work of the modal forces on p.
    pub fn locking(&self, elements: &dyn Elements, p: &[f64]) -> Option<Locking> {
        let moved = p.iter().zip(&self.sizes).any(|(p, size)| p.abs() > LEAST * size);
        if !moved || !self.moves() {
            return None;
        }
        let [q, rest] = self.full(p, &vec![0.0; p.len()]);
        let nodal = &self.nodal;
        let connectivity = &nodal.connectivity;
        let mut force = vec![0.0; q.len()];
        for element in 0..connectivity.count() {
            let (q, v) = (self.gathered(element, &q), self.gathered(element, &rest));
            let mut local = vec![0.0; connectivity.size];
            elements.force(element, &q, &v, &mut local);
            for (value, &component) in local.iter().zip(connectivity.element(element)) {
                force[component] += value;
            }
        }
        // Without what the modes balance, M phi_i (phi_i . F).
        let k = self.modes();
        let mut modal = vec![0.0; k];
        for (component, value) in force.iter().enumerate() {
            for (sum, mode) in modal.iter_mut().zip(self.mode_row(component)) {
                *sum += mode * value;
            }
        }
        for (value, momentum) in force.iter_mut().zip(self.momenta.chunks_exact(k)) {
            *value -= momentum.iter().zip(&modal).map(|(m, f)| m * f).sum::<f64>();
        }
        let left = nodal.reduced(&force);
        let mut displacement = left.clone();
        self.stiffness.as_ref()?.solve(&mut displacement);
        let work = |a: &[f64], b: &[f64]| 0.5 * a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let (released, all) = (work(&left, &displacement), work(&modal, p));
        // The energy U that hinders grows with the fourth power of the deflection d, its force is 4 U/d:
        // the part 4 U/d / F of the deflection is missing, and `all` is F d/2.
        let missing = (2.0 * released / all).min(1.0);
        (all > 0.0 && missing > MISSING).then(|| Locking {
            body: nodal.name.clone(),
            modes: k,
            missing,
        })
    }
}
