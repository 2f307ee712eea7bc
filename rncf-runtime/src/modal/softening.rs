//! Whether modes lose stiffness to the spin that the whole body would keep (THEORY 3.2, T10): linear
//! modes carry the centrifugal softening, but the stiffening comes through the stretch along the body,
//! which the lowest modes do not contain.

use std::fmt;

use super::action::FrameAction;
use super::body::ModalBody;
use super::invariants::{Action, Motion};
use crate::emitted::Fidelity;
use crate::linalg::{Cholesky, symmetric_eigen, times};
use crate::scene::bodies::described::Elements;
use crate::space::Vector;

/// Part of its stiffness at rest that a combination of modes must keep.
const LOWEST: f64 = 0.5;
/// Part of the stiffness at rest that the whole body must have more, for a report, and of its own.
const MISSING: f64 = 0.25;
/// Newton steps towards the equilibrium with the spin.
const STEPS: usize = 12;

/// A combination of modes that a spin softens and the whole body does not.
#[derive(Clone, Debug, PartialEq)]
pub struct LossOfStiffness {
    /// Body.
    pub body: String,
    /// How the body is described.
    pub fidelity: Fidelity,
    /// Spin, rad/s.
    pub spin: f64,
    /// Stiffness with the centrifugal terms over that at rest.
    pub remaining: f64,
    /// The same of the whole body, to first order in the square of the spin.
    pub whole: f64,
}

impl fmt::Display for LossOfStiffness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            body,
            spin,
            remaining,
            whole,
            ..
        } = self;
        match self.fidelity {
            Fidelity::Small(count) => write!(
                f,
                "body `{body}`: at a spin of {spin:.4} rad/s small({count}) leaves out centrifugal effects: in one of its motions the whole body has {whole:.2} times the stiffness at rest, {remaining:.2} times without tension: leave `small` out to use the whole body"
            ),
            _ => write!(
                f,
                "body `{body}`: at a spin of {spin:.4} rad/s its {} modes keep only {remaining:.2} of their stiffness at rest where the whole body has {whole:.2}, because they do not stretch: leave `modal` out to use the whole body, or ask for more modes, up to those along it",
                match self.fidelity {
                    Fidelity::Modal(count) => count,
                    _ => 0,
                }
            ),
        }
    }
}

/// The softest combination of modes.
struct Softest {
    /// Its stiffness over that at rest.
    remaining: f64,
    /// p with unit stiffness at rest.
    direction: Vec<f64>,
}

impl ModalBody {
    /// A loss of stiffness at modal coordinates p which the whole body would not have, if there is
    /// one: the symmetric part of the elastic and centrifugal stiffness is compared with that at rest,
    /// at p and in the equilibrium with the spin. (Euler terms are skew and do not soften.)
    pub fn loss_of_stiffness(
        &self,
        elements: &dyn Elements,
        frame: &FrameAction,
        p: &[f64],
    ) -> Option<LossOfStiffness> {
        let action = Action {
            spin_rate: Vector::zeros(),
            ..Action::new(frame, self.nodal.dimension)
        };
        let spin = action.spin.norm();
        if self.modes() == 0 || spin == 0.0 {
            return None;
        }
        let mut softest = self.softest(elements, &action, p)?;
        if softest.remaining >= LOWEST {
            return None;
        }
        let stretched = self.stretched(&action)?;
        let tightened = self.whole_stiffness(elements, &action, &stretched);
        let mut whole = along(&tightened, &softest.direction);
        let lost = |softest: &Softest, whole: f64| softest.remaining < LOWEST && whole > softest.remaining + MISSING;
        if !lost(&softest, whole) {
            return None;
        }
        // The state may only not have stretched yet.
        if self.moves()
            && let Some(settled) = self.settled(elements, &action, self.coordinates(&stretched))
        {
            softest = self.softest(elements, &action, &settled)?;
            whole = along(&tightened, &softest.direction);
        }
        lost(&softest, whole).then(|| self.loss(spin, [softest.remaining, whole]))
    }

    /// What tension adds to the stiffness of the whole body at a spin and the modes do not have in the equilibrium with it, where
    /// that is much: as of flap, which nothing softens.
    pub fn lack_of_tension(&self, elements: &dyn Elements, frame: &FrameAction) -> Option<LossOfStiffness> {
        let k = self.modes();
        let action = Action {
            spin_rate: Vector::zeros(),
            ..Action::new(frame, self.nodal.dimension)
        };
        let spin = action.spin.norm();
        if k == 0 || spin == 0.0 {
            return None;
        }
        let stretched = self.stretched(&action)?;
        let whole = self.whole_stiffness(elements, &action, &stretched);
        let own = if self.moves() {
            let settled = self.settled(elements, &action, self.coordinates(&stretched))?;
            self.stiffness_in_spin(elements, &action, &settled)
        } else {
            let mut rest = vec![0.0; k * k];
            self.elastic_tangent(elements, &vec![0.0; k], &vec![0.0; k], &mut rest, &mut vec![0.0; k * k]);
            rest
        };
        let lack: Vec<f64> = whole.iter().zip(&own).map(|(whole, own)| whole - own).collect();
        let (lacks, directions) = symmetric_eigen(k, &self.over_rest(lack)).ok()?;
        let direction = self.with_unit_stiffness(&directions[k - 1]);
        let whole = along(&whole, &direction);
        (lacks[k - 1] > MISSING * whole.max(1.0)).then(|| {
            let slack = self.stiffness_in_spin(elements, &action, &vec![0.0; k]);
            self.loss(spin, [along(&slack, &direction), whole])
        })
    }

