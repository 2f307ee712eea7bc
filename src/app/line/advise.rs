//! What `advise` is asked for; `--wanted`, `--outputs` and `--limit` are flags of `chart`, too.

use clap::ArgMatches;

use super::chart as shared;
use super::words::text;
use crate::AnyModel;

/// Accuracy where none is given.
pub(in crate::app) const WANTED: f64 = 1e-3;

/// What is wanted.
#[derive(Clone, Debug)]
pub(in crate::app) struct AdviseSettings {
    /// Largest error relative to the largest change of an output; of several none is meant.
    pub wanted: Vec<f64>,
    /// Columns that count; `None`: all that change.
    pub outputs: Option<Vec<usize>>,
    /// Processor time after which a run is ended, s.
    pub limit: f64,
}

/// Reads the flags.
///
/// # Errors
/// The flag and what would be right.
pub(in crate::app) fn settings(model: &dyn AnyModel, matches: &ArgMatches) -> Result<AdviseSettings, String> {
    let wanted = match text(matches, "wanted") {
        None => vec![WANTED],
        Some(_) => shared::wanted(matches)?,
    };
    Ok(AdviseSettings {
        wanted,
        outputs: shared::outputs(model, matches)?,
        limit: shared::limit(matches)?,
    })
}
