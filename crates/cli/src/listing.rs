//! Claims with their digests, as `torse list --format json` writes them: a line each.

use crate::exit::Failure;
use serde::Deserialize;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use torse::ClaimDigest;

/// A line of a list of claims; other fields are ignored.
#[derive(Debug, Deserialize)]
struct ListedClaim {
    id: String,
    digest: String,
}

/// The claims of a file, one after the other, so that a long list takes no memory.
///
/// # Errors
/// [`Failure::List`] for a file that cannot be read, and in place of a line that is none of a list.
pub fn listed(path: &Path) -> Result<impl Iterator<Item = Result<ClaimDigest, Failure>>, Failure> {
    let path = path.to_owned();
    let file = std::fs::File::open(&path).map_err(|error| wrong(&path, error.to_string()))?;
    let lines = BufReader::new(file).lines().enumerate();
    Ok(lines.map(move |(number, line)| {
        let line = line.map_err(|error| wrong(&path, error.to_string()))?;
        let read: Result<ListedClaim, _> = serde_json::from_str(&line);
        match read {
            Ok(ListedClaim { id, digest }) => Ok(ClaimDigest { id, digest }),
            Err(error) => Err(wrong(&path, format!("line {}: {error}", number + 1))),
        }
    }))
}

fn wrong(path: &Path, reason: String) -> Failure {
    let path: PathBuf = path.to_owned();
    Failure::List { path, reason }
}
