//! What a run leaves on disk while it goes on, and what it would need to be repeated.

use crate::app::results::error::RunError;
use crate::app::results::run::RunResult;
use crate::archive::{Archive, Keep};

/// A run that has been written down.
#[derive(Debug, Default)]
pub(in crate::app) struct Earlier {
    /// What the integrator knew at its last renewal; empty: it begins anew.
    pub renewed: Vec<u8>,
    /// The course.
    pub course: Vec<u8>,
}

impl Keep for Earlier {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { renewed, course } = self;
        archive.bytes(renewed);
        archive.bytes(course);
    }
}

/// Appends to bytes what takes the run up where it is.
pub(in crate::app) type Written<'w> = &'w mut dyn FnMut(&mut Vec<u8>);

/// Is told of the rows of a run as they come.
pub(in crate::app) trait Recorder {
    /// Whether it takes care of the rows, so that memory holds what pictures need alone.
    fn takes_rows(&self) -> bool {
        false
    }

    /// The run that goes on, if one does; of the result what is known before the start is there.
    ///
    /// # Errors
    /// It is not this run, or it cannot be read.
    fn taken_up(&mut self, _result: &RunResult) -> Result<Option<Earlier>, RunError> {
        Ok(None)
    }

    /// The integration is about to begin, or to go on.
    ///
    /// # Errors
    /// A file that cannot be written.
    fn begin(&mut self, _result: &RunResult) -> Result<(), String> {
        Ok(())
    }

    /// A row of the history: its time (s) and the outputs (SI).
    fn row(&mut self, _t: f64, _values: &[f64]) {}

    /// A row or a step is done.
    ///
    /// # Errors
    /// As [`Recorder::begin`].
    fn keep_up(&mut self, _written: Written<'_>) -> Result<(), String> {
        Ok(())
    }

    /// There are no more rows.
    ///
    /// # Errors
    /// As [`Recorder::begin`].
    fn end(&mut self, _is_complete: bool, _written: Written<'_>) -> Result<(), String> {
        Ok(())
    }
}

/// All rows stay in memory.
pub(in crate::app) struct InMemory;

impl Recorder for InMemory {}
