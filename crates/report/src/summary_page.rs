//! A report in one minute: what holds, and the most consequential errors.

use crate::faults::{FaultPart, PlacedFault, faults};
use crate::glossary;
use crate::letter::item;
use crate::names::printed_names;
use crate::sentence;
use crate::tally::Tally;
use crate::text::{enumeration, visible};
use crate::view::{FormulaView, correction, formula};
use serde::Serialize;
use torse_syntax::taxonomy::Verdict;
use torse_typography::{Prose, in_words, spans};
use torse_verdicts::outcome::{Outcome, PaperOutcome};

/// Maximum number of sentences about single statements.
const MAX_ROWS: usize = 5;

/// The summary.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SummaryPage {
    /// How many statements have which verdict, in a sentence.
    pub counts: String,
    /// The first of its corrections, in their order.
    pub points: Vec<SummaryFinding>,
    /// How many more corrections there are, in words.
    pub rest: Option<String>,
}

/// One of the most consequential faults, in short.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SummaryFinding {
    /// Where it is, as the letter says it.
    pub heading: Prose,
    /// What is wrong, in a sentence.
    pub text: Prose,
    /// The words that should stand there, as the letter has them, if they are short.
    pub reads: Option<Prose>,
    /// The role of the formula.
    pub label: &'static str,
    /// The formula of a statement to which the files assign no fault, corrected or as printed, if it is short.
    pub formula: Option<FormulaView>,
    /// Its dependents, in words; empty if there are none.
    pub consequence: String,
}

/// Summarises a paper: the first of its corrections, in their order.
pub(crate) fn summarize(paper: &PaperOutcome) -> SummaryPage {
    let faults = faults(paper);
    let corrections = faults.iter();
    let corrections = corrections.filter(|fault| fault.part == FaultPart::Correction);
    let points: Vec<SummaryFinding> = (corrections.clone().take(MAX_ROWS))
        .filter_map(|fault| point(fault, paper))
        .collect();
    let left = corrections.count() - points.len();
    SummaryPage {
        counts: counts(&paper.claims),
        rest: match left {
            0 => None,
            1 => Some("One more correction is proposed.".to_owned()),
            _ => Some(format!("{left} more corrections are proposed.")),
        },
        points,
    }
}

/// Longer formulas and words, true or printed, are left to the corrections.
const MAX_TRUE_LENGTH: usize = 320;
const MAX_PRINTED_LENGTH: usize = 130;

fn point(fault: &PlacedFault<'_>, paper: &PaperOutcome) -> Option<SummaryFinding> {
    let lead = fault.lead()?;
    let item = item(fault, paper)?;
    let names = printed_names(lead);
    let (text, reads, (label, formula)) = match fault.described {
        Some(described) => {
            let reads = item.changes.into_iter().find_map(|change| change.reads);
            let is_short = |reads: &Prose| in_words(reads).chars().count() <= MAX_TRUE_LENGTH;
            (
                sentence::fault_in_short(&described.says),
                reads.filter(is_short),
                ("", None),
            )
        }
        None => (
            sentence::short_sentence(lead, &paper.faults),
            None,
            formula_of(lead),
        ),
    };
    Some(SummaryFinding {
        heading: item.heading,
        text: spans(&visible(&text), &names),
        reads,
        label,
        formula,
        consequence: glossary::dependents(fault.resting, fault.falling).unwrap_or_default(),
    })
}

/// The corrected formula of a statement, or that of the print, with its role; none if it is long.
fn formula_of(outcome: &Outcome) -> (&'static str, Option<FormulaView>) {
    let names = printed_names(outcome);
    let short = |view: FormulaView, longest: usize| {
        let letters = view.math.as_ref().map(|math| math.text.chars().count());
        letters
            .is_some_and(|letters| letters <= longest)
            .then_some(view)
    };
    match (outcome.correction(), outcome.parsed()) {
        (Some(repair), parsed) => {
            let view = correction(parsed, repair, &names);
            ("should read", short(view.statement, MAX_TRUE_LENGTH))
        }
        (None, Some(parsed)) => (
            "as printed",
            short(formula(parsed, &names), MAX_PRINTED_LENGTH),
        ),
        (None, None) => ("", None),
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
