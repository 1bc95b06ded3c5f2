//! The folder of a studio: its designs, the files that they name, its papers.
//!
//! A file is reached only by a name of the list, which is made anew each time: no text of a request becomes a path.

use crate::exit::Failure;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::UNIX_EPOCH;
use torse_exchange::{MAX_FILE_BYTES, write_file};
use torse_report::digest::digest;

/// A folder whose files are shown and saved.
pub struct SharedFolder {
    path: PathBuf,
    /// Held while a file is compared and written.
    saving: Mutex<()>,
}

/// The files of a folder.
#[derive(Debug, Serialize, PartialEq, Eq)]
pub struct FolderList {
    /// The name of the folder.
    pub folder: String,
    /// The paths of the files, with `/` between their parts, each with a text that changes when the file does.
    pub files: BTreeMap<String, String>,
    /// Whether there are more files than are listed.
    pub cut: bool,
}

/// Why a file was not saved.
#[derive(Debug, PartialEq, Eq)]
pub enum Unsaved {
    /// The folder has no such file, or it is no design or paper.
    Absent,
    /// It has changed since it was read.
    Changed,
    /// The text is too long, or not UTF-8.
    NoText,
    /// The system refuses.
    Refused(String),
}

/// Extensions of designs, papers and the files that designs name.
const EXTENSIONS: [&str; 10] = [
    "toml", "dxf", "svg", "csv", "step", "stp", "iges", "igs", "obj", "stl",
];

/// Folders within folders that are searched.
const MAX_DEPTH: usize = 4;

/// The most files of a list.
const MAX_FILES: usize = 2000;

/// Folders that hold what programs make.
const SKIPPED: [&str; 2] = ["target", "node_modules"];

impl SharedFolder {
    /// Opens a folder.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        let whole = fs::canonicalize(path).ok().filter(|path| path.is_dir());
        let whole = whole.ok_or_else(|| Failure::NoFolder {
            path: path.to_owned(),
        })?;
        Ok(Self {
            path: whole,
            saving: Mutex::new(()),
        })
    }

    /// Lists the files. Symbolic links and hidden files are left out, and so is what is too large to be read.
    pub fn list(&self) -> FolderList {
        let mut files = BTreeMap::new();
        let cut = !search(&self.path, "", MAX_DEPTH, &mut files);
        let name = self.path.file_name().unwrap_or_default();
        FolderList {
            folder: name.to_string_lossy().into_owned(),
            files,
            cut,
        }
    }

    /// Reads a file of the list.
    pub fn read(&self, name: &str) -> Option<Vec<u8>> {
        fs::read(self.place(name)?).ok()
    }

    /// Writes a file of the list whole or not at all, if its contents still have the digest `before`; returns the new
    /// digest.
    pub fn save(&self, name: &str, before: &str, text: &[u8]) -> Result<String, Unsaved> {
        let _held = self.saving.lock().unwrap_or_else(PoisonError::into_inner);
        let is_text = name.ends_with(".toml");
        let place = self
            .place(name)
            .filter(|_| is_text)
            .ok_or(Unsaved::Absent)?;
        if std::str::from_utf8(text).is_err() {
            return Err(Unsaved::NoText);
        }
        let now = fs::read(&place).map_err(|error| Unsaved::Refused(error.to_string()))?;
        if fingerprint(&now) != before {
            return Err(Unsaved::Changed);
        }
        write_file(&place, text).map_err(|error| Unsaved::Refused(error.to_string()))?;
        Ok(fingerprint(text))
    }

    fn place(&self, name: &str) -> Option<PathBuf> {
        let listed = self.list().files;
        let (name, _) = listed.get_key_value(name)?;
        Some(self.path.join(name))
    }
}

/// The digest of the contents of a file.
pub fn fingerprint(contents: &[u8]) -> String {
    digest([contents])
}