    fn loss(&self, spin: f64, [remaining, whole]: [f64; 2]) -> LossOfStiffness {
        LossOfStiffness {
            body: self.nodal.name.clone(),
            fidelity: self.fidelity,
            spin,
            remaining,
            whole,
        }
    }

    /// A stiffness in modal coordinates of unit stiffness at rest.
    fn over_rest(&self, mut stiffness: Vec<f64>) -> Vec<f64> {
        let k = self.modes();
        for (place, entry) in stiffness.iter_mut().enumerate() {
            *entry /= self.frequencies[place / k] * self.frequencies[place % k];
        }
        stiffness
    }

    /// Modal coordinates of those.
    fn with_unit_stiffness(&self, scaled: &[f64]) -> Vec<f64> {
        scaled.iter().zip(&self.frequencies).map(|(y, w)| y / w).collect()
    }

    /// Elastic and centrifugal stiffness at p, k x k.
    fn stiffness_in_spin(&self, elements: &dyn Elements, action: &Action, p: &[f64]) -> Vec<f64> {
        let k = self.modes();
        let (mut stiffness, mut damping) = (vec![0.0; k * k], vec![0.0; k * k]);
        self.loaded.modal_tangent(action, &mut stiffness, &mut damping);
        self.elastic_tangent(elements, p, &vec![0.0; k], &mut stiffness, &mut damping);
        stiffness
    }

    /// The least that centrifugal effects leave of the stiffness of a body from elsewhere, over that at rest.
    pub(super) fn least_stiffness(&self, action: &Action) -> Option<f64> {
        let k = self.modes();
        if k == 0 {
            return None;
        }
        let (mut softening, mut gyroscopic) = (vec![0.0; k * k], vec![0.0; k * k]);
        self.loaded.modal_tangent(action, &mut softening, &mut gyroscopic);
        let mut scaled = self.over_rest(softening);
        (0..k).for_each(|own| scaled[own * k + own] += 1.0);
        let (values, _) = symmetric_eigen(k, &scaled).ok()?;
        values.first().copied()
    }

    fn softest(&self, elements: &dyn Elements, action: &Action, p: &[f64]) -> Option<Softest> {
        let k = self.modes();
        let scaled = self.over_rest(self.stiffness_in_spin(elements, action, p));
        let (values, vectors) = symmetric_eigen(k, &scaled).ok()?;
        Some(Softest {
            remaining: values[0],
            direction: self.with_unit_stiffness(&vectors[0]),
        })
    }

    /// Nodal vectors of the whole body, stretched by the spin to first order in its square.
    fn stretched(&self, action: &Action) -> Option<Vec<f64>> {
        let nodal = &self.nodal;
        let w = action.spin;
        let shape = nodal.vectors(&mut nodal.shape.iter().copied());
        let pull = |&q: &Vector| -> Vec<f64> { w.cross(&w.cross(&q)).as_slice()[..nodal.dimension].to_vec() };
        let pull: Vec<f64> = shape.iter().flat_map(pull).collect();
        let mut load = nodal.reduced(&nodal.momenta(&pull, 1));
        self.stiffness.as_ref()?.solve(&mut load);
        let stretch = nodal.expanded(&[load]);
        Some(nodal.shape.iter().zip(&stretch).map(|(q0, u)| q0 - u).collect())
    }

    /// Elastic and centrifugal stiffness of the whole body with nodal vectors q in the modes' motions, k x k.
    fn whole_stiffness(&self, elements: &dyn Elements, action: &Action, q: &[f64]) -> Vec<f64> {
        let k = self.modes();
        let (mut sum, mut coriolis) = (vec![0.0; k * k], vec![0.0; k * k]);
        self.loaded.modal_tangent(action, &mut sum, &mut coriolis);
        let mut force = vec![0.0; k];
        self.nodal.each_stiffness(elements, q, |components, matrix| {
            for (&row, entries) in components.iter().zip(matrix.chunks_exact(components.len())) {
                force.fill(0.0);
                for (&column, entry) in components.iter().zip(entries) {
                    force
                        .iter_mut()
                        .zip(self.mode_row(column))
                        .for_each(|(f, mode)| *f += entry * mode);
                }
                for (sums, mode) in sum.chunks_exact_mut(k).zip(self.mode_row(row)) {
                    sums.iter_mut().zip(&force).for_each(|(sum, f)| *sum += mode * f);
                }
            }
        });
        sum
    }

    /// Modal coordinates of the stable equilibrium with the spin, by Newton's method from p.
    fn settled(&self, elements: &dyn Elements, action: &Action, mut p: Vec<f64>) -> Option<Vec<f64>> {
        let k = self.modes();
        let zeros = vec![0.0; k];
        let spin = Action {
            acceleration: Vector::zeros(),
            ..*action
        };
        for _ in 0..STEPS {
            let mut force = zeros.clone();
            let motion = Motion {
                p: &p,
                v: &zeros,
                a: &zeros,
            };
            self.loaded.modal_force(&spin, motion, &mut force);
            self.elastic_force(elements, &p, &zeros, &mut force);
            // Only a stable equilibrium counts.
            let factor = Cholesky::new(k, &self.stiffness_in_spin(elements, action, &p)).ok()?;
            factor.solve(&mut force);
            let mut largest: f64 = 0.0;
            for i in 0..k {
                p[i] -= force[i];
                largest = largest.max((force[i] / self.sizes[i]).abs());
            }
            if largest < 1e-9 {
                return Some(p);
            }
        }
        None
    }
}

/// `p . K p`
fn along(stiffness: &[f64], direction: &[f64]) -> f64 {
    let image = times(direction.len(), stiffness, direction);
    image.iter().zip(direction).map(|(a, b)| a * b).sum()
}
