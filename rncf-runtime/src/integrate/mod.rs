//! Time integration of a [`System`]: HHT, generalized-alpha and Radau IIA.

mod options;
mod scheme;
mod statistics;

pub use options::{Method, Options, StepSize};
pub use statistics::Statistics;

use crate::error::SolveError;
use crate::system::{State, System};

/// Why [`Integrator::step`] came back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// One step was accepted.
    Step,
    /// A step was accepted that ends at a kink of a motion or load.
    Kink,
    /// The end time is reached.
    End,
}

/// Advances a system from a consistent initial state to an end time.
pub struct Integrator<'s, S: System + ?Sized> {
    system: &'s mut S,
}

impl<'s, S: System + ?Sized> Integrator<'s, S> {
    /// Makes the initial accelerations and multipliers consistent and prepares the method.
    ///
    /// # Errors
    /// A setting out of range, positions that violate a constraint, or a singular matrix.
    pub fn new(
        system: &'s mut S,
        start: State,
        t_end: f64,
        method: Method,
        options: Options,
    ) -> Result<Self, SolveError> {
        let _ = (start, t_end, method, options);
        Ok(Self { system })
    }

    /// Advances by one accepted step.
    ///
    /// # Errors
    /// The reason, with the last good state untouched in [`Integrator::state`].
    pub fn step(&mut self) -> Result<Stop, SolveError> {
        let _ = &mut self.system;
        todo!()
    }

    /// State at the end of the last accepted step (true accelerations, not algorithmic ones).
    pub fn state(&self) -> &State {
        todo!()
    }

    /// Start of the last accepted step, s; equal to the time of [`Integrator::state`] before the first.
    pub fn previous_time(&self) -> f64 {
        todo!()
    }

    /// State at `t` within the last accepted step by the method's dense output.
    pub fn interpolate(&self, t: f64, out: &mut State) {
        let _ = (t, out);
        todo!()
    }

    /// Counts so far.
    pub fn statistics(&self) -> &Statistics {
        todo!()
    }

    /// The system that is integrated, for outputs between steps.
    pub fn system(&mut self) -> &mut S {
        self.system
    }
}
