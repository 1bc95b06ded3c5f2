//! Statements as they are printed, and that they follow from what is proved.
//!
//! The statement of a claim is written twice: from core terms, as it is proved, and from the tree, as it is read. They stand in
//! sections of their own, `Section_3_4` and `Section_3_4_printed`. Mostly they are the same by conversion, so that a proof of the one is
//! a proof of the other; the tactic `follows` of `Torse/Follows.v` knows besides what to do where premises stand in another
//! order. A difference that it does not bridge is a fault of one of the two writers, and no theorem.

use crate::chapter::comment;
use crate::check::PROOFS;
use crate::script::Script;
use crate::task::Goal;
use crate::theorem::Theorem;

/// The end of the names of sections of statements that are written from the tree.
pub const PRINTED: &str = "_printed";

/// The tactic, as a file of the folder. Nothing is proved with it but what is printed.
pub const FOLLOWS: (&str, &str) = (
    "Torse/Follows.v",
    include_str!("../../../proofs/Torse/Follows.v"),
);

/// The section of what is proved, of a section of statements that are written from the tree.
#[must_use]
pub fn proved(section: &str) -> Option<&str> {
    section.strip_suffix(PRINTED)
}

/// The name of the module of files of proofs, without the end of the file.
fn proofs() -> &'static str {
    PROOFS.trim_end_matches(".v")
}

/// The file of these modules of theorems, with the lines by which they use their statements and what is proved.
#[must_use]
pub fn file(folder: &str, section: &str, modules: &[&str]) -> String {
    let head = format!(
        "{}\nFrom Torse Require Import Defs Follows.\n\
         From {folder} Require {section}{PRINTED} {section}{}.\nOpen Scope R_scope.\n",
        comment("What is printed follows from what is proved: nothing here has to be read."),
        proofs()
    );
    modules.iter().fold(head, |text, module| text + module)
}

/// The module of the theorems of one claim: for each script one of the statement that is printed, which may have no premises to meet.
#[must_use]
pub fn module(folder: &str, section: &str, goal: &Goal, scripts: &[Script]) -> String {
    let module = &goal.module;
    let is_free = goal.proposition.premises.is_empty();
    let scripts = scripts
        .iter()
        .filter(|script| script.says != "instance" || !is_free);
    let mut text = format!("\nModule {module}.\nImport {folder}.{section}{PRINTED}.{module}.\n");
    for Script { name, says, .. } in scripts {
        let proved = format!("{folder}.{section}{}.{module}.{name}", proofs());
        text.push_str(&format!(
            "Theorem {name} : {says}.\nProof. follows {proved}. Qed.\n"
        ));
    }
    text.push_str(&format!("End {module}.\n"));
    text
}

/// The head of a file in which it is tried whether what is printed follows, whatever became of the proofs.
#[must_use]
pub fn head(section: &str) -> String {
    let core = proved(section).unwrap_or(section);
    let (folder, name) = section.split_once('/').unwrap_or(("", section));
    let core = core.split_once('/').map_or(core, |(_, name)| name);
    format!(
        "From Torse Require Import Defs Follows.\nFrom {folder} Require {core} {name}.\nOpen Scope R_scope.\n"
    )
}

/// The module of a theorem with what is proved as a premise.
#[must_use]
pub fn alone(theorem: &Theorem) -> String {
    let core = proved(&theorem.section).unwrap_or(&theorem.section);
    let core = core.replace('/', ".");
    let printed = theorem.section.replace('/', ".");
    let module = &theorem.module;
    let mut text = format!("\nModule {module}.\n");
    let lines = theorem.proof.lines();
    let theorems = lines.filter_map(|line| line.strip_prefix("Theorem ")?.strip_suffix('.'));
    for (name, says) in theorems.filter_map(|line| line.split_once(" : ")) {
        let (negation, what) = match says.strip_prefix("~ ") {
            Some(what) => ("~ ", what),
            None => ("", says),
        };
        text.push_str(&format!(
            "Theorem {name} : {negation}{core}.{module}.{what} -> {negation}{printed}.{module}.{what}.\n\
             Proof. let H := fresh in (intro H; follows H). Qed.\n"
        ));
    }
    text.push_str(&format!("End {module}.\n"));
    text
}
