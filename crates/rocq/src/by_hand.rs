//! Scripts that are written by hand: for theorems whose proofs have an idea of their own.
//!
//! `proofs/by-hand.json` has them by the claim, with `(corrected)` behind the id of a claim whose corrected statement is
//! meant, and by the name of the theorem. The kernel checks them like all others. What several scripts say alike stands once,
//! under `(shared)`: tactics by their names, which the proofs that use them define in front.

use crate::task::{Goal, Role};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The file.
const FILE: &str = include_str!("../../../proofs/by-hand.json");

/// Tactics by claim, and by the name of the theorem.
type Scripts = BTreeMap<String, BTreeMap<String, String>>;

/// Where the tactics stand that several scripts use.
const SHARED: &str = "(shared)";

static SCRIPTS: LazyLock<Scripts> =
    LazyLock::new(|| serde_json::from_str(FILE).unwrap_or_default());

/// The tactics for a theorem of a goal, if somebody wrote them.
#[must_use]
pub fn tactics(goal: &Goal, theorem: &str) -> Option<String> {
    let corrected = match goal.role {
        Role::Corrected => " (corrected)",
        Role::Holds | Role::Refuted => "",
    };
    let scripts = SCRIPTS.get(&format!("{}{corrected}", goal.id))?;
    let script = scripts.get(theorem)?;
    Some(
        SCRIPTS
            .get(SHARED)
            .map_or_else(|| script.clone(), |shared| with_definitions(script, shared)),
    )
}

/// A script with the definitions of the shared tactics that it uses in front.
fn with_definitions(script: &str, shared: &BTreeMap<String, String>) -> String {
    let used = shared.iter().filter(|(name, _)| {
        let mut words = script.split(|c: char| !c.is_alphanumeric() && c != '_');
        words.any(|word| word == name.as_str())
    });
    let definitions: String = used
        .map(|(name, tactic)| format!("let {name} := {tactic} in "))
        .collect();
    definitions + script
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_is_read_and_each_script_is_one_tactic() {
        let scripts: Scripts = serde_json::from_str(FILE).unwrap();
        for (claim, theorems) in &scripts {
            for (name, tactics) in theorems {
                let theorem = ["proved", "refuted", "met"].contains(&name.as_str());
                assert!(theorem || claim == SHARED, "{claim}");
                assert!(!tactics.contains(['\n']), "{claim}");
                for word in ["admit", "Admitted", "Axiom", "give_up", "Qed", "Abort"] {
                    assert!(!tactics.contains(word), "{claim}");
                }
            }
        }
    }

    #[test]
    fn a_script_defines_the_shared_tactics_that_it_uses_and_no_others() {
        let shared = [("one", "idtac"), ("two", "fun x => pose x")];
        let shared = shared.map(|(name, tactic)| (name.to_owned(), tactic.to_owned()));
        let shared = BTreeMap::from(shared);
        let script = with_definitions("intros; two 1; alone", &shared);
        assert_eq!(script, "let two := fun x => pose x in intros; two 1; alone");
        assert_eq!(with_definitions("lra", &shared), "lra");
    }
}
