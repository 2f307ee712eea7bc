//! The cheapest description of the bodies that suffices: a ladder from rigid to all nodal vectors, on finer and finer meshes.

use clap::{Arg, ArgMatches};

use super::arguments::Arguments;
use super::execute::{FAILURE, Failure};
use crate::Model;

/// What is wanted.
#[derive(Clone, Debug, Default)]
pub(super) struct AdviseSettings {}

/// The flags of this command alone.
pub(super) fn flags() -> Vec<Arg> {
    Vec::new()
}

/// Reads the flags.
///
/// # Errors
/// The flag and what would be right.
pub(super) fn settings<M: Model>(_matches: &ArgMatches) -> Result<AdviseSettings, String> {
    Ok(AdviseSettings {})
}

/// Does it all and writes; the text for standard output.
pub(super) fn execute<M: Model>(_arguments: &Arguments<M>, _interrupted: impl Fn() -> bool) -> Result<String, Failure> {
    Err(Failure::new(FAILURE, "not yet"))
}
