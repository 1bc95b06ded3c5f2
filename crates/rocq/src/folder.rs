//! The folder of proofs: a deterministic set of files, from the results for claims.

use crate::check::PROOFS;
use crate::closed::CLOSED;
use crate::equal_definitions::{Equations, SharedEquations};
use crate::gap::Untranslatable;
use crate::library::LIBRARY;
use crate::name::camel;
use crate::printed::{self, FOLLOWS, FUNCTIONS, JETS, PRINTED};
use crate::script::{self, scripts};
use crate::shared::Shared;
use crate::task::{Goal, ProofTask, goals};
use crate::theorem::{RestsOn, Theorem};
use crate::{check, closed, modules, section};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use torse_certificate::Evidence;

/// The page that says how to check and what to trust.
pub const README: &str = include_str!("../proofs/README.md");

/// The file of the theorems whose proof scripts are known to fail, with reasons.
pub const UNPROVED: &str = "unproved.json";

/// Reads the theorems of a folder whose scripts are known to fail, with reasons; empty if there is no list.
///
/// # Errors
/// The message of the parser, if the list cannot be read.
pub fn unproved(folder: &Path) -> Result<BTreeMap<String, String>, String> {
    match std::fs::read_to_string(folder.join(UNPROVED)) {
        Ok(text) => serde_json::from_str(&text).map_err(|error| error.to_string()),
        Err(_) => Ok(BTreeMap::new()),
    }
}

/// The file of the theorems that another script proves than the one that the verdict names.
pub const SCRIPTS: &str = "scripts.json";

/// Reads scripts.json: theorem -> index of the script that proves it (empty if missing).
#[must_use]
pub fn chosen(folder: &Path) -> BTreeMap<String, usize> {
    let text = std::fs::read_to_string(folder.join(SCRIPTS)).unwrap_or_default();
    serde_json::from_str(&text).unwrap_or_default()
}

/// The file of the theorems that the kernel accepted.
pub const ACCEPTED: &str = "accepted.json";

/// The file of the claims without a statement, with reasons.
pub const NOT_STATED: &str = "not-stated.json";

/// The file of the claims whose statements are not written from the tree, with reasons.
pub const NOT_PRINTED: &str = "not-printed.json";

/// The file that lists the files for `coq_makefile`.
pub const PROJECT: &str = "_CoqProject";

/// A claim, or a part of its verdict, for which no proof is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Missing {
    /// The id of the claim.
    pub id: String,
    /// The evidence of the verdict, if it has any.
    pub evidence: Option<Evidence>,
    /// The reason.
    pub reason: String,
}

/// The files of a folder of proofs.
#[derive(Debug, Clone, Default)]
pub struct Folder {
    /// Paths below the folder, with their texts.
    pub files: BTreeMap<String, String>,
    /// The theorems with a proof.
    pub theorems: Vec<Theorem>,
    /// The theorems without a proof.
    pub missing: Vec<Missing>,
    /// The claims without a statement, with reasons.
    pub not_stated: BTreeMap<String, String>,
    /// The claims whose statements are not written from the tree, and why.
    pub not_printed: BTreeMap<String, String>,
    /// The ids of all claims it was made for.
    pub requested: BTreeSet<String>,
    /// Where definitions stand.
    layout: Layout,
}

/// Where definitions shared by several statements of a section stand.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Layout {
    /// Once, before the statements of the section.
    #[default]
    Together,
    /// In each module: the folder is for some claims of its sections.
    Apart,
}

impl Layout {
    fn shared(self, goals: &[Goal]) -> Shared {
        match self {
            Self::Together => Shared::from_goals(goals),
            Self::Apart => Shared::default(),
        }
    }
}

