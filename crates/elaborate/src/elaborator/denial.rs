//! The two kinds of negation: `not p` is about a point, `fails(p)` about the domain.
//!
//! At a point, `not` of a comparison is the opposite comparison, and `and`, `or` and `implies` are negated by De
//! Morgan's rules. `fails(p)` says that p is false somewhere in the domain, so it is not a statement about a point:
//! it may stand alone or as a part of a conjunction, and nowhere else.

use super::{Outcome, wrong};
use torse_core::Statement;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Expr, Place};

/// The negation at a point: true where `statement` is false, and defined at the same points.
///
/// # Errors
/// [`Fault`] for statements that have no opposite: properties of a basis, agreement with printed numbers, and
/// `fails`.
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
                "the negation, at each point, of something other than a comparison",
                "a comparison, or `fails(..)` to say that it does not hold everywhere",
            ));
        }
    })
}

/// Returns the statement if it is about points.
///
/// # Errors
/// [`Fault`] for a statement that contains `fails`.
pub(super) fn about_points(statement: Statement, tree: &Expr) -> Outcome<Statement> {
    if is_about_domain(&statement) {
        Err(misplaced(tree.place))
    } else {
        Ok(statement)
    }
}

/// Whether the statement contains `fails`, so that it is about the domain.
pub(crate) fn is_about_domain(statement: &Statement) -> bool {
    match statement {
        Statement::Not(_) => true,
        Statement::Join(_, a, b) => is_about_domain(a) || is_about_domain(b),
        Statement::Compare { .. } | Statement::Agrees { .. } | Statement::Family(..) => false,
    }
}

/// The error for a `fails` at a place where it is not allowed.
pub(crate) fn misplaced(place: Place) -> Fault {
    wrong(
        place,
        "`fails` inside of a statement about points",
        "`fails(..)` as the statement of a claim without `exists`, or joined to it by `and`,",
    )
}
