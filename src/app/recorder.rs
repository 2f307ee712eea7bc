//! What a run leaves on disk while it goes on, and what it would need to be repeated.

use super::arguments::Arguments;
use super::files;
use super::history::push_csv;
use super::journal::Journal;
use super::run::RunResult;
use super::summary;
use crate::Model;

/// Is told of the rows of a run as they come.
pub(super) trait Recorder {
    /// Whether the rows are kept on disk, so that memory holds what pictures need alone.
    fn is_on_disk(&self) -> bool;

    /// The integration is about to begin.
    ///
    /// # Errors
    /// A file that cannot be written.
    fn begin(&mut self, result: &RunResult) -> Result<(), String>;

    /// A row of the history: its time (s) and the outputs (SI).
    fn row(&mut self, t: f64, values: &[f64]);

    /// A step is done.
    ///
    /// # Errors
    /// As [`Recorder::begin`].
    fn keep_up(&mut self) -> Result<(), String>;

    /// There are no more rows.
    ///
    /// # Errors
    /// As [`Recorder::begin`].
    fn end(&mut self) -> Result<(), String>;
}

/// All rows stay in memory.
pub(super) struct InMemory;

impl Recorder for InMemory {
    fn is_on_disk(&self) -> bool {
        false
    }

    fn begin(&mut self, _: &RunResult) -> Result<(), String> {
        Ok(())
    }

    fn row(&mut self, _: f64, _: &[f64]) {}

    fn keep_up(&mut self) -> Result<(), String> {
        Ok(())
    }

    fn end(&mut self) -> Result<(), String> {
        Ok(())
    }
}

/// The name of the history.
pub(super) const HISTORY: &str = "history.csv";
/// The reason in the summary of a run that has not ended in good order.
const UNFINISHED: &str = "still running, or ended from outside: the history holds what was reached";

/// The history grows on disk; the summary says from the beginning what runs.
pub(super) struct OnDisk<'a, M> {
    arguments: &'a Arguments<M>,
    journal: Option<Journal>,
    line: String,
}

impl<'a, M: Model> OnDisk<'a, M> {
    /// In the folder of the arguments, which is there.
    pub fn new(arguments: &'a Arguments<M>) -> Self {
        Self {
            arguments,
            journal: None,
            line: String::new(),
        }
    }
}

impl<M: Model> Recorder for OnDisk<'_, M> {
    fn is_on_disk(&self) -> bool {
        true
    }

    fn begin(&mut self, result: &RunResult) -> Result<(), String> {
        let folder = &self.arguments.out;
        files::remove(folder, &["report.html", "animation.html", "paraview.pvd"])?;
        let mut known = summary::of_run(&self.arguments.model, result);
        summary::outcome(&mut known, Some(UNFINISHED.into()));
        summary::command_line(&mut known, &self.arguments.line);
        files::write(folder, "summary.json", &summary::to_text(&known))?;
        self.journal = Some(Journal::create(folder, HISTORY, &result.history.csv_head())?);
        Ok(())
    }

    fn row(&mut self, t: f64, values: &[f64]) {
        if let Some(journal) = &mut self.journal {
            self.line.clear();
            push_csv(&mut self.line, t, values);
            journal.line(&self.line);
        }
    }

    fn keep_up(&mut self) -> Result<(), String> {
        match &mut self.journal {
            Some(journal) => journal.keep_up(),
            None => Ok(()),
        }
    }

    fn end(&mut self) -> Result<(), String> {
        match &mut self.journal {
            Some(journal) => journal.flush(),
            None => Ok(()),
        }
    }
}
