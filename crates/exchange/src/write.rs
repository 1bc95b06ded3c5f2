//! Files that are there whole or not at all.

use crate::error::{ExchangeError, Result};
use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::Path;

/// Writes a file: first beside its place, then renamed into it, so that nobody ever reads half a file and
/// what stood there before survives a failure.
///
/// # Errors
/// [`ExchangeError::Write`] with the path and the reason of the operating system.
///
/// ```
/// use torse_exchange::{ExchangeError, write_file};
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("part.step");
/// write_file(&path, b"ISO-10303-21;")?;
/// assert_eq!(std::fs::read(&path)?, b"ISO-10303-21;");
/// assert_eq!(std::fs::read_dir(folder.path())?.count(), 1);
/// let nowhere = folder.path().join("missing").join("part.step");
/// assert!(matches!(write_file(&nowhere, b""), Err(ExchangeError::Write { .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<()> {
    let failed = |source| ExchangeError::Write {
        path: path.to_owned(),
        source,
    };
    let name = path
        .file_name()
        .ok_or_else(|| failed(std::io::ErrorKind::InvalidFilename.into()))?;
    // Two processes that write the same file must not share the draft.
    let mut draft = OsString::from(".");
    draft.push(name);
    draft.push(format!(".{}.part", std::process::id()));
    let draft = path.with_file_name(draft);
    let written = fs::File::create(&draft)
        .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
        .and_then(|()| fs::rename(&draft, path));
    written.map_err(|source| {
        // The first failure is the one to report.
        let _ = fs::remove_file(&draft);
        failed(source)
    })
}
