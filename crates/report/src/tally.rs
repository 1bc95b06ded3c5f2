//! Counts by verdict and evidence, the two axes of every answer; remarks of ours are counted separately.

use crate::glossary::{self, EVIDENCE, Term, VERDICTS};
use serde::Serialize;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::outcome::Outcome;

/// How many claims have which verdict, and which evidence with it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Tally {
    /// The number of claims, without remarks of ours.
    pub total: usize,
    /// The number of remarks of ours, and how many of them hold, possibly under a stated condition. They say nothing
    /// about the paper, and are counted in no row.
    pub remarks: Remarks,
    /// The kinds of evidence that occur, strongest first: the columns.
    pub evidence: Vec<Term>,
    /// The verdicts that occur: the rows.
    pub rows: Vec<Row>,
}

/// Statements of ours that the paper does not make.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Remarks {
    /// All of them.
    pub total: usize,
    /// Those that hold or hold under their condition.
    pub proved: usize,
    /// Those of them that hold under a condition.
    pub conditional: usize,
}

impl Remarks {
    /// How many of them hold, in words.
    #[must_use]
    pub fn in_words(&self) -> String {
        let hold = match self.proved {
            1 => "1 of them holds".to_owned(),
            many => format!("{many} of them hold"),
        };
        match self.conditional {
            0 => hold,
            some => format!("{hold}, {some} under a condition"),
        }
    }
}

/// The claims of one verdict.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Row {
    /// The verdict.
    pub verdict: Term,
    /// How many claims have it.
    pub count: usize,
    /// How many of them have each kind of [`Tally::evidence`], in that order.
    pub by_evidence: Vec<usize>,
    /// How many of them need no evidence.
    pub without: usize,
}

impl Tally {
    /// Counts `claims`.
    #[must_use]
    pub fn new<'a>(claims: impl IntoIterator<Item = &'a Outcome>) -> Self {
        let (remarks, claims): (Vec<&Outcome>, Vec<&Outcome>) = claims
            .into_iter()
            .partition(|outcome| outcome.claim.kind == Kind::Remark);
        let with = |of: Verdict| remarks.iter().filter(|r| r.verdict() == of).count();
        let conditional = with(Verdict::Conditional);
        let remarks = Remarks {
            total: remarks.len(),
            proved: with(Verdict::Holds) + conditional,
            conditional,
        };
        let count =
            |keep: &dyn Fn(&Outcome) -> bool| claims.iter().filter(|claim| keep(claim)).count();
        let occurring: Vec<_> = EVIDENCE
            .into_iter()
            .filter(|own| claims.iter().any(|claim| claim.evidence() == Some(*own)))
            .collect();
        let rows = VERDICTS.into_iter().map(|verdict| Row {
            verdict: glossary::verdict(verdict),
            count: count(&|claim| claim.verdict() == verdict),
            by_evidence: occurring
                .iter()
                .map(|evidence| {
                    count(&|claim| {
                        claim.verdict() == verdict && claim.evidence() == Some(*evidence)
                    })
                })
                .collect(),
            without: count(&|claim| claim.verdict() == verdict && claim.evidence().is_none()),
        });
        Tally {
            total: claims.len(),
            remarks,
            rows: rows.filter(|row| row.count > 0).collect(),
            evidence: occurring.into_iter().map(glossary::evidence).collect(),
        }
    }
}
