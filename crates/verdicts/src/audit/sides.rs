//! Flags an equation whose sides are the same as written: it says nothing.

use super::{RaisedFlag, Subject, raised};
use crate::conjunction::conjuncts;
use torse_syntax::derivation::Claim;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::{Expr, Node, Relation};
use torse_syntax::notation;
use torse_syntax::taxonomy::{Flag, Kind};

/// Maximum depth to which names are expanded.
const DEPTH: usize = 8;

/// Returns equations with equal sides after names of formulas are expanded; a definition is meant to have equal sides.
pub(super) fn equations_with_equal_sides(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let definition = subject.claim.entry.kind == Kind::Definition;
    let statement = subject.claim.statement.as_ref().filter(|_| !definition);
    let mut flags = vec![];
    for part in statement.iter().flat_map(|w| conjuncts(&w.expr)) {
        for (left, relation, right) in comparisons(part) {
            if relation == Relation::Equal && are_equal(left, right, &subject.claim.declarations) {
                let (left, right) = (notation::text(left), notation::text(right));
                let evidence = format!("`{left}` and `{right}` are the same formula");
                flags.push(raised(Flag::EqualSides, evidence));
            }
        }
    }
    flags
}

/// Whether the statement of a claim, or of a reading, compares a formula with anything but itself: a definition that does
/// not says how a name is written, and nothing that could be wrong.
pub(crate) fn compares(claim: &Claim) -> bool {
    let statement = claim.statement.iter();
    let readings = claim.readings.iter();
    let statements = statement.chain(readings.filter_map(|own| own.claim.statement.as_ref()));
    let mut parts = statements.flat_map(|w| conjuncts(&w.expr));
    parts.any(|part| match &part.node {
        Node::Compare(..) => comparisons(part).iter().any(|(left, relation, right)| {
            *relation != Relation::Equal || !are_equal(left, right, &claim.declarations)
        }),
        _ => true,
    })
}

/// The comparisons of a chain, two by two; none where a formula is no comparison.
fn comparisons(part: &Expr) -> Vec<(&Expr, Relation, &Expr)> {
    let Node::Compare(first, rest) = &part.node else {
        return vec![];
    };
    let mut left: &Expr = first;
    let mut list = vec![];
    for (relation, right) in rest {
        list.push((left, *relation, right));
        left = right;
    }
    list
}

fn are_equal(left: &Expr, right: &Expr, declarations: &Declarations) -> bool {
    let opened = |side: &Expr| opened(side, declarations, DEPTH).placeless();
    opened(left) == opened(right)
}

/// The formula with the bodies of definitions in place of their names, of functions where they are taken at their own
/// parameters.
fn opened(expr: &Expr, declarations: &Declarations, depth: usize) -> Expr {
    let named = match &expr.node {
        Node::Name(name) => Some((name, [].as_slice())),
        Node::Call(head, arguments) | Node::Index(head, arguments) => match &head.node {
            Node::Name(name) => Some((name, arguments.as_slice())),
            _ => None,
        },
        _ => None,
    };
    if let Some((name, arguments)) = named
        && let Some(definition) = declarations.definition(name)
        && depth > 0
        && arguments.len() == definition.parameters.len()
        && arguments.iter().zip(&definition.parameters).all(
            |(argument, parameter)| matches!(&argument.node, Node::Name(name) if name == parameter),
        )
    {
        return opened(&definition.body.expr, declarations, depth - 1);
    }
    expr.with_parts(|part| opened(part, declarations, depth))
}
