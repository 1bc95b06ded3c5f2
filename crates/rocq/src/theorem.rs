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
    /// The proved statement, if this one follows from it.
    pub rests_on: Option<String>,
}

impl Theorem {
    /// Returns a name that no other theorem of the folder has: `GbtDevelopable/Section_5_1.thm_2_a`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}.{}", self.section, self.module)
    }
}
