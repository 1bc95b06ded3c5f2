//! Simplifies formulas for reading: removes factors 1, terms 0, nested brackets of one kind, double signs.
//!
//! The simplified formula has the same value wherever the original one has a value.

use std::sync::Arc;
use torse_syntax::formula::{Expr, Node, Operator};
use torse_syntax::notation::text;

/// Simplifies the formula.
pub(crate) fn tidy(formula: &Expr) -> Expr {
    let formula = formula.with_parts(tidy);
    match &formula.node {
        Node::Binary(Operator::Add | Operator::Subtract, ..) => sum(terms(&formula)),
        Node::Negative(inner) => negative(inner),
        Node::Binary(Operator::Multiply, ..) => product(factors(&formula)),
        Node::Binary(Operator::Divide, a, b) if is_one(b) => (**a).clone(),
        Node::Binary(Operator::Divide, a, b) => match &a.node {
            Node::Negative(inner) => {
                negated((**inner).clone().with(Operator::Divide, (**b).clone()))
            }
            _ => formula,
        },
        Node::Binary(Operator::Power, a, b) if is_one(b) => (**a).clone(),
        _ => formula,
    }
}

pub(crate) fn is_zero(formula: &Expr) -> bool {
    is(formula, "0")
}

fn is_one(formula: &Expr) -> bool {
    is(formula, "1")
}

/// Whether the formula is a number of these digits.
fn is(formula: &Expr, digits: &str) -> bool {
    matches!(formula.node, Node::Number { .. }) && text(formula) == digits
}

/// A small whole number.
fn whole(number: i64) -> Expr {
    Expr::number(&number.into())
}

/// A number, or a quotient of two.
fn is_number(formula: &Expr) -> bool {
    match &formula.node {
        Node::Number { .. } => true,
        Node::Binary(Operator::Divide, a, b) => is_number(a) && is_number(b),
        _ => false,
    }
}

fn negated(formula: Expr) -> Expr {
    Expr::made(Node::Negative(Arc::new(formula)))
}

fn negative(inner: &Expr) -> Expr {
    match &inner.node {
        Node::Negative(twice) => (**twice).clone(),
        _ if is_zero(inner) => inner.clone(),
        _ => negated(inner.clone()),
    }
}

/// A term with its sign.
pub(crate) type Term = (Operator, Expr);

/// Returns the terms of a sum, in order; for anything else, itself.
pub(crate) fn terms(formula: &Expr) -> Vec<Term> {
    let mut list = Vec::new();
    // Sums group to the left and may have thousands of terms.
    let mut rest = formula;
    while let Node::Binary(operator @ (Operator::Add | Operator::Subtract), a, b) = &rest.node {
        match (&b.node, operator) {
            (Node::Binary(Operator::Add | Operator::Subtract, ..), Operator::Add) => {
                list.extend(terms(b).into_iter().rev());
            }
            (Node::Negative(inner), _) => list.push((opposite(*operator), (**inner).clone())),
            _ => list.push((*operator, (**b).clone())),
        }
        rest = a;
    }
    match &rest.node {
        Node::Negative(inner) => list.push((Operator::Subtract, (**inner).clone())),
        _ => list.push((Operator::Add, rest.clone())),
    }
    list.reverse();
    list
}

fn opposite(operator: Operator) -> Operator {
    match operator {
        Operator::Add => Operator::Subtract,
        _ => Operator::Add,
    }
}

/// Adds terms, without zeros.
pub(crate) fn sum(terms: Vec<Term>) -> Expr {
    let mut terms = terms.into_iter().filter(|(_, term)| !is_zero(term));
    let Some((sign, first)) = terms.next() else {
        return whole(0);
    };
    let first = match sign {
        Operator::Subtract => negated(first),
        _ => first,
    };
    terms.fold(first, |sum, (sign, term)| sum.with(sign, term))
}

/// Returns the factors of a product, in order; for anything else, itself.
pub(crate) fn factors(formula: &Expr) -> Vec<Expr> {
    match &formula.node {
        Node::Binary(Operator::Multiply, a, b) => {
            let mut list = factors(a);
            list.extend(factors(b));
            list
        }
        _ => vec![formula.clone()],
    }
}

/// Multiplies factors: a single number first, without ones, the sign before it.
pub(crate) fn product(factors: Vec<Expr>) -> Expr {
    let mut minus = false;
    let mut list = Vec::new();
    for factor in factors {
        match &factor.node {
            Node::Negative(inner) => {
                minus = !minus;
                list.extend(self::factors(inner));
            }
            _ => list.push(factor),
        }
    }
    if list.iter().any(is_zero) {
        return whole(0);
    }
    list.retain(|factor| !is_one(factor));
    if list.iter().filter(|factor| is_number(factor)).count() == 1 {
        list.sort_by_key(|factor| !is_number(factor));
    }
    let product = list
        .into_iter()
        .reduce(|a, b| a.with(Operator::Multiply, b));
    let product = product.unwrap_or_else(|| whole(1));
    match minus {
        true => negated(product),
        false => product,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_syntax::formula::parse;

    #[test]
    fn factors_one_terms_zero_double_signs_and_superfluous_brackets_go() {
        for (given, tidied) in [
            ("(1)*g[1,2]", "g[1,2]"),
            ("1*H(1) + 0*H'(1)", "H(1)"),
            ("a - (-b) + (c - d) - (e - f)", "a + b + c - d - (e - f)"),
            ("pi*(1/2*((2 + x)*(p - q)))", "1/2*pi*(2 + x)*(p - q)"),
            ("-(-x)", "x"),
            ("a*(-b)", "-(a*b)"),
            ("0 - x", "-x"),
            ("0*x", "0"),
            ("x^1/1", "x"),
            ("-0", "0"),
            ("1*1", "1"),
            ("2*3*x", "2*3*x"),
            ("a/b*(c/d)", "a/b*(c/d)"),
        ] {
            assert_eq!(text(&tidy(&parse(given).unwrap())), tidied, "{given}");
        }
    }
}
