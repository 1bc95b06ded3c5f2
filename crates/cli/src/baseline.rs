//! Compares verdicts with those of an earlier run: changed, new and removed ones.

use crate::exit::Failure;
use crate::input;
use crate::terminal;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use torse::selection;

/// Verdicts as `verify --format json` writes them; other fields are ignored.
#[derive(Debug, Deserialize)]
pub struct Verdicts {
    claims: Vec<Claim>,
}

#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
struct Claim {
    id: String,
    verdict: String,
    evidence: Option<String>,
    condition: Option<String>,
}

impl Claim {
    fn describe(&self) -> String {
        let evidence = self.evidence.as_ref().map(|e| format!(" ({e})"));
        let condition = self.condition.as_ref().map(|c| format!(", if {c}"));
        let [evidence, condition] = [evidence, condition].map(Option::unwrap_or_default);
        format!("{}{evidence}{condition}", self.verdict)
    }
}

impl Verdicts {
    /// Reads the verdicts of a file.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let unreadable = |reason: String| Failure::Against {
            path: path.to_owned(),
            reason,
        };
        Self::parse(&input::text(path)?).map_err(|error| unreadable(error.to_string()))
    }

    /// Parses verdicts.
    pub fn parse(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }

    /// Returns the claims that one of these names refers to, or all if there are no names.
    pub fn named(mut self, names: &[String]) -> Self {
        let is_named = |claim: &Claim| names.iter().any(|name| selection::means(name, &claim.id));
        self.claims
            .retain(|claim| names.is_empty() || is_named(claim));
        self
    }
}

/// A claim with its old and its new verdict; none if it is new or removed.
type Difference = (String, Option<String>, Option<String>);

/// Returns the differences, by id.
pub fn differences(before: &Verdicts, now: &Verdicts) -> Vec<Difference> {
    let by_id = |of: &'_ Verdicts| -> BTreeMap<String, Claim> {
        let pairs = of
            .claims
            .iter()
            .map(|claim| (claim.id.clone(), claim.clone()));
        pairs.collect()
    };
    let (before, now) = (by_id(before), by_id(now));
    let ids: BTreeSet<&String> = before.keys().chain(now.keys()).collect();
    let changed = ids.into_iter().filter(|id| before.get(*id) != now.get(*id));
    let describe = |of: Option<&Claim>| of.map(Claim::describe);
    changed
        .map(|id| (id.clone(), describe(before.get(id)), describe(now.get(id))))
        .collect()
}

/// Writes the table of differences, or that there are none.
pub fn text(differences: &[Difference]) -> String {
    if differences.is_empty() {
        return "no verdict, evidence or condition differs\n".to_owned();
    }
    let mut table = terminal::table();
    table.set_header(["claim", "was", "is"]);
    for (id, before, now) in differences {
        let was = before.as_deref().unwrap_or("- (new)");
        let is = now.as_deref().unwrap_or("- (gone)");
        table.add_row([id.as_str(), was, is]);
    }
    terminal::lines(&table)
}
