//! A report in one minute: what holds, and the most important errors.

use crate::applicability::title;
use crate::corrections::ranked;
use crate::findings::{self, Finding};
use crate::glossary;
use crate::names::printed_names;
use crate::statements::{dependents, is_refuted};
use crate::tally::Tally;
use crate::text::{enumeration, visible};
use crate::view::{FormulaView, correction, formula};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::taxonomy::Verdict;
use torse_typography::Prose;
use torse_verdicts::consequences::{resting, users};
use torse_verdicts::outcome::{Outcome, PaperOutcome};

/// Maximum number of sentences about single statements.
const MAX_ROWS: usize = 5;

/// The summary.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SummaryPage {
    /// How many statements have which verdict, in a sentence.
    pub counts: String,
    /// The most important findings, those with most dependents first.
    pub points: Vec<SummaryFinding>,
    /// How many more statements are false as printed, in words.
    pub rest: Option<String>,
}

/// One of the most important findings.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SummaryFinding {
    /// The finding.
    pub finding: Finding,
    /// A theorem that depends on it and is false too, with its finding.
    pub resting: Option<(String, Prose)>,
    /// The role of the formula.
    pub label: &'static str,
    /// The formula in question.
    pub formula: Option<FormulaView>,
    /// Its dependents, in words; empty if there are none.
    pub consequence: String,
}

/// Summarises a paper; `anchors` holds the identifiers of its claims for links, by position.
pub(crate) fn summarize(paper: &PaperOutcome, anchors: &[String]) -> SummaryPage {
    let claims = &paper.claims;
    let uses = claims
        .iter()
        .map(|of| (of.claim.id.as_str(), of.claim.uses.as_slice()));
    let users = users(uses);
    let refuted: Vec<&Outcome> = claims.iter().filter(|of| is_refuted(of)).collect();
    // A statement that depends on another refuted one is reported with that one, and equal sentences are reported once.
    let followers: BTreeSet<&str> = refuted
        .iter()
        .filter(|of| of.claim.garbled.is_none())
        .flat_map(|of| resting(&of.claim.id, &users))
        .map(|(id, _)| id)
        .collect();
    let mut reported = BTreeSet::new();
    let mut points = Vec::new();
    // Statements about one theorem or example count together.
    let mut groups: BTreeMap<String, usize> = BTreeMap::new();
    for claim in &refuted {
        *groups.entry(group(claim)).or_insert(0) += 1;
    }
    let siblings_of: BTreeMap<String, usize> = groups
        .iter()
        .map(|(name, count)| (name.clone(), count - 1))
        .collect();
    let mut ranked = ranked(paper);
    // A slip in a proof says nothing against the theorem.
    ranked.sort_by_key(|(position, _)| {
        let outcome = claims.get(*position);
        outcome.is_some_and(|outcome| outcome.claim.at.contains("proof of"))
    });
    for (position, (resting, falling)) in ranked {
        let (Some(claim), Some(anchor)) = (claims.get(position), anchors.get(position)) else {
            continue;
        };
        let is_reported = match &claim.claim.author_note {
            Some(finding) => !reported.insert(finding.clone()),
            None => false,
        };
        let follows = followers.contains(claim.claim.id.as_str());
        let new = !is_reported && !follows && claim.claim.garbled.is_none();
        // One point for one theorem or example.
        if points.len() < MAX_ROWS && new && groups.remove(&group(claim)).is_some() {
            let more = siblings_of.get(&group(claim)).copied().unwrap_or(0);
            points.push(point(claim, anchor, (resting, falling, more), paper));
        }
    }
    let left = refuted.len() - points.len();
    SummaryPage {
        counts: counts(claims),
        rest: match left {
            0 => None,
            1 => Some("One more statement is false as printed.".to_owned()),
            _ => Some(format!("{left} more statements are false as printed.")),
        },
        points,
    }
}

/// Returns the theorem or example that a statement belongs to, or its place if there is none.
fn group(outcome: &Outcome) -> String {
    title(outcome).unwrap_or_else(|| outcome.claim.at.clone())
}

