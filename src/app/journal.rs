//! A table on disk that grows while a run goes on: whatever ends the program, the file holds all rows up to the last flush.

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Longest time that a row waits in memory for the next step.
const PATIENCE: Duration = Duration::from_millis(250);

/// The growing file.
#[derive(Debug)]
pub(super) struct Journal {
    file: File,
    path: PathBuf,
    /// Whole lines that are not in the file yet.
    lines: String,
    /// Length of the file's whole lines, bytes.
    length: u64,
    flushed: Instant,
}

impl Journal {
    /// Begins the file with its head line in place of an earlier one.
    ///
    /// # Errors
    /// The path and the system's reason.
    pub fn create(folder: &Path, name: &str, head: &str) -> Result<Self, String> {
        let path = folder.join(name);
        let file = File::create(&path).map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        let mut journal = Self {
            file,
            path,
            lines: format!("{head}\n"),
            length: 0,
            flushed: Instant::now(),
        };
        journal.flush()?;
        Ok(journal)
    }

    /// Adds a line.
    pub fn line(&mut self, line: &str) {
        self.lines += line;
        self.lines.push('\n');
    }

    /// Writes what has waited long enough; to be called after every step.
    ///
    /// # Errors
    /// As [`Journal::flush`].
    pub fn keep_up(&mut self) -> Result<(), String> {
        if self.flushed.elapsed() < PATIENCE {
            return Ok(());
        }
        self.flush()
    }

    /// Writes all lines.
    ///
    /// # Errors
    /// The path and the system's reason, such as a full disk; the file then ends with the last whole line.
    pub fn flush(&mut self) -> Result<(), String> {
        self.flushed = Instant::now();
        if self.lines.is_empty() {
            return Ok(());
        }
        if let Err(error) = self.file.write_all(self.lines.as_bytes()) {
            // Half a line is worse than none. That it cannot be cut off either adds nothing.
            let _ = self.file.set_len(self.length);
            return Err(format!("cannot write {}: {error}", self.path.display()));
        }
        self.length += self.lines.len() as u64;
        self.lines.clear();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::temporary_folder;
    use std::fs;

    #[test]
    fn lines_are_on_disk_after_a_flush_and_an_earlier_file_is_gone() {
        let folder = temporary_folder("journal");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("a.csv"), "much that is old\n".repeat(9)).unwrap();
        let mut journal = Journal::create(&folder, "a.csv", "t [s]").unwrap();
        let read = || fs::read_to_string(folder.join("a.csv")).unwrap();
        assert_eq!(read(), "t [s]\n");
        journal.line("0");
        journal.keep_up().unwrap();
        assert_eq!(read(), "t [s]\n");
        std::thread::sleep(PATIENCE);
        journal.keep_up().unwrap();
        assert_eq!(read(), "t [s]\n0\n");
        journal.line("1");
        journal.flush().unwrap();
        assert_eq!(read(), "t [s]\n0\n1\n");
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_named() {
        // This device is always full.
        let error = Journal::create(Path::new("/dev"), "full", "t [s]").unwrap_err();
        assert!(error.starts_with("cannot write /dev/full: "), "{error}");
    }
}
