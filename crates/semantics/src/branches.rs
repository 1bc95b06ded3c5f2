//! The thin parts of a domain on which a statement may fail though it holds elsewhere, as the text shows them.
//!
//! Points that are drawn at random satisfy an equation where it is easily solved. Where a coefficient vanishes the same equation
//! says something else: `x*(y^2 - 2) == 0` holds for x = 0, and where `y^2 == 2` for every x. So for each equation among hypotheses
//! and premises, and each symbol in it, the points are looked for at which the equation does not move with the symbol; besides
//! those at which a premise is true, and those at which both sides of a comparison in the statement are equal.

use crate::domain::constraints::constraints;
use crate::tree::Reading;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::{Connective, Expr, Node, Operator, Relation};

/// How many parts of one domain are visited.
const MAX_BRANCHES: usize = 12;
/// How deep definitions of statements are opened.
const MAX_OPENED: u32 = 16;

/// What is true on each thin part of a domain, in the order in which they are visited.
pub(crate) fn branches(reading: &Reading<'_>) -> Vec<Expr> {
    let declarations = reading.declarations();
    let mut found = Found::default();
    found.collect(declarations, reading.tree(), MAX_OPENED);
    let assumed: Vec<&Expr> = reading
        .hypotheses()
        .chain(found.premises.iter().copied())
        .collect();
    let equations = constraints(declarations, &assumed);
    let equations = equations
        .into_iter()
        .filter(|(relation, ..)| *relation == Relation::Equal);
    let premises = found.premises.iter().filter(|premise| {
        let all = constraints(declarations, &[**premise]);
        all.iter()
            .any(|(relation, ..)| *relation == Relation::Equal)
    });
    let mut all: Vec<Expr> = premises.map(|premise| Expr::clone(premise)).collect();
    for (_, left, right) in equations {
        let difference = left.clone().with(Operator::Subtract, right.clone());
        for symbol in numbers_in(declarations, [left, right]) {
            let symbol = Expr::name(symbol);
            let rate = Node::Call(Arc::new(Expr::name("D")), vec![difference.clone(), symbol]);
            all.push(equal(Expr::made(rate), Expr::number(&integer(0))));
        }
    }
    let sides = found.sides.iter();
    all.extend(sides.map(|(left, right)| equal((*left).clone(), (*right).clone())));
    all.truncate(MAX_BRANCHES);
    all
}

fn equal(left: Expr, right: Expr) -> Expr {
    Expr::made(Node::Compare(
        Arc::new(left),
        vec![(Relation::Equal, right)],
    ))
}

/// The declared real numbers that are written in formulas.
fn numbers_in<'a>(declarations: &Declarations, trees: [&'a Expr; 2]) -> BTreeSet<&'a str> {
    let names = trees.into_iter().flat_map(Expr::names);
    let numbers = names.filter(|name| {
        let is_definition = declarations.definition(name).is_some();
        !is_definition && matches!(declarations.symbol(name), Some(SymbolKind::Real(_)))
    });
    numbers.collect()
}

/// What a statement has in it.
#[derive(Default)]
struct Found<'a> {
    premises: Vec<&'a Expr>,
    /// The sides of comparisons that are no equations.
    sides: Vec<(&'a Expr, &'a Expr)>,
}

impl<'a> Found<'a> {
    fn collect(&mut self, declarations: &'a Declarations, tree: &'a Expr, depth: u32) {
        match &tree.node {
            Node::Join(connective, a, b) => {
                if *connective == Connective::Implies {
                    self.premises.push(a);
                }
                self.collect(declarations, a, depth);
                self.collect(declarations, b, depth);
            }
            Node::Not(inner) => self.collect(declarations, inner, depth),
            Node::Compare(first, rest) => {
                let mut left = &**first;
                for (relation, right) in rest {
                    if *relation != Relation::Equal {
                        self.sides.push((left, right));
                    }
                    left = right;
                }
            }
            Node::Name(name) => {
                let definition = declarations.definition(name);
                if let (Some(definition), Some(depth)) = (definition, depth.checked_sub(1)) {
                    self.collect(declarations, &definition.body.expr, depth);
                }
            }
            _ => {}
        }
    }
}
