//! Writes files whole or not at all.

use std::{
    ffi::OsString,
    fs,
    io::Write,
    path::{Path, PathBuf},
};

use crate::ReportError;

/// Writes `bytes` to `path`: first to a temporary file in the same folder, which is then renamed.
///
/// A reader sees the old file or the new one, never half of one, and a failure leaves the old file as it was. Missing
/// folders are made. The name of the temporary file contains the process number, so two runs at once do not overwrite
/// each other's.
///
/// # Errors
///
/// [`ReportError::Write`] when the folder cannot be made or the file cannot be written or renamed.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), ReportError> {
    let neighbour = neighbour(path);
    let written = replace(path, &neighbour, bytes);
    if written.is_err() {
        // The temporary file is removed; a failure of that does not change the first error.
        let _ = fs::remove_file(&neighbour);
    }
    written.map_err(|source| ReportError::Write {
        path: path.to_owned(),
        source,
    })
}

fn replace(path: &Path, neighbour: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let mut file = fs::File::create(neighbour)?;
    file.write_all(bytes)?;
    file.sync_all()?;
    drop(file);
    fs::rename(neighbour, path)
}

fn neighbour(path: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.part", std::process::id()));
    path.with_file_name(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<OsString> {
        fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name())
            .collect()
    }

    #[test]
    fn writing_makes_folders_replaces_the_file_and_leaves_no_neighbour() {
        let root = tempfile::tempdir().unwrap();
        let path = root.path().join("deep/er/report.txt");
        write_file(&path, b"first").unwrap();
        write_file(&path, b"second").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        assert_eq!(names(path.parent().unwrap()), ["report.txt"]);
    }

    #[test]
    fn a_failed_write_names_the_file_and_leaves_nothing_behind() {
        let root = tempfile::tempdir().unwrap();
        let occupied = root.path().join("occupied");
        fs::create_dir_all(occupied.join("child")).unwrap();
        let error = write_file(&occupied, b"bytes").unwrap_err();
        assert!(matches!(error, ReportError::Write { path, .. } if path == occupied));
        assert_eq!(names(root.path()), ["occupied"]);
    }
}
