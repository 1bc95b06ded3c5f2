//! Files that the command line names. `-` is standard input for every one of them, and is read by one of them at most.

use crate::exit::Failure;
use crate::standard::is_standard;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use tempfile::NamedTempFile;

/// Opens a file.
///
/// # Errors
/// [`Failure::Input`] for one that cannot be opened, for a folder, and for standard input that was opened before.
pub fn open(path: &Path) -> Result<Box<dyn BufRead>, Failure> {
    opened(path).map_err(|source| failed(path, source))
}

/// Returns the bytes of a file; of one that is longer than `most` a beginning that is too long.
///
/// # Errors
/// As [`open`], and for what cannot be read.
pub fn bytes(path: &Path, most: usize) -> Result<Vec<u8>, Failure> {
    let most = u64::try_from(most).unwrap_or(u64::MAX);
    let mut bytes = vec![];
    let read = open(path)?
        .take(most.saturating_add(1))
        .read_to_end(&mut bytes);
    read.map_err(|source| failed(path, source))?;
    Ok(bytes)
}

/// Returns the text of a file.
///
/// # Errors
/// As [`bytes`], and for what is no UTF-8.
pub fn text(path: &Path) -> Result<String, Failure> {
    let mut text = String::new();
    let read = open(path)?.read_to_string(&mut text);
    read.map_err(|source| failed(path, source))?;
    Ok(text)
}

/// Goes through the lines of a file, so that a long one takes no memory.
///
/// # Errors
/// As [`open`], and in place of a line that cannot be read.
pub fn lines(path: &Path) -> Result<impl Iterator<Item = Result<String, Failure>>, Failure> {
    let (lines, path) = (open(path)?.lines(), path.to_owned());
    Ok(lines.map(move |line| line.map_err(|source| failed(&path, source))))
}

/// A file that can be opened several times: standard input is copied to a file that is gone afterwards.
pub struct Lasting {
    path: PathBuf,
    /// What the user has called it.
    named: PathBuf,
    _copy: Option<NamedTempFile>,
}

impl Lasting {
    /// Copies standard input, and leaves every other file where it is.
    ///
    /// # Errors
    /// As [`text`], and where the copy cannot be written.
    pub fn new(path: &Path) -> Result<Self, Failure> {
        let named = path.to_owned();
        if !is_standard(path) {
            return Ok(Self {
                path: path.to_owned(),
                named,
                _copy: None,
            });
        }
        let mut from = open(path)?;
        let mut copy = NamedTempFile::new().map_err(Failure::Print)?;
        io::copy(&mut from, &mut copy).map_err(|source| failed(path, source))?;
        copy.flush().map_err(Failure::Print)?;
        Ok(Self {
            path: copy.path().to_owned(),
            named,
            _copy: Some(copy),
        })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// What the user has called it.
    pub fn named(&self) -> &Path {
        &self.named
    }
}

fn opened(path: &Path) -> io::Result<Box<dyn BufRead>> {
    static IS_READ: AtomicBool = AtomicBool::new(false);
    if is_standard(path) {
        if IS_READ.swap(true, Ordering::Relaxed) {
            return Err(io::Error::other("it is read once, and `-` is there twice"));
        }
        return Ok(Box::new(io::stdin().lock()));
    }
    let file = File::open(path)?;
    if file.metadata()?.is_dir() {
        return Err(io::Error::other("it is a folder"));
    }
    Ok(Box::new(BufReader::new(file)))
}

fn failed(path: &Path, source: io::Error) -> Failure {
    let path = path.to_owned();
    Failure::Input { path, source }
}
