//! The words of the report: labels, meanings and rules, in one place for every output.
//!
//! A template never chooses a label: the key of a verdict is its name in the JSON interface, and label, meaning and
//! colour class follow from it.

use serde::Serialize;
use torse_prove::evidence::Evidence;
use torse_syntax::taxonomy::{Flag, Kind, Verdict};
use torse_verdicts::claim_record::HypothesisSource;
use torse_verdicts::consequences::{Consequence, Fate};
use torse_verdicts::outcome::Outcome;
use torse_verdicts::repair;

/// A key with its label and its meaning in one sentence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Term {
    /// The name in the JSON interface, for instance `out-of-scope`.
    pub key: &'static str,
    /// The label that a reader sees.
    pub label: &'static str,
    /// Its meaning.
    pub meaning: &'static str,
}

/// Every verdict, in the order in which tables list them.
pub const VERDICTS: [Verdict; 12] = [
    Verdict::Holds,
    Verdict::Conditional,
    Verdict::Misprint,
    Verdict::False,
    Verdict::Depends,
    Verdict::Undecided,
    Verdict::Vacuous,
    Verdict::Definition,
    Verdict::Underspecified,
    Verdict::OutOfScope,
    Verdict::Reproduced,
    Verdict::Partial,
];

/// Every kind of evidence, strongest first.
pub const EVIDENCE: [Evidence; 7] = [
    Evidence::Identity,
    Evidence::Induction,
    Evidence::Inequality,
    Evidence::Enclosure,
    Evidence::Witness,
    Evidence::CheckedRange,
    Evidence::Sampled,
];

/// Every kind of statement.
pub const KINDS: [Kind; 9] = [
    Kind::Definition,
    Kind::Identity,
    Kind::Inequality,
    Kind::Value,
    Kind::Property,
    Kind::Construction,
    Kind::Figure,
    Kind::Prose,
    Kind::Remark,
];

/// Describes what becomes of a claim that depends on a refuted one.
#[must_use]
pub const fn fate(of: Fate) -> &'static str {
    match of {
        Fate::Survives => "survives: still true as printed",
        Fate::SurvivesIf => "survives under its own condition",
        Fate::Corrected => "survives with a correction of its own",
        Fate::Falls => "fails too: false as printed",
        Fate::Open => "open",
    }
}

/// The same, with the conditions under which the claim survives.
#[must_use]
pub fn consequence(of: &Consequence) -> String {
    let conditions: Vec<String> = of.conditions.iter().map(|c| quoted(&c.text)).collect();
    match (of.fate, conditions.is_empty()) {
        (Fate::Open, _) => format!("open: {}", verdict(of.verdict).label),
        (Fate::Survives, _) if of.verdict == Verdict::Definition => {
            "stands: a definition".to_owned()
        }
        (_, true) => fate(of.fate).to_owned(),
        (_, false) => format!("{}: {}", fate(of.fate), conditions.join(" and ")),
    }
}

/// Counts the claims that depend on a refuted one through others only, and survive.
#[must_use]
pub fn distant_survivors(count: usize) -> String {
    match count {
        1 => "one more depends on it indirectly, and survives".to_owned(),
        _ => format!("{count} more depend on it indirectly, and survive"),
    }
}

