//! Claims with their digests, as `torse list --format json` writes them: a line each.

use crate::exit::Failure;
use crate::input::{self, Lasting};
use serde::{Deserialize, Serialize};
use torse::ClaimDigest;

/// The last line of a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ListEnd {
    /// The number of claims.
    pub claims: usize,
    /// The exit code of the list, which knows the mistakes of all files.
    pub exit: u8,
}

/// A line of a list of claims.
#[derive(Debug)]
pub enum Listed {
    /// A claim.
    Claim(ClaimDigest),
    /// The last line.
    End(ListEnd),
}

/// A line of a claim; other fields are ignored.
#[derive(Debug, Deserialize)]
struct ListedClaim {
    id: String,
    digest: String,
}

/// The lines of a file, one after the other, so that a long list takes no memory.
///
/// # Errors
/// [`Failure::Input`] for a file that cannot be read, and [`Failure::List`] in place of a line that is none of a list.
pub fn listed(file: &Lasting) -> Result<impl Iterator<Item = Result<Listed, Failure>>, Failure> {
    let lines = input::lines(file.path())?.enumerate();
    let path = file.named().to_owned();
    Ok(lines.map(move |(number, line)| {
        let line = line?;
        if let Ok(end) = serde_json::from_str(&line) {
            return Ok(Listed::End(end));
        }
        let read: Result<ListedClaim, _> = serde_json::from_str(&line);
        match read {
            Ok(ListedClaim { id, digest }) => Ok(Listed::Claim(ClaimDigest::new(id, digest))),
            Err(error) => Err(Failure::List {
                path: path.clone(),
                reason: format!("line {}: {error}", number + 1),
            }),
        }
    }))
}
