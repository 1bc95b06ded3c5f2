//! The thin parts of a domain on which a statement may fail although it holds elsewhere, found from the text.
//!
//! Random points satisfy an equation where it is easily solved. But where a coefficient vanishes, the equation means
//! something else: `x*(y^2 - 2) == 0` holds for x = 0, and for every x if `y^2 == 2`. So for each equation among
//! hypotheses and premises and each symbol in it, points are sought at which the derivative of the equation by the
//! symbol vanishes; also points at which a premise is true, and points at which both sides of a comparison in the
//! statement are equal.

use crate::domain::constraints::constraints;
use crate::tree::Reading;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::{Connective, Expr, Node, Operator, Relation};

/// The largest number of parts of one domain that are visited.
const MAX_BRANCHES: usize = 12;
/// The largest depth to which definitions of statements are opened.
const MAX_OPENED: u32 = 16;

/// A thin part of a domain.
pub(crate) struct Branch {
    /// The equation that is satisfied before all others.
    pub first: Expr,
    /// All that is assumed there in addition to the hypotheses.
    pub inside: Expr,
}

impl Branch {
    /// The part on which this is true.
    pub(crate) fn new(inside: Expr) -> Self {
        Self {
            first: inside.clone(),
            inside,
        }
    }
}

/// The thin parts of a domain, in the order of visits.
pub(crate) fn branches(reading: &Reading<'_>) -> Vec<Branch> {
    let declarations = reading.declarations();
    let mut found = Found::default();
    found.collect(declarations, reading.tree(), MAX_OPENED);
    let mut all = vec![];
    for premise in &found.premises {
        let equations = equations(declarations, &[*premise]);
        if equations.is_empty() {
            continue;
        }
        all.push(Branch::new(Expr::clone(premise)));
        for first in stationary(declarations, &equations) {
            let both = (Arc::new(first.clone()), Arc::new(Expr::clone(premise)));
            all.push(Branch {
                first,
                inside: Expr::made(Node::Join(Connective::And, both.0, both.1)),
            });
        }
    }
    let assumed: Vec<&Expr> = reading.hypotheses().collect();
    let rates = stationary(declarations, &equations(declarations, &assumed));
    let sides = found.sides.iter();
    let sides = sides.map(|(left, right)| equal((*left).clone(), (*right).clone()));
    all.extend(rates.into_iter().chain(sides).map(Branch::new));
    all.truncate(MAX_BRANCHES);
    all
}

/// The equations that hold wherever all of these statements are true.
fn equations<'a>(declarations: &'a Declarations, trees: &[&'a Expr]) -> Vec<(&'a Expr, &'a Expr)> {
    let all = constraints(declarations, trees).into_iter();
    let equations = all.filter(|(relation, ..)| *relation == Relation::Equal);
    equations.map(|(_, left, right)| (left, right)).collect()
}

/// For each equation and each symbol in it: the statement that the derivative of the equation by the symbol vanishes.
fn stationary(declarations: &Declarations, equations: &[(&Expr, &Expr)]) -> Vec<Expr> {
    let mut all = vec![];
    for (left, right) in equations {
        let difference = Expr::clone(left).with(Operator::Subtract, Expr::clone(right));
        for symbol in numbers_in(declarations, [left, right]) {
            let arguments = vec![difference.clone(), Expr::name(symbol)];
            let rate = Node::Call(Arc::new(Expr::name("D")), arguments);
            all.push(equal(Expr::made(rate), Expr::number(&integer(0))));
        }
    }
    all
}

/// The statement that two formulas are equal.
pub(crate) fn equal(left: Expr, right: Expr) -> Expr {
    Expr::made(Node::Compare(
        Arc::new(left),
        vec![(Relation::Equal, right)],
    ))
}

/// The declared real numbers that occur in formulas.
fn numbers_in<'a>(declarations: &Declarations, trees: [&'a Expr; 2]) -> BTreeSet<&'a str> {
    let names = trees.into_iter().flat_map(Expr::names);
    let numbers = names.filter(|name| {
        let is_definition = declarations.definition(name).is_some();
        !is_definition && matches!(declarations.symbol(name), Some(SymbolKind::Real(_)))
    });
    numbers.collect()
}

/// The parts of a statement that give rise to branches.
#[derive(Default)]
struct Found<'a> {
    premises: Vec<&'a Expr>,
    /// The sides of comparisons other than equations.
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
