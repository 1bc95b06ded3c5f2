//! A normal form of trees up to brackets: chains of sums, products and `and` are flat, a sign stands before its product.

use std::sync::Arc;
use torse_syntax::formula::{Connective, Expr, Node, Operator, parse};

/// The normal form of a formula in the language of the files.
pub fn normal_text(text: &str) -> Expr {
    normal(&parse(text).unwrap_or_else(|error| unreachable!("{text}: {error}")))
}

/// The normal form.
pub fn normal(formula: &Expr) -> Expr {
    let formula = formula.placeless().with_parts(normal);
    match &formula.node {
        Node::Number { value, .. } => Expr::number(value),
        Node::Binary(Operator::Add | Operator::Subtract, ..) => {
            let mut terms = vec![];
            terms_of(&formula, false, &mut terms);
            let mut terms = terms.into_iter();
            let (negative, first) = terms.next().unwrap();
            let first = if negative { negated(first) } else { first };
            terms.fold(first, |sum, (negative, term)| {
                sum.with(
                    if negative {
                        Operator::Subtract
                    } else {
                        Operator::Add
                    },
                    term,
                )
            })
        }
        Node::Negative(_) | Node::Binary(Operator::Multiply | Operator::Divide, ..) => {
            let (mut above, mut below, mut negative) = (vec![], vec![], false);
            factors(&formula, false, &mut negative, &mut above, &mut below);
            let product = |list: Vec<Expr>| {
                list.into_iter()
                    .reduce(|a, b| a.with(Operator::Multiply, b))
            };
            let one = Expr::number(&torse_numbers::Rational::from_integer(1.into()));
            let mut whole = product(above).unwrap_or(one);
            if let Some(below) = product(below) {
                whole = whole.with(Operator::Divide, below);
            }
            if negative { negated(whole) } else { whole }
        }
        Node::Join(Connective::And, a, b) => match &b.node {
            Node::Join(Connective::And, c, d) => {
                let left = Expr::made(Node::Join(Connective::And, Arc::clone(a), Arc::clone(c)));
                normal(&Expr::made(Node::Join(
                    Connective::And,
                    Arc::new(left),
                    Arc::clone(d),
                )))
            }
            _ => formula,
        },
        _ => formula,
    }
}

fn negated(formula: Expr) -> Expr {
    Expr::made(Node::Negative(Arc::new(formula)))
}

fn terms_of(formula: &Expr, negative: bool, terms: &mut Vec<(bool, Expr)>) {
    match &formula.node {
        Node::Binary(operator @ (Operator::Add | Operator::Subtract), a, b) => {
            terms_of(a, negative, terms);
            terms_of(b, negative ^ (*operator == Operator::Subtract), terms);
        }
        Node::Negative(inner) => terms_of(inner, !negative, terms),
        _ => terms.push((negative, formula.clone())),
    }
}

fn factors(
    formula: &Expr,
    inverse: bool,
    negative: &mut bool,
    above: &mut Vec<Expr>,
    below: &mut Vec<Expr>,
) {
    match &formula.node {
        Node::Negative(inner) => {
            *negative = !*negative;
            factors(inner, inverse, negative, above, below);
        }
        Node::Binary(Operator::Multiply, a, b) => {
            factors(a, inverse, negative, above, below);
            factors(b, inverse, negative, above, below);
        }
        Node::Binary(Operator::Divide, a, b) => {
            factors(a, inverse, negative, above, below);
            factors(b, !inverse, negative, above, below);
        }
        _ if inverse => below.push(formula.clone()),
        _ => above.push(formula.clone()),
    }
}
