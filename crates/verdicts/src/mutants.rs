//! Mutation testing: does the engine notice a slip that is made on purpose in a statement that holds?
//!
//! The edits that correct a misprint ([`crate::repair::edits`]) are applied to a statement that holds. A changed
//! statement with another meaning must be refuted. One that is not is a survivor: either it is true as well, which a
//! proof that the changed side equals the printed one shows, or the engine is too weak for it, or contradicts itself.

use crate::repair::alphabet::alphabet;
use crate::repair::canonical::canonical;
use crate::repair::edit::{Change, placed};
use crate::repair::edits::single;
use crate::words::certificate;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_prove::decide::value::plain;
use torse_prove::decide::{Decision, Unsettled};
use torse_prove::decide_statement;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Connective, Expr, Node, Relation};
use torse_syntax::notation;

/// Why a changed statement was not refuted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Survival {
    /// The changed side is proved equal to the printed one: another true statement.
    Equivalent,
    /// The statement is neither proved nor refuted.
    Open {
        /// The engine's answer.
        reason: String,
    },
    /// The statement is proved, but not that both sides are equal: a contradiction if that is refuted.
    Unexplained,
}

/// A changed statement that was not refuted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Survivor {
    /// The changed statement, in the language of the derivation files.
    pub statement: String,
    /// The change in words.
    pub change: String,
    /// Why it was not refuted.
    pub survival: Survival,
}

/// Returns the survivors among at most `most` changed statements of a claim, spread evenly over all of them, and how
/// many were decided. Changes that make no sense, or change nothing, do not count. A claim whose statement has no
/// equality has no changed statements.
#[must_use]
pub fn survivors(claim: &Claim, most: usize) -> (Vec<Survivor>, usize) {
    let Some(statement) = &claim.statement else {
        return (vec![], 0);
    };
    let mutants = mutants(claim, &statement.expr);
    let step = mutants.len().div_ceil(most.max(1)).max(1);
    let (mut survivors, mut decided) = (vec![], 0);
    for mutant in mutants.iter().step_by(step) {
        let survival = match decide_written(claim, statement, &mutant.statement) {
            None => continue,
            Some(Decision::Refuted(_)) => None,
            Some(Decision::Proven(_)) => {
                let equal = decide_written(claim, statement, &mutant.equality());
                let proved = equal.is_some_and(|d| d.is_proven());
                Some(if proved {
                    Survival::Equivalent
                } else {
                    Survival::Unexplained
                })
            }
            Some(Decision::Open(Unsettled { reason, .. })) => Some(Survival::Open { reason }),
            Some(Decision::Vacuous(emptiness)) => {
                let reason = certificate::emptiness(&emptiness.map(&plain));
                Some(Survival::Open { reason })
            }
        };
        decided += 1;
        survivors.extend(survival.map(|survival| Survivor {
            statement: notation::text(&mutant.statement),
            change: mutant.change.to_string(),
            survival,
        }));
    }
    (survivors, decided)
}

/// Whether one of at most `most` changed statements of a claim, spread evenly over all of them, is refuted, and how
/// many were decided until then: the rest is not looked at.
#[must_use]
pub fn one_is_refuted(claim: &Claim, most: usize) -> (bool, usize) {
    let Some(statement) = &claim.statement else {
        return (false, 0);
    };
    let mutants = mutants(claim, &statement.expr);
    let step = mutants.len().div_ceil(most.max(1)).max(1);
    let mut decided = 0;
    for mutant in mutants.iter().step_by(step) {
        let decision = decide_written(claim, statement, &mutant.statement);
        decided += usize::from(decision.is_some());
        if matches!(decision, Some(Decision::Refuted(_))) {
            return (true, decided);
        }
    }
    (false, decided)
}

/// At most `most` claims that say something else by one change and that are refuted, spread evenly over all changes of
/// a claim, with the changes in words.
pub fn refuted(claim: &Claim, most: usize) -> impl Iterator<Item = (Claim, String)> {
    let statement = claim.statement.iter();
    let all = statement.flat_map(move |statement| {
        let mutants = mutants(claim, &statement.expr);
        let step = mutants.len().div_ceil(most.max(1)).max(1);
        mutants.into_iter().step_by(step).map(move |mutant| {
            let expr = mutant.statement;
            let origin = statement.origin.clone();
            (Written { expr, origin }, mutant.change.to_string())
        })
    });
    all.filter_map(move |(written, change)| {
        let decision = decide_statement(claim, &written).ok()?;
        matches!(decision, Decision::Refuted(_)).then(|| {
            let mut changed = claim.clone();
            changed.statement = Some(written);
            (changed, change)
        })
    })
}

/// A statement with one change, and the side that was changed.
struct Mutant {
    statement: Expr,
    printed: Expr,
    changed: Expr,
    change: Change,
}

impl Mutant {
    /// Returns the statement that the change changes nothing.
    fn equality(&self) -> Expr {
        let right = vec![(Relation::Equal, self.changed.clone())];
        Expr::made(Node::Compare(Arc::new(self.printed.clone()), right))
    }
}

/// Returns the statements with one edit of one side, without edits that only reorder.
fn mutants(claim: &Claim, statement: &Expr) -> Vec<Mutant> {
    let mut result = vec![];
    for (path, printed) in sides(statement) {
        let alphabet = alphabet(claim, statement, printed);
        let mut seen = BTreeSet::from([canonical(printed)]);
        for edit in single(printed, &alphabet) {
            if seen.insert(canonical(&edit.expr)) {
                result.push(Mutant {
                    statement: placed(statement, &path, edit.expr.clone()),
                    printed: printed.clone(),
                    changed: edit.expr,
                    change: edit.change,
                });
            }
        }
    }
    result
}

/// Returns the right sides of the equalities of a conjunction, and the left side where something is compared with a
/// number, with the paths to them.
fn sides(statement: &Expr) -> Vec<(Vec<usize>, &Expr)> {
    let mut found = vec![];
    let mut pending = vec![(vec![], statement)];
    while let Some((path, expr)) = pending.pop() {
        match &expr.node {
            Node::Join(Connective::And, a, b) => {
                pending.push(([path.as_slice(), &[1]].concat(), b));
                pending.push(([path.as_slice(), &[0]].concat(), a));
            }
            Node::Compare(left, rest) => {
                for (position, (relation, right)) in rest.iter().enumerate() {
                    if *relation == Relation::Equal {
                        found.push(([path.as_slice(), &[position + 1]].concat(), right));
                    }
                }
                if let [(Relation::Equal, right)] = rest.as_slice()
                    && matches!(right.node, Node::Number { .. })
                {
                    found.push(([path.as_slice(), &[0]].concat(), left));
                }
            }
            _ => {}
        }
    }
    found
}

/// Decides a formula in the setting of a claim; none if it makes no sense.
fn decide_written(claim: &Claim, like: &Written, expr: &Expr) -> Option<Decision> {
    let written = Written {
        expr: expr.clone(),
        origin: like.origin.clone(),
    };
    decide_statement(claim, &written).ok()
}
