//! Claims with their digests, as `torse list --format json` writes them: a line each.

use crate::exit::Failure;
use crate::input::{self, Lasting};
use serde::Deserialize;
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
/// [`Failure::Input`] for a file that cannot be read, and [`Failure::List`] in place of a line that is none of a list.
pub fn listed(
    file: &Lasting,
) -> Result<impl Iterator<Item = Result<ClaimDigest, Failure>>, Failure> {
    let lines = input::lines(file.path())?.enumerate();
    let path = file.named().to_owned();
    Ok(lines.map(move |(number, line)| {
        let read: Result<ListedClaim, _> = serde_json::from_str(&line?);
        match read {
            Ok(ListedClaim { id, digest }) => Ok(ClaimDigest::new(id, digest)),
            Err(error) => Err(Failure::List {
                path: path.clone(),
                reason: format!("line {}: {error}", number + 1),
            }),
        }
    }))
}
