//! The comparisons among the hypotheses of a claim.

use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::{Connective, Expr, Node, Relation};

/// The largest depth to which definitions of statements are opened.
const MAX_OPENED: u32 = 16;

/// A comparison that every point of the domain satisfies.
pub(crate) type Constraint<'a> = (Relation, &'a Expr, &'a Expr);

/// The comparisons that are true wherever all hypotheses are: the parts of conjunctions, and of negated disjunctions.
pub(crate) fn constraints<'a>(
    declarations: &'a Declarations,
    hypotheses: &[&'a Expr],
) -> Vec<Constraint<'a>> {
    let mut all = vec![];
    for tree in hypotheses {
        collect(declarations, tree, false, MAX_OPENED, &mut all);
    }
    all
}

/// Whether a hypothesis is a conjunction of equations, so that all of it is solved.
pub(crate) fn is_equations(declarations: &Declarations, tree: &Expr) -> bool {
    let mut all = vec![];
    let complete = collect(declarations, tree, false, MAX_OPENED, &mut all);
    complete
        && all
            .iter()
            .all(|(relation, ..)| *relation == Relation::Equal)
}

/// Adds the comparisons of which a statement, or its negation, is a conjunction. Returns whether these are equivalent
/// to it.
fn collect<'a>(
    declarations: &'a Declarations,
    tree: &'a Expr,
    is_negated: bool,
    depth: u32,
    all: &mut Vec<Constraint<'a>>,
) -> bool {
    match &tree.node {
        Node::Join(connective, a, b) => {
            let first_negated = match (connective, is_negated) {
                (Connective::And, false) | (Connective::Implies, true) => false,
                (Connective::Or, true) => true,
                _ => return false,
            };
            let first = collect(declarations, a, first_negated, depth, all);
            collect(declarations, b, is_negated, depth, all) && first
        }
        Node::Not(inner) => collect(declarations, inner, !is_negated, depth, all),
        Node::Compare(first, rest) if !is_negated || rest.len() == 1 => {
            let mut left = &**first;
            for (relation, right) in rest {
                let relation = if is_negated {
                    relation.opposite()
                } else {
                    *relation
                };
                all.push((relation, left, right));
                left = right;
            }
            true
        }
        Node::Name(name) => match (declarations.definition(name), depth.checked_sub(1)) {
            (Some(definition), Some(depth)) => {
                collect(declarations, &definition.body.expr, is_negated, depth, all)
            }
            _ => false,
        },
        _ => false,
    }
}
