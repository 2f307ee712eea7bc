//! Solutions with the mass matrix bordered by the constraints (THEORY 10): consistent
//! accelerations, velocities without numerical bias and the constrained jerk.
//!
//! Instead of the mass, squares of the sizes of the unknowns may weigh a change, or any other matrix: corrections of
//! positions that have nothing to do with inertia. Neither block needs to be regular by itself in
//! theory, and nothing here asks for an inverse of it.
//!
//! Mass and border move with the state. A factorization is kept while refinement with the true
//! matrix converges fast. Where a change is far below the tolerance of a step, as with few constraints
//! on a large system, its direction may be that of an earlier mass: neither mass nor solution is needed.

use super::anderson::Acceleration;
use super::norms::norm as weighted_norm;
use super::statistics::Statistics;
use crate::linalg::{Dense, Pattern, Saddle, Singular};
use crate::system::{ConstraintLevel, State, System};

/// Refinement stops when a correction is this small relative to the solution.
const REFINED: f64 = 1e-6;
/// Most corrections: more of them cost as much as a new factorization.
const CORRECTIONS: usize = 5;

/// Most constraints whose responses are kept, and fewest unknowns for each of them: beyond that a
/// solution costs no more than the responses.
const FEW: usize = 8;
const MANY: usize = 16;
/// Weighted size up to which a change may have the direction of an earlier mass.
const NEGLIGIBLE: f64 = 1e-3;

/// How large a change counts as small: `factor` times it, in the norm of the weights.
pub(super) struct Measure<'a> {
    pub(super) factor: f64,
    pub(super) inverse_weights: &'a [f64],
}

/// `[[M, C_x^T], [C_x, 0]]` at a time and position, and solutions with it.
pub(super) struct Bordered {
    weight: Weight,
    pattern: Pattern,
    constraint_pattern: Pattern,
    sizes: Vec<f64>,
    mass: Vec<f64>,
    /// States, and the places of their unit in the mass: what has no inertia has no acceleration that would matter.
    states: Vec<(usize, usize)>,
    /// Whether the mass is that of the present state, not only the border.
    mass_is_present: bool,
    jacobian: Vec<f64>,
    responses: Responses,
    saddle: Saddle<f64>,
    state_of_factors: Factors,
    /// Right side as given, and what is left of it.
    given: (Vec<f64>, Vec<f64>),
    rest: (Vec<f64>, Vec<f64>),
    work: Vec<f64>,
    acceleration: Acceleration,
}

/// What weighs a change of the unknowns.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Weight {
    /// The mass matrix.
    Mass,
    /// A matrix that stays as it is.
    Given,
}

/// Changes of the unknowns of least mass with unit rates of single constraints, by the kept factorization.
struct Responses {
    are_known: bool,
    /// n entries for every constraint; empty where there are too many.
    columns: Vec<f64>,
    /// Rates of the present constraints in them.
    rates: Dense<f64>,
    work: Vec<f64>,
}

/// What the kept factorization belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Factors {
    None,
    /// An earlier matrix.
    Old,
    /// The present matrix.
    Present,
}

impl Bordered {
    /// Analyses the patterns; [`Bordered::move_to`] must come next.
    pub(super) fn new(system: &dyn System) -> Self {
        Self::weighted(system, Weight::Mass, system.pattern().clone(), system.border())
    }

    /// The same with `1 / size^2` of the unknowns in place of the mass.
    pub(super) fn by_sizes(system: &dyn System) -> Self {
        let n = system.unknowns();
        let mut bordered = Self::weighted(system, Weight::Given, Pattern::new(n, n, (0..n).map(|i| (i, i))), 0);
        for (weight, size) in bordered.mass.iter_mut().zip(system.sizes()) {
            *weight = 1.0 / (size * size);
        }
        bordered
    }

    /// The same with a symmetric matrix on the pattern of the system.
    pub(super) fn weighted_by(system: &dyn System, weights: Vec<f64>) -> Self {
        Self {
            mass: weights,
            ..Self::weighted(system, Weight::Given, system.pattern().clone(), system.border())
        }
    }