/// Returns the words for the verdict on a claim: for one that holds, whether the paper assumes something for it; for a
/// false one, whether its true form was found.
#[must_use]
pub fn verdict_on(outcome: &Outcome) -> Term {
    let term = verdict(outcome.verdict());
    let printed = |from: &HypothesisSource| matches!(from, HypothesisSource::Printed { .. });
    let assumes = outcome.claim.assumed.iter().any(|h| printed(&h.from));
    match (outcome.verdict(), outcome.claim.kind == Kind::Remark) {
        (Verdict::Holds, true) => Term {
            meaning: "True. A statement of ours, which the paper does not make.",
            ..term
        },
        (Verdict::Holds, false) if assumes => Term {
            meaning: "True as printed, under the paper’s own assumptions.",
            ..term
        },
        (Verdict::Holds, false) => Term {
            meaning: "True as printed.",
            ..term
        },
        (Verdict::False, _) if denied(outcome) => Term {
            meaning: "False as printed: the opposite is proved, everywhere.",
            ..term
        },
        (Verdict::False, _) if outcome.correction().is_some() && outcome.ended_early() => Term {
            meaning: "False as printed, with an exact counterexample; small edits that would correct it were not searched to the end. What is true instead was derived anew and is proved.",
            ..term
        },
        (Verdict::False, _) if outcome.ended_early() && outcome.data().is_none() => Term {
            meaning: "False as printed, with an exact counterexample; small edits that would correct it were not searched to the end.",
            ..term
        },
        (Verdict::False, _) if outcome.correction().is_some() => Term {
            meaning: "False as printed, with an exact counterexample; no small edit corrects it. The true form was derived anew and is proved.",
            ..term
        },
        (Verdict::False, _) if outcome.data().is_some() => Term {
            meaning: "False as printed, with exact values; the printed value is right for other data, which are shown.",
            ..term
        },
        // The formula of a sentence is ours, so no edit of it was searched for.
        (Verdict::False, _) if !repair::is_sought(outcome.claim.kind) => Term {
            meaning: "False as printed, with an exact counterexample.",
            ..term
        },
        (Verdict::Definition, _) if outcome.evidence().is_some() => Term {
            meaning: "A definition that is proved to agree with the rest of the paper.",
            ..term
        },
        _ => term,
    }
}

/// Whether a statement is refuted by a proof of what it denies, rather than by a point.
#[must_use]
pub fn denied(outcome: &Outcome) -> bool {
    outcome.verdict() == Verdict::False
        && outcome
            .evidence()
            .is_some_and(|own| own != Evidence::Witness)
}

/// Formulas that nobody printed and that have more characters are described by their number of terms.
const MAX_DERIVED_LENGTH: usize = 240;

/// Describes a long condition or derived formula by its number of terms.
#[must_use]
pub fn long(text: &str) -> Option<String> {
    if text.chars().count() <= MAX_DERIVED_LENGTH {
        return None;
    }
    let terms = terms(text);
    Some(match text.strip_suffix("!= 0") {
        Some(_) => format!(
            "a polynomial of {} is not 0 (`torse explain` has it)",
            plural(terms, "term")
        ),
        None => format!(
            "a formula of {} (`torse explain` has it)",
            plural(terms, "term")
        ),
    })
}

/// Writes a condition in the language of the files, or its number of terms if it is long.
#[must_use]
pub fn condition(text: &str) -> String {
    long(text).unwrap_or_else(|| text.to_owned())
}

/// Writes a number with a noun in singular or plural.
pub(crate) fn plural(count: usize, noun: &str) -> String {
    match count {
        1 => format!("1 {noun}"),
        _ => format!("{count} {noun}s"),
    }
}

/// Says what becomes of the statements that depend on a fault. None if there are none.
pub(crate) fn dependents(resting: usize, falling: usize) -> Option<String> {
    let all = plural(resting, "statement");
    Some(match (resting, falling) {
        (0, _) => return None,
        (1, 0) => "One statement depends on it, and does not fail.".to_owned(),
        (1, _) => "The one statement that depends on it is false too.".to_owned(),
        (_, 0) => format!("{all} depend on it; none fails."),
        (_, 1) => format!("{all} depend on it; one is false too."),
        _ => format!("{all} depend on it; {falling} are false too."),
    })
}

/// Writes a condition between backticks, or its number of terms if it is long.
pub(crate) fn quoted(text: &str) -> String {
    long(text).unwrap_or_else(|| format!("`{text}`"))
}

