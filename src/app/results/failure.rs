//! Failures of a command with their exit codes.

use super::error::RunError;
use super::incomplete::Incomplete;

/// Exit codes: what was asked for failed, what was asked for makes no sense, Ctrl-C.
pub(in crate::app) const FAILURE: u8 = 1;
pub(in crate::app) const MISTAKE: u8 = 2;
pub(in crate::app) const INTERRUPTION: u8 = 130;

/// A failure with its exit code.
pub(in crate::app) struct Failure {
    pub code: u8,
    pub message: String,
}

impl Failure {
    pub fn new(code: u8, message: impl ToString) -> Self {
        Self {
            code,
            message: message.to_string(),
        }
    }
}

impl From<&RunError> for Failure {
    fn from(error: &RunError) -> Self {
        let reason = match error {
            RunError::Settings(_) | RunError::Model(_) => return Failure::new(MISTAKE, error),
            RunError::Start(_) | RunError::Files(_) | RunError::Equilibrium(_) => None,
            RunError::Incomplete(result) => result.incomplete.as_ref(),
            RunError::Equilibria(result) => result.incomplete.as_ref(),
            RunError::Campbell(result) => result.incomplete.as_ref(),
        };
        let is_interrupted = reason == Some(&Incomplete::Interrupted);
        Failure::new(if is_interrupted { INTERRUPTION } else { FAILURE }, error)
    }
}
