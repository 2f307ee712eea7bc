//! Newton's iteration of a step of energy-momentum integration, to round-off: what is left of the residual, times the
//! step, is energy that is lost.
//!
//! With `dx = h^2 da / 2` the matrix is `[[M + h^2/4 dF/dq_m, C_x^T], [C_x, 0]]`, where `dF/dq_m` is by the mean of both
//! ends. It is not symmetric.

use super::super::charts::Charts;
use super::super::compensated::{self, Low};
use super::super::norms::{largest, norm, row};
use super::super::scheme::Cause;
use super::super::statistics::Statistics;
use crate::linalg::{Pattern, Saddle};
use crate::system::{Conserving, ConstraintLevel, State, System};

/// Contraction above which the matrix is made anew.
const POOR: f64 = 0.1;
/// Contraction above which increments do not fall any more.
const STAGNANT: f64 = 0.5;
/// Increments that stagnate below this part of the step, or of the sizes of the unknowns, are round-off.
const NOISE: [f64; 2] = [1e-10, 1e-13];
/// The factorization is kept while the step is within this ratio of the one it was made for.
const SAME_STEP: f64 = 1.2;

/// The end of a step; while it is iterated `a` is the acceleration of the step.
pub(super) struct Trial {
    pub(super) state: State,
    /// What rounding took from time, position and velocity.
    pub(super) low: Low,
}

/// Newton's iteration with a kept factorization.
pub(super) struct Newton {
    constraint_pattern: Pattern,
    charts: Charts,
    inverse_sizes: Vec<f64>,
    saddle: Saddle<f64>,
    block: Vec<f64>,
    jacobian: Vec<f64>,
    /// Of the forces of the multipliers.
    forces: Vec<f64>,
    dx: Vec<f64>,
    dlambda: Vec<f64>,
    /// Step for which the matrix was factored; `None`: make it before the next iteration.
    factored_for: Option<f64>,
}

/// The forces of a system; that it has them was checked at the start.
fn forces(system: &mut dyn System) -> Result<&mut dyn Conserving, Cause> {
    system.conserving().map_err(|_| Cause::Singular { worst: None })
}

impl Newton {
    /// An iteration for `system`.
    pub(super) fn new(system: &dyn System) -> Self {
        let (pattern, constraint_pattern) = (system.pattern(), system.constraint_pattern().clone());
        Self {
            charts: Charts::new(system.turns(), pattern),
            inverse_sizes: system.sizes().iter().map(|size| 1.0 / size).collect(),
            saddle: Saddle::new(pattern, system.border(), &constraint_pattern).sized(system.sizes()),
            block: vec![0.0; pattern.entries()],
            jacobian: vec![0.0; constraint_pattern.entries()],
            forces: vec![0.0; constraint_pattern.entries()],
            dx: vec![0.0; pattern.columns()],
            dlambda: vec![0.0; constraint_pattern.columns()],
            factored_for: None,
            constraint_pattern,
        }
    }

    /// Makes the next iteration start with a new matrix.
    pub(super) fn discard(&mut self) {
        self.factored_for = None;
    }

    /// Positions and velocities at the end of a step of size `h` with the acceleration that is in the trial.
    pub(super) fn place(&self, h: f64, start: &State, start_low: &Low, trial: &mut Trial) {
        let Trial { state, low } = trial;
        for i in 0..state.a.len() {
            let change = h * (start.v[i] + 0.5 * h * state.a[i]);
            (state.x[i], low.x[i]) = compensated::sum(start.x[i], start_low.x[i], change);
            (state.v[i], low.v[i]) = compensated::sum(start.v[i], start_low.v[i], h * state.a[i]);
        }
    }