    fn weighted(system: &dyn System, weight: Weight, pattern: Pattern, border: usize) -> Self {
        let constraint_pattern = system.constraint_pattern().clone();
        let (n, m) = (system.unknowns(), system.constraints());
        Self {
            saddle: Saddle::new(&pattern, border, &constraint_pattern).sized(system.sizes()),
            weight,
            sizes: system.sizes().to_vec(),
            jacobian: vec![0.0; constraint_pattern.entries()],
            mass: vec![0.0; pattern.entries()],
            states: pattern.diagonal(system.states().iter().copied()).collect(),
            mass_is_present: false,
            responses: Responses {
                are_known: false,
                columns: vec![0.0; if m <= FEW && MANY * m <= n { n * m } else { 0 }],
                rates: Dense::new(m),
                work: vec![0.0; m],
            },
            state_of_factors: Factors::None,
            given: (vec![0.0; n], vec![0.0; m]),
            rest: (vec![0.0; n], vec![0.0; m]),
            work: vec![0.0; m],
            acceleration: Acceleration::new(n + m, system.sizes().iter().map(|size| 1.0 / size).collect()),
            pattern,
            constraint_pattern,
        }
    }

    /// Moves the matrix to the state's time and position.
    pub(super) fn move_to(&mut self, system: &mut dyn System, state: &State) {
        self.approach(system, state);
        self.fetch_mass(system, state);
    }

    /// Moves the border to the state's time and position; the mass follows where it is needed.
    pub(super) fn approach(&mut self, system: &mut dyn System, state: &State) {
        self.mass_is_present = false;
        if self.constraint_pattern.columns() > 0 {
            system.constraint_jacobian(state, &mut self.jacobian);
        }
        if self.state_of_factors == Factors::Present {
            self.state_of_factors = Factors::Old;
        }
    }

    fn fetch_mass(&mut self, system: &mut dyn System, state: &State) {
        if self.weight == Weight::Mass && !self.mass_is_present {
            system.mass(state, &mut self.mass);
            self.states.iter().for_each(|&(_, place)| self.mass[place] = 1.0);
        }
        self.mass_is_present = true;
    }

    /// The smallest change `y` of the unknowns, in the norm of the weight, with `C_x y = -value`.
    pub(super) fn least_change(
        &mut self,
        value: &[f64],
        out: &mut [f64],
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        self.given.1.copy_from_slice(value);
        self.least(out, statistics)
    }

    /// [`Bordered::least_change`] with the value in the right side of the constraints.
    fn least(&mut self, out: &mut [f64], statistics: &mut Statistics) -> Result<(), Singular> {
        self.given.0.fill(0.0);
        self.against_constraints(out, statistics)
    }

    /// The answer to the right side of the unknowns that takes away what is in the right side of the constraints.
    fn against_constraints(&mut self, out: &mut [f64], statistics: &mut Statistics) -> Result<(), Singular> {
        negate(&mut self.given.1);
        let mut forces = std::mem::take(&mut self.work);
        let result = self.solve_given(out, &mut forces, statistics);
        self.work = forces;
        result
    }

    /// Rates of states, and accelerations and multipliers that satisfy the equations of motion and the second time
    /// derivative of the constraints at the state's time, position and velocity; the matrix must be there.
    pub(super) fn accelerations(
        &mut self,
        system: &mut dyn System,
        state: &mut State,
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        if self.state_of_factors == Factors::Old {
            self.state_of_factors = Factors::None; // to full accuracy, and rarely asked for
        }
        state.a.fill(0.0);
        system.residual(state, &mut self.given.0);
        statistics.residual_evaluations += 1;
        if !self.states.is_empty() {
            for &(unknown, _) in &self.states {
                state.v[unknown] -= self.given.0[unknown];
            }
            system.residual(state, &mut self.given.0);
            statistics.residual_evaluations += 1;
        }
        system.constraint(ConstraintLevel::Acceleration, state, &mut self.given.1);
        negate(&mut self.given.0);
        negate(&mut self.given.1);
        self.solve_given(&mut state.a, &mut state.lambda, statistics)
    }

