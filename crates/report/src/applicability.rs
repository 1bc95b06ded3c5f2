//! Whether a reader can use what a paper builds and names: as printed, with a correction, or not.
//!
//! A construction is something with a name of its own, `Theorem 4`, `Algorithm 2`, or of that kind; its answer is that
//! of the statements made under the name. Proofs do not count: a slip in a proof says nothing against the theorem.

use crate::text::{name, visible};
use serde::Serialize;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome};

/// Whether a construction can be used, best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Usability {
    /// All its statements hold.
    AsPrinted,
    /// They hold under conditions that the paper does not print.
    UnderCondition,
    /// They hold in one reading of the printed text.
    InOneReading,
    /// Some are false, and a true form of each is proved.
    Corrected,
    /// Something is false, and no true form is known.
    Not,
    /// Nothing was decided.
    Open,
}

impl Usability {
    /// All answers, best first.
    pub const ALL: [Self; 6] = [
        Self::AsPrinted,
        Self::UnderCondition,
        Self::InOneReading,
        Self::Corrected,
        Self::Not,
        Self::Open,
    ];

    /// Returns the answer in words.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Usability::AsPrinted => "as printed",
            Usability::UnderCondition => "under a condition that is not printed",
            Usability::InOneReading => "in one reading of the print",
            Usability::Corrected => "with a correction",
            Usability::Not => "not as printed",
            Usability::Open => "not decided",
        }
    }
}

/// Something that the paper builds or states by name.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct NamedResult {
    /// Its name.
    pub name: String,
    /// Whether it can be used.
    pub answer: Usability,
    /// The answer in words.
    pub label: &'static str,
    /// The identifier for links of the first of its claims.
    pub anchor: String,
    /// The claims that decide the answer: their names and identifiers for links.
    pub because: Vec<Reason>,
}

/// A claim that decides an answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reason {
    /// The name of the claim.
    pub name: String,
    /// Its identifier for links.
    pub anchor: String,
}

/// Returns the constructions of a paper in its order; `anchors` holds the identifiers of its claims for links.
pub(crate) fn constructions(paper: &PaperOutcome, anchors: &[String]) -> Vec<NamedResult> {
    let mut groups: Vec<(String, Vec<(&Outcome, &String)>)> = Vec::new();
    for (claim, anchor) in paper.claims.iter().zip(anchors) {
        let Some(title) = title(claim) else { continue };
        match groups.iter_mut().find(|(name, _)| *name == title) {
            Some((_, group)) => group.push((claim, anchor)),
            None => groups.push((title, vec![(claim, anchor)])),
        }
    }
    groups
        .into_iter()
        .filter_map(|(title, group)| construction(title, &group, &paper.faults))
        .collect()
}

/// Returns the name under which a claim is made.
pub(crate) fn title(outcome: &Outcome) -> Option<String> {
    const WORDS: [&str; 5] = [
        "Theorem",
        "Proposition",
        "Algorithm",
        "Definition",
        "Example",
    ];
    if outcome.claim.at.contains("proof of")
        || outcome.claim.at.contains("before")
        || outcome.claim.at.contains("after D")
    {
        return None;
    }
    for word in WORDS {
        if let Some((_, after)) = outcome.claim.at.split_once(word) {
            let after = after.trim_start();
            let number: String = after
                .chars()
                .take_while(|c| c.is_ascii_digit() || *c == '.')
                .collect();
            let number = number.trim_end_matches('.');
            if !number.is_empty() {
                return Some(format!("{word} {number}"));
            }
        }
    }
    let (section, rest) = outcome
        .claim
        .at
        .split_once(", ")
        .unwrap_or((&outcome.claim.at, ""));
    if rest.starts_with("example") {
        return Some(format!("Example of {section}"));
    }
    if outcome.claim.kind != Kind::Construction {
        return None;
    }
    let equation = rest
        .split_once("eq. (")
        .and_then(|(_, after)| after.split_once(')'));
    Some(match equation {
        Some((number, _)) => format!("Equation ({})", visible(number)),
        None => format!("Construction of {}", visible(section)),
    })
}

fn construction(
    title: String,
    group: &[(&Outcome, &String)],
    faults: &[PaperFault],
) -> Option<NamedResult> {
    let statements = || {
        let ours = |(claim, _): &&(&Outcome, &String)| claim.claim.kind != Kind::Remark;
        group.iter().filter(ours)
    };
    let (_, first) = statements().next()?;
    // The files may restate a false statement, and a proved remark of ours may be its true form.
    let true_form = |outcome: &Outcome| {
        let whole = outcome.claim.part_of.as_ref().unwrap_or(&outcome.claim.id);
        outcome.correction().is_some()
            || outcome.data().is_some()
            || is_restated(outcome, faults)
            || group.iter().any(|(other, _)| {
                other.claim.kind == Kind::Remark
                    && other.claim.id.starts_with(whole.as_str())
                    && matches!(other.verdict(), Verdict::Holds | Verdict::Conditional)
            })
    };
    let answer_of = |claim: &Outcome| match claim.verdict() {
        Verdict::Holds | Verdict::Definition | Verdict::Reproduced => Some(Usability::AsPrinted),
        Verdict::Conditional => Some(Usability::UnderCondition),
        Verdict::Depends => Some(Usability::InOneReading),
        Verdict::Misprint | Verdict::False if true_form(claim) => Some(Usability::Corrected),
        Verdict::Misprint | Verdict::False | Verdict::Vacuous => Some(Usability::Not),
        Verdict::Undecided => Some(Usability::Open),
        _ => None,
    };
    let answers: Vec<(Usability, &Outcome, &String)> = statements()
        .filter_map(|(claim, anchor)| Some((answer_of(claim)?, *claim, *anchor)))
        .collect();
    // Definitions that are only well formed are not constructions.
    if answers
        .iter()
        .all(|(_, claim, _)| claim.verdict() == Verdict::Definition)
    {
        return None;
    }
    let answer = answers.iter().map(|(answer, ..)| *answer).max()?;
    let because = answers
        .iter()
        .filter(|(of, ..)| *of == answer && answer != Usability::AsPrinted);
    Some(NamedResult {
        name: title,
        answer,
        label: answer.label(),
        anchor: (*first).clone(),
        because: because
            .map(|(_, claim, anchor)| Reason {
                name: visible(name(&claim.claim.id)),
                anchor: (*anchor).clone(),
            })
            .collect(),
    })
}

/// Whether a fault shows in a claim of which the files have corrected words.
fn is_restated(outcome: &Outcome, faults: &[PaperFault]) -> bool {
    let id = &outcome.claim.id;
    faults
        .iter()
        .any(|fault| fault.shows_in(id) && fault.changes.iter().any(|change| change.claim == *id))
}
