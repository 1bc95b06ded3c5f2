//! How a letter begins: to whom it is written, how much was decided, how much there is to correct.

use crate::glossary::plural;
use crate::text::{enumeration, visible};
use serde::Serialize;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_typography::plain;
use torse_verdicts::outcome::Outcome;

/// How many statements, formulas and figures of a paper were decided, of how many that it has. Remarks of ours are not counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Scope {
    /// Those that were written as formulas and decided.
    pub decided: usize,
    /// All of them.
    pub total: usize,
}

impl Scope {
    pub(super) fn new(claims: &[Outcome]) -> Self {
        let own = claims
            .iter()
            .filter(|listed| listed.claim.kind != Kind::Remark);
        let is_decided = |outcome: &&Outcome| match outcome.verdict() {
            Verdict::Holds
            | Verdict::Conditional
            | Verdict::Misprint
            | Verdict::False
            | Verdict::Vacuous
            | Verdict::Depends => true,
            // Printed data are compared with those of other statements, or stand for themselves.
            Verdict::Definition => outcome.evidence().is_some(),
            Verdict::Undecided
            | Verdict::Underspecified
            | Verdict::OutOfScope
            | Verdict::Reproduced
            | Verdict::Partial => false,
        };
        Self {
            decided: own.clone().filter(is_decided).count(),
            total: own.count(),
        }
    }

    /// Says how much was decided, without the full stop.
    fn sentence(self) -> String {
        let Self { decided, total } = self;
        match (decided, total) {
            (0, _) => "No statement of your paper has been decided yet, so that nothing is said about it here".to_owned(),
            (1, 1) => "We wrote the statement of your paper as a formula and decided it by exact computation, with the program torse".to_owned(),
            (_, _) if decided == total => format!("We wrote each of the {total} statements of your paper as a formula and decided it by exact computation, with the program torse"),
            (1, _) => format!("Of the {total} statements, formulas and figures of your paper, we wrote one as a formula and decided it by exact computation, with the program torse"),
            _ => format!("Of the {total} statements, formulas and figures of your paper, we wrote {decided} as formulas and checked them by exact computation, with the program torse"),
        }
    }
}

pub(super) fn salutation(authors: &str) -> String {
    let names: Vec<&str> = authors.split(',').map(str::trim).collect();
    match names.as_slice() {
        [] => "Dear authors,".to_owned(),
        names => format!("Dear {},", enumeration(names)),
    }
}

pub(super) fn example(corrections: usize) -> String {
    format!(
        "This is no paper but a worked example: {} in it {} wrong on purpose, and here is what torse found of {}. Changes are framed; changed words are bold.",
        plural(corrections, "statement"),
        if corrections == 1 { "is" } else { "are" },
        if corrections == 1 { "it" } else { "them" },
    )
}

pub(super) fn opening(
    scope: Scope,
    [corrections, conditions, questions]: [usize; 3],
    open: &[&Outcome],
) -> String {
    let mut text = scope.sentence();
    let named: Vec<String> = open.iter().map(|outcome| named(outcome)).collect();
    text.push_str(&match named.as_slice() {
        [] => ".".to_owned(),
        [one] => format!("; one more is not decided, {one}."),
        several => format!(
            "; {} more are not decided: {}.",
            several.len(),
            several.join("; ")
        ),
    });
    text.push_str(&match corrections {
        0 if scope.decided == 0 => String::new(),
        0 => " None was found to be false.".to_owned(),
        1 => " We propose one correction. Changes are framed; changed words are bold.".to_owned(),
        _ => format!(
            " We propose {corrections} corrections, the most consequential first. Changes are framed; changed words are bold."
        ),
    });
    text.push_str(&match conditions {
        0 => String::new(),
        1 => " We add one point that the text should state more exactly.".to_owned(),
        _ => format!(" We add {conditions} points that the text should state more exactly."),
    });
    text.push_str(&match questions {
        0 => String::new(),
        1 => " We also ask you to look at one place that may be a slip of our copy.".to_owned(),
        _ => {
            format!(" We also ask you to look at {questions} places that may be slips of our copy.")
        }
    });
    text
}

/// The words of a statement and its place, for a sentence.
fn named(outcome: &Outcome) -> String {
    // Words that are left out are marked, but for those before and after the quotation.
    let quoted = outcome.claim.printed.trim_matches(['.', ' ']);
    let words = quoted.replace("...", "[…]");
    let words: Vec<&str> = words.split_whitespace().collect();
    let at = plain(&outcome.claim.at);
    visible(&format!("“{}” ({at})", words.join(" ")))
}