/// Counts the terms outside brackets.
fn terms(text: &str) -> usize {
    let mut depth = 0_usize;
    let mut terms = 1;
    for word in text.split(' ') {
        terms += usize::from(depth == 0 && matches!(word, "+" | "-"));
        for c in word.chars() {
            match c {
                '(' | '[' => depth += 1,
                ')' | ']' => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
    }
    terms
}

/// Returns the words for a verdict.
#[must_use]
pub const fn verdict(of: Verdict) -> Term {
    let (key, label, meaning) = match of {
        Verdict::Holds => (
            "holds",
            "holds",
            "True as printed. Hypotheses that it needs are the paper’s own.",
        ),
        Verdict::Conditional => (
            "conditional",
            "conditional",
            "True under an extra condition that the paper does not state; the condition is given.",
        ),
        Verdict::Misprint => (
            "misprint",
            "misprint",
            "False as printed; a small correction is given, and the corrected statement is proved.",
        ),
        Verdict::False => (
            "false",
            "false",
            "False as printed, with an exact counterexample; no small edit was proved to correct it.",
        ),
        Verdict::Depends => (
            "depends",
            "depends on the reading",
            "Reasonable readings of the sentence have different verdicts; each is shown.",
        ),
        Verdict::Undecided => (
            "undecided",
            "undecided",
            "Neither proved nor refuted; the attempts are shown. The statement may be true.",
        ),
        Verdict::Vacuous => (
            "vacuous",
            "vacuous",
            "No point satisfies the hypotheses, so the statement says nothing.",
        ),
        Verdict::Definition => (
            "definition",
            "definition",
            "A well-formed definition. It counts as checked where it was compared with another statement of the paper.",
        ),
        Verdict::Underspecified => (
            "underspecified",
            "underspecified",
            "The data needed to decide are not printed.",
        ),
        Verdict::OutOfScope => (
            "out-of-scope",
            "out of scope",
            "Not a statement that can be decided by exact computation; the reason is given.",
        ),
        Verdict::Reproduced => (
            "reproduced",
            "reproduced",
            "A figure, redrawn from the printed data alone.",
        ),
        Verdict::Partial => (
            "partial",
            "partial",
            "A figure, redrawn under assumptions, each of which is listed.",
        ),
    };
    Term {
        key,
        label,
        meaning,
    }
}

/// Returns the words for the evidence of the verdict on a claim; for a point, what it shows.
#[must_use]
pub fn evidence_on(outcome: &Outcome) -> Option<Term> {
    let term = evidence(outcome.evidence()?);
    let meaning = match (outcome.evidence(), outcome.verdict()) {
        (Some(Evidence::Identity), Verdict::False) => {
            "The denied statement was brought to the normal form of an exact algebra, and is true at every point of the domain."
        }
        (Some(Evidence::Witness), Verdict::False | Verdict::Misprint) => {
            "An exact point of the domain at which the printed statement fails."
        }
        (Some(Evidence::Witness), Verdict::Holds | Verdict::Conditional) => {
            "An exact point of the domain with the numbers that are claimed to exist."
        }
        _ => term.meaning,
    };
    Some(Term { meaning, ..term })
}

/// Returns the words for evidence.
#[must_use]
pub const fn evidence(of: Evidence) -> Term {
    let (key, label, meaning) = match of {
        Evidence::Identity => (
            "identity",
            "identity",
            "Both sides were brought to the normal form of an exact algebra in which zero has one form only; their difference is zero.",
        ),
        Evidence::Induction => (
            "induction",
            "induction",
            "Proved for every degree at once, with the degree as a symbol.",
        ),
        Evidence::Inequality => (
            "inequality",
            "inequality",
            "A certificate of sign, valid on the whole stated range.",
        ),
        Evidence::Enclosure => (
            "enclosure",
            "enclosure",
            "Certified interval arithmetic: the true value lies between two exact rationals.",
        ),
        Evidence::Witness => (
            "witness",
            "witness",
            "An exact point of the domain: one at which a refuted statement fails, or one with the numbers that are claimed to exist.",
        ),
        Evidence::CheckedRange => (
            "checked-range",
            "checked range",
            "Every degree up to a stated bound, and no more: never a proof for all degrees.",
        ),
        Evidence::Sampled => (
            "sampled",
            "sampled",
            "Sample points, and no more: never a proof.",
        ),
    };
    Term {
        key,
        label,
        meaning,
    }
}

/// Describes how a verdict was checked: its strongest level; none if nothing was decided.
#[must_use]
pub fn level(outcome: &Outcome, accepted: bool) -> Option<Term> {
    let netted = outcome.net().is_some_and(|net| net.netted);
    match (accepted, netted) {
        (true, _) => Some(KERNEL),
        (false, true) => Some(NETTED),
        (false, false) => outcome.evidence().map(|_| DECIDED),
    }
}

/// Says in a sentence what checked a verdict of a level beside the prover; none if nothing did.
#[must_use]
pub fn checked_by(level: Term) -> Option<&'static str> {
    match level {
        KERNEL => Some("by the kernel of Rocq"),
        NETTED => Some("by a second evaluator"),
        _ => None,
    }
}

/// Decided only.
pub const DECIDED: Term = Term {
    key: "decided",
    label: "decided",
    meaning: "The prover decided it by exact computation; no second check was made, or it had no answer.",
};

/// Also proved by the proof assistant.
pub const KERNEL: Term = Term {
    key: "kernel",
    label: "kernel",
    meaning: "The kernel of the proof assistant Rocq accepted a proof of this verdict.",
};

/// Also confirmed at points.
pub const NETTED: Term = Term {
    key: "netted",
    label: "netted",
    meaning: "A second evaluator, which shares only the parser and the numbers with the prover, confirmed it at every exact point that was tried.",
};

/// Returns the words for a kind of statement.
#[must_use]
pub const fn kind(of: Kind) -> Term {
    let (key, label, meaning) = match of {
        Kind::Definition => ("definition", "definition", "A definition."),
        Kind::Identity => (
            "identity",
            "identity",
            "An equation that is claimed to hold identically.",
        ),
        Kind::Inequality => ("inequality", "inequality", "An inequality on a range."),
        Kind::Value => ("value", "value", "A printed value."),
        Kind::Property => ("property", "property", "A property in words."),
        Kind::Construction => ("construction", "construction", "A construction."),
        Kind::Figure => ("figure", "figure", "A figure."),
        Kind::Prose => ("prose", "prose", "A checkable remark."),
        Kind::Remark => (
            "remark",
            "remark",
            "A statement of ours that the paper does not make.",
        ),
    };
    Term {
        key,
        label,
        meaning,
    }
}

/// The label of words that a paper prints.
pub const PRINTED: &str = "printed";

/// Returns the label of the words of a claim: the paper prints them, unless they are a remark of ours.
#[must_use]
pub fn words_of(of: Kind) -> &'static str {
    match of {
        Kind::Remark => "ours",
        _ => PRINTED,
    }
}

