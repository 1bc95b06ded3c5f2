//! Scripts that are written by hand: for theorems whose proofs have an idea of their own.
//!
//! `proofs/by-hand.json` has them by the claim, with `(corrected)` behind the id of a claim whose corrected statement is
//! meant, and by the name of the theorem. The kernel checks them like all others.

use crate::task::{Goal, Role};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The file.
const FILE: &str = include_str!("../../../proofs/by-hand.json");

/// Tactics by claim, and by the name of the theorem.
type Scripts = BTreeMap<String, BTreeMap<String, String>>;

static SCRIPTS: LazyLock<Scripts> =
    LazyLock::new(|| serde_json::from_str(FILE).unwrap_or_default());

/// The tactics for a theorem of a goal, if somebody wrote them.
#[must_use]
pub fn tactics(goal: &Goal, theorem: &str) -> Option<&'static str> {
    let corrected = match goal.role {
        Role::Corrected => " (corrected)",
        Role::Holds | Role::Refuted => "",
    };
    let scripts = SCRIPTS.get(&format!("{}{corrected}", goal.id))?;
    scripts.get(theorem).map(String::as_str)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_is_read_and_each_script_is_one_tactic() {
        let scripts: Scripts = serde_json::from_str(FILE).unwrap();
        for (claim, theorems) in &scripts {
            for (name, tactics) in theorems {
                assert!(["proved", "refuted", "met"].contains(&name.as_str()));
                assert!(!tactics.contains(['\n']), "{claim}");
                for word in ["admit", "Admitted", "Axiom", "give_up", "Qed", "Abort"] {
                    assert!(!tactics.contains(word), "{claim}");
                }
            }
        }
    }
}
