//! The comparisons among the hypotheses of a claim.

use torse_core::{Claim, Statement, Term};
use torse_syntax::formula::{Connective, Relation};

/// The comparisons that every point of the domain satisfies: those of conjunctions of hypotheses.
pub(crate) fn constraints(claim: &Claim) -> Vec<(Relation, &Term, &Term)> {
    let mut pending: Vec<&Statement> = claim
        .hypotheses
        .iter()
        .rev()
        .map(|h| &h.statement)
        .collect();
    let mut all = vec![];
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Join(Connective::And, a, b) => pending.extend([&**b, &**a]),
            Statement::Compare {
                relation,
                left,
                right,
            } => all.push((*relation, left, right)),
            _ => {}
        }
    }
    all
}

/// Whether a hypothesis is a conjunction of equations, all of which [`solve`] looks at.
pub(crate) fn is_equations(statement: &Statement) -> bool {
    let mut pending = vec![statement];
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Join(Connective::And, a, b) => pending.extend([&**a, &**b]),
            Statement::Compare {
                relation: Relation::Equal,
                ..
            } => {}
            _ => return false,
        }
    }
    true
}

/// The equations among them.
pub(crate) fn equations(claim: &Claim) -> Vec<(&Term, Option<&Term>)> {
    constraints(claim)
        .into_iter()
        .filter(|(relation, ..)| *relation == Relation::Equal)
        .map(|(_, left, right)| (left, Some(right)))
        .collect()
}
