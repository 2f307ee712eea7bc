//! Step size control from the local error (THEORY 7.1).

/// Safety factor of a proposal.
const SAFETY: f64 = 0.9;
/// Ratio of the next attempt to one whose iteration failed (THEORY 7.1).
const RETRY: f64 = 0.25;
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

/// After an iteration failed, the next steps stay below this part of the step that failed.
const BELOW_FAILURE: f64 = 0.5;
/// Growth of that limit from step to step.
const RECOVERY: f64 = 1.05;

/// Proportional-integral controller for an error of third order in the step.
#[derive(Clone, Debug)]
pub(super) struct Controller {
    before: Option<f64>,
    rejected: bool,
    /// Largest step at which the iteration is trusted, s.
    trusted: f64,
}

impl Default for Controller {
    fn default() -> Self {
        Self {
            before: None,
            rejected: false,
            trusted: f64::INFINITY,
        }
    }
}

impl Controller {
    /// Forgets the history: a start or a restart.
    pub(super) fn restart(&mut self) {
        *self = Self::default();
    }

    /// The next step (s) after one of `h` that was accepted with `error <= 1`.
    pub(super) fn accept(&mut self, h: f64, error: f64) -> f64 {
        let error = error.max(SMALLEST);
        let ratio = match self.before {
            Some(before) => SAFETY * error.powf(-0.23) * before.powf(0.1),
            None => SAFETY * error.powf(-1.0 / 3.0),
        };
        let limit = if self.rejected { 1.0 } else { GROWTH };
        self.before = Some(error);
        self.rejected = false;
        self.trusted *= RECOVERY;
        let ratio = ratio.clamp(SHRINK, limit).min((self.trusted / h).max(1.0));
        if (TOLERABLE..WORTHWHILE).contains(&ratio) {
            h
        } else {
            h * ratio
        }
    }

    /// The next attempt (s) after one of `h` was rejected with `error > 1`.
    pub(super) fn reject(&mut self, h: f64, error: f64) -> f64 {
        self.rejected = true;
        h * (SAFETY * error.powf(-1.0 / 3.0)).clamp(SHRINK, SAFETY)
    }

    /// The next attempt (s) after the iteration failed with `h` (THEORY 7.1).
    pub(super) fn failed(&mut self, h: f64) -> f64 {
        self.rejected = true;
        self.trusted = BELOW_FAILURE * h;
        RETRY * h
    }
}
