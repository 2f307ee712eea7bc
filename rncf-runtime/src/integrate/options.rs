//! Options of an integration.

use super::method::Method;

/// Step size control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StepSize {
    /// By the local error estimate.
    Adaptive,
    /// Fixed (s); shortened only to end at kinks and at the end time.
    Fixed(f64),
}

/// Options of an integration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Relative tolerance, relative to the size of the kind of every unknown.
    pub rtol: f64,
    /// Adaptive or fixed.
    pub step: StepSize,
    /// Ceiling of the step, s; infinite by default.
    pub max_step: f64,
    /// First step, s; `None` lets the method choose.
    pub first_step: Option<f64>,
    /// Positions and velocities both on the constraints (index 2 after Gear, Gupta and Leimkuhler,
    /// THEORY 7.4); otherwise positions alone (index 3).
    pub stabilised: bool,
    /// The global error, not the local one, shall be proportional to `rtol`: [`Options::local_tolerance`].
    pub proportional: bool,
    /// Evaluations of the residual after which all that is kept from step to step but could be found again (matrices,
    /// factorizations) is found again: so often a run can be taken up. `None`: by the number of unknowns, so that it costs
    /// little and happens every few seconds of work.
    pub renewed_after: Option<u64>,
}

/// Global error over size, of HHT and generalized-alpha, per power 2/3 of the tolerance of the local error: the
/// middle of 0.5 to 7.5 measured on a spun-up beam, a slider-crank, a motor and a heavy top (docs/step_control.md).
const ALPHA_CONSTANT: f64 = 3.0;

/// Evaluations of the residual between two renewals, times unknowns: some seconds; a small system counts as a larger one.
const WORK: u64 = 20_000_000;
const SMALL: u64 = 50;
/// Bounds of these evaluations: what a renewal costs does not show.
const FEWEST: u64 = 5_000;
const MOST: u64 = 200_000;

impl Options {
    /// [`Options::renewed_after`] of a system with so many unknowns.
    pub(super) fn renewal(&self, unknowns: usize) -> u64 {
        let by_size = WORK / (unknowns as u64 + SMALL);
        self.renewed_after.unwrap_or(by_size.clamp(FEWEST, MOST))
    }

    /// The relative tolerance of a step's local error.
    ///
    /// This is `rtol` itself unless `proportional`. A method of order 2 controls local errors of order 3: its global
    /// error follows the power 2/3 of their tolerance, `error = C rtol_local^(2/3)` relative to the sizes, so that
    /// `rtol_local = (rtol / C)^(3/2)` with C = 3 makes it about `rtol`. Radau's estimate is of order 4 and so are, with dense
    /// output or stiff motions, its global errors: they follow the tolerance as it is, with a constant near 1.
    pub fn local_tolerance(&self, method: Method) -> f64 {
        if self.proportional && method.adds_up() {
            (self.rtol / ALPHA_CONSTANT).powf(1.5)
        } else {
            self.rtol
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self {
            rtol: 1e-6,
            step: StepSize::Adaptive,
            max_step: f64::INFINITY,
            first_step: None,
            stabilised: false,
            proportional: false,
            renewed_after: None,
        }
    }
}
