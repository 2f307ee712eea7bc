//! Step size control from the local error (THEORY 7.1).

/// Safety factor of a proposal.
const SAFETY: f64 = 0.9;
/// Largest growth from one step to the next.
const GROWTH: f64 = 2.0;
/// Smallest ratio of one step to the last.
const SHRINK: f64 = 0.2;
/// A growth below this is not worth a new factorization: the step is kept.
const WORTHWHILE: f64 = 1.2;
/// A proposed reduction of an accepted step above this is left to the next error test.
const TOLERABLE: f64 = 0.95;
/// Errors below this count as this: an error that vanishes by chance says nothing.
const SMALLEST: f64 = 1e-4;

/// Proportional-integral controller for an error of third order in the step.
#[derive(Clone, Debug, Default)]
pub(super) struct Controller {
    before: Option<f64>,
    rejected: bool,
}

impl Controller {
    /// Forgets the history: a start or a restart.
    pub(super) fn restart(&mut self) {
        *self = Self::default();
    }

    /// Ratio of the next step to the one that was accepted with `error <= 1`.
    pub(super) fn accept(&mut self, error: f64) -> f64 {
        let error = error.max(SMALLEST);
        let ratio = match self.before {
            Some(before) => SAFETY * error.powf(-0.23) * before.powf(0.1),
            None => SAFETY * error.powf(-1.0 / 3.0),
        };
        let limit = if self.rejected { 1.0 } else { GROWTH };
        self.before = Some(error);
        self.rejected = false;
        let ratio = ratio.clamp(SHRINK, limit);
        if (TOLERABLE..WORTHWHILE).contains(&ratio) {
            1.0
        } else {
            ratio
        }
    }

    /// Ratio of the next attempt to the one that was rejected with `error > 1`.
    pub(super) fn reject(&mut self, error: f64) -> f64 {
        self.rejected = true;
        (SAFETY * error.powf(-1.0 / 3.0)).clamp(SHRINK, SAFETY)
    }

    /// A step was rejected without an error: do not grow right after the next.
    pub(super) fn failed(&mut self) {
        self.rejected = true;
    }
}
