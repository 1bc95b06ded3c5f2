//! Corrigenda as TOML: what the authors of a paper are told, fault by fault.

use super::Text;
use serde::Deserialize;
use std::collections::BTreeMap;

/// A fault of the paper, wherever it shows.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CorrigendumEntry {
    /// Its id: `paper/corrigendum.name`.
    pub id: Text,
    /// Where the paper has it; the place of the first claim if left out.
    pub at: Option<String>,
    /// What is wrong, in one sentence.
    pub says: Text,
    /// The claims in which it shows.
    pub shows: Vec<Text>,
    /// What the paper's own names mean once it is corrected: definitions that take the place of those of the files.
    #[serde(default)]
    pub define: BTreeMap<String, Text>,
    /// What is to be read instead.
    #[serde(default, rename = "change")]
    pub changes: Vec<ChangeEntry>,
}

/// Words of the paper, and what is to be read instead.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChangeEntry {
    /// The claim in whose print they stand.
    pub claim: Text,
    /// The words; the whole print of the claim if left out.
    pub printed: Option<Text>,
    /// What is to be read instead, in the notation of the paper; left out where other words of the paper are corrected, and
    /// only what the claim states changes with them.
    pub reads: Option<Text>,
    /// The corrected statement of the claim; left out where the corrected definitions, or a correction that was found, are
    /// enough.
    pub states: Option<Text>,
    /// The remark that states what is true; it is the corrected statement where there is no `states`.
    pub remark: Option<Text>,
    /// Definitions of the corrected statement alone.
    #[serde(default, rename = "let")]
    pub local: BTreeMap<String, Text>,
    /// What the corrected text assumes besides.
    #[serde(default)]
    pub assume: Vec<Text>,
}
