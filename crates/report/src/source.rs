//! The sources of a report, so that readers can see whether two reports are about the same paper and the same files.

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
    /// Returns the source of a report about the paper with this slug.
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

    /// Returns the leading digits for comparison.
    pub(crate) fn short(&self) -> &str {
        /// Enough digits to distinguish any two states of the files.
        const DIGITS: usize = 12;
        self.digest.get(..DIGITS).unwrap_or(&self.digest)
    }
}
