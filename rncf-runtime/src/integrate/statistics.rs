//! Counts of an integration; always filled.

use crate::archive::{Archive, Keep};

/// Counts of an integration.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps, all causes.
    pub rejected_steps: u64,
    /// Of these: the local error was too large.
    pub rejected_by_error: u64,
    /// Of these: Newton's iteration did not converge or the matrix was singular.
    pub rejected_by_newton: u64,
    /// Newton iterations (Radau: of all stages together).
    pub newton_iterations: u64,
    /// Evaluations of the residual.
    pub residual_evaluations: u64,
    /// Evaluations of the tangent.
    pub jacobian_evaluations: u64,
    /// Factorizations of a real or complex matrix.
    pub factorizations: u64,
    /// Solutions with a factorization.
    pub solves: u64,
    /// Restarts at kinks of motions, the first start not counted.
    pub restarts: u64,
    /// Accepted steps at the step ceiling `max_step` (within 1 %).
    pub steps_at_ceiling: u64,
    /// Accepted steps that were shortened so as to meet what motions, loads or forces do within a longer one.
    pub shortened_steps: u64,
    /// Smallest accepted step, s; 0 before the first.
    pub smallest_step: f64,
    /// Largest accepted step, s; 0 before the first.
    pub largest_step: f64,
    /// Largest constraint violation |C| at accepted steps, in the constraints' units.
    pub max_constraint_residual: f64,
    /// Largest change of an initial position that put it onto the constraints, relative to the size
    /// of the unknown; 0: none was needed.
    pub position_correction: f64,
    /// The same of an initial velocity, relative to the size over the time of the run.
    pub velocity_correction: f64,
    /// Prescribed velocities that jumped, one sentence each, the first time of each.
    pub jumps: Vec<String>,
}

/// Most jumps that are told.
const MOST_JUMPS: usize = 4;

impl Keep for Statistics {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self {
            steps,
            rejected_steps,
            rejected_by_error,
            rejected_by_newton,
            newton_iterations,
            residual_evaluations,
            jacobian_evaluations,
            factorizations,
            solves,
            restarts,
            steps_at_ceiling,
            shortened_steps,
            smallest_step,
            largest_step,
            max_constraint_residual,
            position_correction,
            velocity_correction,
            jumps,
        } = self;
        for count in [
            steps,
            rejected_steps,
            rejected_by_error,
            rejected_by_newton,
            newton_iterations,
            residual_evaluations,
            jacobian_evaluations,
            factorizations,
            solves,
            restarts,
            steps_at_ceiling,
            shortened_steps,
        ] {
            count.keep(archive);
        }
        for value in [
            smallest_step,
            largest_step,
            max_constraint_residual,
            position_correction,
            velocity_correction,
        ] {
            value.keep(archive);
        }
        jumps.keep(archive);
    }
}

impl Statistics {
    /// Notes that a prescribed velocity jumped at a time, s: the first time of each, by its words.
    pub(super) fn note_jump(&mut self, t: f64, text: &str) {
        let words = |text: &str| text.split(" jumps by ").next().unwrap_or_default().to_string();
        let is_new = self.jumps.iter().all(|jump| words(jump) != words(text));
        if is_new && self.jumps.len() < MOST_JUMPS {
            self.jumps
                .push(format!("{text} at t = {t:.6} s, and acts as an impact"));
        }
    }

    /// Notes that steps pass the kink of a law without an end there, from a time on, s: once for each law.
    pub(super) fn note_rattling(&mut self, t: f64, law: &str) {
        let what = format!("{law} rattles");
        if self.jumps.len() < MOST_JUMPS && !self.jumps.iter().any(|told| told.starts_with(&what)) {
            self.jumps.push(format!(
                "{what}: it passes a kink every few steps, from t = {t:.6} s on, so that these are left to the control of the error, and its \
                 impulses may be wrong by more than the tolerance; compare with a smaller one, or make the law softer"
            ));
        }
    }

    /// Notes that a fixed step jumps over what a motion or load does about a time, s: once for each.
    pub(super) fn note_unseen(&mut self, t: f64, of: &str) {
        let what = format!("{of} changes within a fixed step");
        if self.jumps.len() < MOST_JUMPS && !self.jumps.iter().any(|told| told.starts_with(&what)) {
            self.jumps.push(format!(
                "{what}, first at t = {t:.6} s, and comes back before the step ends, so that the run does not feel all of it; take shorter steps, or adaptive ones"
            ));
        }
    }

    /// Notes that nothing excludes that a motion or load comes and goes within a step at a time, s: once for each.
    pub(super) fn note_vague(&mut self, t: f64, of: &str) {
        let what = format!("{of} may come and go within steps");
        if self.jumps.len() < MOST_JUMPS && !self.jumps.iter().any(|told| told.starts_with(&what)) {
            self.jumps.push(format!(
                "{what}, first at t = {t:.6} s: its bounds over a step stay much wider than its values, so that nothing tells whether the run feels all of it; \
                 compare with a ceiling of the step, or write it with fewer terms that cancel each other"
            ));
        }
    }

    /// Accepted steps for each factorization: how often one is used again; `None` without any. Radau makes two at a time, a
    /// real and a complex one.
    pub fn steps_per_factorization(&self) -> Option<f64> {
        (self.factorizations > 0).then(|| self.steps as f64 / self.factorizations as f64)
    }
}
