//! Multipliers between the ends of steps, from the equations of motion there.
//!
//! A step has errors of positions and velocities in view. Where these follow a polynomial, as of a crank that turns evenly, it is as long as several
//! turns, over which the forces of joints go to and fro: the polynomial through the multipliers of its stages says nothing of them.

use crate::linalg::{Pattern, Saddle};
use crate::system::{State, System};

/// The equations of motion at a state between two stages.
pub(super) struct Between {
    saddle: Saddle<f64>,
    constraint_pattern: Pattern,
    block: Vec<f64>,
    jacobian: Vec<f64>,
    forces: Vec<f64>,
    violations: Vec<f64>,
}

impl Between {
    pub(super) fn new(system: &dyn System) -> Self {
        let (pattern, constraint_pattern) = (system.pattern(), system.constraint_pattern());
        Self {
            saddle: Saddle::new(pattern, system.border(), constraint_pattern).sized(system.sizes()),
            block: vec![0.0; pattern.entries()],
            jacobian: vec![0.0; constraint_pattern.entries()],
            forces: vec![0.0; system.unknowns()],
            violations: vec![0.0; system.constraints()],
            constraint_pattern: constraint_pattern.clone(),
        }
    }

    /// Corrects the multipliers of a state by one step of Newton's iteration, as if it were a stage; `g` (1/s) is the slope of rates in positions there.
    /// What the places of stiff bodies lack of their balance is answered by changes of places, which are left out, and not by the multipliers; these keep
    /// what they are where the matrix is singular.
    pub(super) fn balance(&mut self, system: &mut dyn System, g: f64, state: &mut State) {
        system.residual(state, &mut self.forces);
        system.constraint_jacobian(state, &mut self.jacobian);
        self.constraint_pattern
            .multiply_add(1.0, &self.jacobian, &state.lambda, &mut self.forces);
        self.forces.iter_mut().for_each(|force| *force = -*force);
        self.violations.fill(0.0);
        system.iteration_matrix(state, [g * g, g, 1.0], &mut self.block);
        if self.saddle.factor(&self.block, &self.jacobian, &self.jacobian).is_err() {
            return;
        }
        self.saddle.solve(&mut self.forces, &mut self.violations);
        if self.violations.iter().all(|change| change.is_finite()) {
            state
                .lambda
                .iter_mut()
                .zip(&self.violations)
                .for_each(|(own, change)| *own += change);
        }
    }
}
