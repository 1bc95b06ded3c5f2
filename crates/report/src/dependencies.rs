//! The dependencies of a statement, line by line, for every output: hypotheses with their sources, declared sets,
//! definitions.

use serde::Serialize;
use torse_verdicts::claim_record::{Assumed, HypothesisSource, Role};
use torse_verdicts::dependencies::Declared;
use torse_verdicts::outcome::Outcome;

/// Lines under one label.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct DependencyGroup {
    /// The label.
    pub label: &'static str,
    /// The lines, plain text.
    pub lines: Vec<String>,
}

/// Returns all dependencies of the statement, in groups; empty groups are left out.
#[must_use]
pub fn dependency_groups(outcome: &Outcome) -> Vec<DependencyGroup> {
    let table = &outcome.claim.table;
    let by_role = |role: Role| outcome.claim.assumed.iter().filter(move |h| h.role == role);
    let texts = |role| by_role(role).map(|h| h.formula.text.clone()).collect();
    let unknowns = table.unknowns.iter().map(|u| u.text.clone());
    let definitions = table.definitions.iter();
    let bases = table.bases.iter().map(|family| {
        let seeds: Vec<&str> = family.seeds.iter().map(|s| s.text.as_str()).collect();
        let [a, b] = &family.step;
        let step = match family.is_list() {
            true => String::new(),
            false => format!(" and the step factors {} and {}", a.text, b.text),
        };
        format!(
            "{} with {} in degree {}{step}",
            family.head.text,
            seeds.join(", "),
            family.degree
        )
    });
    let groups = [
        ("given", texts(Role::Given)),
        ("solved for", joined(unknowns.collect())),
        (
            "where",
            joined(table.symbols.iter().map(|s| s.set.clone()).collect()),
        ),
        (
            "with",
            definitions
                .map(|d| format!("{} = {}", d.head.text, d.body.text))
                .chain(bases)
                .collect(),
        ),
        (
            "source",
            (outcome.claim.assumed.iter())
                .filter(|hypothesis| concerns(hypothesis, &table.symbols))
                .filter_map(|h| describe_source(h, &str::to_owned))
                .collect(),
        ),
    ];
    let groups = groups
        .into_iter()
        .map(|(label, lines)| DependencyGroup { label, lines });
    groups.filter(|group| !group.lines.is_empty()).collect()
}

/// One line with all of them.
fn joined(items: Vec<String>) -> Vec<String> {
    match items.is_empty() {
        true => vec![],
        false => vec![items.join("; ")],
    }
}

/// Whether a hypothesis concerns the statement: a paper declares the ranges of more symbols than a sentence has.
pub(crate) fn concerns(hypothesis: &Assumed, symbols: &[Declared]) -> bool {
    let text = &hypothesis.formula.text;
    let mut words = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    hypothesis.role != Role::Range || words.any(|word| symbols.iter().any(|s| s.name == word))
}

/// Describes the source of a hypothesis, if the file gives it; `code` writes formulas.
pub(crate) fn describe_source(
    hypothesis: &Assumed,
    code: &dyn Fn(&str) -> String,
) -> Option<String> {
    let formula = code(&hypothesis.formula.text);
    match &hypothesis.from {
        HypothesisSource::Stated => None,
        HypothesisSource::Printed { quote, claim } => {
            Some(format!("{formula}: the paper, “{quote}” ({claim})"))
        }
        HypothesisSource::Ours { reason } => {
            let needed = match hypothesis.needed {
                Some(true) => ", needed",
                Some(false) => ", not needed",
                None => "",
            };
            Some(format!("{formula}: ours{needed}, {reason}"))
        }
    }
}
