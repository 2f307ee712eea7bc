//! What the driver ([`super::Integrator`]) asks of a method: one attempt at a step at a time.
//! The driver owns limits, kinks and the counts of accepted and rejected steps; a scheme owns its
//! matrices, its error estimate and its proposal for the next step.

use super::statistics::Statistics;
use crate::archive::Keep;
use crate::error::SolveErrorKind;
use crate::system::{State, System};

/// What became of an attempt.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Outcome {
    /// Accepted; the scheme would take `next` (s) for the next step.
    Accepted { next: f64 },
    /// Rejected; try again with `next` (s).
    Rejected { next: f64, cause: Cause },
}

/// Why an attempt was rejected.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cause {
    /// The local error was too large.
    Error,
    /// Newton's iteration did not converge; index of the worst row: unknowns first, then constraints.
    Newton { worst: Option<usize> },
    /// The matrix was singular; index as above where known.
    Singular { worst: Option<usize> },
    /// A value was not finite.
    NotFinite,
}

/// An integration method. It keeps what it knows between two steps; what it could find again (matrices, factorizations) it does not.
pub(super) trait Scheme: Keep {
    /// Begins at a consistent state (accelerations and multipliers solved for), at the start or
    /// after a kink; `h` (s) is the step that will be tried first.
    fn begin(
        &mut self,
        system: &mut dyn System,
        state: &State,
        h: f64,
        statistics: &mut Statistics,
    ) -> Result<(), SolveErrorKind>;

    /// Tries one step of size `h` (s) from the last accepted state. With a fixed step there is no
    /// error test, but a step that has not converged is rejected all the same.
    fn attempt(&mut self, system: &mut dyn System, h: f64, statistics: &mut Statistics) -> Outcome;

    /// Goes on from what was read into the method, which is otherwise new.
    fn take_up(&mut self, system: &mut dyn System);

    /// The state at the end of the last accepted step, with true accelerations.
    fn state(&self) -> &State;

    /// What the time of [`Scheme::state`] lacks of the sum of all steps by rounding, s.
    fn time_rest(&self) -> f64;

    /// The state at `t` within the last accepted step.
    fn interpolate(&self, t: f64, out: &mut State);

    /// Parts of a step at which forces are evaluated inside of it, ascending.
    fn inside(&self) -> &[f64] {
        &[]
    }

    /// The state at which the matrix of the iteration was last evaluated, where that is known.
    fn linearized(&self) -> Option<&State> {
        None
    }

    /// Balances the forces of a state from [`Scheme::interpolate`] by its multipliers, where steps do not follow these.
    fn balance(&mut self, _system: &mut dyn System, _state: &mut State) {}

    /// The unknown with the largest part in the error of the last attempt, if known.
    fn worst_error(&self) -> Option<usize> {
        None
    }
}
