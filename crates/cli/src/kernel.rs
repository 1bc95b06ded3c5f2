//! The level *kernel*: verdicts whose theorems the kernel of the proof assistant accepted, as the folder of proofs keeps it.

use crate::proof_tasks::proof_tasks;
use crate::run::Run;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use torse_report::digest::digest;
use torse_rocq::accepted::Accepted;
use torse_rocq::folder::{ACCEPTED, Folder, Layout, chosen, unproved};
use torse_syntax::derivation::Paper;

/// The option that names the folder of the kernel's proofs.
#[derive(Debug, clap::Args)]
pub struct Kernel {
    /// Read proofs for the Rocq kernel from this folder; its accepted.json counts as long as statements, proofs and
    /// library are unchanged
    #[arg(long = "kernel", value_name = "DIR", default_value = "proofs")]
    kernel: PathBuf,
}

impl Kernel {
    /// Digests the list of what was accepted; none if there is no list that could be read.
    pub fn digest(&self) -> Option<String> {
        let text = std::fs::read(self.kernel.join(ACCEPTED)).ok()?;
        Accepted::read(&self.kernel)?;
        Some(digest([text.as_slice()]))
    }

    /// Returns the ids of the claims of a run all of whose theorems were accepted in their present form. A claim with a
    /// theorem without a proof is not among them.
    pub fn accepted(&self, papers: &[Paper], run: &Run) -> BTreeSet<String> {
        let Some(accepted) = Accepted::read(&self.kernel) else {
            return BTreeSet::new();
        };
        // If the list cannot be read, no theorem counts as unproved: accepted theorems have their digests.
        let unproved = unproved(&self.kernel).unwrap_or_default();
        let tasks = proof_tasks(papers, run);
        let chosen = chosen(&self.kernel);
        let folder = Folder::with_scripts(&tasks, &unproved, &chosen, Layout::Apart);
        let fingerprints = accepted.fingerprints();
        let mut fresh: BTreeMap<&str, bool> = BTreeMap::new();
        for theorem in &folder.theorems {
            // If no printed statement of a section was checked, the proved lemmas count.
            if theorem.rests_on.is_some() && !accepted.has_section(&theorem.section) {
                continue;
            }
            let accepted = accepted.has(theorem, &fingerprints.fingerprint(theorem));
            *fresh.entry(&theorem.id).or_insert(true) &= accepted;
        }
        for missing in &folder.missing {
            fresh.insert(&missing.id, false);
        }
        let accepted = fresh.into_iter().filter(|(_, fits)| *fits);
        accepted.map(|(id, _)| id.to_owned()).collect()
    }
}
