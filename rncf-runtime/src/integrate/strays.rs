//! Velocities that stray from their constraints. Methods on constraints of index 3 hold positions alone: where a curve that something follows begins to
//! bend at the end of a step, the velocity there is not along it, and the error estimate, which sees the stages, does not know. The next step would have to
//! turn it by a blow. Such a step is taken again, shorter. Smooth curves need no look.

use super::recent::Recent;
use crate::system::{ConstraintLevel, State, System};

/// The step that is tried in place of one at whose end velocities stray, as a part of it.
pub(super) const RETRY: f64 = 0.25;

/// Memory of the look.
pub(super) struct Strays {
    recent: Recent,
    jacobian: Vec<f64>,
    rates: Vec<f64>,
}

impl Strays {
    pub(super) fn new(system: &dyn System) -> Self {
        Self {
            recent: Recent::default(),
            jacobian: vec![0.0; system.constraint_pattern().entries()],
            rates: vec![0.0; system.constraints()],
        }
    }

    /// Whether velocities at the end of a step (s) violate constraints by more than positions may, a tolerance of their sizes.
    pub(super) fn are_in(&mut self, system: &mut dyn System, state: &State, h: f64, rtol: f64) -> bool {
        system.constraint_jacobian(state, &mut self.jacobian);
        system.constraint(ConstraintLevel::Velocity, state, &mut self.rates);
        let (pattern, sizes) = (system.constraint_pattern(), system.sizes());
        let time = self.recent.lasting(h);
        let strays = self.rates.iter().enumerate().any(|(column, &rate)| {
            let (mut rate, mut scale) = (rate, 0.0);
            for place in pattern.starts()[column]..pattern.starts()[column + 1] {
                let row = pattern.indices()[place];
                rate += self.jacobian[place] * state.v[row];
                scale += (self.jacobian[place] * sizes[row]).abs();
            }
            time * rate.abs() > rtol * scale
        });
        if !strays {
            self.recent.meet(h);
        }
        strays
    }
}
