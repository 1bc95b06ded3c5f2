//! Syntax trees made from algebra's atoms, in the shape that their own text is read back as: a minus
//! sign sits on the first factor, products and sums group to the left.

use num_traits::{One, Signed};
use std::sync::Arc;
use torse_algebra::{Affine, Angle, Exponent, Rational, Symbol, Unit, rational};
use torse_syntax::formula::{Expr, Node, Operator, parse};

/// A summand with its sign apart.
#[derive(Debug, Clone)]
pub(super) struct Summand {
    pub negative: bool,
    pub body: Expr,
}

/// Begins with a positive summand if there is one: the other way round where that is enough.
pub(super) fn positive_first(mut terms: Vec<Summand>) -> Vec<Summand> {
    if terms.first().is_some_and(|first| first.negative) {
        if terms.last().is_some_and(|last| !last.negative) {
            terms.reverse();
        } else if let Some(position) = terms.iter().position(|term| !term.negative) {
            terms[..=position].rotate_right(1);
        }
    }
    terms
}

/// The sum; zero for none.
pub(super) fn sum(terms: Vec<Summand>) -> Expr {
    let mut terms = terms.into_iter();
    let Some(first) = terms.next() else {
        return integer(0);
    };
    let first = if first.negative {
        negated(first.body)
    } else {
        first.body
    };
    terms.fold(first, |sum, term| {
        let operator = if term.negative {
            Operator::Subtract
        } else {
            Operator::Add
        };
        sum.with(operator, term.body)
    })
}

/// The product; one for none.
pub(super) fn product(factors: Vec<Expr>) -> Expr {
    factors
        .into_iter()
        .reduce(|a, b| a.with(Operator::Multiply, b))
        .unwrap_or_else(|| integer(1))
}

/// The formula with a minus sign on its first factor.
pub(super) fn negated(expr: Expr) -> Expr {
    match expr.node {
        Node::Binary(operator @ (Operator::Multiply | Operator::Divide), a, b) => {
            negated(Arc::unwrap_or_clone(a)).with(operator, Arc::unwrap_or_clone(b))
        }
        node => Expr::made(Node::Negative(Arc::new(Expr::made(node)))),
    }
}

/// `base^exponent`; the base itself for exponent one.
pub(super) fn power(base: Expr, exponent: u32) -> Expr {
    match exponent {
        1 => base,
        _ => base.with(Operator::Power, integer(i64::from(exponent))),
    }
}

/// An integer.
pub(super) fn integer(value: i64) -> Expr {
    Expr::number(&rational::integer(value))
}

/// A positive rational as a first factor: none for one.
pub(super) fn coefficient(value: &Rational) -> Vec<Expr> {
    if value.is_one() {
        vec![]
    } else {
        vec![Expr::number(value)]
    }
}

/// A symbol of the algebra.
pub(super) fn symbol(symbol: &Symbol) -> Expr {
    let applied =
        |name: &str, argument| Expr::made(Node::Call(Arc::new(Expr::name(name)), vec![argument]));
    let angle = |variable: &str, Angle { unit, parts }: &Angle| match (unit, parts) {
        (Unit::Radian, 1) => Expr::name(variable),
        (Unit::Radian, parts) => {
            Expr::name(variable).with(Operator::Divide, integer(i64::from(*parts)))
        }
        (Unit::QuarterTurn, parts) => {
            let part = Expr::name("pi").with(Operator::Divide, integer(2 * i64::from(*parts)));
            part.with(Operator::Multiply, Expr::name(variable))
        }
    };
    match symbol {
        Symbol::Named(name) => named(name),
        Symbol::Pi => Expr::name("pi"),
        Symbol::Root(prime) => applied("sqrt", integer(i64::from(*prime))),
        Symbol::Log(prime) => applied("log", integer(i64::from(*prime))),
        Symbol::Arc(above, below) => {
            let part = |n: u32| integer(i64::from(n));
            applied("atan", part(*above).with(Operator::Divide, part(*below)))
        }
        Symbol::Sin(name, a) => applied("sin", angle(name, a)),
        Symbol::Cos(name, a) => applied("cos", angle(name, a)),
        Symbol::Exp(exponent) => applied("exp", exponent_of(exponent)),
        // The generic coordinate of a vector is written like the vector.
        Symbol::Indexed(name, index) if index.is_empty() => named(name),
        Symbol::Indexed(name, index) => {
            let index = index.iter().map(affine).collect();
            Expr::made(Node::Index(Arc::new(named(name)), index))
        }
    }
}

/// A declared name, or a smooth function at a place: `c''(u)`.
fn named(name: &str) -> Expr {
    match name.contains('(') {
        true => parse(name).unwrap_or_else(|_| Expr::name(name)),
        false => Expr::name(name),
    }
}

/// What stands under an exponential.
fn exponent_of(exponent: &Exponent) -> Expr {
    let power = |(name, power): &(Arc<str>, u16)| match power {
        1 => Expr::name(name),
        power => Expr::name(name).with(Operator::Power, integer(i64::from(*power))),
    };
    let factors: Vec<Expr> = exponent.powers().iter().map(power).collect();
    let monomial = match factors.is_empty() {
        true => integer(1),
        false => product(factors),
    };
    match exponent.parts() {
        1 => monomial,
        parts => monomial.with(Operator::Divide, integer(i64::from(parts))),
    }
}

/// An index such as `k - 2`.
fn affine(index: &Affine) -> Expr {
    let constant = index.constant();
    let number =
        (constant != 0 || index.as_number().is_some()).then(|| rational::integer(constant));
    let multiples = index.multiples().map(|(name, multiple)| {
        let multiple = rational::integer(multiple);
        let mut factors = coefficient(&multiple.abs());
        factors.push(Expr::name(name));
        Summand {
            negative: multiple.is_negative(),
            body: product(factors),
        }
    });
    let number = number.map(|number| Summand {
        negative: number.is_negative(),
        body: Expr::number(&number.abs()),
    });
    sum(multiples.chain(number).collect())
}

/// Where a symbol stands within a product, as one would write it by hand: roots, pi, names, functions,
/// control points.
pub(super) fn rank(symbol: &Symbol) -> u8 {
    match symbol {
        Symbol::Root(_) => 0,
        Symbol::Pi | Symbol::Log(_) | Symbol::Arc(..) => 1,
        Symbol::Named(_) => 2,
        Symbol::Sin(..) | Symbol::Cos(..) | Symbol::Exp(_) => 3,
        Symbol::Indexed(..) => 4,
    }
}
