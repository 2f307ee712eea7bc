//! Files that are complete or absent, never half-written, and the folder that they are written to.

use std::fs::{self, File, TryLockError};
use std::io::ErrorKind;
use std::path::Path;

/// Writes `text` to `folder/name`: first to a temporary name, then renamed.
///
/// # Errors
/// The path and the system's reason.
pub(in crate::app) fn write(folder: &Path, name: &str, text: &str) -> Result<(), String> {
    write_bytes(folder, name, text.as_bytes())
}

/// The same of bytes.
///
/// # Errors
/// As [`write`].
pub(in crate::app) fn write_bytes(folder: &Path, name: &str, bytes: &[u8]) -> Result<(), String> {
    let path = folder.join(name);
    let partial = folder.join(format!(".{name}.{}.partial", std::process::id()));
    let written = fs::write(&partial, bytes).and_then(|()| fs::rename(&partial, &path));
    written.map_err(|error| {
        // The partial file is of no use; that it cannot be removed either adds nothing.
        let _ = fs::remove_file(&partial);
        format!("cannot write {}: {error}", path.display())
    })
}

/// Takes away files of an earlier result, which would contradict a new one.
///
/// # Errors
/// The path and the system's reason; a file that is not there is none.
pub(in crate::app) fn remove(folder: &Path, names: &[&str]) -> Result<(), String> {
    for name in names {
        let path = folder.join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                return Err(format!("cannot remove {}: {error}", path.display()));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Takes away what a writer left that was killed in the middle of a file; to be called by the folder's one writer.
pub(in crate::app) fn remove_partial(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with('.') && name.ends_with(".partial") {
            // It contradicts nothing; that it cannot be removed is no failure.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Keeps other programs of this kind out of a folder for as long as it lives.
#[derive(Debug)]
pub(in crate::app) struct Claim {
    _folder: Option<File>,
}

/// Claims the folder.
///
/// # Errors
/// Another program writes to it. A system that cannot say so lets everybody in.
pub(in crate::app) fn claim(folder: &Path) -> Result<Claim, String> {
    let Ok(handle) = File::open(folder) else {
        return Ok(Claim { _folder: None });
    };
    match handle.try_lock() {
        Err(TryLockError::WouldBlock) => Err(format!(
            "another run writes to {}: wait for its end, or name another folder with `--out`",
            folder.display()
        )),
        // The system gives the folder free with the end of the program, whatever ends it.
        Ok(()) => Ok(Claim { _folder: Some(handle) }),
        Err(TryLockError::Error(_)) => Ok(Claim { _folder: None }),
    }
}

/// Makes the folder with all its parents.
///
/// # Errors
/// The path and the system's reason.
pub(in crate::app) fn create_folder(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("cannot make the folder {}: {error}", folder.display()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::temporary_folder;

    #[test]
    fn files_appear_whole_and_alone() {
        let folder = temporary_folder("files");
        create_folder(&folder).unwrap();
        write(&folder, "a.csv", "old").unwrap();
        write(&folder, "a.csv", "new").unwrap();
        assert_eq!(fs::read_to_string(folder.join("a.csv")).unwrap(), "new");
        let names: Vec<_> = fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name())
            .collect();
        assert_eq!(names, ["a.csv"]);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn a_folder_has_one_writer_at_a_time() {
        let folder = temporary_folder("files-claimed");
        create_folder(&folder).unwrap();
        let first = claim(&folder).unwrap();
        let error = claim(&folder).unwrap_err();
        assert!(error.starts_with("another run writes to "), "{error}");
        drop(first);
        claim(&folder).unwrap();
        fs::remove_dir_all(&folder).unwrap();
    }

    /// Who reads the old file goes on to read it, and who opens it finds the old or the new one, whole.
    #[test]
    fn a_file_is_replaced_and_not_written_over() {
        let folder = temporary_folder("files-replaced");
        create_folder(&folder).unwrap();
        write(&folder, "a.csv", "old").unwrap();
        fs::hard_link(folder.join("a.csv"), folder.join("reader.csv")).unwrap();
        write(&folder, "a.csv", "new").unwrap();
        let text = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
        assert_eq!(
            (text("a.csv"), text("reader.csv")),
            ("new".to_string(), "old".to_string())
        );
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn files_of_an_earlier_result_are_taken_away() {
        let folder = temporary_folder("files-removed");
        create_folder(&folder).unwrap();
        write(&folder, "a.csv", "old").unwrap();
        remove(&folder, &["a.csv", "b.csv"]).unwrap();
        fs::write(folder.join(".a.csv.7.partial"), "o").unwrap();
        remove_partial(&folder);
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_failure_names_the_path() {
        let folder = temporary_folder("files-absent");
        let error = write(&folder, "a.csv", "text").unwrap_err();
        let path = folder.join("a.csv");
        assert!(
            error.starts_with(&format!("cannot write {}: ", path.display())),
            "{error}"
        );
    }
}
