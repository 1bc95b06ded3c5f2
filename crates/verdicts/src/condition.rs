//! Conditions as formulas.

use std::sync::Arc;
use torse_algebra::Polynomial;
use torse_algebra::rational::integer;
use torse_language::notation::{self, Formula};
use torse_language::syntax::{Expr, Node, Relation};
use torse_prove::formula;

/// `p != 0`.
pub fn nonzero(polynomial: &Polynomial) -> Formula {
    let left = formula::expression(&polynomial.clone().into());
    let zero = Expr::number(&integer(0));
    let different = vec![(Relation::Different, zero)];
    notation::formula(&Expr::made(Node::Compare(Arc::new(left), different)))
}
