//! Writes conditions as formulas, and reads formulas back.

use std::sync::Arc;
use torse_algebra::Polynomial;
use torse_algebra::rational::integer;
use torse_prove::formula;
use torse_syntax::derivation::{Origin, Source, Written};
use torse_syntax::formula::{Expr, Node, Relation, parse};
use torse_syntax::notation::{self, Formula};

/// `p != 0`.
pub fn nonzero(polynomial: &Polynomial) -> Formula {
    let left = formula::expression(&polynomial.clone().into());
    let zero = Expr::number(&integer(0));
    let different = vec![(Relation::Different, zero)];
    notation::formula(&Expr::made(Node::Compare(Arc::new(left), different)))
}

/// Reads back a formula of an outcome; `name` stands for the file in messages.
pub fn written(formula: &Formula, name: &str) -> Option<Written> {
    let source = Arc::new(Source::new(name, formula.text.clone()));
    let origin = Origin::range(&source, 0, formula.text.len());
    let expr = parse(&formula.text).ok()?;
    Some(Written { expr, origin })
}
