//! The two files that describe all others: what the kernel is asked about them, and their list.

use crate::chapter::comment;
use crate::modules;
use std::collections::BTreeMap;

/// The end of the names of the files of proofs.
pub(crate) const PROOFS: &str = "_proofs.v";

/// The theorems that a module of proofs may have, and what they say of their module of statements.
const SAYS: [(&str, &str, &str); 3] = [
    ("proved", "", "statement"),
    ("refuted", "~ ", "statement"),
    ("met", "", "instance"),
];

/// The file whose output is the referee's list: every theorem of the files of proofs with the statement it has, and the
/// axioms of all.
#[must_use]
pub fn referee(files: &BTreeMap<String, String>) -> String {
    let mut text = comment(
        "The kernel's word: each theorem has the type of its statement, and what all of them assume.",
    );
    text.push('\n');
    let sections: Vec<(&str, &str)> = files
        .iter()
        .filter_map(|(path, proofs)| Some((path.strip_suffix(PROOFS)?, proofs.as_str())))
        .collect();
    for (section, _) in &sections {
        if let Some((prefix, section)) = section.split_once('/') {
            text.push_str(&format!(
                "From {prefix} Require {section} {section}_proofs.\n"
            ));
        }
    }
    let mut parts = vec![];
    for (section, proofs) in sections {
        let path = section.replace('/', ".");
        for (module, body) in modules::split(proofs).modules {
            for (name, negation, what) in SAYS {
                if !body.contains(&format!("\nTheorem {name} :")) {
                    continue;
                }
                let proof = format!("{path}_proofs.{module}.{name}");
                text.push_str(&format!(
                    "Check ({proof} : {negation}{path}.{module}.{what}).\n"
                ));
                parts.push(proof);
            }
        }
    }
    // One walk over all proofs: a term that names each.
    text.push_str("Definition all_theorems : True :=\n");
    for part in parts {
        text.push_str(&format!("let _ := {part} in\n"));
    }
    text.push_str("I.\nPrint Assumptions all_theorems.\n");
    text
}

/// The list of the files.
#[must_use]
pub fn project(files: &BTreeMap<String, String>) -> String {
    let paths = || files.keys().filter(|path| path.ends_with(".v"));
    let mut prefixes: Vec<&str> = paths()
        .filter_map(|path| Some(path.split_once('/')?.0))
        .collect();
    // The library stands first, as it is read first.
    prefixes.sort_by_key(|prefix| (*prefix != "Torse", *prefix));
    prefixes.dedup();
    // `Check.v` stands beside the folders. Where the folder of a file is not named, `coq_makefile` gives all below it a
    // name of its own, and no file finds another.
    let mut text = "-I .\n".to_owned();
    for prefix in prefixes {
        text.push_str(&format!("-Q {prefix} {prefix}\n"));
    }
    text.push_str("-arg -w -arg none\n");
    for path in paths() {
        text.push_str(&format!("{path}\n"));
    }
    text
}

/// The files that a list names.
pub(crate) fn listed(project: &str) -> impl Iterator<Item = &str> {
    project.lines().filter(|line| line.ends_with(".v"))
}
