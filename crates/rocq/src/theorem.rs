//! Theorems of a folder of proofs.

use crate::task::Role;
use torse_certificate::Evidence;

/// A theorem of the folder.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Theorem {
    /// The folder and the section, as `GbtDevelopable/Section_5_1`.
    pub section: String,
    /// The module.
    pub module: String,
    /// The id of the claim.
    pub id: String,
    /// What it says about the claim's statement.
    pub role: Role,
    /// The evidence of the verdict.
    pub evidence: Evidence,
    /// The proposition that is proved, and its proof, as they stand in their modules.
    pub says: String,
    /// The text of the proof.
    pub proof: String,
    /// What it follows from, if it follows from another one.
    pub rests_on: Option<RestsOn>,
}

/// What a printed statement follows from.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct RestsOn {
    /// The proved statement.
    pub statement: String,
    /// The text of the proof without equations of definitions: which of these stand in it depends on the claims beside it.
    pub plain_proof: String,
}

impl Theorem {
    /// Returns a name that no other theorem of the folder has: `GbtDevelopable/Section_5_1.thm_2_a`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}.{}", self.section, self.module)
    }
}
