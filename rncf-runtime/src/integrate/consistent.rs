//! Consistent initial positions and velocities: small violations of the constraints are projected
//! away, large ones are refused by name.
//!
//! The correction is the smallest one relative to the sizes of the unknowns (Gauss-Newton with
//! `[[1/size^2, C_x^T], [C_x, 0]]`); inertia has no say in where a body was meant to be.

use super::bordered::{Bordered, add};
use super::charts::Charts;
use super::statistics::Statistics;
use crate::linalg::Singular;
use crate::system::{ConstraintLevel, State, System};

/// Largest violation that is corrected, relative to the change of the constraint when every unknown
/// changes by its size.
const NEAR: f64 = 1e-2;
/// Violations up to here are round-off, in the same measure.
const EXACT: f64 = 1e-14;
/// Largest violation that may be left.
const CONSISTENT: f64 = 1e-7;
/// Most corrections; convergence is quadratic.
const ITERATIONS: usize = 10;

/// Why a state cannot be made consistent.
pub(super) enum Inconsistent {
    /// Violation of the worst constraint (or of its rate), in its unit, its index, and the level.
    Far(f64, usize, ConstraintLevel),
    /// The constraints contradict or depend on each other.
    Singular(Singular),
}

/// Projects positions, then velocities, onto the constraints, and notes the largest corrections.
///
/// Velocities are measured by the terms of the constraint and by the sizes over `span` (s).
pub(super) fn project(
    system: &mut dyn System,
    state: &mut State,
    span: f64,
    statistics: &mut Statistics,
) -> Result<(), Inconsistent> {
    if system.constraints() == 0 {
        return Ok(());
    }
    let mut projection = Projection::new(system, Bordered::by_sizes(system), span);
    statistics.position_correction = projection.run(system, state, ConstraintLevel::Position, NEAR)?;
    statistics.velocity_correction = projection.run(system, state, ConstraintLevel::Velocity, NEAR)?;
    Ok(())
}

/// Projects positions as [`project`] does, and changes velocities as little as constraints allow, in the norm of a matrix on the
/// pattern of the system, which is symmetric and positive definite beside the constraints.
pub(super) fn set_in_motion(system: &mut dyn System, state: &mut State, weights: Vec<f64>) -> Result<(), Inconsistent> {
    let mut positions = Projection::new(system, Bordered::by_sizes(system), f64::INFINITY);
    positions.run(system, state, ConstraintLevel::Position, NEAR)?;
    // Rates are small beside the fastest one that is asked for.
    let span = 1.0 / positions.violations.fastest(system, state);
    if span.is_finite() {
        let mut velocities = Projection::new(system, Bordered::weighted_by(system, weights), span);
        velocities.run(system, state, ConstraintLevel::Velocity, f64::INFINITY)?;
    }
    Ok(())
}

/// By how much a state violates a constraint that is too far off to be corrected, in its unit, and which; of positions.
pub(crate) fn far_off(system: &mut dyn System, state: &State) -> Option<(f64, usize)> {
    if system.constraints() == 0 {
        return None;
    }
    let mut violations = Violations::new(system, f64::INFINITY);
    let (violation, worst) = violations.largest(system, state, ConstraintLevel::Position);
    (violation > NEAR).then(|| (violations.value[worst].abs(), worst))
}

/// Whether velocities of a state violate constraints by more than is corrected, beside those in which all unknowns change by their sizes over a time, s.
pub(crate) fn moves_off(system: &mut dyn System, state: &State, span: f64) -> bool {
    system.constraints() > 0
        && Violations::new(system, span)
            .largest(system, state, ConstraintLevel::Velocity)
            .0
            > NEAR
}

/// Values of constraints, and what they are measured by.
struct Violations {
    jacobian: Vec<f64>,
    value: Vec<f64>,
    span: f64,
}

/// Values of constraints, and the matrix that takes them away.
struct Projection {
    violations: Violations,
    bordered: Bordered,
    charts: Charts,
    change: Vec<f64>,
}

