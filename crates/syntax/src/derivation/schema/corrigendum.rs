//! Corrigenda as TOML: the errors of a paper, as they are reported to its authors.

use super::Text;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// An error of the paper, wherever it shows.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CorrigendumEntry {
    /// Its id: `paper/corrigendum.name`.
    pub id: Text,
    /// Its place in the paper; by default the place of the first claim.
    pub at: Option<String>,
    /// The part of a letter that lists it; by default the part that the verdicts of its claims ask for.
    pub part: Option<LetterPart>,
    /// The error in one sentence.
    pub says: Text,
    /// The claims in which the error shows.
    pub shows: Vec<Text>,
    /// Corrected definitions, which replace those of the files.
    #[serde(default)]
    pub define: BTreeMap<String, Text>,
    /// The corrected wording.
    #[serde(default, rename = "change")]
    pub changes: Vec<ChangeEntry>,
}

/// A part of a letter to the authors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum LetterPart {
    /// What is wrong, though no formula in it is refuted: a sentence that says nothing, or is true under one reading alone.
    Correction,
    /// What the text should state more exactly.
    Condition,
}

/// A passage of the paper, and its corrected wording.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChangeEntry {
    /// The claim whose printed text contains the passage.
    pub claim: Text,
    /// The passage; by default the whole printed text of the claim.
    pub printed: Option<Text>,
    /// The corrected wording in the notation of the paper. Left out if other passages are corrected, and only the
    /// statement of this claim changes with them.
    pub reads: Option<Text>,
    /// The corrected statement of the claim. Left out if the corrected definitions, or a correction that was found,
    /// are enough.
    pub states: Option<Text>,
    /// The remark that states the correction; the corrected statement is that of the remark unless `states` is given.
    pub remark: Option<Text>,
    /// Definitions for the corrected statement only.
    #[serde(default, rename = "let")]
    pub local: BTreeMap<String, Text>,
    /// Additional assumptions of the corrected text.
    #[serde(default)]
    pub assume: Vec<Text>,
}
