//! Hand-written scripts, for theorems whose proofs need an idea of their own.
//!
//! `proofs/manual/` contains them, a file for each paper. Before each script stand a comment with the claim, and the
//! name of the theorem. After the id, `(corrected)` stands for the corrected statement of the claim, and `(printed)`
//! for its printed statement, if that needs more than the usual tactic. The kernel checks these scripts like all
//! others. `shared.v` contains tactics that several scripts use; the proofs that use them start with their definitions.

use crate::task::{Goal, Role};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The files of scripts, one for each paper.
const FILES: [&str; 8] = [
    include_str!("../proofs/manual/bezier.v"),
    include_str!("../proofs/manual/gbt-developable.v"),
    include_str!("../proofs/manual/gbt-surfaces.v"),
    include_str!("../proofs/manual/hermite-developable.v"),
    include_str!("../proofs/manual/hyperbolic.v"),
    include_str!("../proofs/manual/splines.v"),
    include_str!("../proofs/manual/torses.v"),
    include_str!("../proofs/manual/trigonometric.v"),
];

/// The file of the tactics that several scripts use.
const SHARED: &str = include_str!("../proofs/manual/shared.v");

/// Scripts by the claim and the name of the theorem.
type Scripts = BTreeMap<(&'static str, &'static str), String>;

static SCRIPTS: LazyLock<Scripts> = LazyLock::new(|| FILES.into_iter().flat_map(scripts).collect());
static TACTICS: LazyLock<BTreeMap<&'static str, String>> =
    LazyLock::new(|| tactics_of(SHARED).into_iter().collect());

/// Reads the scripts of a file. A script becomes one line, so the breaks of its lines become spaces.
fn scripts(file: &str) -> Vec<((&str, &str), String)> {
    let mut found = vec![];
    let (mut claim, mut name) = ("", "");
    let mut script: Option<Vec<&str>> = None;
    for line in file.lines() {
        match (&mut script, line) {
            (None, "Proof.") => script = Some(vec![]),
            (Some(lines), "Qed.") => {
                found.push(((claim, name), joined(lines)));
                script = None;
            }
            (Some(lines), line) => lines.push(line),
            (None, line) => {
                if let Some(id) = line.strip_prefix("(* ").and_then(|l| l.strip_suffix(" *)")) {
                    claim = id;
                }
                if let Some(theorem) = line
                    .strip_prefix("Theorem ")
                    .and_then(|l| l.strip_suffix('.'))
                {
                    name = theorem;
                }
            }
        }
    }
    found
}

/// Reads the tactics of a file, by name: each ends before an empty line.
fn tactics_of(file: &str) -> Vec<(&str, String)> {
    let parts = file.split("\n\n");
    let tactics = parts.filter_map(|part| part.strip_prefix("Ltac ")?.split_once(" :=\n"));
    let tactics = tactics.map(|(name, text)| (name, joined(&text.lines().collect::<Vec<_>>())));
    tactics.collect()
}

/// Joins lines, without the point at the end.
fn joined(lines: &[&str]) -> String {
    let lines: Vec<&str> = lines.iter().map(|line| line.trim()).collect();
    let text = lines.join(" ");
    text.strip_suffix('.').unwrap_or(&text).to_owned()
}

/// Returns the hand-written tactics for a theorem of a goal, if there are any.
#[must_use]
pub fn tactics(goal: &Goal, theorem: &str) -> Option<String> {
    let corrected = match goal.role {
        Role::Corrected => " (corrected)",
        Role::Holds | Role::Refuted => "",
    };
    let claim = format!("{}{corrected}", goal.id);
    let script = SCRIPTS.get(&(claim.as_str(), theorem))?;
    Some(with_definitions(script, &TACTICS))
}

/// Returns the tactics by which a printed theorem follows from the proved one, which they call `proved_there`.
#[must_use]
pub fn printed(goal: &Goal, theorem: &str) -> Option<String> {
    let claim = format!("{} (printed)", goal.id);
    SCRIPTS.get(&(claim.as_str(), theorem)).cloned()
}

/// Puts the definitions of the shared tactics that a script uses before it.
fn with_definitions(script: &str, shared: &BTreeMap<&str, String>) -> String {
    let used = shared.iter().filter(|(name, _)| {
        let mut words = script.split(|c: char| !c.is_alphanumeric() && c != '_');
        words.any(|word| word == **name)
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
    fn every_script_has_a_claim_and_a_theorem_and_nothing_that_is_admitted() {
        assert!(SCRIPTS.len() > 700, "{}", SCRIPTS.len());
        let read = FILES.iter().map(|file| file.matches("\nQed.\n").count());
        assert_eq!(read.sum::<usize>(), SCRIPTS.len(), "no theorem twice");
        for ((claim, name), script) in SCRIPTS.iter() {
            // The name of a reading may contain blanks.
            let (paper, id) = claim.split_once('/').unwrap_or_default();
            let is_slug = |c: char| c.is_ascii_alphanumeric() || c == '-';
            assert!(!paper.is_empty() && paper.chars().all(is_slug), "{claim}");
            assert!(!id.is_empty() && id.trim() == id, "{claim}");
            assert!(["proved", "refuted", "met"].contains(name), "{claim}");
            assert!(!script.is_empty(), "{claim}");
            for word in ["admit", "Admitted", "Axiom", "give_up", "Qed", "Abort"] {
                assert!(!script.contains(word), "{claim}");
            }
        }
        assert_eq!(TACTICS.len(), SHARED.matches("\nLtac ").count());
    }

    #[test]
    fn lines_of_a_script_are_joined_and_its_last_point_is_left_out() {
        let file = "(* all of them *)\n\n(* p/a (corrected) *)\nTheorem met.\nProof.\n  one;\n    two.\nQed.\n";
        let wanted = (("p/a (corrected)", "met"), "one; two".to_owned());
        assert_eq!(scripts(file), [wanted]);
        let file = "(* x *)\n\nLtac one :=\n  fun x =>\n    idtac x.\n\nLtac two :=\n  idtac.\n";
        let wanted = [("one", "fun x => idtac x"), ("two", "idtac")];
        assert_eq!(tactics_of(file), wanted.map(|(n, t)| (n, t.to_owned())));
    }

    #[test]
    fn a_script_defines_the_shared_tactics_that_it_uses_and_no_others() {
        let shared = [("one", "idtac"), ("two", "fun x => pose x")];
        let shared = BTreeMap::from(shared.map(|(name, tactic)| (name, tactic.to_owned())));
        let script = with_definitions("intros; two 1; alone", &shared);
        assert_eq!(script, "let two := fun x => pose x in intros; two 1; alone");
        assert_eq!(with_definitions("lra", &shared), "lra");
    }
}