    /// Iterates from the predictor in `trial`, at most so many times, until nothing but round-off is left of the residual.
    pub(super) fn solve(
        &mut self,
        system: &mut dyn System,
        h: f64,
        (start, low): (&State, &Low),
        trial: &mut Trial,
        iterations: u32,
        statistics: &mut Statistics,
    ) -> Result<(), Cause> {
        if !self.is_made_for(h) {
            self.refresh(system, h, start, &trial.state, statistics)?;
        }
        let mut before: Option<f64> = None;
        for _ in 0..iterations {
            self.increment(system, h, start, &trial.state, statistics)?;
            let size = norm(&self.dx, &self.inverse_sizes);
            if !size.is_finite() || !self.dlambda.iter().all(|d| d.is_finite()) {
                return Err(Cause::NotFinite);
            }
            self.charts.to_chart(&trial.state, &mut self.dx);
            let factor = 2.0 / (h * h);
            for (a, dx) in trial.state.a.iter_mut().zip(&self.dx) {
                *a += factor * dx;
            }
            for (lambda, d) in trial.state.lambda.iter_mut().zip(&self.dlambda) {
                *lambda += factor * d;
            }
            self.place(h, start, low, trial);
            if let worst @ Some(_) = self.charts.overturned(&trial.state) {
                return Err(Cause::Newton { worst });
            }
            let step = self.step(start, &trial.state);
            if size <= f64::EPSILON * (step + f64::EPSILON) {
                return Ok(());
            }
            if let Some(before) = before {
                let contraction = size / before;
                if contraction > STAGNANT && size <= NOISE[0] * step + NOISE[1] {
                    return Ok(());
                }
                if contraction > POOR {
                    self.refresh(system, h, start, &trial.state, statistics)?;
                }
            }
            before = Some(size);
        }
        Err(Cause::Newton { worst: self.worst() })
    }

    /// Size of the step.
    fn step(&self, start: &State, end: &State) -> f64 {
        let squares = start.x.iter().zip(&end.x).zip(&self.inverse_sizes);
        let sum: f64 = squares.map(|((from, to), scale)| ((to - from) * scale).powi(2)).sum();
        (sum / start.x.len().max(1) as f64).sqrt()
    }

    fn worst(&self) -> Option<usize> {
        largest(&self.dx, &self.inverse_sizes)
    }

    fn is_made_for(&self, h: f64) -> bool {
        self.factored_for
            .is_some_and(|made| h <= SAME_STEP * made && made <= SAME_STEP * h)
    }

    /// Evaluates and factors the matrix of a step of size `h` from `start` to `end`.
    fn refresh(
        &mut self,
        system: &mut dyn System,
        h: f64,
        start: &State,
        end: &State,
        statistics: &mut Statistics,
    ) -> Result<(), Cause> {
        forces(system)?.matrix(start, end, [1.0, 0.25 * h * h], &mut self.block);
        statistics.jacobian_evaluations += 1;
        if !self.dlambda.is_empty() {
            system.constraint_jacobian(end, &mut self.jacobian);
            forces(system)?.constraint_forces(start, end, &mut self.forces);
        }
        self.factored_for = None;
        statistics.factorizations += 1;
        self.saddle
            .factor(&self.block, &self.forces, &self.jacobian)
            .map_err(|singular| Cause::Singular {
                worst: row(singular, self.dx.len()),
            })?;
        self.factored_for = Some(h);
        Ok(())
    }

    /// Increments of positions and multipliers, the latter times `h^2 / 2`.
    fn increment(
        &mut self,
        system: &mut dyn System,
        h: f64,
        start: &State,
        end: &State,
        statistics: &mut Statistics,
    ) -> Result<(), Cause> {
        forces(system)?.residual(start, end, &mut self.dx);
        statistics.residual_evaluations += 1;
        statistics.newton_iterations += 1;
        if !end.lambda.is_empty() {
            forces(system)?.constraint_forces(start, end, &mut self.forces);
            self.constraint_pattern
                .multiply_add(1.0, &self.forces, &end.lambda, &mut self.dx);
            system.constraint(ConstraintLevel::Position, end, &mut self.dlambda);
            self.dlambda.iter_mut().for_each(|c| *c = -*c);
        }
        let scale = -0.5 * h * h;
        self.dx.iter_mut().for_each(|r| *r *= scale);
        self.saddle.solve(&mut self.dx, &mut self.dlambda);
        statistics.solves += 1;
        Ok(())
    }
}
