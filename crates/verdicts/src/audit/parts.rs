//! A statement with fewer relations than the sentence.

use super::formulas::{Formulas, every};
use super::{Sign, Subject, sign};
use torse_language::derivation::Claim;
use torse_language::syntax::{Expr, Node, Relation};
use torse_language::words::Flag;

/// The relations that a claim states or assumes; a definition that it uses and a narrowed range count as one.
pub(super) fn relations_of(claim: &Claim) -> usize {
    let formulas = Formulas::of(claim);
    let mut count = claim.entry.symbols.len();
    for expr in &formulas.own {
        every(expr, &mut |part| count += relations(part));
    }
    let defined = formulas.names.iter();
    count
        + defined
            .filter(|name| claim.declarations.definition(name).is_some())
            .count()
}

/// The relations of a formula by itself: an equation of vectors is one for each entry that is written out.
fn relations(expr: &Expr) -> usize {
    match &expr.node {
        Node::Compare(_, rest) => rest.iter().map(|(_, side)| entries(side)).sum(),
        _ => 0,
    }
}

fn entries(expr: &Expr) -> usize {
    match &expr.node {
        Node::List(items) => items.iter().map(entries).sum(),
        _ => 1,
    }
}

/// Whether an equation is stated.
pub(super) fn has_equation(expr: &Expr) -> bool {
    let mut found = false;
    every(expr, &mut |part| {
        if let Node::Compare(_, rest) = &part.node {
            found |= rest
                .iter()
                .any(|(relation, _)| *relation == Relation::Equal);
        }
    });
    found
}

/// A sentence of which all parts together state fewer relations than are printed.
pub(super) fn short(subject: &Subject<'_>) -> Vec<Sign> {
    let (stated, printed) = (subject.relations_of_all_parts, subject.print.relations);
    match stated < printed {
        true => {
            let seen = format!("{printed} relations are printed, {stated} stated or defined");
            vec![sign(Flag::ShortConjunction, seen)]
        }
        false => vec![],
    }
}