impl Folder {
    /// Makes the folder for these papers. Theorems named in `unproved` get a statement and no proof.
    #[must_use]
    pub fn new(
        papers: &[(String, Vec<ProofTask<'_>>)],
        unproved: &BTreeMap<String, String>,
    ) -> Self {
        Self::with_scripts(papers, unproved, &BTreeMap::new(), Layout::default())
    }

    /// Makes the same folder with the scripts found to prove what the first ones do not.
    #[must_use]
    pub fn with_scripts(
        papers: &[(String, Vec<ProofTask<'_>>)],
        unproved: &BTreeMap<String, String>,
        chosen: &BTreeMap<String, usize>,
        layout: Layout,
    ) -> Self {
        let mut folder = Self {
            layout,
            ..Self::default()
        };
        for (path, text) in LIBRARY {
            folder.files.insert(path.to_owned(), text.to_owned());
        }
        folder
            .files
            .insert("README.md".to_owned(), README.to_owned());
        for (slug, tasks) in papers {
            let prefix = camel(slug);
            folder.paper(slug, &prefix, tasks, unproved, chosen);
        }
        for (path, text) in [FOLLOWS, FUNCTIONS, JETS] {
            folder.files.insert(path.to_owned(), text.to_owned());
        }
        folder
            .files
            .insert(NOT_PRINTED.to_owned(), listed(&folder.not_printed));
        let lists = check::referees(&folder.files);
        folder.files.extend(lists);
        folder
            .files
            .insert(NOT_STATED.to_owned(), listed(&folder.not_stated));
        folder
            .files
            .insert(PROJECT.to_owned(), check::project(&folder.files));
        folder
    }

    /// Returns the sections with theorems, in the order of the files.
    #[must_use]
    pub fn sections(&self) -> Vec<&str> {
        let mut sections: Vec<&str> = self.theorems.iter().map(|t| t.section.as_str()).collect();
        sections.dedup();
        sections
    }

    /// Returns the theorems of a section.
    #[must_use]
    pub fn theorems_of(&self, section: &str) -> Vec<&Theorem> {
        let all = self.theorems.iter();
        all.filter(|theorem| theorem.section == section).collect()
    }

    /// Returns the same folder with the theorems of some sections alone.
    #[must_use]
    pub fn of_sections(&self, sections: &BTreeSet<&str>) -> Self {
        let mut folder = self.clone();
        folder
            .theorems
            .retain(|theorem| sections.contains(theorem.section.as_str()));
        folder
    }

    /// Returns the same folder with some theorems alone, by name; the files of proofs contain no others.
    #[must_use]
    pub fn of_theorems(&self, names: &BTreeSet<String>) -> Self {
        let mut folder = self.clone();
        folder
            .theorems
            .retain(|theorem| names.contains(&theorem.name()));
        let files = folder.files.into_iter().filter_map(|(path, text)| {
            let Some(section) = path.strip_suffix(PROOFS) else {
                return Some((path, text));
            };
            let is_named = |module: &str| names.contains(&format!("{section}.{module}"));
            Some((path.clone(), modules::with_some(&text, is_named)?))
        });
        folder.files = files.collect();
        folder
    }

    fn paper(
        &mut self,
        slug: &str,
        prefix: &str,
        tasks: &[ProofTask<'_>],
        unproved: &BTreeMap<String, String>,
        chosen: &BTreeMap<String, usize>,
    ) {
        let mut sections: BTreeMap<String, Vec<Goal>> = BTreeMap::new();
        for task in tasks {
            self.requested.insert(task.id.clone());
            match goals(task) {
                Ok(found) => {
                    for goal in found {
                        sections
                            .entry(section::section(&goal.at))
                            .or_default()
                            .push(goal);
                    }
                }
                Err(gap) => {
                    self.not_stated.insert(task.id.clone(), gap.to_string());
                    self.lacks(&task.id, task.evidence, &gap);
                }
            }
        }
        for (section, mut goals) in sections {
            let mut names = BTreeSet::new();
            for goal in &mut goals {
                while !names.insert(goal.module.clone()) {
                    goal.module.push('_');
                }
            }
            let path = format!("{prefix}/{section}");
            let shared = self.layout.shared(&goals);
            self.files.insert(
                format!("{path}.v"),
                section::statements(slug, &section, &goals, &shared, section::claim),
            );
            let (printed, shared_print) = self.printed(slug, prefix, &section, &goals);
            let equations = SharedEquations::new(&section, &shared_print, &shared);
            let (mut proved, mut followed) = (vec![], vec![]);
            for goal in &goals {
                let name = format!("{path}.{}", goal.module);
                let which = chosen.get(&name).copied().unwrap_or_default();
                let scripts = match (unproved.get(&name), scripts(goal, which)) {
                    (None, Some(scripts)) => scripts,
                    (reason, _) => {
                        let unknown = || format!("there is no script {which}");
                        self.missing.push(Missing {
                            id: goal.id.clone(),
                            evidence: Some(goal.evidence),
                            reason: reason.cloned().unwrap_or_else(unknown),
                        });
                        continue;
                    }
                };
                let proof = script::module(prefix, &section, goal, &scripts);
                proved.push(proof.clone());
                self.theorems.push(Theorem {
                    section: path.clone(),
                    module: goal.module.clone(),
                    id: goal.id.clone(),
                    role: goal.role,
                    evidence: goal.evidence,
                    says: section::statement(goal, &goal.definitions()),
                    proof,
                    rests_on: None,
                });
                let Some(printed) = printed.get(&goal.module) else {
                    continue;
                };
                let own = format!("{path}{PRINTED}");
                if let Some(reason) = unproved.get(&format!("{own}.{}", goal.module)) {
                    self.missing.push(Missing {
                        id: goal.id.clone(),
                        evidence: Some(goal.evidence),
                        reason: reason.clone(),
                    });
                    continue;
                }
                let equations = Equations::new(
                    &section,
                    &equations,
                    (&shared_print, &shared),
                    (printed, goal),
                );
                let proof = printed::module(&section, (printed, goal), &equations, &scripts);
                let plain =
                    printed::module(&section, (printed, goal), &Equations::default(), &scripts);
                followed.push(Theorem {
                    section: own,
                    module: goal.module.clone(),
                    id: goal.id.clone(),
                    role: goal.role,
                    evidence: goal.evidence,
                    says: section::statement(printed, &printed.definitions()),
                    proof,
                    rests_on: Some(RestsOn {
                        statement: section::statement(goal, &goal.definitions()),
                        plain_proof: plain,
                    }),
                });
            }
            if !proved.is_empty() {
                let proved: Vec<&str> = proved.iter().map(String::as_str).collect();
                let staged = closed::staged(proved.iter().copied());
                let forms = closed::file(prefix, &section, &shared, &staged);
                let uses = section::uses(prefix, &section, &shared, forms.is_some());
                if let Some(forms) = forms {
                    self.files.insert(format!("{path}{CLOSED}"), forms);
                }
                self.files
                    .insert(format!("{path}{PROOFS}"), section::proofs(&uses, &proved));
            }
            if !followed.is_empty() {
                let modules: Vec<&str> = followed.iter().map(|t| t.proof.as_str()).collect();
                self.files.insert(
                    format!("{path}{PRINTED}{PROOFS}"),
                    printed::file(
                        prefix,
                        &section,
                        &equations.lines(&format!("{section}{PRINTED}")),
                        &modules,
                    ),
                );
                self.theorems.extend(followed);
            }
        }
    }

    /// Returns the goals of a section with the printed statements, by their modules, and what they share; writes the
    /// file of these statements.
    fn printed(
        &mut self,
        slug: &str,
        prefix: &str,
        section: &str,
        goals: &[Goal],
    ) -> (BTreeMap<String, Goal>, Shared) {
        let mut printed = vec![];
        for goal in goals {
            match goal.as_printed() {
                Ok(goal) => printed.push(goal),
                Err(gap) => {
                    self.not_printed.insert(goal.id.clone(), gap.to_string());
                }
            }
        }
        let shared = self.layout.shared(&printed);
        if !printed.is_empty() {
            self.files.insert(
                format!("{prefix}/{section}{PRINTED}.v"),
                section::statements(slug, section, &printed, &shared, section::print),
            );
        }
        let named = printed.into_iter();
        let named = named.map(|goal| (goal.module.clone(), goal)).collect();
        (named, shared)
    }

    fn lacks(&mut self, id: &str, evidence: Option<Evidence>, gap: &Untranslatable) {
        self.missing.push(Missing {
            id: id.to_owned(),
            evidence,
            reason: gap.to_string(),
        });
    }
}

/// Writes a list of names and reasons as a file.
pub(crate) fn listed(reasons: &BTreeMap<String, String>) -> String {
    let text = serde_json::to_string_pretty(reasons);
    text.map_or_else(|_| String::new(), |text| text + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::task::Role;

    fn theorem(section: &str, module: &str) -> Theorem {
        Theorem {
            section: section.to_owned(),
            module: module.to_owned(),
            id: format!("paper/{module}"),
            role: Role::Holds,
            evidence: Evidence::Identity,
            says: "True".to_owned(),
            proof: "exact I".to_owned(),
            rests_on: None,
        }
    }

    #[test]
    fn a_folder_of_some_theorems_has_their_proofs_alone() {
        let proofs = "head\n\nModule a.\nEnd a.\n\nModule b.\nEnd b.\n";
        let folder = Folder {
            files: BTreeMap::from([
                ("P/One.v".to_owned(), "statements".to_owned()),
                ("P/One_proofs.v".to_owned(), proofs.to_owned()),
                ("P/Two_proofs.v".to_owned(), proofs.to_owned()),
            ]),
            theorems: vec![
                theorem("P/One", "a"),
                theorem("P/One", "b"),
                theorem("P/Two", "a"),
            ],
            ..Folder::default()
        };
        let some = folder.of_theorems(&BTreeSet::from(["P/One.b".to_owned()]));
        assert_eq!(some.theorems, [theorem("P/One", "b")]);
        let left: Vec<(&str, &str)> = some
            .files
            .iter()
            .map(|(path, text)| (path.as_str(), text.as_str()))
            .collect();
        assert_eq!(
            left,
            [
                ("P/One.v", "statements"),
                ("P/One_proofs.v", "head\n\nModule b.\nEnd b.\n"),
            ]
        );
    }

    #[test]
    fn a_folder_of_some_sections_has_their_theorems_and_all_files() {
        let folder = Folder {
            files: BTreeMap::from([("P/Two.v".to_owned(), String::new())]),
            theorems: vec![theorem("P/One", "a"), theorem("P/Two", "b")],
            ..Folder::default()
        };
        let some = folder.of_sections(&BTreeSet::from(["P/One"]));
        assert_eq!(some.theorems, [theorem("P/One", "a")]);
        assert_eq!(some.files, folder.files);
        let none = folder.of_sections(&BTreeSet::new());
        assert!(none.sections().is_empty());
    }
}