    /// The constrained part `P (j - other)` of the jerk, from the third derivative of the constraints
    /// at the state (THEORY 10), less that of `other`; the border must be there. A change that is
    /// negligible by `measure` is right but for its direction.
    pub(super) fn constrained_jerk(
        &mut self,
        system: &mut dyn System,
        state: &State,
        other: &[f64],
        measure: &Measure,
        out: &mut [f64],
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        let level = ConstraintLevel::Jerk;
        self.replace_constrained(system, (level, Some(measure)), state, other, out, statistics)
    }

    /// The smallest change of `jerk`, in the norm of the mass, that satisfies the third derivative
    /// of the constraints: its constrained part becomes `P j`.
    pub(super) fn constrain_jerk(
        &mut self,
        system: &mut dyn System,
        state: &State,
        jerk: &mut [f64],
        change: &mut [f64],
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        self.replace_constrained(system, (ConstraintLevel::Jerk, None), state, jerk, change, statistics)?;
        add(jerk, change);
        Ok(())
    }

    /// The smallest change of the state's velocity, in the norm of the mass, with which it satisfies
    /// the first time derivative of the constraints; the border must be there. A change that is
    /// negligible by `measure` is right but for its direction.
    pub(super) fn velocity_change(
        &mut self,
        system: &mut dyn System,
        state: &State,
        measure: Option<&Measure>,
        change: &mut [f64],
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        let level = ConstraintLevel::Velocity;
        self.replace_constrained(system, (level, measure), state, &state.v, change, statistics)
    }

    /// What the velocity of a state leaves of the first time derivative of the constraints.
    pub(super) fn constraint_rates(&mut self, system: &mut dyn System, state: &State) -> Vec<f64> {
        self.approach(system, state);
        self.fetch_constrained(system, ConstraintLevel::Velocity, state, &state.v);
        self.given.1.clone()
    }

    /// The change of the state's velocity at an impact, in which a `jolt` (N s or N m s) meets the mass and the constraints: afterwards it leaves what is
    /// `left` of their first time derivative; the border must be there.
    pub(super) fn impact(
        &mut self,
        system: &mut dyn System,
        state: &State,
        (jolt, left): (&[f64], &[f64]),
        change: &mut [f64],
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        self.fetch_constrained(system, ConstraintLevel::Velocity, state, &state.v);
        for (rate, left) in self.given.1.iter_mut().zip(left) {
            *rate -= left;
        }
        self.fetch_mass(system, state);
        self.given.0.copy_from_slice(jolt);
        negate(&mut self.given.0);
        self.against_constraints(change, statistics)
    }

    /// Puts what a derivative of the unknowns leaves of the constraints at a level into their right side.
    fn fetch_constrained(
        &mut self,
        system: &mut dyn System,
        level: ConstraintLevel,
        state: &State,
        derivative: &[f64],
    ) {
        system.constraint(level, state, &mut self.given.1);
        self.constraint_pattern
            .transpose_multiply_add(1.0, &self.jacobian, derivative, &mut self.given.1);
    }

    /// Solves for `y` in `M y + C_x^T nu = 0`, `C_x (derivative + y) + value of the level = 0`.
    fn replace_constrained(
        &mut self,
        system: &mut dyn System,
        (level, measure): (ConstraintLevel, Option<&Measure>),
        state: &State,
        derivative: &[f64],
        out: &mut [f64],
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        if self.work.is_empty() {
            out.fill(0.0);
            return Ok(());
        }
        self.fetch_constrained(system, level, state, derivative);
        if let Some(measure) = measure
            && self.is_negligible(measure, out, statistics)
        {
            return Ok(());
        }
        self.fetch_mass(system, state);
        self.least(out, statistics)
    }

