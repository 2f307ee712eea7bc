//! Time integration of a [`System`](crate::System): HHT, generalized-alpha, Radau IIA and energy-momentum integration.
//!
//! The driver (`driver::Driver`) owns the time axis: limits, kinks, the end, and the counts of
//! steps. A method (`scheme::Scheme`) tries one step at a time. [`Integrator`] is the driver with its system.

mod alpha;
mod anderson;
mod bordered;
mod charts;
mod coefficients;
mod compensated;
mod consistent;
mod control;
mod dense;
mod diagnose;
mod driver;
mod energy;
mod experience;
mod history;
mod lasting;
mod levers;
mod method;
mod moving;
mod newton;
mod noise;
mod norms;
mod options;
mod radau;
mod recent;
mod renewal;
mod scheme;
mod segments;
mod sight;
mod stabiliser;
mod start;
mod statistics;
mod strays;
mod switches;
mod watch;

#[cfg(test)]
mod tests;

pub(crate) use consistent::{far_off, moves_off};
pub use driver::Stop;
pub use method::{Method, Parameter};
pub use moving::set_in_motion;
pub use options::{Options, StepSize};
pub use statistics::Statistics;

use crate::error::SolveError;
use crate::system::{AsSystem, State};
use driver::Driver;

/// Advances a system from a consistent initial state to an end time.
pub struct Integrator<'s, S: AsSystem + ?Sized> {
    system: &'s mut S,
    driver: Driver,
}

impl<'s, S: AsSystem + ?Sized> Integrator<'s, S> {
    /// Makes the initial accelerations and multipliers consistent and prepares the method.
    ///
    /// Time, positions, orientations and velocities of `start` are used. A start at a kink counts as
    /// behind it. Positions and velocities that are slightly off the constraints are put onto them,
    /// see [`Statistics::position_correction`].
    ///
    /// # Errors
    /// A setting out of range, a method without dissipation on constraints of index 3, a state of the
    /// wrong length, positions or velocities that violate a constraint by more than that, constraints
    /// that depend on each other, a motion that has neither inertia nor a tie, or a singular matrix.
    pub fn new(
        system: &'s mut S,
        start: State,
        t_end: f64,
        method: Method,
        options: Options,
    ) -> Result<Self, SolveError> {
        let driver = Driver::new(system.as_system(), start, t_end, method, options)?;
        Ok(Self { system, driver })
    }

    /// Takes up an integration from [`Integrator::renewed`]: with the same system, method and options the steps that follow have
    /// the same bits.
    ///
    /// # Errors
    /// The bytes are those of another system or method.
    pub fn resume(system: &'s mut S, renewed: &[u8], method: Method, options: Options) -> Result<Self, SolveError> {
        let driver = Driver::resume(system.as_system(), renewed, method, options)?;
        Ok(Self { system, driver })
    }

    /// Advances by one accepted step.
    ///
    /// At the end time it returns [`Stop::End`] without a step.
    ///
    /// # Errors
    /// The reason, with the last good state untouched in [`Integrator::state`].
    pub fn step(&mut self) -> Result<Stop, SolveError> {
        self.driver.step(self.system.as_system())
    }

    /// State at the end of the last accepted step (true accelerations, not algorithmic ones).
    pub fn state(&self) -> &State {
        self.driver.scheme.state()
    }

    /// Start of the last accepted step, s; equal to the time of [`Integrator::state`] before the first.
    pub fn previous_time(&self) -> f64 {
        self.driver.previous_time
    }

    /// State at `t` within the last accepted step by the method's dense output; multipliers of Radau by the equations of motion there.
    pub fn interpolate(&mut self, t: f64, out: &mut State) {
        self.driver.scheme.interpolate(t, out);
        self.driver.scheme.balance(self.system.as_system(), out);
    }

    /// Counts so far.
    pub fn statistics(&self) -> &Statistics {
        &self.driver.statistics
    }

    /// What [`Integrator::resume`] needs to repeat all steps since the last renewal ([`Options::renewed_after`]) and to go on, to
    /// the last bit; `None` before the first one.
    pub fn renewed(&self) -> Option<&[u8]> {
        self.driver.renewal.known()
    }

    /// The system that is integrated, for outputs between steps.
    pub fn system(&mut self) -> &mut S {
        self.system
    }
}
