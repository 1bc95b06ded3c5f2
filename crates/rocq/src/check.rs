//! Files about all other files: the one that asks the kernel for axioms, and the lists.

use crate::modules;
use crate::section::comment;
use std::collections::BTreeMap;

/// The file that asks for the axioms of all theorems.
pub const CHECK: &str = "Check.v";

/// Suffix of the names of files of proofs.
pub(crate) const PROOFS: &str = "_proofs.v";

/// The theorems that a module of proofs may have, with what each says about the statement of its module.
const SAYS: [(&str, &str, &str); 3] = [
    ("proved", "", "statement"),
    ("refuted", "~ ", "statement"),
    ("met", "", "instance"),
];

/// The file of a paper that lists its theorems.
const THEOREMS: &str = "/Theorems.v";

/// Whether a file lists the theorems of a paper.
pub(crate) fn is_list(path: &str) -> bool {
    path.ends_with(THEOREMS)
}

/// Returns the files whose output is the referee's list: one for each paper, with every theorem of its files of proofs
/// and its statement, then the one that asks for the axioms of all.
#[must_use]
pub fn referees(files: &BTreeMap<String, String>) -> Vec<(String, String)> {
    let mut papers: BTreeMap<&str, Vec<(&str, &str)>> = BTreeMap::new();
    for (path, proofs) in files {
        if let Some(section) = path.strip_suffix(PROOFS)
            && let Some((prefix, _)) = section.split_once('/')
        {
            papers.entry(prefix).or_default().push((section, proofs));
        }
    }
    let mut lists = vec![];
    let mut whole = comment("What all theorems assume.") + "\n";
    let mut all = vec![];
    for (prefix, sections) in papers {
        whole.push_str(&format!("From {prefix} Require Theorems.\n"));
        all.push(format!("{prefix}.Theorems.all_theorems"));
        lists.push((format!("{prefix}{THEOREMS}"), list(&sections)));
    }
    whole.push_str(&named(&all));
    whole.push_str("Print Assumptions all_theorems.\n");
    lists.push((CHECK.to_owned(), whole));
    lists
}

/// Writes that file for these sections of a paper.
fn list(sections: &[(&str, &str)]) -> String {
    let mut text = comment("The kernel's word: each theorem has the type of its statement.") + "\n";
    for (section, _) in sections {
        if let Some((prefix, section)) = section.split_once('/') {
            text.push_str(&format!(
                "From {prefix} Require {section} {section}_proofs.\n"
            ));
        }
    }
    let mut parts = vec![];
    for (section, proofs) in sections {
        let path = section.split_once('/').map_or(*section, |(_, name)| name);
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
    text + &named(&parts)
}

/// Makes one term that mentions every proof, so that they are traversed once.
fn named(parts: &[String]) -> String {
    let parts = parts.iter().map(|part| format!("let _ := {part} in\n"));
    format!(
        "Definition all_theorems : True :=\n{}I.\n",
        parts.collect::<String>()
    )
}

/// Writes the list of the files.
#[must_use]
pub fn project(files: &BTreeMap<String, String>) -> String {
    let paths = || files.keys().filter(|path| path.ends_with(".v"));
    let mut prefixes: Vec<&str> = paths()
        .filter_map(|path| Some(path.split_once('/')?.0))
        .collect();
    // The library comes first, since it is read first.
    prefixes.sort_by_key(|prefix| (*prefix != "Torse", *prefix));
    prefixes.dedup();
    // `Check.v` stands beside the folders. If the folder of a file is not listed, `coq_makefile` gives everything below
    // it a name of its own, and no file finds another.
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

/// Returns the files in a list.
pub(crate) fn listed(project: &str) -> impl Iterator<Item = &str> {
    project.lines().filter(|line| line.ends_with(".v"))
}