    /// The change that takes the value in the right side of the constraints away, in the direction of the
    /// kept factorization; false where it is too large for that, or nothing is kept.
    fn is_negligible(&mut self, measure: &Measure, out: &mut [f64], statistics: &mut Statistics) -> bool {
        let (n, m) = (out.len(), self.work.len());
        if self.responses.columns.is_empty() || self.state_of_factors == Factors::None {
            return false;
        }
        if !self.responses.are_known {
            self.responses.are_known = true;
            for (j, column) in self.responses.columns.chunks_exact_mut(n).enumerate() {
                column.fill(0.0);
                self.work.fill(0.0);
                self.work[j] = 1.0;
                self.saddle.solve(column, &mut self.work);
            }
            statistics.solves += m as u64;
        }
        let Responses {
            columns, rates, work, ..
        } = &mut self.responses;
        rates.clear();
        let pattern = &self.constraint_pattern;
        for (j, column) in columns.chunks_exact(n).enumerate() {
            for i in 0..m {
                let places = pattern.starts()[i]..pattern.starts()[i + 1];
                let terms = places.map(|place| self.jacobian[place] * column[pattern.indices()[place]]);
                let (sum, sizes) = terms.fold((0.0, 0.0), |(sum, sizes), term| (sum + term, sizes + term.abs()));
                rates.add(i, j, sum, sizes);
            }
        }
        if rates.factor().is_err() {
            return false;
        }
        work.copy_from_slice(&self.given.1);
        rates.solve(work);
        out.fill(0.0);
        for (column, &factor) in columns.chunks_exact(n).zip(&*work) {
            for (out, value) in out.iter_mut().zip(column) {
                *out -= factor * value;
            }
        }
        measure.factor * weighted_norm(out, measure.inverse_weights) <= NEGLIGIBLE
    }

    /// Solves with the right side `given`, by refinement with the kept factorization or anew.
    fn solve_given(
        &mut self,
        dynamics: &mut [f64],
        constraints: &mut [f64],
        statistics: &mut Statistics,
    ) -> Result<(), Singular> {
        if self.state_of_factors == Factors::Old && self.refine(dynamics, constraints, statistics) {
            return Ok(());
        }
        if self.state_of_factors != Factors::Present {
            self.state_of_factors = Factors::None;
            self.responses.are_known = false;
            statistics.factorizations += 1;
            self.saddle.factor_symmetric(&self.mass, &self.jacobian)?;
            self.state_of_factors = Factors::Present;
        }
        dynamics.copy_from_slice(&self.given.0);
        constraints.copy_from_slice(&self.given.1);
        statistics.solves += 1;
        self.saddle.solve(dynamics, constraints);
        Ok(())
    }

    /// Refines from zero with the factorization of an earlier matrix; false if that is slow.
    fn refine(&mut self, dynamics: &mut [f64], constraints: &mut [f64], statistics: &mut Statistics) -> bool {
        dynamics.fill(0.0);
        constraints.fill(0.0);
        self.rest.0.copy_from_slice(&self.given.0);
        self.rest.1.copy_from_slice(&self.given.1);
        let n = dynamics.len();
        self.acceleration.restart();
        for _ in 0..CORRECTIONS {
            statistics.solves += 1;
            self.saddle.solve(&mut self.rest.0, &mut self.rest.1);
            let mut change = [&self.rest.0[..], &self.rest.1].concat();
            self.acceleration.follow(&mut change, true);
            let correction = self.norm(&self.rest.0);
            add(dynamics, &change[..n]);
            add(constraints, &change[n..]);
            if correction <= REFINED * self.norm(dynamics) {
                return true;
            }
            if !correction.is_finite() {
                return false;
            }
            self.rest.0.copy_from_slice(&self.given.0);
            self.rest.1.copy_from_slice(&self.given.1);
            self.pattern.multiply_add(-1.0, &self.mass, dynamics, &mut self.rest.0);
            self.constraint_pattern
                .multiply_add(-1.0, &self.jacobian, constraints, &mut self.rest.0);
            self.constraint_pattern
                .transpose_multiply_add(-1.0, &self.jacobian, dynamics, &mut self.rest.1);
        }
        false
    }

    /// Euclidean norm relative to the sizes of the unknowns.
    fn norm(&self, y: &[f64]) -> f64 {
        y.iter()
            .zip(&self.sizes)
            .map(|(y, size)| (y / size).powi(2))
            .sum::<f64>()
            .sqrt()
    }
}

fn negate(y: &mut [f64]) {
    y.iter_mut().for_each(|y| *y = -*y);
}

/// `y += change`.
pub(super) fn add(y: &mut [f64], change: &[f64]) {
    y.iter_mut().zip(change).for_each(|(y, change)| *y += change);
}
