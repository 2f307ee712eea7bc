//! Files that are complete or absent, never half-written.

use std::fs;
use std::path::Path;

/// Writes `text` to `folder/name`: first to a temporary name, then renamed.
///
/// # Errors
/// The path and the system's reason.
pub(super) fn write(folder: &Path, name: &str, text: &str) -> Result<(), String> {
    let path = folder.join(name);
    let partial = folder.join(format!(".{name}.{}.partial", std::process::id()));
    let written = fs::write(&partial, text).and_then(|()| fs::rename(&partial, &path));
    written.map_err(|error| {
        // The partial file is of no use; that it cannot be removed either adds nothing.
        let _ = fs::remove_file(&partial);
        format!("cannot write {}: {error}", path.display())
    })
}

/// Makes the folder with all its parents.
///
/// # Errors
/// The path and the system's reason.
pub(super) fn create_folder(folder: &Path) -> Result<(), String> {
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
