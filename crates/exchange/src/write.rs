//! Files that are there whole or not at all.

use crate::error::{ExchangeError, Result};
use std::ffi::OsString;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The most symbolic links to follow.
const MAX_LINKS: usize = 40;

/// Writes a file: first beside its place, then renamed into it, so that nobody ever reads half a file and
/// what stood there before survives a failure. A symbolic link stays one: the file that it names is written.
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
    let place = target(path).map_err(failed)?;
    let name = place
        .file_name()
        .ok_or_else(|| failed(std::io::ErrorKind::InvalidFilename.into()))?;
    // Two processes that write the same file must not share the draft.
    let mut draft = OsString::from(".");
    draft.push(name);
    draft.push(format!(".{}.part", std::process::id()));
    let draft = place.with_file_name(draft);
    let written = fs::File::create(&draft)
        .and_then(|mut file| file.write_all(bytes).and_then(|()| file.sync_all()))
        .and_then(|()| fs::rename(&draft, &place));
    written.map_err(|source| {
        // The first failure is the one to report.
        let _ = fs::remove_file(&draft);
        failed(source)
    })
}

/// The file that a path names where it is a symbolic link, also to one that is not there yet.
fn target(path: &Path) -> std::io::Result<PathBuf> {
    let mut place = path.to_owned();
    for _ in 0..MAX_LINKS {
        match fs::symlink_metadata(&place) {
            Ok(found) if found.is_symlink() => {
                let next = fs::read_link(&place)?;
                place = place.parent().unwrap_or(Path::new("")).join(next);
            }
            _ => return Ok(place),
        }
    }
    Err(std::io::Error::other("too many symbolic links"))
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn a_symbolic_link_stays_one_and_its_file_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let (file, link) = (
            folder.path().join("part.dxf"),
            folder.path().join("latest.dxf"),
        );
        std::os::unix::fs::symlink("part.dxf", &link).unwrap();
        // Also where the file is not there yet.
        for content in ["first", "second"] {
            write_file(&link, content.as_bytes()).unwrap();
            assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
            assert_eq!(fs::read_to_string(&file).unwrap(), content);
        }
        let ring = folder.path().join("ring");
        std::os::unix::fs::symlink("ring", &ring).unwrap();
        assert!(write_file(&ring, b"").is_err());
    }
}
