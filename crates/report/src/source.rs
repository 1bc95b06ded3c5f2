//! What a report was made from, so that a reader can tell whether it is about the same paper and the same files.

use crate::text::visible;
use serde::Serialize;

/// The paper's identifier, the version of this library, and the derivation files.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Source {
    /// Digital object identifier of the paper.
    pub doi: Option<String>,
    /// SHA-256 of the paper's derivation files, one after the other in the order of their names, as hexadecimal digits.
    pub digest: String,
    /// The version that made the report.
    pub version: &'static str,
    /// The command that shows the digest, in the folder of the derivations.
    pub command: String,
}

impl Source {
    /// The source of a report about the paper with this slug.
    #[must_use]
    pub fn new(slug: &str, doi: Option<&str>, digest: &str) -> Self {
        Source {
            doi: doi.map(visible),
            digest: visible(digest),
            version: env!("CARGO_PKG_VERSION"),
            command: format!(
                "LC_ALL=C; cat derivations/{}/*.toml | sha256sum",
                visible(slug)
            ),
        }
    }

    /// The digits by which readers compare.
    pub(crate) fn short(&self) -> &str {
        /// As many as tell any two states of the files apart.
        const DIGITS: usize = 12;
        self.digest.get(..DIGITS).unwrap_or(&self.digest)
    }
}
