//! A run on disk: the history grows, the summary says from the beginning what runs, and the checkpoint goes on from here.

use std::time::{Duration, Instant};

use serde_json::Value;

use super::checkpoint;
use crate::app::line::arguments::Arguments;
use crate::app::machine::files;
use crate::app::machine::journal::{Journal, Mark};
use crate::app::page::summary;
use crate::app::results::error::RunError;
use crate::app::results::history::{HISTORY, push_csv};
use crate::app::results::run::RunResult;
use crate::app::runs::recorder::{Earlier, Recorder, Written};
use crate::app::writing::entries::to_text;

/// The reason in the summary of a run that has not ended in good order.
const UNFINISHED: &str = "still running, or ended from outside: the history holds what was reached";

/// Shortest time between two checkpoints.
const PAUSE: Duration = Duration::from_secs(1);

/// The same in times that the last one took: what they cost does not show.
const SHARE: u32 = 50;

/// The history grows on disk; the summary says from the beginning what runs, and the checkpoint goes on from here.
pub(in crate::app) struct OnDisk<'a> {
    arguments: &'a Arguments,
    journal: Option<Journal>,
    line: String,
    identity: String,
    /// Where the history of a run that goes on stands.
    mark: Option<Mark>,
    /// When the next checkpoint is due; at once, before the first one.
    due: Option<Instant>,
}

impl<'a> OnDisk<'a> {
    /// In the folder of the arguments, which is there.
    pub fn new(arguments: &'a Arguments) -> Self {
        Self {
            arguments,
            journal: None,
            line: String::new(),
            identity: String::new(),
            mark: None,
            due: None,
        }
    }

    /// Writes a checkpoint of the history as it is on disk.
    fn write_checkpoint(&mut self, written: Written<'_>) -> Result<(), String> {
        let Some(journal) = &mut self.journal else {
            return Ok(());
        };
        let start = Instant::now();
        let mark = journal.mark()?;
        checkpoint::write(&self.arguments.out, &self.identity, mark, written)?;
        let end = Instant::now();
        self.due = Some(end + PAUSE.max(SHARE * (end - start)));
        Ok(())
    }
}

impl Recorder for OnDisk<'_> {
    fn takes_rows(&self) -> bool {
        true
    }

    fn taken_up(&mut self, result: &RunResult) -> Result<Option<Earlier>, RunError> {
        let size = Some([result.unknowns, result.constraints]);
        let identity = checkpoint::identity(self.arguments.model(), &result.settings, size);
        self.identity = Value::Object(identity.clone()).to_string();
        if !self.arguments.resume {
            return Ok(None);
        }
        let folder = &self.arguments.out;
        let found = checkpoint::read(folder).map_err(RunError::Files)?;
        if let Some(text) = checkpoint::refusal(folder, &found.identity, &identity) {
            return Err(RunError::Settings(text));
        }
        self.mark = Some(found.mark);
        Ok(Some(found.earlier))
    }

    fn begin(&mut self, result: &RunResult) -> Result<(), String> {
        let folder = &self.arguments.out;
        files::remove_partial(folder);
        let journal = match self.mark {
            Some(mark) => Some(Journal::reopen(folder, HISTORY, mark)?),
            None => {
                files::remove(folder, &[checkpoint::NAME])?;
                None
            }
        };
        files::remove(folder, &["report.html", "animation.html", "paraview.pvd"])?;
        let mut known = summary::of_run(self.arguments.model(), result);
        summary::outcome(&mut known, Some(UNFINISHED.into()));
        summary::command_line(&mut known, &self.arguments.line);
        files::write(folder, "summary.json", &to_text(&known))?;
        self.journal = Some(match journal {
            Some(journal) => journal,
            None => Journal::create(folder, HISTORY, &result.history.csv_head())?,
        });
        Ok(())
    }

    fn row(&mut self, t: f64, values: &[f64]) {
        if let Some(journal) = &mut self.journal {
            self.line.clear();
            push_csv(&mut self.line, t, values);
            journal.line(&self.line);
        }
    }

    fn keep_up(&mut self, written: Written<'_>) -> Result<(), String> {
        let now = Instant::now();
        if let Some(journal) = &mut self.journal {
            journal.keep_up(now)?;
        }
        if self.due.is_none_or(|due| now >= due) {
            self.write_checkpoint(written)?;
        }
        Ok(())
    }

    fn end(&mut self, is_complete: bool, written: Written<'_>) -> Result<(), String> {
        if !is_complete {
            return self.write_checkpoint(written);
        }
        match &mut self.journal {
            Some(journal) => journal.flush(),
            None => Ok(()),
        }
    }
}