/// Returns the name of a flag of the audit in files and outputs.
#[must_use]
pub const fn flag(of: Flag) -> &'static str {
    match of {
        Flag::EqualSides => "equal-sides",
        Flag::NothingOfThePaper => "nothing-of-the-paper",
        Flag::LacksNumber => "lacks-number",
        Flag::LacksName => "lacks-name",
        Flag::LacksRelation => "lacks-relation",
        Flag::AddsNumber => "adds-number",
        Flag::AddsName => "adds-name",
        Flag::AddsRelation => "adds-relation",
        Flag::ReadsOtherwise => "reads-otherwise",
        Flag::ReadsAnotherFormula => "reads-another-formula",
        Flag::AssumedConclusion => "assumed-conclusion",
        Flag::ShortConjunction => "short-conjunction",
        Flag::OneDegree => "one-degree",
        Flag::OneCoordinate => "one-coordinate",
        Flag::OneInstance => "one-instance",
        Flag::NoMutant => "no-mutant",
        Flag::UnstatedReading => "unstated-reading",
        Flag::UnstatedRelation => "unstated-relation",
        Flag::UnneededHypothesis => "unneeded-hypothesis",
        Flag::QuoteSaysOtherwise => "quote-says-otherwise",
        Flag::GarbledExcuse => "garbled-excuse",
        Flag::UnsourcedRange => "unsourced-range",
        Flag::AccusedWithoutVerdict => "accused-without-verdict",
        Flag::CorrectedReading => "corrected-reading",
        Flag::SamePrint => "same-print",
    }
}

