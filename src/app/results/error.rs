//! Why a run, or the continuation of equilibria, has no complete result.

use std::fmt;

use super::campbell::Campbell;
use super::equilibria::Equilibria;
use super::incomplete::Incomplete;
use super::run::RunResult;
use crate::{ModelError, SolveError};

/// Why a run has no complete result.
#[derive(Clone, Debug)]
pub enum RunError {
    /// A time is not a positive number, or asks for too many rows.
    Settings(String),
    /// The scene cannot be built from these parameters.
    Model(ModelError),
    /// The integration could not begin.
    Start(SolveError),
    /// A file cannot be written before the first step; the text names it.
    Files(String),
    /// The run stopped on its way; the result up to there.
    Incomplete(Box<RunResult>),
    /// There is no equilibrium, or no modes; the text says why and where.
    Equilibrium(String),
    /// The continuation of equilibria stopped on its way; the result up to there.
    Equilibria(Box<Equilibria>),
    /// The modes over a parameter or the spin stopped on their way; the result up to there.
    Campbell(Box<Campbell>),
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RunError::Settings(text) | RunError::Files(text) => f.write_str(text),
            RunError::Model(error) => error.fmt(f),
            RunError::Start(error) => error.fmt(f),
            RunError::Incomplete(result) => match &result.incomplete {
                // The solver's error names the time itself.
                Some(Incomplete::Solve(error)) => error.fmt(f),
                Some(reason) => write!(f, "stopped at t = {} s: {reason}", result.state.t),
                None => f.write_str("stopped before the end"),
            },
            RunError::Equilibrium(text) => f.write_str(text),
            RunError::Equilibria(result) => stopped(f, result.incomplete.as_ref()),
            RunError::Campbell(result) => stopped(f, result.incomplete.as_ref()),
        }
    }
}

fn stopped(f: &mut fmt::Formatter<'_>, reason: Option<&Incomplete>) -> fmt::Result {
    match reason {
        Some(reason) => write!(f, "{reason}"),
        None => f.write_str("stopped before the end"),
    }
}

impl std::error::Error for RunError {}
