//! Step size control from the local error (THEORY 7.1), without chatter.
//!
//! Each accepted step tells which step would just have met the tolerance. Errors of an oscillating motion
//! oscillate, too: a step that follows each of them is changed, and factored for, again and again, and meets
//! the next peak too long. What is proposed is therefore a filtered value: it falls at once and rises slowly, so
//! that it rests at what the peaks allow. The step itself changes only where the proposal leaves a band around it:
//! within the band the factorization is kept. (Digital filters in step size control: Soderlind 2003.)

use crate::archive::{Archive, Keep};

/// Safety factor of a proposal.
const SAFETY: f64 = 0.82;
/// A growth below this is not worth a new factorization: the step is kept.
const WORTHWHILE: f64 = 1.2;
/// A proposed reduction of an accepted step above this is left to the next error test.
const TOLERABLE: f64 = 0.93;
/// Smallest ratio of one step to the last.
const SHRINK: f64 = 0.2;
/// Errors below this count as this: an error that vanishes by chance says nothing.
const SMALLEST: f64 = 1e-4;
/// After an iteration failed, the next steps stay below this part of the step that failed.
const BELOW_FAILURE: f64 = 0.6;
/// Growth of that limit from step to step.
const RECOVERY: f64 = 1.05;

/// Ratio of the next attempt of a method of second order to one whose iteration failed (THEORY 7.1).
pub(super) const RETRY: f64 = 0.25;

/// Controller of a method whose local error is of a given order in the step.
#[derive(Clone, Debug)]
pub(super) struct Controller {
    /// Order of the local error.
    order: f64,
    /// Largest growth from one step to the next.
    growth: f64,
    /// Part of the way, in logarithms, that a proposal rises towards what a step allowed.
    release: f64,
    /// Filtered proposal, s; none after a start.
    proposal: Option<f64>,
    rejected: bool,
    /// Largest step at which the iteration is trusted, s.
    trusted: f64,
}

impl Keep for Controller {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            order: _,
            growth: _,
            release: _,
            proposal,
            rejected,
            trusted,
        } = self;
        proposal.keep(archive);
        rejected.keep(archive);
        trusted.keep(archive);
    }
}

impl Controller {
    /// A controller for local errors of `order` in the step, which may grow by `growth` at once; proposals
    /// rise by the part `release` of the way.
    pub(super) fn new(order: f64, growth: f64, release: f64) -> Self {
        Self {
            order,
            growth,
            release,
            proposal: None,
            rejected: false,
            trusted: f64::INFINITY,
        }
    }

    /// The controller of methods of second order, whose local errors of positions are of the third: a step grows by two at
    /// most, and proposals rise slowly, since errors of stiff motions oscillate over many steps.
    pub(super) fn of_second_order() -> Self {
        Self::new(3.0, 2.0, 0.1)
    }

    /// Forgets the history: a start or a restart.
    pub(super) fn restart(&mut self) {
        *self = Self::new(self.order, self.growth, self.release);
    }

    /// The step that would have met the tolerance, less a margin, s.
    fn ideal(&self, h: f64, error: f64) -> f64 {
        SAFETY * h * error.max(SMALLEST).powf(-1.0 / self.order)
    }

    /// The next step (s) after one of `h` that was accepted with `error <= 1`.
    pub(super) fn accept(&mut self, h: f64, error: f64) -> f64 {
        let ideal = self.ideal(h, error);
        let proposal = match self.proposal {
            Some(before) if ideal > before => before * (ideal / before).powf(self.release),
            _ => ideal,
        };
        self.trusted *= RECOVERY;
        // What the step could not follow is no history of the error.
        let limit = if self.rejected { 1.0 } else { self.growth };
        let proposal = proposal.min(self.trusted.max(h)).clamp(SHRINK * h, limit * h);
        self.proposal = Some(proposal);
        self.rejected = false;
        let ratio = proposal / h;
        if (TOLERABLE..WORTHWHILE).contains(&ratio) {
            h
        } else {
            proposal
        }
    }

    /// The next attempt (s) after one of `h` was rejected with `error > 1`.
    pub(super) fn reject(&mut self, h: f64, error: f64) -> f64 {
        self.rejected = true;
        let next = self.ideal(h, error).clamp(SHRINK * h, SAFETY * h);
        self.proposal = Some(next);
        next
    }

    /// The next attempt (s) after the iteration failed with `h` and a step of `ratio h` should converge.
    pub(super) fn failed(&mut self, h: f64, ratio: f64) -> f64 {
        self.rejected = true;
        self.trusted = BELOW_FAILURE * h;
        ratio * h
    }

    /// Whether the next step is the first one after a start or a rejection.
    pub(super) fn is_new(&self) -> bool {
        self.rejected || self.proposal.is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps of a method of third order under a local error of `of(t) h^3`, rejected ones counted.
    fn steps(of: impl Fn(f64) -> f64) -> (Vec<f64>, usize) {
        let mut controller = Controller::of_second_order();
        let (mut t, mut h, mut taken, mut rejected) = (0.0, 1e-4, Vec::new(), 0);
        while t < 100.0 {
            let error = of(t + 0.5 * h) * h * h * h;
            if error > 1.0 {
                rejected += 1;
                h = controller.reject(h, error);
            } else {
                t += h;
                taken.push(h);
                h = controller.accept(h, error);
            }
        }
        (taken, rejected)
    }

    fn changes(steps: &[f64]) -> usize {
        steps.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    #[test]
    fn a_constant_error_means_a_constant_step() {
        let (steps, rejected) = steps(|_| 1e3);
        // From 1e-4 to nearly 0.1, by doubling and then more and more slowly.
        assert_eq!(rejected, 0);
        assert!(changes(&steps) <= 30, "{}", changes(&steps));
        let error = 1e3 * steps.last().unwrap().powi(3);
        assert!(error > 0.3 && error < 0.75, "{error}");
    }

    #[test]
    fn the_step_rests_at_what_the_peaks_of_an_oscillating_error_allow() {
        let (steps, rejected) = steps(|t| 1e4 * (5.0 * t).sin().powi(2) + 1.0);
        assert!(rejected * 20 < steps.len(), "{rejected} of {}", steps.len());
        assert!(
            changes(&steps) * 3 < steps.len(),
            "{} of {}",
            changes(&steps),
            steps.len()
        );
    }

    #[test]
    fn fast_ripples_are_not_followed() {
        let (steps, rejected) = steps(|t| 1e4 * (20.0 * t).sin().powi(2) + 1.0);
        assert!(
            rejected * 100 < steps.len() && changes(&steps) * 20 < steps.len(),
            "{rejected}"
        );
    }

    #[test]
    fn a_failed_iteration_keeps_the_step_short_for_a_while() {
        let mut controller = Controller::of_second_order();
        let mut h = controller.failed(1.0, 0.25);
        assert_eq!(h, 0.25);
        for _ in 0..5 {
            h = controller.accept(h, 1e-3);
            assert!(h < 0.8, "{h}");
        }
    }
}