/// Adds the files of a folder; returns whether all have a place.
fn search(folder: &Path, before: &str, depth: usize, files: &mut BTreeMap<String, String>) -> bool {
    let mut entries: Vec<_> = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .collect();
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        // What is no text has no name in a page.
        let Ok(name) = entry.file_name().into_string() else {
            continue;
        };
        // A link may lead anywhere. A file that is being replaced may be missing for a moment.
        let Some(found) = entry.metadata().ok().filter(|found| !found.is_symlink()) else {
            continue;
        };
        if name.starts_with('.') {
            continue;
        }
        let path = format!("{before}{name}");
        if found.is_dir() && depth > 0 && !SKIPPED.contains(&name.as_str()) {
            if !search(&entry.path(), &format!("{path}/"), depth - 1, files) {
                return false;
            }
        } else if found.is_file() && is_shown(&name, found.len()) {
            if files.len() == MAX_FILES {
                return false;
            }
            let time = found.modified().ok();
            let time = time.and_then(|time| time.duration_since(UNIX_EPOCH).ok());
            let nanoseconds = time.unwrap_or_default().as_nanos();
            files.insert(path, format!("{}-{nanoseconds}", found.len()));
        }
    }
    true
}

fn is_shown(name: &str, length: u64) -> bool {
    let extension = Path::new(name).extension().and_then(|e| e.to_str());
    let known = extension.is_some_and(|extension| {
        let extension = extension.to_ascii_lowercase();
        EXTENSIONS.contains(&extension.as_str())
    });
    known && usize::try_from(length).is_ok_and(|length| length <= MAX_FILE_BYTES)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[allow(clippy::unwrap_used, reason = "a test")]
    fn a_file_is_saved_only_where_it_is_listed_and_as_it_was_read() {
        let outer = tempfile::tempdir().unwrap();
        let inner = outer.path().join("inner");
        fs::create_dir(&inner).unwrap();
        fs::write(inner.join("a.toml"), "one").unwrap();
        fs::write(outer.path().join("b.toml"), "outside").unwrap();
        let folder = SharedFolder::open(&inner).unwrap();
        let before = fingerprint(b"one");
        for name in ["../b.toml", "b.toml", "./a.toml", "/a.toml", ""] {
            assert_eq!(
                folder.save(name, &before, b"two"),
                Err(Unsaved::Absent),
                "{name}"
            );
            assert_eq!(folder.read(name), None, "{name}");
        }
        assert_eq!(
            folder.save("a.toml", &fingerprint(b"else"), b"two"),
            Err(Unsaved::Changed)
        );
        assert_eq!(
            folder.save("a.toml", &before, &[0xff]),
            Err(Unsaved::NoText)
        );
        assert_eq!(folder.read("a.toml").unwrap(), b"one");
        let stamp = folder.list();
        assert_eq!(
            folder.save("a.toml", &before, b"three"),
            Ok(fingerprint(b"three"))
        );
        assert_ne!(folder.list(), stamp);
        assert_eq!(fs::read_dir(&inner).unwrap().count(), 1);
    }

    #[test]
    #[cfg(unix)]
    #[allow(clippy::unwrap_used, reason = "a test")]
    fn links_hidden_files_and_other_kinds_are_not_listed() {
        let outer = tempfile::tempdir().unwrap();
        let inner = outer.path().join("inner");
        fs::create_dir_all(inner.join("paper")).unwrap();
        fs::create_dir(inner.join(".git")).unwrap();
        fs::write(outer.path().join("secret.toml"), "").unwrap();
        for name in [
            "a.toml",
            "paper/paper.toml",
            ".hidden.toml",
            ".git/c.toml",
            "key.pem",
        ] {
            fs::write(inner.join(name), "").unwrap();
        }
        std::os::unix::fs::symlink(outer.path().join("secret.toml"), inner.join("link.toml"))
            .unwrap();
        std::os::unix::fs::symlink(outer.path(), inner.join("up")).unwrap();
        let listed = SharedFolder::open(&inner).unwrap().list();
        let names: Vec<&String> = listed.files.keys().collect();
        assert_eq!(names, ["a.toml", "paper/paper.toml"]);
        assert!(!listed.cut);
    }
}
