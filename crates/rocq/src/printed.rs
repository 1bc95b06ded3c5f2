//! Printed statements, and how they follow from the proved ones.
//!
//! The statement of a claim is written twice: from core terms, as it is proved, and from the tree, as it is read. They
//! stand in separate sections, `Section_3_4` and `Section_3_4_printed`. Usually they are convertible, so that a proof
//! of one is a proof of the other; the tactic `follows` of `Torse/Follows.v` also handles premises in another order. A
//! difference that it does not bridge is a fault of one of the two writers, and no theorem. If functions are declared,
//! the proved statement is about numbers; see the module `jets`.

use crate::check::PROOFS;
use crate::proposition::Proposition;
use crate::script::Script;
use crate::section::comment;
use crate::task::{Goal, Role};
use crate::theorem::Theorem;
use crate::{jets, manual_proofs};

/// Suffix of the names of sections of statements that are written from the tree.
pub const PRINTED: &str = "_printed";

/// The tactic, as a file of the folder. It proves printed statements only.
pub const FOLLOWS: (&str, &str) = ("Torse/Follows.v", include_str!("../proofs/Torse/Follows.v"));

/// The further imports if functions are declared.
pub const JETS: (&str, &str) = ("Torse/Jets.v", include_str!("../proofs/Torse/Jets.v"));

/// The definition of declared functions, as a file of the folder: statements with functions use it.
pub const FUNCTIONS: (&str, &str) = (
    "Torse/Functions.v",
    include_str!("../proofs/Torse/Functions.v"),
);

/// Whether a proof needs it.
pub(crate) fn uses_jets(proof: &str) -> bool {
    proof.contains("by_jets")
}

/// Returns the line by which files of such proofs use the library.
fn imports<'p>(mut proofs: impl Iterator<Item = &'p str>) -> &'static str {
    match proofs.any(uses_jets) {
        true => "From Torse Require Import Defs Follows Jets.\n",
        false => "From Torse Require Import Defs Follows.\n",
    }
}

/// Returns the section of proved statements for a section of statements that are written from the tree.
#[must_use]
pub fn proved(section: &str) -> Option<&str> {
    section.strip_suffix(PRINTED)
}

/// Returns the name of the module of a file of proofs, without the extension of the file.
fn proofs() -> &'static str {
    PROOFS.trim_end_matches(".v")
}

/// Writes the file of these modules of theorems, with the lines by which they use their statements and the proved ones.
#[must_use]
pub fn file(folder: &str, section: &str, modules: &[&str]) -> String {
    let head = format!(
        "{}\n{}From {folder} Require {section}{PRINTED} {section}{}.\nOpen Scope R_scope.\n",
        comment("What is printed follows from what is proved: nothing here has to be read."),
        imports(modules.iter().copied()),
        proofs()
    );
    modules.iter().fold(head, |text, module| text + module)
}

/// The proved statement, if it stands as a premise.
const PROVED_THERE: &str = "proved_there";

/// Writes the module of the theorems of one claim: for each script a theorem about the printed statement, which may
/// have no premises to satisfy.
#[must_use]
pub fn module(
    folder: &str,
    section: &str,
    printed: &Goal,
    core: &Goal,
    scripts: &[Script],
) -> String {
    let module = &printed.module;
    let is_free = printed.proposition.premises.is_empty();
    let scripts = scripts
        .iter()
        .filter(|script| script.says != "instance" || !is_free);
    let mut text = format!("\nModule {module}.\nImport {folder}.{section}{PRINTED}.{module}.\n");
    for Script { name, says, .. } in scripts {
        let proved = format!("{folder}.{section}{}.{module}.{name}", proofs());
        text.push_str(&format!(
            "Theorem {name} : {says}.\nProof. {}. Qed.\n",
            tactics(&proved, says, printed, core)
        ));
    }
    // The proved statement may have no premises, while functions have to be smooth.
    if jets::has_functions(&printed.proposition)
        && core.proposition.premises.is_empty()
        && printed.role != Role::Refuted
        && let Some(values) = jets::polynomials(&no_numbers(core), &printed.proposition)
    {
        text.push_str(&format!(
            "Theorem met : instance.\nProof. hnf; exists {}; met_by_jets. Qed.\n",
            values.join(", ")
        ));
    }
    text.push_str(&format!("End {module}.\n"));
    text
}

/// Returns the same text without binders.
fn no_numbers(core: &Goal) -> Proposition {
    Proposition {
        binders: vec![],
        ..core.proposition.clone()
    }
}

