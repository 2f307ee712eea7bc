//! Work-precision charts: error over work of formulations, meshes, methods and tolerances of one model.

use clap::{Arg, ArgMatches};

use super::arguments::Arguments;
use super::execute::{FAILURE, Failure};
use crate::Model;

/// What is compared and against what.
#[derive(Clone, Debug, Default)]
pub(super) struct ChartSettings {}

/// The flags of this command; `--outputs`, `--wanted`, `--fresh` and `--limit` are those of `advise`, too.
pub(super) fn flags() -> Vec<Arg> {
    Vec::new()
}

/// Reads the flags.
///
/// # Errors
/// The flag and what would be right.
pub(super) fn settings<M: Model>(_matches: &ArgMatches) -> Result<ChartSettings, String> {
    Ok(ChartSettings {})
}

/// Does it all and writes; the text for standard output.
pub(super) fn execute<M: Model>(_arguments: &Arguments<M>, _interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    Err(Failure::new(FAILURE, "not yet"))
}
