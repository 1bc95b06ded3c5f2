//! Counts by verdict and evidence, the two axes of every answer.

use crate::words::{self, EVIDENCE, Term, VERDICTS};
use serde::Serialize;
use torse_verdicts::outcome::Outcome;

/// How many claims have which verdict, and which evidence with it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Tally {
    /// How many claims there are.
    pub total: usize,
    /// The kinds of evidence that occur, strongest first: the columns.
    pub evidence: Vec<Term>,
    /// The verdicts that occur: the rows.
    pub rows: Vec<Row>,
}

/// The claims of one verdict.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Row {
    /// The verdict.
    pub verdict: Term,
    /// How many claims have it.
    pub count: usize,
    /// How many of them rest on each kind of [`Tally::evidence`], in that order.
    pub by_evidence: Vec<usize>,
    /// How many of them need no evidence.
    pub without: usize,
}

impl Tally {
    /// Counts `claims`.
    #[must_use]
    pub fn new(claims: &[Outcome]) -> Self {
        let count =
            |keep: &dyn Fn(&Outcome) -> bool| claims.iter().filter(|claim| keep(claim)).count();
        let occurring: Vec<_> = EVIDENCE
            .into_iter()
            .filter(|of| claims.iter().any(|claim| claim.evidence == Some(*of)))
            .collect();
        let rows = VERDICTS.into_iter().map(|verdict| Row {
            verdict: words::verdict(verdict),
            count: count(&|claim| claim.verdict == verdict),
            by_evidence: occurring
                .iter()
                .map(|of| count(&|claim| claim.verdict == verdict && claim.evidence == Some(*of)))
                .collect(),
            without: count(&|claim| claim.verdict == verdict && claim.evidence.is_none()),
        });
        Tally {
            total: claims.len(),
            rows: rows.filter(|row| row.count > 0).collect(),
            evidence: occurring.into_iter().map(words::evidence).collect(),
        }
    }
}