impl Projection {
    fn new(system: &dyn System, bordered: Bordered, span: f64) -> Self {
        Self {
            violations: Violations::new(system, span),
            bordered,
            charts: Charts::new(system.turns(), system.pattern()),
            change: vec![0.0; system.unknowns()],
        }
    }

    /// Corrects violations of one level up to `near`; returns the largest change relative to the sizes of the unknowns (velocities:
    /// over the span).
    fn run(
        &mut self,
        system: &mut dyn System,
        state: &mut State,
        level: ConstraintLevel,
        near: f64,
    ) -> Result<f64, Inconsistent> {
        let (mut largest, mut before) = (0.0_f64, f64::INFINITY);
        for iteration in 0..=ITERATIONS {
            let (violation, worst) = self.violations.largest(system, state, level);
            let far = Inconsistent::Far(self.violations.value[worst].abs(), worst, level);
            if iteration == 0 && violation > near || !violation.is_finite() {
                return Err(far);
            }
            let stagnates = violation > 0.5 * before || iteration == ITERATIONS;
            if violation <= EXACT || stagnates && violation <= CONSISTENT {
                break;
            }
            if stagnates {
                return Err(far);
            }
            before = violation;
            // Solutions for a start are not counted.
            self.bordered.move_to(system, state);
            self.bordered
                .least_change(&self.violations.value, &mut self.change, &mut Statistics::default())
                .map_err(Inconsistent::Singular)?;
            let sizes = system.sizes();
            let unit = if level == ConstraintLevel::Position {
                self.charts.to_chart(state, &mut self.change);
                add(&mut state.x, &self.change);
                1.0
            } else {
                add(&mut state.v, &self.change);
                self.violations.span
            };
            let moved = self.change.iter().zip(sizes).map(|(change, size)| change.abs() / size);
            largest = moved.fold(largest, |largest, moved| largest.max(unit * moved));
        }
        Ok(largest)
    }
}

impl Violations {
    fn new(system: &dyn System, span: f64) -> Self {
        Self {
            jacobian: vec![0.0; system.constraint_pattern().entries()],
            value: vec![0.0; system.constraints()],
            span,
        }
    }

    /// The largest rate of a constraint, relative to its change when every unknown changes by its size, 1/s.
    fn fastest(&mut self, system: &mut dyn System, state: &State) -> f64 {
        self.largest(system, state, ConstraintLevel::Velocity);
        let rates = self.value.iter().enumerate().map(|(column, value)| {
            let scale = scale(system, &self.jacobian, column);
            if scale > 0.0 { value.abs() / scale } else { 0.0 }
        });
        rates.fold(0.0, f64::max)
    }

    /// The largest violation of a constraint, relative to its scale, and its index; values on the way.
    fn largest(&mut self, system: &mut dyn System, state: &State, level: ConstraintLevel) -> (f64, usize) {
        system.constraint_jacobian(state, &mut self.jacobian);
        system.constraint(level, state, &mut self.value);
        let pattern = system.constraint_pattern();
        let mut worst = (0.0, 0);
        for (column, value) in self.value.iter_mut().enumerate() {
            let mut scale = scale(system, &self.jacobian, column);
            if level == ConstraintLevel::Velocity {
                let mut rate = value.abs();
                for place in pattern.starts()[column]..pattern.starts()[column + 1] {
                    let term = self.jacobian[place] * state.v[pattern.indices()[place]];
                    rate += term.abs();
                    *value += term;
                }
                scale = rate + scale / self.span;
            }
            let violation = if *value == 0.0 { 0.0 } else { value.abs() / scale };
            if violation.is_nan() {
                return (violation, column);
            }
            if violation > worst.0 {
                worst = (violation, column);
            }
        }
        worst
    }
}

/// The change of a constraint when every unknown changes by its size.
fn scale(system: &dyn System, jacobian: &[f64], column: usize) -> f64 {
    let (pattern, sizes) = (system.constraint_pattern(), system.sizes());
    let places = pattern.starts()[column]..pattern.starts()[column + 1];
    places.fold(0.0, |sum, place| {
        sum + (jacobian[place] * sizes[pattern.indices()[place]]).abs()
    })
}
