//! What was found out, in plain words: one sentence or two for each claim that a reader must know of.

use crate::text::{beginning, name, plain, visible};
use crate::words::{self, Term};
use serde::Serialize;
use torse_language::notation::Formula;
use torse_language::words::Verdict;
use torse_prove::evidence::Witness;
use torse_verdicts::outcome::{Correction, Outcome};

/// Exact values of more characters than this are told by their decimals.
const LONGEST_EXACT_VALUE: usize = 24;

/// Points and conditions of more characters than this are left to the claim's own section.
const LONGEST_LIST: usize = 90;

/// Of what is printed, no more than this many characters is quoted.
const LONGEST_QUOTATION: usize = 110;

/// One finding.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// The claim's id.
    pub id: String,
    /// The id without the paper's slug.
    pub name: String,
    /// The claim's identifier for links.
    pub anchor: String,
    /// Where the paper says it.
    pub at: String,
    /// The verdict.
    pub verdict: Term,
    /// The statement as printed, or its beginning.
    pub printed: String,
    /// What was found, in words.
    pub text: String,
}

/// The findings about `claims`, graver verdicts first and then in file order.
///
/// `anchors` holds the claims' identifiers for links, by position.
pub(crate) fn of(claims: &[Outcome], anchors: &[String]) -> Vec<Finding> {
    const TOLD: [Verdict; 5] = [
        Verdict::False,
        Verdict::Misprint,
        Verdict::Conditional,
        Verdict::Vacuous,
        Verdict::Undecided,
    ];
    let mut findings = Vec::new();
    for verdict in TOLD {
        for (claim, anchor) in claims.iter().zip(anchors) {
            if claim.verdict == verdict {
                findings.push(Finding {
                    id: visible(&claim.id),
                    name: visible(name(&claim.id)),
                    anchor: anchor.clone(),
                    at: visible(&claim.at),
                    verdict: words::verdict(verdict),
                    printed: visible(&beginning(&claim.printed, LONGEST_QUOTATION)),
                    text: visible(&sentence(claim)),
                });
            }
        }
    }
    findings
}

fn sentence(claim: &Outcome) -> String {
    let told = claim.finding.as_deref().map(plain);
    match claim.verdict {
        Verdict::Misprint => {
            let repair = claim.correction.as_ref().map(repaired);
            let repair = repair.unwrap_or_default();
            match told {
                Some(told) => format!("False as printed: {told}.{repair}"),
                None => format!("False as printed.{repair}"),
            }
        }
        Verdict::False => {
            if let Some(told) = told {
                return format!("False: {told}.");
            }
            let at_a_point = || claim.witness.as_ref().map(fails_at);
            match denied(claim).or_else(at_a_point) {
                Some(reason) => format!("False: {reason}."),
                None => "False.".to_owned(),
            }
        }
        Verdict::Conditional => {
            let told = told.map_or_else(String::new, |told| format!(" In words: {told}."));
            match conjunction(&claim.conditions) {
                Some(conditions) => format!("True only under a condition: {conditions}.{told}"),
                None => {
                    format!("True only under a condition, which is stated with the claim.{told}")
                }
            }
        }
        Verdict::Depends => {
            let told = told.map_or_else(String::new, |told| format!(" In words: {told}."));
            let each = claim.readings.iter().map(|reading| {
                let verdict = words::verdict(reading.outcome.verdict).label;
                format!("{verdict} if it says that {}", reading.says)
            });
            let each: Vec<String> = each.collect();
            format!("Depends on the reading: {}.{told}", each.join("; "))
        }
        Verdict::Vacuous => "No point satisfies the assumptions.".to_owned(),
        _ => match &claim.note {
            Some(note) => format!("Not decided. {note}"),
            None => "Not decided.".to_owned(),
        },
    }
}

/// Of a claim that something is not so, refuted by proving that it is so everywhere: just that.
pub(crate) fn denied(claim: &Outcome) -> Option<String> {
    const PROVED: &str = "the negated statement is proved";
    const INSTANCE: &str = "the instance ";
    let steps = || claim.steps.iter();
    if !steps().any(|step| step.starts_with(PROVED)) {
        return None;
    }
    let what = match claim
        .parsed
        .as_ref()
        .map(|formula| equations(&formula.text))
    {
        Some(1) => "the two sides are equal everywhere",
        _ => "what it denies holds everywhere",
    };
    let place = match steps().find_map(|step| step.strip_prefix(INSTANCE)) {
        Some(values) => format!("at {values} "),
        None => String::new(),
    };
    Some(format!("{place}{what}"))
}

/// How many equations a statement of equations consists of; none for one with another relation.
fn equations(statement: &str) -> usize {
    match statement.contains(['<', '>']) || statement.contains("!=") {
        true => 0,
        false => statement.matches("==").count(),
    }
}

fn repaired(repair: &Correction) -> String {
    let edits = repair.edits.join("; ");
    let others = if repair.unique {
        ""
    } else {
        " (other repairs as small exist)"
    };
    format!(" Proved with this change: {edits}{others}.")
}

pub(crate) fn fails_at(witness: &Witness) -> String {
    let values: Vec<String> = witness
        .at
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    let place = match short(values.join(", ")) {
        Some(values) if values.is_empty() => String::new(),
        Some(values) => format!("at {values} "),
        None => "at the point stated with the claim ".to_owned(),
    };
    let left = told(&witness.left, &witness.left_decimal);
    let right = told(&witness.right, &witness.right_decimal);
    if witness.left == witness.right {
        format!("{place}the two sides are equal")
    } else {
        format!("{place}the left side is {left}, the right side {right}")
    }
}

fn told<'a>(exact: &'a str, decimal: &'a str) -> &'a str {
    if exact.chars().count() <= LONGEST_EXACT_VALUE || decimal.is_empty() {
        exact
    } else {
        decimal
    }
}

/// The conditions joined, unless there are none or they are long.
fn conjunction(formulas: &[Formula]) -> Option<String> {
    let texts: Vec<String> = formulas
        .iter()
        .map(|formula| words::condition(&formula.text))
        .collect();
    short(texts.join(" and ")).filter(|text| !text.is_empty())
}

fn short(list: String) -> Option<String> {
    (list.chars().count() <= LONGEST_LIST).then_some(list)
}
