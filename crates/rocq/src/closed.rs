//! Closed forms of the definitions that statements of a section share: each is computed once, in a file that all proofs
//! of the section use. The tactic `stage` of a script looks there first, and computes what is missing.

use crate::section::{comment, imports};
use crate::shared::{DEFINITIONS, Definition, Shared};
use std::collections::BTreeSet;

/// Suffix of the names of files of closed forms.
pub(crate) const CLOSED: &str = "_closed.v";

/// The definitions that scripts compute one after the other.
#[must_use]
pub fn staged<'t>(scripts: impl IntoIterator<Item = &'t str>) -> BTreeSet<&'t str> {
    let mut names = BTreeSet::new();
    for script in scripts {
        for word in ["stage ", "stage_at ", "staged_goal "] {
            let parts = script.split(word).skip(1);
            names.extend(parts.filter_map(|part| part.split([';', ' ']).next()));
        }
    }
    names
}

/// Writes the file of the closed forms of the shared definitions that are `wanted`; none if there are none.
#[must_use]
pub fn file(
    folder: &str,
    section: &str,
    shared: &Shared,
    wanted: &BTreeSet<&str>,
) -> Option<String> {
    let known = |name: &str| wanted.contains(name);
    let forms: String = shared
        .definitions()
        .iter()
        .filter(|definition| known(&definition.name))
        .map(|definition| form(definition, &known))
        .collect();
    (!forms.is_empty()).then(|| {
        format!(
            "{}\n{}From {folder} Require {section}.\nImport {folder}.{section}.{DEFINITIONS}.\nOpen Scope R_scope.\n{forms}",
            comment("Closed forms of the definitions of a section: nothing here has to be read."),
            imports()
        )
    })
}

/// Writes one closed form, and the line by which `stage` finds it.
fn form(definition: &Definition, known: &dyn Fn(&str) -> bool) -> String {
    let Definition { name, uses, at, .. } = definition;
    let used = uses.iter().filter(|used| known(used));
    let stages: String = used.map(|used| format!("stage {used}; ")).collect();
    let found = match at.is_empty() {
        true => format!("closed_once {name}"),
        false => {
            let values: Vec<String> = at.iter().map(u64::to_string).collect();
            format!("closed_at {name} [{}]%Z", values.join("; "))
        }
    };
    format!(
        "Definition {name}_closed := ltac:({stages}{found}).\n#[export] Instance {name}_is : Closed {name} _ := {name}_closed.\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_definitions_of_scripts_are_found() {
        let names = staged([
            "cbv; stage p; stage_at q' [0; 1]%Z; staged_goal r; identity",
            "ring",
        ]);
        assert_eq!(names.into_iter().collect::<Vec<_>>(), ["p", "q'", "r"]);
    }
}
