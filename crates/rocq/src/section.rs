//! Files of statements and of proofs, a pair for each section of a paper.
//!
//! Statements are for reading: their files contain no proof and import nothing but `Torse.Defs` and, if functions are
//! declared, `Torse.Functions`, so no proof can change what a statement means.

use crate::jets::has_functions;
use crate::library::LIBRARY;
use crate::name::camel;
use crate::shared::{DEFINITIONS, Shared};
use crate::task::{Goal, Role};

/// Returns the section of a paper that a place such as `Sect. 5.1, eq. (5.3)` belongs to, as the name of a file.
#[must_use]
pub fn section(at: &str) -> String {
    let number = |rest: &str| -> String {
        let kept: String = rest
            .chars()
            .take_while(|c| c.is_ascii_digit() || *c == '.')
            .collect();
        kept.trim_end_matches('.').replace('.', "_")
    };
    for word in ["Sect. ", "Section ", "Sec. "] {
        if let Some((_, rest)) = at.split_once(word) {
            let number = number(rest);
            if !number.is_empty() {
                return format!("Section_{number}");
            }
        }
    }
    match at.split(|c: char| !c.is_ascii_alphabetic()).next() {
        // A reserved word cannot be the name of a file.
        Some(word) if !word.is_empty() => format!("Part_{}", camel(word)),
        _ => "Other".to_owned(),
    }
}

/// Writes a text as a comment of Rocq, which reads quotes and brackets in comments.
#[must_use]
pub fn comment(text: &str) -> String {
    let text = text
        .replace("(*", "( *")
        .replace("*)", "* )")
        .replace('"', "''");
    format!("(* {} *)", text.trim())
}

/// Writes the file of statements of these goals, with their shared definitions first.
#[must_use]
pub fn statements(paper: &str, section: &str, goals: &[Goal], shared: &Shared) -> String {
    let mut text = format!(
        "{}\nFrom Torse Require Import Defs{}.\nOpen Scope R_scope.\n",
        comment(&format!(
            "Statements of {paper}, {}. Nothing is proved here.",
            section.replace('_', " ")
        )),
        match goals.iter().any(|goal| has_functions(&goal.proposition)) {
            true => " Functions",
            false => "",
        }
    );
    text.push_str(&shared.module());
    for goal in goals {
        text.push_str(&statement(goal, &shared.others(goal)));
    }
    text
}

/// Writes the module of the statement of a goal, with these of its definitions.
#[must_use]
pub fn statement(goal: &Goal, definitions: &[&str]) -> String {
    let mut text = format!("\nModule {}.\n", goal.module);
    let corrected = if goal.role == Role::Corrected {
        " (corrected)"
    } else {
        ""
    };
    let about = format!(
        "{}{corrected}, {}\n   printed: {}\n   stated: {}",
        goal.id, goal.at, goal.printed, goal.states
    );
    text.push_str(&comment(&about));
    text.push('\n');
    let proposition = &goal.proposition;
    for definition in definitions {
        text.push_str(definition);
        text.push('\n');
    }
    text.push_str(&format!(
        "Definition statement : Prop :=\n{}.\n",
        proposition.universal()
    ));
    if let (Some(instance), true) = (proposition.instance(), goal.role != Role::Refuted) {
        text.push_str(&format!("Definition instance : Prop :=\n{instance}.\n"));
    }
    text.push_str(&format!("End {}.\n", goal.module));
    text
}

/// Returns the line by which files of proofs use the library.
#[must_use]
pub fn imports() -> String {
    let names = LIBRARY.iter().filter_map(|(path, _)| {
        let (_, file) = path.split_once('/')?;
        file.strip_suffix(".v")
    });
    let names: Vec<&str> = names.collect();
    format!("From Torse Require Import {}.\n", names.join(" "))
}

/// Returns the lines by which proofs of a section use its statements, its shared definitions and their closed forms.
#[must_use]
pub fn uses(folder: &str, section: &str, shared: &Shared, closed: bool) -> String {
    let mut text = format!("From {folder} Require {section}.\n");
    if !shared.definitions().is_empty() {
        text.push_str(&format!("Import {folder}.{section}.{DEFINITIONS}.\n"));
    }
    if closed {
        text.push_str(&format!("From {folder} Require Import {section}_closed.\n"));
    }
    text
}

/// Writes the file of these modules of proofs, with the lines by which they use their section.
#[must_use]
pub fn proofs(uses: &str, modules: &[&str]) -> String {
    let mut text = format!(
        "{}\n{}{uses}Open Scope R_scope.\n",
        comment("Proofs: nothing here has to be read."),
        imports()
    );
    for module in modules {
        text.push_str(module);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_name_their_sections() {
        assert_eq!(section("Sect. 5.1, eq. (5.3), first line"), "Section_5_1");
        assert_eq!(section("eq. (3.11), Sect. 3.4."), "Section_3_4");
        assert_eq!(section("Abstract, last sentence"), "Part_Abstract");
        assert_eq!(section("3"), "Other");
    }

    #[test]
    fn no_text_ends_its_comment() {
        assert_eq!(comment("a *) \"b\" (* c"), "(* a * ) ''b'' ( * c *)");
    }
}
