//! Flags an equation whose sides are the same as written: it says nothing.

use super::{Sign, Subject, sign};
use crate::conjunction::conjuncts;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::{Expr, Node, Relation};
use torse_syntax::notation;
use torse_syntax::taxonomy::{Flag, Kind};

/// Maximum depth to which names are expanded.
const DEPTH: usize = 8;

/// Returns equations with equal sides after names of formulas are expanded; a definition is meant to have equal sides.
pub(super) fn equal(subject: &Subject<'_>) -> Vec<Sign> {
    let definition = subject.claim.entry.kind == Kind::Definition;
    let statement = subject.claim.statement.as_ref().filter(|_| !definition);
    let mut signs = vec![];
    for part in statement.iter().flat_map(|w| conjuncts(&w.expr)) {
        let Node::Compare(first, rest) = &part.node else {
            continue;
        };
        let mut left: &Expr = first;
        for (relation, right) in rest {
            let opened = |side: &Expr| opened(side, &subject.claim.declarations, DEPTH);
            let equal = opened(left).placeless() == opened(right).placeless();
            if *relation == Relation::Equal && equal {
                let (left, right) = (notation::text(left), notation::text(right));
                let seen = format!("`{left}` and `{right}` are the same formula");
                signs.push(sign(Flag::EqualSides, seen));
            }
            left = right;
        }
    }
    signs
}

/// Replaces names by the bodies of their plain definitions.
fn opened(expr: &Expr, declarations: &Declarations, depth: usize) -> Expr {
    if let Node::Name(name) = &expr.node
        && let Some(definition) = declarations.definition(name)
        && definition.parameters.is_empty()
        && depth > 0
    {
        return opened(&definition.body.expr, declarations, depth - 1);
    }
    expr.with_parts(|part| opened(part, declarations, depth))
}
