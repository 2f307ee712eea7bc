//! Why a run, or the continuation of equilibria, ended early.

use std::fmt;

use crate::SolveError;

/// Why a run stopped before its end.
#[derive(Clone, Debug, PartialEq)]
pub enum Incomplete {
    /// The watcher asked for it (Ctrl-C on the command line).
    Interrupted,
    /// A step failed.
    Solve(SolveError),
    /// An output became infinite or not a number; the text names it.
    Output(String),
    /// A file cannot be written, such as on a full disk; the text names it.
    Files(String),
    /// There is no equilibrium, or no modes, beyond a value of what is continued; the text names it.
    Equilibrium(String),
}

impl fmt::Display for Incomplete {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Incomplete::Interrupted => f.write_str("interrupted by the user"),
            Incomplete::Solve(error) => error.fmt(f),
            Incomplete::Output(text) | Incomplete::Files(text) | Incomplete::Equilibrium(text) => f.write_str(text),
        }
    }
}
