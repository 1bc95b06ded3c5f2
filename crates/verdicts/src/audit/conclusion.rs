//! Flags conclusions that are assumed.

use super::{RaisedFlag, Subject, raised};
use crate::conjunction::conjuncts;
use std::sync::Arc;
use torse_syntax::formula::{Expr, Node};
use torse_syntax::notation;
use torse_syntax::taxonomy::Flag;

/// Returns the parts of the statement that are hypotheses, with their sides in either order.
pub(super) fn assumed(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let hypotheses = subject.claim.assumptions.iter().chain(&subject.claim.given);
    let hypotheses = hypotheses.flat_map(|h| conjuncts(&h.formula.expr));
    let hypotheses: Vec<Expr> = hypotheses.map(|part| part.placeless()).collect();
    let statement = subject.claim.statement.iter();
    let parts = statement.flat_map(|w| conjuncts(&w.expr));
    let assumed = parts.filter(|part| {
        let part = part.placeless();
        hypotheses.contains(&part) || turned(&part).is_some_and(|t| hypotheses.contains(&t))
    });
    assumed
        .map(|part| {
            let evidence = format!("`{}` is stated and assumed", notation::text(part));
            raised(Flag::AssumedConclusion, evidence)
        })
        .collect()
}

/// Returns `b == a` for `a == b`, `b > a` for `a < b`.
fn turned(part: &Expr) -> Option<Expr> {
    let Node::Compare(left, rest) = &part.node else {
        return None;
    };
    let [(relation, right)] = rest.as_slice() else {
        return None;
    };
    let rest = vec![(relation.mirrored(), (**left).clone())];
    Some(Expr::made(Node::Compare(Arc::new(right.clone()), rest)))
}
