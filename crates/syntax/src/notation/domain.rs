//! Declared sets as formulas and as words.

use super::text::text;
use crate::derivation::declarations::{Bound, Constant, End, SymbolKind};
use crate::formula::{Expr, Node, Operator, Relation};
use std::sync::Arc;
use torse_numbers::{Affine, Rational, rational};

/// The range as a statement such as `0 < mu <= 1`; `None` for the whole real line and for kinds other than numbers.
#[must_use]
pub fn statement(name: &str, kind: &SymbolKind) -> Option<Expr> {
    let below = |closed: bool| {
        if closed {
            Relation::AtMost
        } else {
            Relation::Less
        }
    };
    let above = |closed: bool| {
        if closed {
            Relation::AtLeast
        } else {
            Relation::Greater
        }
    };
    let (low, high) = match kind {
        SymbolKind::Real(interval) => (
            end(&interval.lower, &interval.above),
            end(&interval.upper, &interval.below),
        ),
        SymbolKind::Integer { least, most } => (
            least.as_ref().map(|form| (affine(form), true)),
            most.as_ref().map(|form| (affine(form), true)),
        ),
        SymbolKind::Vector(_) | SymbolKind::Family { .. } => return None,
    };
    let name = Expr::name(name);
    let (first, rest) = match (low, high) {
        (None, None) => return None,
        (Some((low, closed)), None) => (name, vec![(above(closed), low)]),
        (None, Some((high, closed))) => (name, vec![(below(closed), high)]),
        (Some((low, left)), Some((high, right))) => {
            (low, vec![(below(left), name), (below(right), high)])
        }
    };
    Some(Expr::made(Node::Compare(Arc::new(first), rest)))
}

/// A bound of an interval as a formula, and whether it belongs to the interval.
fn end(number: &Option<Bound>, formula: &Option<End>) -> Option<(Expr, bool)> {
    let number = number.as_ref();
    let number = number.map(|bound| (constant(&bound.value), bound.closed));
    let formula = formula.as_ref();
    number.or_else(|| formula.map(|end| (end.formula.expr.placeless(), end.closed)))
}

fn constant(value: &Constant) -> Expr {
    let zero = rational::integer(0);
    let turns = |q: &Rational| {
        if *q == rational::integer(1) {
            Expr::name("pi")
        } else {
            Expr::number(q).with(Operator::Multiply, Expr::name("pi"))
        }
    };
    match (value.rational == zero, value.turns == zero) {
        (_, true) => Expr::number(&value.rational),
        (true, false) => turns(&value.turns),
        (false, false) => Expr::number(&value.rational).with(Operator::Add, turns(&value.turns)),
    }
}

/// An integer-affine form as a formula.
fn affine(form: &Affine) -> Expr {
    let number = |n: i64| Expr::number(&rational::integer(n));
    let mut sum: Option<Expr> = None;
    for (name, multiple) in form.multiples() {
        let term = match multiple {
            1 => Expr::name(name),
            n => number(n).with(Operator::Multiply, Expr::name(name)),
        };
        sum = Some(match sum {
            None => term,
            Some(before) => before.with(Operator::Add, term),
        });
    }
    let rest = form.constant();
    match sum {
        None => number(rest),
        Some(sum) if rest == 0 => sum,
        Some(sum) if rest < 0 => sum.with(Operator::Subtract, number(-rest)),
        Some(sum) => sum.with(Operator::Add, number(rest)),
    }
}

/// The set of a symbol in words: `mu in [-1, 1]`, `k >= 2, an integer`, `Q[0..k], points with 4 coordinates`.
#[must_use]
pub fn words(name: &str, kind: &SymbolKind) -> String {
    let printed = |form: &Affine| text(&affine(form));
    let coordinates = |dimension: &Option<u8>| match dimension {
        None => "of any dimension".to_owned(),
        Some(n) => format!("with {n} coordinates"),
    };
    match kind {
        SymbolKind::Real(interval) => {
            let shown = |end: &Option<(Expr, bool)>, infinite: &str| match end {
                None => (infinite.to_owned(), false),
                Some((end, closed)) => (text(end), *closed),
            };
            let ends = [
                end(&interval.lower, &interval.above),
                end(&interval.upper, &interval.below),
            ];
            let [(low, low_closed), (high, high_closed)] =
                [shown(&ends[0], "-inf"), shown(&ends[1], "inf")];
            let left = if low_closed { '[' } else { '(' };
            let right = if high_closed { ']' } else { ')' };
            match ends {
                [None, None] => format!("{name}, a real number"),
                _ => format!("{name} in {left}{low}, {high}{right}"),
            }
        }
        SymbolKind::Integer { .. } => match statement(name, kind) {
            None => format!("{name}, an integer"),
            Some(range) => format!("{}, an integer", text(&range)),
        },
        SymbolKind::Vector(dimension) => format!("{name}, a vector {}", coordinates(dimension)),
        SymbolKind::Family { dimension, ranges } => {
            let ranges: Vec<String> = ranges
                .iter()
                .map(|(low, high)| format!("{}..{}", printed(low), printed(high)))
                .collect();
            let indices = if ranges.is_empty() {
                String::new()
            } else {
                format!("[{}]", ranges.join(", "))
            };
            match dimension {
                Some(1) => format!("{name}{indices}, numbers"),
                of => format!("{name}{indices}, points {}", coordinates(of)),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn real(low: Option<(i64, bool)>, high: Option<(i64, bool)>) -> SymbolKind {
        let bound = |(value, closed): (i64, bool)| Bound {
            value: rational::integer(value).into(),
            closed,
        };
        SymbolKind::Real(Box::new(crate::derivation::declarations::Interval {
            lower: low.map(bound),
            upper: high.map(bound),
            ..Default::default()
        }))
    }

    #[test]
    fn sets_are_formulas_and_words() {
        let k = Affine::symbol("k");
        let cases = [
            (
                real(Some((-1, true)), Some((1, false))),
                Some("-1 <= s < 1"),
                "s in [-1, 1)",
            ),
            (real(Some((0, false)), None), Some("s > 0"), "s in (0, inf)"),
            (real(None, None), None, "s, a real number"),
            (
                SymbolKind::Integer {
                    least: Some(Affine::number(2)),
                    most: None,
                },
                Some("s >= 2"),
                "s >= 2, an integer",
            ),
            (
                SymbolKind::Integer {
                    least: Some(Affine::number(0)),
                    most: Some(k.clone() * 2 + Affine::number(-1)),
                },
                Some("0 <= s <= 2*k - 1"),
                "0 <= s <= 2*k - 1, an integer",
            ),
            (
                SymbolKind::Vector(Some(4)),
                None,
                "s, a vector with 4 coordinates",
            ),
            (
                SymbolKind::Family {
                    dimension: None,
                    ranges: vec![(Affine::number(0), k)],
                },
                None,
                "s[0..k], points of any dimension",
            ),
        ];
        for (kind, formula, said) in cases {
            let found = statement("s", &kind).map(|range| text(&range));
            assert_eq!(found.as_deref(), formula);
            assert_eq!(words("s", &kind), said);
        }
    }
}
