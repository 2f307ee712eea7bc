//! A table on disk that grows while a run goes on: whatever ends the program, the file holds all rows up to the last flush.

use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::archive::{Archive, Keep};
use crate::hash::hash_on;

/// Longest time that a row waits in memory for the next one.
const PATIENCE: Duration = Duration::from_millis(250);

/// The growing file.
#[derive(Debug)]
pub(in crate::app) struct Journal {
    file: File,
    path: PathBuf,
    /// Whole lines that are not in the file yet.
    lines: String,
    /// Length of the file's whole lines, bytes.
    length: u64,
    /// Hash of all lines.
    hash: u64,
    flushed: Instant,
}

/// Where a journal stood: by its length (bytes) and the hash of its lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::app) struct Mark {
    length: u64,
    hash: u64,
}

impl Keep for Mark {
    fn keep(&mut self, archive: &mut Archive<'_>) {
        let Self { length, hash } = self;
        length.keep(archive);
        hash.keep(archive);
    }
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
            lines: String::new(),
            length: 0,
            hash: 0,
            flushed: Instant::now(),
        };
        journal.line(head);
        journal.flush()?;
        Ok(journal)
    }

    /// Goes on with a file from a mark; what stands behind it is cut off.
    ///
    /// # Errors
    /// The path and the system's reason, or that the file is not the one that was marked.
    pub fn reopen(folder: &Path, name: &str, mark: Mark) -> Result<Self, String> {
        let path = folder.join(name);
        let opened = OpenOptions::new().read(true).write(true).open(&path);
        let file = opened.map_err(|error| format!("cannot go on with {}: {error}", path.display()))?;
        let checked = Self::is_marked(&file, mark).and_then(|is_marked| {
            if is_marked {
                file.set_len(mark.length)?;
                (&file).seek(SeekFrom::Start(mark.length))?;
            }
            Ok(is_marked)
        });
        match checked {
            Ok(true) => Ok(Self {
                file,
                path,
                lines: String::new(),
                length: mark.length,
                hash: mark.hash,
                flushed: Instant::now(),
            }),
            Ok(false) => Err(format!(
                "{} is not the table that the checkpoint belongs to: it was changed since",
                path.display()
            )),
            Err(error) => Err(format!("cannot go on with {}: {error}", path.display())),
        }
    }

    /// Whether a file begins with the lines of a mark.
    fn is_marked(file: &File, mark: Mark) -> std::io::Result<bool> {
        let (mut reader, mut line) = (BufReader::new(file), Vec::new());
        let mut read = Mark::default();
        while read.length < mark.length {
            line.clear();
            let length = reader.read_until(b'\n', &mut line)?;
            if line.pop() != Some(b'\n') {
                return Ok(false);
            }
            read.length += length as u64;
            read.hash = hash_on(read.hash, &line);
        }
        Ok(read == mark)
    }

    /// Where the table stands, all of it in the file.
    ///
    /// # Errors
    /// As [`Journal::flush`].
    pub fn mark(&mut self) -> Result<Mark, String> {
        self.flush()?;
        Ok(Mark {
            length: self.length,
            hash: self.hash,
        })
    }

    /// Adds a line.
    pub fn line(&mut self, line: &str) {
        self.hash = hash_on(self.hash, line.as_bytes());
        self.lines += line;
        self.lines.push('\n');
    }

    /// Writes what has waited long enough; to be called after every row.
    ///
    /// # Errors
    /// As [`Journal::flush`].
    pub fn keep_up(&mut self, now: Instant) -> Result<(), String> {
        if now.duration_since(self.flushed) < PATIENCE {
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
            let _ = self.file.seek(SeekFrom::Start(self.length));
            return Err(format!("cannot write {}: {error}", self.path.display()));
        }
        self.length += self.lines.len() as u64;
        self.lines.clear();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::app::testing::temporary_folder;

    #[test]
    fn lines_are_on_disk_after_a_flush_and_an_earlier_file_is_gone() {
        let folder = temporary_folder("journal");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("a.csv"), "much that is old\n".repeat(9)).unwrap();
        let mut journal = Journal::create(&folder, "a.csv", "t [s]").unwrap();
        let read = || fs::read_to_string(folder.join("a.csv")).unwrap();
        assert_eq!(read(), "t [s]\n");
        journal.line("0");
        let now = Instant::now();
        journal.keep_up(now).unwrap();
        assert_eq!(read(), "t [s]\n");
        journal.keep_up(now + PATIENCE).unwrap();
        assert_eq!(read(), "t [s]\n0\n");
        journal.line("1");
        journal.flush().unwrap();
        assert_eq!(read(), "t [s]\n0\n1\n");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_table_goes_on_behind_a_mark() {
        let folder = temporary_folder("journal-marked");
        fs::create_dir_all(&folder).unwrap();
        let mut journal = Journal::create(&folder, "a.csv", "t [s]").unwrap();
        journal.line("0,1");
        journal.line("1,2");
        let mark = journal.mark().unwrap();
        journal.line("2,3");
        journal.line("3");
        journal.flush().unwrap();
        drop(journal);
        let mut journal = Journal::reopen(&folder, "a.csv", mark).unwrap();
        assert_eq!(journal.mark().unwrap(), mark);
        journal.line("2,4");
        let second = journal.mark().unwrap();
        let text = fs::read_to_string(folder.join("a.csv")).unwrap();
        assert_eq!(text, "t [s]\n0,1\n1,2\n2,4\n");
        // Another table, a shorter one, one that ends within a line.
        for other in ["t [s]\n0,1\n1,3\n2,4\n", "t [s]\n0,1\n", "t [s]\n0,1\n1,2\n2,"] {
            fs::write(folder.join("a.csv"), other).unwrap();
            let error = Journal::reopen(&folder, "a.csv", second).unwrap_err();
            assert!(error.ends_with("it was changed since"), "{error}");
            assert_eq!(fs::read_to_string(folder.join("a.csv")).unwrap(), other);
        }
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
