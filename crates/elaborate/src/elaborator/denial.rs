//! `not p` is about the point, `fails(p)` about the domain.
//!
//! At a point a comparison is denied by the opposite one, and `and`, `or` and `implies` by De Morgan's rules. What is said to fail
//! somewhere is no statement about a point: it stands alone or beside others in a conjunction, and nowhere else.

use super::{Outcome, wrong};
use torse_core::Statement;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Expr, Place};

/// The statement that is true at the points at which this one is false, and defined where it is.
///
/// # Errors
/// [`Fault`] for what has no opposite: a property of a basis, printed numbers, what fails somewhere.
pub(super) fn opposite(statement: Statement, tree: &Expr) -> Outcome<Statement> {
    Ok(match statement {
        Statement::Compare {
            relation,
            left,
            right,
        } => Statement::Compare {
            relation: relation.opposite(),
            left,
            right,
        },
        Statement::Join(connective, a, b) => {
            let (connective, a) = match connective {
                Connective::And if injected(InjectedFault::DenialOfBoth) => {
                    (Connective::And, opposite(*a, tree)?)
                }
                Connective::And => (Connective::Or, opposite(*a, tree)?),
                Connective::Or => (Connective::And, opposite(*a, tree)?),
                Connective::Implies => (Connective::And, *a),
            };
            Statement::Join(connective, Box::new(a), Box::new(opposite(*b, tree)?))
        }
        Statement::Agrees { .. } | Statement::Family(..) | Statement::Not(_) => {
            return Err(wrong(
                tree.place,
                "a denial at each point of what is no comparison",
                "a comparison, or `fails(..)`: it does not hold everywhere",
            ));
        }
    })
}

/// The statement, unless it is one about the domain.
///
/// # Errors
/// [`Fault`] for a statement in which something is said to fail somewhere.
pub(super) fn about_points(statement: Statement, tree: &Expr) -> Outcome<Statement> {
    match is_about_domain(&statement) {
        true => Err(misplaced(tree.place)),
        false => Ok(statement),
    }
}

/// Whether something is said to fail somewhere.
pub(crate) fn is_about_domain(statement: &Statement) -> bool {
    match statement {
        Statement::Not(_) => true,
        Statement::Join(_, a, b) => is_about_domain(a) || is_about_domain(b),
        Statement::Compare { .. } | Statement::Agrees { .. } | Statement::Family(..) => false,
    }
}

/// `fails` where it may not stand.
pub(crate) fn misplaced(place: Place) -> Fault {
    wrong(
        place,
        "`fails` inside of a statement about points",
        "`fails(..)` as the statement of a claim without `exists`, or joined to it by `and`,",
    )
}