/// Returns the tactics by which the printed statement follows from the proved one with this name.
fn tactics(proved: &str, says: &str, printed: &Goal, core: &Goal) -> String {
    let name = match says {
        "statement" => "proved",
        "instance" => "met",
        _ => "refuted",
    };
    if let Some(script) = manual_proofs::printed(printed, name) {
        return script.replace(PROVED_THERE, proved);
    }
    let (printed, core) = (&printed.proposition, &core.proposition);
    let by_jets = || -> Option<String> {
        Some(match says {
            "statement" => format!(
                "hnf; intros {}; by_jets ({proved} {})",
                jets::names(printed).join(" "),
                jets::numbers(core, printed)?.join(" ")
            ),
            "instance" => format!(
                "destruct {proved} as {}; hnf; exists {}; there_by_jets there",
                jets::names(core)
                    .iter()
                    .rfold("there".to_owned(), |rest, name| format!("[{name} {rest}]")),
                jets::polynomials(core, printed)?.join(", ")
            ),
            _ => format!(
                "intro all; apply {proved}; hnf; intros {}; by_jets (all {})",
                jets::names(core).join(" "),
                jets::polynomials(core, printed)?.join(" ")
            ),
        })
    };
    let tactics = jets::has_functions(printed).then(by_jets).flatten();
    tactics.unwrap_or_else(|| format!("follows {proved}"))
}

/// Writes the head of a file that tests whether printed statements follow, independently of the proofs.
#[must_use]
pub fn head(section: &str, theorems: &[&Theorem]) -> String {
    let core = proved(section).unwrap_or(section);
    let (folder, name) = section.split_once('/').unwrap_or(("", section));
    let core = core.split_once('/').map_or(core, |(_, name)| name);
    format!(
        "{}From {folder} Require {core} {name}.\nOpen Scope R_scope.\n",
        imports(theorems.iter().map(|theorem| theorem.proof.as_str()))
    )
}

/// Writes the module of a theorem with the proved statement as a premise, where its proof uses that one.
#[must_use]
pub fn alone(theorem: &Theorem) -> String {
    let core = proved(&theorem.section).unwrap_or(&theorem.section);
    let core = core.replace('/', ".");
    let printed = theorem.section.replace('/', ".");
    let module = &theorem.module;
    let mut text = format!("\nModule {module}.\n");
    let mut named = None;
    for line in theorem.proof.lines() {
        let says = line.strip_prefix("Theorem ");
        if let Some(says) = says.and_then(|line| line.strip_suffix('.')?.split_once(" : ")) {
            named = Some(says);
            continue;
        }
        let tactics = line.strip_prefix("Proof. ");
        let Some(((name, says), tactics)) = named.take().zip(tactics) else {
            continue;
        };
        let (negation, what) = match says.strip_prefix("~ ") {
            Some(what) => ("~ ", what),
            None => ("", says),
        };
        let premise = format!("{core}{}.{module}.{name}", proofs());
        // A proved statement without premises has no instance; the printed one has, since functions are smooth.
        let (implied_by, introduced) = match tactics.contains(&premise) {
            true => (
                format!("{negation}{core}.{module}.{what} -> "),
                format!("intro {PROVED_THERE}; "),
            ),
            false => Default::default(),
        };
        let tactics = tactics.replace(&premise, PROVED_THERE);
        text.push_str(&format!(
            "Theorem {name} : {implied_by}{negation}{printed}.{module}.{what}.\nProof. {introduced}{tactics}\n"
        ));
    }
    text.push_str(&format!("End {module}.\n"));
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::task::Evidence;

    #[test]
    fn alone_a_theorem_has_the_proved_statement_as_a_premise_only_where_its_proof_uses_it() {
        let theorem = Theorem {
            section: "P/S_printed".to_owned(),
            module: "a".to_owned(),
            id: "p/a".to_owned(),
            role: Role::Holds,
            evidence: Evidence::Identity,
            says: String::new(),
            proof:
                "Module a.\nTheorem proved : statement.\nProof. follows P.S_proofs.a.proved. Qed.\n\
                    Theorem met : instance.\nProof. hnf; exists 0. Qed.\nEnd a.\n"
                    .to_owned(),
            rests_on: Some(String::new()),
        };
        assert_eq!(
            alone(&theorem),
            "\nModule a.\n\
             Theorem proved : P.S.a.statement -> P.S_printed.a.statement.\n\
             Proof. intro proved_there; follows proved_there. Qed.\n\
             Theorem met : P.S_printed.a.instance.\nProof. hnf; exists 0. Qed.\nEnd a.\n"
        );
    }
}