/// Returns the theorems and examples with a false statement that depends on a claim.
fn fallen(outcome: &Outcome, paper: &PaperOutcome) -> Vec<String> {
    let own = title(outcome);
    let mut names: Vec<String> = Vec::new();
    for name in dependents(outcome, paper).1.into_iter().filter_map(title) {
        if Some(&name) != own.as_ref() && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// For a claim whose file has no finding, returns a theorem that depends on it and is false too, with the finding about
/// that.
fn theorem_on(outcome: &Outcome, paper: &PaperOutcome) -> Option<(String, Prose)> {
    if outcome.claim.author_note.is_some() {
        return None;
    }
    let mut fallen = dependents(outcome, paper).1.into_iter();
    fallen.find_map(|outcome| {
        outcome.claim.author_note.as_ref()?;
        let name = title(outcome).filter(|name| !name.starts_with("Example"))?;
        Some((
            visible(&name),
            findings::about(outcome, "", &paper.faults).text,
        ))
    })
}

/// Longer formulas, true or printed, are left to the corrections.
const MAX_TRUE_LENGTH: usize = 320;
const MAX_PRINTED_LENGTH: usize = 130;

fn point(
    outcome: &Outcome,
    anchor: &str,
    weight: (usize, usize, usize),
    paper: &PaperOutcome,
) -> SummaryFinding {
    let (resting, falling, more) = weight;
    let names = printed_names(outcome);
    let (label, formula) = match (outcome.correction(), outcome.parsed()) {
        (Some(repair), parsed) => {
            let view = correction(parsed, repair, &names);
            ("should read", Some(view.statement))
        }
        (None, Some(parsed)) => ("as printed", Some(formula(parsed, &names))),
        (None, None) => ("", None),
    };
    let places = fallen(outcome, paper);
    let places = match places.is_empty() {
        true => String::new(),
        false => format!(" ({})", places.join(", ")),
    };
    let consequence = glossary::dependents(resting, falling, &places);
    let others = match more {
        0 => None,
        1 => Some(format!(
            "One more statement of {} is false.",
            visible(&group(outcome))
        )),
        _ => Some(format!(
            "{more} more statements of {} are false.",
            visible(&group(outcome))
        )),
    };
    let consequence: Vec<String> = (consequence.into_iter().chain(others)).collect();
    SummaryFinding {
        finding: findings::about(outcome, anchor, &paper.faults),
        resting: theorem_on(outcome, paper),
        label,
        formula: formula.filter(|view| {
            let letters = view.math.as_ref().map(|math| math.text.chars().count());
            let longest = match outcome.correction() {
                Some(_) => MAX_TRUE_LENGTH,
                None => MAX_PRINTED_LENGTH,
            };
            letters.is_some_and(|letters| letters <= longest)
        }),
        consequence: consequence.join(" "),
    }
}

/// Counts the statements by verdict.
fn counts(claims: &[Outcome]) -> String {
    let tally = Tally::new(claims);
    let count = |verdict| {
        let key = glossary::verdict(verdict).key;
        let rows = tally.rows.iter().filter(|row| row.verdict.key == key);
        rows.map(|row| row.count).sum::<usize>()
    };
    let mut parts = Vec::new();
    let mut part = |count: usize, one: &str, many: &str| match count {
        0 => {}
        1 => parts.push(format!("one {one}")),
        _ => parts.push(format!("{count} {many}")),
    };
    part(count(Verdict::Holds), "holds as printed", "hold as printed");
    part(
        count(Verdict::Conditional),
        "holds under a condition that is not printed",
        "hold under a condition that is not printed",
    );
    part(
        count(Verdict::Misprint),
        "is false and has a small correction that is proved",
        "are false and have a small correction that is proved",
    );
    part(count(Verdict::False), "is false", "are false");
    part(
        count(Verdict::Depends),
        "depends on how it is read",
        "depend on how they are read",
    );
    part(
        count(Verdict::Undecided),
        "was not decided",
        "were not decided",
    );
    let total = glossary::plural(tally.total, "statement");
    let others = others(&tally);
    let decided = match parts.is_empty() {
        true => format!("{total}; nothing was to be decided."),
        false => format!("Of {total}, {}.", enumeration(&parts)),
    };
    format!("{decided}{others}")
}

/// Counts the statements with any other verdict, so that the numbers add up.
fn others(tally: &Tally) -> String {
    const WORDS: [(Verdict, &str, &str); 6] = [
        (Verdict::Definition, "definition", "definitions"),
        (
            Verdict::Reproduced,
            "figure that the printed data give",
            "figures that the printed data give",
        ),
        (
            Verdict::Partial,
            "figure that needs further data",
            "figures that need further data",
        ),
        (
            Verdict::Underspecified,
            "without the data that a decision needs",
            "without the data that a decision needs",
        ),
        (
            Verdict::Vacuous,
            "with hypotheses that exclude each other",
            "with hypotheses that exclude each other",
        ),
        (
            Verdict::OutOfScope,
            "that no computation can decide",
            "that no computation can decide",
        ),
    ];
    let mut sum = 0;
    let mut parts: Vec<String> = Vec::new();
    for (verdict, one, many) in WORDS {
        let key = glossary::verdict(verdict).key;
        let rows = tally.rows.iter().filter(|row| row.verdict.key == key);
        let count = rows.map(|row| row.count).sum::<usize>();
        sum += count;
        match count {
            0 => {}
            1 => parts.push(format!("1 {one}")),
            _ => parts.push(format!("{count} {many}")),
        }
    }
    match (sum, parts.as_slice()) {
        (_, []) => String::new(),
        (1, [only]) => format!(" One more: {only}."),
        (_, [only]) => format!(" The others: {only}."),
        (_, all) => format!(" The other {sum}: {}.", enumeration(all)),
    }
}
