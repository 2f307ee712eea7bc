//! What the stabilised index 2 (THEORY 7.4) adds to Newton's matrix: multipliers mu that move the
//! positions by `-h W C_x(x_n)^T mu`, and the velocity constraints as their rows.
//!
//! With nu = -h mu, P = W C_x(x_n)^T (in right increments T P), and rows scaled by b = beta h^2 and
//! s = beta h / gamma:
//!
//! ```text
//! [[ S,                      C_x^T, b K P         ]    d          -b R
//!  [ C_x,                    0,     C_x P         ]    b dlambda = -C
//!  [ C_x T^-1 + s (C_x v)_x, 0,     s (C_x v)_x P ]]   dnu         -s (C_x v + C_t)
//! ```
//!
//! The first two unknowns are eliminated with the matrix of index 3; what is left for nu is full, of
//! the number of constraints. W are the squared sizes of the unknowns, in place of 1, so that nothing
//! depends on units: mu vanishes with the step in either case.

use super::charts::Charts;
use super::statistics::Statistics;
use crate::linalg::{Dense, Pattern, Saddle, Singular};
use crate::system::{ConstraintLevel, State, System};

/// The rows and columns of mu, and their elimination.
pub(super) struct Stabiliser {
    pattern: Pattern,
    /// Squared sizes of the unknowns.
    weights: Vec<f64>,
    /// `C_x^T` at the start of the step.
    start: Vec<f64>,
    /// `s (C_x v)_x^T` where the matrix was made.
    rate: Vec<f64>,
    /// `d` and `b dlambda` for every unit of nu, column after column.
    responses: Vec<(Vec<f64>, Vec<f64>)>,
    schur: Dense<f64>,
    velocity: Vec<f64>,
    shift: Vec<f64>,
    work: Vec<f64>,
}

/// Factors of the rows: `b` and `s`.
#[derive(Clone, Copy)]
pub(super) struct Scales {
    pub(super) dynamics: f64,
    pub(super) velocity: f64,
}

impl Stabiliser {
    /// For the constraints of `system`.
    pub(super) fn new(system: &dyn System) -> Self {
        let pattern = system.constraint_pattern().clone();
        let (n, m) = (system.unknowns(), system.constraints());
        Self {
            weights: system.sizes().iter().map(|size| size * size).collect(),
            start: vec![0.0; pattern.entries()],
            rate: vec![0.0; pattern.entries()],
            responses: vec![(vec![0.0; n], vec![0.0; m]); m],
            schur: Dense::new(m),
            velocity: vec![0.0; m],
            shift: vec![0.0; n],
            work: vec![0.0; n],
            pattern,
        }
    }

    /// Takes the direction of mu from the start of a step.
    pub(super) fn begin(&mut self, system: &mut dyn System, start: &State) {
        system.constraint_jacobian(start, &mut self.start);
    }

    /// Eliminates with a new matrix of index 3 at `state`: `stiffness` is K on the system's pattern,
    /// `jacobian` is `C_x^T`.
    pub(super) fn refresh(
        &mut self,
        system: &mut dyn System,
        state: &State,
        scales: Scales,
        (saddle, charts): (&mut Saddle<f64>, &Charts),
        (stiffness, jacobian): (&[f64], &[f64]),
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        system.constraint_rate_tangent(state, &mut self.rate);
        self.rate.iter_mut().for_each(|value| *value *= scales.velocity);
        self.schur.clear();
        for j in 0..self.velocity.len() {
            self.direction(j);
            charts.to_increments(state, &mut self.shift);
            let (d, lambda) = &mut self.responses[j];
            d.fill(0.0);
            lambda.fill(0.0);
            system
                .pattern()
                .multiply_add(-scales.dynamics, stiffness, &self.shift, d);
            self.pattern.transpose_multiply_add(-1.0, jacobian, &self.shift, lambda);
            saddle.solve(d, lambda);
            statistics.solves += 1;
            self.velocity.fill(0.0);
            self.pattern
                .transpose_multiply_add(1.0, &self.rate, &self.shift, &mut self.velocity);
            self.pattern
                .transpose_multiply_add(1.0, &self.rate, d, &mut self.velocity);
            self.work.copy_from_slice(d);
            charts.to_chart(state, &mut self.work);
            self.pattern
                .transpose_multiply_add(1.0, jacobian, &self.work, &mut self.velocity);
            for (i, &value) in self.velocity.iter().enumerate() {
                self.schur.add(i, j, value, value.abs());
            }
        }
        self.schur.factor().map_err(Singular::Constraint)
    }

    /// Completes the solution of index 3 in `d` and `lambda`: on return they are those of the large
    /// matrix, and [`Stabiliser::shift`] is what mu adds to the positions.
    pub(super) fn solve(
        &mut self,
        system: &mut dyn System,
        state: &State,
        scales: Scales,
        (charts, jacobian): (&Charts, &[f64]),
        (d, lambda): (&mut [f64], &mut [f64]),
    ) {
        // -s (C_x v + C_t) - (C_x T^-1 + s (C_x v)_x) d
        system.constraint(ConstraintLevel::Velocity, state, &mut self.velocity);
        self.work.copy_from_slice(d);
        charts.to_chart(state, &mut self.work);
        for (work, v) in self.work.iter_mut().zip(&state.v) {
            *work += scales.velocity * v;
        }
        self.velocity.iter_mut().for_each(|value| *value *= scales.velocity);
        self.pattern
            .transpose_multiply_add(1.0, jacobian, &self.work, &mut self.velocity);
        self.pattern
            .transpose_multiply_add(1.0, &self.rate, d, &mut self.velocity);
        self.velocity.iter_mut().for_each(|value| *value = -*value);
        self.schur.solve(&mut self.velocity);
        for (&nu, (of_d, of_lambda)) in self.velocity.iter().zip(&self.responses) {
            d.iter_mut().zip(of_d).for_each(|(d, response)| *d += nu * response);
            lambda
                .iter_mut()
                .zip(of_lambda)
                .for_each(|(lambda, response)| *lambda += nu * response);
        }
        self.shift.fill(0.0);
        self.pattern
            .multiply_add(1.0, &self.start, &self.velocity, &mut self.shift);
        self.shift
            .iter_mut()
            .zip(&self.weights)
            .for_each(|(shift, w)| *shift *= w);
    }

    /// What mu added to the positions, in the charts of the step.
    pub(super) fn shift(&self) -> &[f64] {
        &self.shift
    }

    /// Column j of P into `shift`.
    fn direction(&mut self, j: usize) {
        self.shift.fill(0.0);
        for entry in self.pattern.starts()[j]..self.pattern.starts()[j + 1] {
            let row = self.pattern.indices()[entry];
            self.shift[row] = self.weights[row] * self.start[entry];
        }
    }
}