/// A rule that the verdicts rely on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Rule {
    /// The name.
    pub name: &'static str,
    /// The statement and, in brief, why it is true.
    pub statement: &'static str,
}

/// Returns the rules and theorems that every verdict relies on.
pub const RULES: [Rule; 7] = [
    Rule {
        name: "Equality is decided, never sampled",
        statement: "The formulas live in the ring of polynomials with rational coefficients in π, the parameters, the variable x and the pair s = sin(πx/2), c = cos(πx/2), modulo s² + c² = 1. Since π is transcendental and x is algebraically independent of s and c, this ring embeds in the ring of functions: a zero normal form proves an identity, and a normal form other than zero disproves it.",
    },
    Rule {
        name: "Every division is recorded",
        statement: "A quotient is computed together with the statement that its divisor is not zero. Divisors that the paper’s own assumptions do not exclude are listed with the verdict as conditions.",
    },
    Rule {
        name: "A counterexample is exact",
        statement: "A refuted statement comes with exact values of its symbols at which both sides were computed exactly. Decimals beside them are certified enclosures, given for the reader’s convenience only.",
    },
    Rule {
        name: "A correction is proved",
        statement: "A corrected formula is offered only when the corrected statement itself has been decided to hold by the same procedure. If another correction with as few edits was found, the report says so.",
    },
    Rule {
        name: "Every degree at once",
        statement: "Statements for all degrees are decided with the degree as a symbol: a curve of degree k is a Bernstein blend of local quadratics, and its endpoint derivatives follow from truncated power series whose coefficients are polynomials in k.",
    },
    Rule {
        name: "Enclosures are one-sided by construction",
        statement: "Values of π, sine and cosine are computed as pairs of rationals that enclose the true value; each operation rounds outward. An inequality or a printed decimal is accepted or refused only when the whole enclosure agrees.",
    },
    Rule {
        name: "Failure to prove is not refutation",
        statement: "A statement is called false only with a witness. Where neither a proof nor a witness was found, the verdict is undecided, with what was tried.",
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_the_names_of_the_json_interface() {
        for of in VERDICTS {
            assert_eq!(serde_json::to_value(of).unwrap(), verdict(of).key);
        }
        for of in EVIDENCE {
            assert_eq!(serde_json::to_value(of).unwrap(), evidence(of).key);
        }
        for of in KINDS {
            assert_eq!(serde_json::to_value(of).unwrap(), kind(of).key);
        }
    }

    #[test]
    fn a_long_condition_is_counted() {
        assert_eq!(condition("x != 0"), "x != 0");
        assert_eq!(long("x + 1"), None);
        let long = vec!["a*(b + c)"; 80].join(" + ") + " - y != 0";
        let words = "a polynomial of 81 terms is not 0 (`torse explain` has it)";
        assert_eq!(condition(&long), words);
    }

    #[test]
    fn tables_list_every_verdict_evidence_and_kind_once() {
        for (position, of) in VERDICTS.into_iter().enumerate() {
            assert_eq!(of as usize, position);
        }
        for (position, of) in EVIDENCE.into_iter().enumerate() {
            assert_eq!(of as usize, position);
        }
        for (position, of) in KINDS.into_iter().enumerate() {
            assert_eq!(of as usize, position);
        }
    }
}
