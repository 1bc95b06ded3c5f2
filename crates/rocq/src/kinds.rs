//! The kinds of the variables of a family.

use crate::context::{Kind, Used};
use crate::shape::Shape;
use std::collections::BTreeSet;
use torse_core::{Family, Node, Term, Variable};

/// Decides the kinds of the variable and the parameters of a family: integers if they occur in an index, else numbers.
#[must_use]
pub fn kinds(family: &Family) -> Vec<Kind> {
    let mut indexing = BTreeSet::new();
    for part in family.seeds.iter().chain([&family.step.0, &family.step.1]) {
        collect_indexing(part, &mut indexing);
    }
    let kind = |variable: &Variable| match indexing.contains(variable) {
        true => Kind::Integer,
        false => Kind::Value(Shape::Number),
    };
    family.variables.iter().map(kind).collect()
}

/// Collects the variables in indices of members.
fn collect_indexing(term: &Term, found: &mut BTreeSet<Variable>) {
    if let Node::Member(_, indices) = &*term.node {
        found.extend(
            indices
                .iter()
                .flat_map(|index| Used::from_term(index).variables.into_iter()),
        );
    }
    for part in term.parts() {
        collect_indexing(part, found);
    }
}
