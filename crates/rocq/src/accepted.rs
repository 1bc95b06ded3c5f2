//! The theorems that the kernel accepted, with digests of all that the answers depend on.

use crate::digest::Digest;
use crate::folder::ACCEPTED;
use crate::library::LIBRARY;
use crate::printed::{self, FOLLOWS, FUNCTIONS, JETS};
use crate::theorem::{RestsOn, Theorem};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// The theorems that the kernel accepted, as stored.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Accepted {
    /// The version of the program.
    pub coq: String,
    /// The axioms that all of them together rest on.
    pub axioms: Vec<String>,
    /// The answer of the separate checker of compiled files for the same theorems, if it was asked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coqchk: Option<CoqchkAnswer>,
    /// Names of theorems, with the digest of everything that the answer depends on.
    pub theorems: BTreeMap<String, String>,
}

/// The answer of the separate checker, which reads compiled files anew and does not trust tactics or the compiler.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct CoqchkAnswer {
    /// Whether it accepted all files and everything that they rest on.
    pub accepted: bool,
    /// The axioms that it lists: those of all loaded files, used or not.
    pub axioms: Vec<String>,
    /// How many theorems were accepted when it was asked.
    pub theorems: usize,
}

impl Accepted {
    /// Reads what a folder stores; empty if nothing can be read.
    #[must_use]
    pub fn read(folder: &Path) -> Option<Self> {
        let text = std::fs::read_to_string(folder.join(ACCEPTED)).ok()?;
        serde_json::from_str(&text).ok()
    }

    /// Returns the digests of its theorems.
    #[must_use]
    pub fn fingerprints(&self) -> Fingerprints {
        Fingerprints::of_version(&self.coq)
    }

    /// Whether a theorem of this section was accepted.
    #[must_use]
    pub fn has_section(&self, section: &str) -> bool {
        let mut names = self.theorems.keys();
        names.any(|name| {
            name.strip_prefix(section)
                .is_some_and(|rest| rest.starts_with('.'))
        })
    }

    /// Whether a theorem was accepted with this digest.
    #[must_use]
    pub fn has(&self, theorem: &Theorem, fingerprint: &str) -> bool {
        let accepted = self.theorems.get(&theorem.name());
        accepted.is_some_and(|accepted| accepted == fingerprint)
    }
}

/// Computes digests of theorems from the version of the program, the library, the statement and the proof. The common
/// part is digested once.
#[derive(Debug, Clone)]
pub struct Fingerprints(Digest);

impl Fingerprints {
    /// Starts digests for a version of the program.
    #[must_use]
    pub fn of_version(version: &str) -> Self {
        let texts = LIBRARY.iter().map(|(_, text)| *text);
        Self(texts.fold(Digest::default().and(version), Digest::and))
    }

    /// Returns the digest of one theorem.
    #[must_use]
    pub fn fingerprint(&self, theorem: &Theorem) -> String {
        let own = self.0.clone().and(&theorem.says);
        // A statement that follows from another one was accepted together with it, by its own tactic.
        let whole = match &theorem.rests_on {
            None => own.and(&theorem.proof),
            Some(RestsOn {
                statement,
                plain_proof,
            }) => {
                let own = own.and(plain_proof).and(statement).and(FOLLOWS.1);
                match printed::uses_jets(&theorem.proof) {
                    true => own.and(JETS.1).and(FUNCTIONS.1),
                    false => own,
                }
            }
        };
        whole.hexadecimal()
    }
}
