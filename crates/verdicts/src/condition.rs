//! Writes conditions as formulas, and reads formulas back.

use std::sync::Arc;
use torse_algebra::Polynomial;
use torse_algebra::rational::integer;
use torse_prove::formula;
use torse_syntax::derivation::{Origin, Source, Written};
use torse_syntax::formula::{Expr, Node, Relation, parse};
use torse_syntax::notation::{self, Formula};

/// Writes `p != 0`.
pub fn nonzero(polynomial: &Polynomial) -> Formula {
    notation::formula(&nonzero_expression(polynomial))
}

/// Returns the formula `p != 0`.
pub fn nonzero_expression(polynomial: &Polynomial) -> Expr {
    different_from_zero(formula::expression_of(polynomial))
}

/// Returns the comparison of a formula with zero, `formula != 0`.
pub fn different_from_zero(formula: Expr) -> Expr {
    let zero = Expr::number(&integer(0));
    let different = vec![(Relation::Different, zero)];
    Expr::made(Node::Compare(Arc::new(formula), different))
}

/// Reads back a formula of an outcome; `name` stands for the file in messages.
pub fn written(formula: &Formula, name: &str) -> Option<Written> {
    let source = Arc::new(Source::new(name, formula.text.clone()));
    let origin = Origin::range(&source, 0, formula.text.len());
    let expr = parse(&formula.text).ok()?;
    Some(Written { expr, origin })
}
