//! Digests of what claims rest on, by which a claim that has not changed is known.

use serde::Serialize;
use std::sync::Arc;
use torse_report::digest::digest;
use torse_syntax::derivation::Paper;

/// A claim and the digest of what it rests on.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[non_exhaustive]
pub struct ClaimDigest {
    /// The claim.
    pub id: String,
    /// The SHA-256 of its fields, of the declarations of its paper and its file, and of the other printed values of its
    /// example, as hexadecimal digits. Comments and layout do not count, and neither do places in the file.
    pub digest: String,
}

impl ClaimDigest {
    /// The digest of a claim, as it was written down before.
    #[must_use]
    pub fn new(id: impl Into<String>, digest: impl Into<String>) -> Self {
        let (id, digest) = (id.into(), digest.into());
        Self { id, digest }
    }
}

/// Digests what each claim rests on, in file order. A claim with the digest that it had before has the finding that it had
/// before, if the same program decides it with the same budget.
///
/// ```
/// let read = |states: &'static str| torse::Paper::read(move |name| match name {
///     "paper.toml" => Some("[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n[define]\na = '2'".to_owned()),
///     "c.toml" => Some(format!(
///         "[[claim]]\nid = 'p/1'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = 'a == 2'\n\
///          [[claim]] # the second\nid = 'p/2'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = '{states}'"
///     )),
///     _ => None,
/// });
/// let digests = |states| Ok::<_, torse::Error>(torse::digests(&[read(states)?.parts().clone()]));
/// let (before, after) = (digests("a == 2")?, digests("a == 1 + 1")?);
/// assert_eq!(before[0], after[0]);
/// assert_ne!(before[1].digest, after[1].digest);
/// # Ok::<(), torse::Error>(())
/// ```
#[must_use]
pub fn digests(papers: &[Paper]) -> Vec<ClaimDigest> {
    // All claims of a file share the text of its declarations, which is digested once.
    let mut last: Option<(Arc<str>, String)> = None;
    let claims = papers.iter().flat_map(Paper::rests_on).map(|claim| {
        let shared = match &last {
            Some((text, shared)) if Arc::ptr_eq(text, &claim.shared) => shared.clone(),
            _ => {
                let shared = digest([claim.shared.as_bytes()]);
                last = Some((Arc::clone(&claim.shared), shared.clone()));
                shared
            }
        };
        ClaimDigest {
            digest: digest([shared.as_bytes(), claim.own.as_bytes()]),
            id: claim.id,
        }
    });
    claims.collect()
}
