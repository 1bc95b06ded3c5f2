//! Finds the claims that differ from what they were: in a list of claims, or at a revision of the repository.

use crate::exit::Failure;
use crate::input::Lasting;
use crate::listing::{Listed, listed};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;
use torse::{digests, selection};
use torse_syntax::derivation::{Paper, load_all};

/// Returns the papers with those of their claims alone that differ from `since`: a file that `torse list --format json` has
/// written (`-` is standard input), or a revision of the git repository of `folder`. A claim differs if it is new, or if its fields or the
/// declarations that it sees have changed.
pub fn changed(papers: &[Paper], since: &str, folder: &Path) -> Result<Vec<Paper>, Failure> {
    let before: BTreeMap<String, String> = if since == "-" || Path::new(since).is_file() {
        let list = Lasting::new(Path::new(since))?;
        let claims = listed(&list)?;
        let mut pairs = BTreeMap::new();
        for line in claims {
            if let Listed::Claim(claim) = line? {
                pairs.insert(claim.id, claim.digest);
            }
        }
        pairs
    } else {
        let claims = at_revision(since, folder)?;
        let claims = claims.into_iter();
        claims.map(|claim| (claim.id, claim.digest)).collect()
    };
    let now = digests(papers);
    let differs = |id: &str, digest: &str| before.get(id).is_none_or(|before| before != digest);
    let ids: Vec<&str> = now
        .iter()
        .filter(|claim| differs(&claim.id, &claim.digest))
        .map(|claim| claim.id.as_str())
        .collect();
    Ok(selection::only(papers, &ids))
}

/// Digests the claims of a folder as they were at a revision. What was wrong then has no digest, so it has changed.
fn at_revision(revision: &str, folder: &Path) -> Result<Vec<torse::ClaimDigest>, Failure> {
    let unknown = |reason: String| Failure::Since {
        since: revision.to_owned(),
        reason,
    };
    let git = |arguments: &[&OsStr]| -> Result<Vec<u8>, Failure> {
        let ran = Command::new("git")
            .current_dir(folder)
            .args(arguments)
            .output();
        let ran = ran.map_err(|error| unknown(format!("git does not run: {error}")))?;
        match ran.status.success() {
            true => Ok(ran.stdout),
            false => Err(unknown(
                String::from_utf8_lossy(&ran.stderr).trim().to_owned(),
            )),
        }
    };
    let commit = format!("{revision}^{{commit}}");
    let verify = [
        "rev-parse",
        "--verify",
        "--quiet",
        "--end-of-options",
        &commit,
    ];
    let commit = git(&verify.map(OsStr::new)).map_err(|failure| match failure {
        Failure::Since { since, reason } if reason.is_empty() => Failure::Since {
            since,
            reason: "there is no such file, and no such commit".to_owned(),
        },
        other => other,
    })?;
    let commit = String::from_utf8_lossy(&commit).trim().to_owned();
    let tree = ["ls-tree", "-r", "-z", "--name-only", &commit];
    let names = git(&tree.map(OsStr::new))?;
    let copy = tempfile::tempdir().map_err(Failure::Print)?;
    for name in names.split(|byte| *byte == 0) {
        let Ok(name) = std::str::from_utf8(name) else {
            continue;
        };
        // Papers are folders with TOML files in them; no other file is read.
        let parts: Vec<&str> = name.split('/').collect();
        let [paper, file] = parts.as_slice() else {
            continue;
        };
        if Path::new(file).extension() != Some(OsStr::new("toml")) {
            continue;
        }
        let text = git(&[
            OsStr::new("show"),
            OsStr::new(&format!("{commit}:./{name}")),
        ])?;
        let to = copy.path().join(paper);
        std::fs::create_dir_all(&to).map_err(Failure::Print)?;
        std::fs::write(to.join(file), text).map_err(Failure::Print)?;
    }
    // Without any paper everything is new.
    let papers = load_all(copy.path()).map(|loaded| loaded.papers);
    Ok(digests(&papers.unwrap_or_default()))
}
