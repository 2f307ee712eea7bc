//! What moves freely keeps its momentum: a shift of all of it across the axis, at rest in axes that do not turn, goes round in those that turn with
//! the system, with `s = i w`. The eigenvalue is a double one with one vector (what is pushed drifts on), and the round-off of a double one
//! is the root of that of the matrices. It is known, and so the rest is looked for beside it.

use crate::linalg::{c64, norm};
use crate::model::{Scene, Uniform};
use crate::system::{State, Tangent};

/// Part of the terms of an equation that is round-off.
const ROUND_OFF: f64 = 1e-9;

/// Shifts of what moves together, along two directions across the axis.
pub(super) struct Carried {
    pub shifts: [Vec<f64>; 2],
}

impl Carried {
    /// The motion that goes round against the rotation, in unknowns.
    pub fn shape(&self) -> Vec<c64> {
        let [first, second] = &self.shifts;
        first.iter().zip(second).map(|(&re, &im)| c64::new(re, im)).collect()
    }
}

/// The shifts across the axis that nothing ties while the axes turn with `speed`, rad/s: the equations of motion hold for them, and nothing else
/// changes the momentum.
pub(super) fn carried(
    scene: &mut dyn Scene,
    at: &Uniform,
    state: &State,
    tangent: &Tangent,
    speed: f64,
) -> Vec<Carried> {
    let shifts = scene.shifts_across(at, state);
    if shifts.is_empty() {
        return Vec::new();
    }
    let mut jacobian = vec![0.0; scene.constraint_pattern().entries()];
    scene.constraint_jacobian(state, &mut jacobian);
    let equations = Equations {
        scene,
        tangent,
        jacobian,
        speed,
    };
    shifts
        .into_iter()
        .filter_map(|shifts| equations.kept_by(shifts))
        .collect()
}

struct Equations<'a> {
    scene: &'a dyn Scene,
    tangent: &'a Tangent,
    jacobian: Vec<f64>,
    speed: f64,
}

impl Equations<'_> {
    fn kept_by(&self, shifts: [Vec<f64>; 2]) -> Option<Carried> {
        let Tangent {
            mass,
            damping,
            stiffness,
        } = self.tangent;
        let speed = self.speed;
        let momenta = shifts.each_ref().map(|shift| self.product(mass, shift, false));
        let size = speed * speed * self.size(&momenta[0]).max(self.size(&momenta[1]));
        let is = |image: &[f64], factor: f64, momentum: &[f64], rate: f64| {
            let rest: Vec<f64> = image.iter().zip(momentum).map(|(a, b)| a - factor * b).collect();
            rate * self.size(&rest) <= ROUND_OFF * size
        };
        // K r = -w^2 M r, C r_1 = 2 w M r_2, C r_2 = -2 w M r_1, the axes turning from the first to the second; from the left C has the other sign.
        let is_carried = |own: usize, is_left: bool| {
            let [stiff, gyroscopic] = [stiffness, damping].map(|values| self.product(values, &shifts[own], is_left));
            let factor = if (own == 0) == is_left {
                -2.0 * speed
            } else {
                2.0 * speed
            };
            is(&stiff, -speed * speed, &momenta[own], 1.0) && is(&gyroscopic, factor, &momenta[1 - own], speed)
        };
        let is_kept = size > 0.0
            && [0, 1]
                .into_iter()
                .all(|own| is_carried(own, false) && is_carried(own, true) && self.is_untied(&shifts[own]));
        is_kept.then_some(Carried { shifts })
    }

    /// Size of a generalised force, by the work on the unknowns' own sizes.
    fn size(&self, force: &[f64]) -> f64 {
        let works = force.iter().zip(self.scene.sizes()).map(|(force, size)| force * size);
        norm(&works.collect::<Vec<_>>())
    }

    fn product(&self, values: &[f64], x: &[f64], is_transposed: bool) -> Vec<f64> {
        let mut image = vec![0.0; x.len()];
        for ((row, column), value) in self.scene.pattern().places().zip(values) {
            let (to, from) = if is_transposed { (column, row) } else { (row, column) };
            image[to] += value * x[from];
        }
        image
    }

    fn is_untied(&self, shift: &[f64]) -> bool {
        let pattern = self.scene.constraint_pattern();
        let (mut rates, mut terms) = (vec![0.0; pattern.columns()], vec![0.0; pattern.columns()]);
        for ((row, constraint), value) in pattern.places().zip(&self.jacobian) {
            rates[constraint] += value * shift[row];
            terms[constraint] += (value * shift[row]).abs();
        }
        rates
            .iter()
            .zip(&terms)
            .all(|(rate, term)| rate.abs() <= ROUND_OFF * term)
    }
}
