//! Intervals of real numbers in declarations.

use super::error::{DerivationError, LoadError};
use super::source::{Origin, Source, whole};
use super::written::Written;
use crate::formula::{Expr, Node, Relation, parse};
use std::sync::Arc;
use toml::Spanned;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::{Rational, rational};

/// The number `rational + pi * turns`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Constant {
    /// The rational part.
    pub rational: Rational,
    /// The multiple of pi.
    pub turns: Rational,
}

impl Constant {
    /// The number as a rational, if pi does not occur in it.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        (self.turns == rational::integer(0)).then_some(&self.rational)
    }
}

impl From<Rational> for Constant {
    fn from(rational: Rational) -> Self {
        Self {
            rational,
            turns: rational::integer(0),
        }
    }
}

/// One end of an interval.
#[derive(Debug, Clone)]
pub struct Bound {
    /// The exact value.
    pub value: Constant,
    /// Whether the end belongs to the interval.
    pub closed: bool,
}

/// A bound of an interval that is a formula in declared symbols.
#[derive(Debug, Clone)]
pub struct End {
    /// The formula.
    pub formula: Written,
    /// Whether the end belongs to the interval.
    pub closed: bool,
}

/// An interval of real numbers. A side with neither a numeric nor a formula bound is unbounded.
///
/// Numeric bounds determine the set. Bounds that are formulas depend on the values of other symbols, so a claim in
/// which the symbol occurs has them as hypotheses, see [`Interval::relations`].
#[derive(Debug, Clone, Default)]
pub struct Interval {
    /// The lower bound, if it is a number.
    pub lower: Option<Bound>,
    /// The upper bound, if it is a number.
    pub upper: Option<Bound>,
    /// The lower bound, if it is a formula.
    pub above: Option<End>,
    /// The upper bound, if it is a formula.
    pub below: Option<End>,
}

impl Interval {
    /// The bounds that are formulas.
    pub fn formulas(&self) -> impl Iterator<Item = &End> {
        self.above.iter().chain(&self.below)
    }

    /// The bounds that are formulas as relations for a symbol of this interval: `a <= t`, `t <= b`.
    #[must_use]
    pub fn relations(&self, name: &str) -> Vec<Written> {
        let relation = |end: &End| {
            if end.closed {
                Relation::AtMost
            } else {
                Relation::Less
            }
        };
        let symbol = |end: &End| Expr {
            node: Node::Name(name.to_owned()),
            place: end.formula.expr.place,
        };
        let written = |end: &End, first: Expr, second: Expr| Written {
            expr: Expr {
                node: Node::Compare(Arc::new(first), vec![(relation(end), second)]),
                place: end.formula.expr.place,
            },
            origin: end.formula.origin.clone(),
        };
        let above =
            (self.above.iter()).map(|end| written(end, end.formula.expr.clone(), symbol(end)));
        let below =
            (self.below.iter()).map(|end| written(end, symbol(end), end.formula.expr.clone()));
        above.chain(below).collect()
    }
}

/// Reads `[-1, 1]`, `(0, inf)`, `[a, 2*b]`. Bounds are rational numbers, rational multiples of pi, or formulas in
/// declared symbols other than `symbol`.
pub(super) fn interval(
    source: &Arc<Source>,
    symbol: &str,
    text: &Spanned<String>,
) -> Result<Interval, LoadError> {
    let origin = Origin::from_spanned(source, text);
    let wrong = || {
        let message = format!(
            "`{}` is not an interval: write `[-1, 1]`, `(0, inf)`, `[0, c]` and so on",
            text.get_ref()
        );
        let error = DerivationError::at(&origin, whole(text), message);
        LoadError::Derivation(Box::new(error))
    };
    let ([low, high], [left, right], start) = parts(text.get_ref()).ok_or_else(wrong)?;
    // `inf` is allowed on the right only, `-inf` on the left only.
    if low.trim() == "inf" || high.trim() == "-inf" {
        return Err(wrong());
    }
    let mut interval = Interval::default();
    let upper_start = start + low.len() + 1;
    match end(&origin, symbol, low, start)? {
        Found::Nothing => return Err(wrong()),
        Found::Infinite => {}
        Found::Number(value) => {
            interval.lower = Some(Bound {
                value,
                closed: left,
            });
        }
        Found::Formula(formula) => {
            interval.above = Some(End {
                formula,
                closed: left,
            });
        }
    }
    match end(&origin, symbol, high, upper_start)? {
        Found::Nothing => return Err(wrong()),
        Found::Infinite => {}
        Found::Number(value) => {
            interval.upper = Some(Bound {
                value,
                closed: right,
            });
        }
        Found::Formula(formula) => {
            interval.below = Some(End {
                formula,
                closed: right,
            });
        }
    }
    Ok(interval)
}

/// The texts of the two bounds, whether each is closed, and the offset of the first one.
fn parts(text: &str) -> Option<([&str; 2], [bool; 2], usize)> {
    let inside = text.trim();
    let before = text.len() - text.trim_start().len();
    let left = match inside.chars().next()? {
        '[' => true,
        '(' => injected(InjectedFault::OpenEndClosed),
        _ => return None,
    };
    let right = match inside.chars().next_back()? {
        ']' => true,
        ')' => false,
        _ => return None,
    };
    let ends = inside.get(1..inside.len().checked_sub(1)?)?;
    let (low, high) = ends.split_at(outer_comma(ends)?);
    let high = high.strip_prefix(',')?;
    Some(([low, high], [left, right], before + 1))
}

/// The offset of the first comma that is outside of all brackets: `max(a, b)` is one end.
fn outer_comma(ends: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, c) in ends.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.checked_sub(1)?,
            ',' if depth == 0 => return Some(at),
            _ => {}
        }
    }
    None
}

/// The kinds of bounds.
enum Found {
    Infinite,
    Number(Constant),
    Formula(Written),
    /// An invalid bound: a formula without a value, or one that contains the symbol itself.
    Nothing,
}

/// Reads a bound of the interval of `symbol`, which begins at byte `start` of the text.
fn end(origin: &Origin, symbol: &str, text: &str, start: usize) -> Result<Found, LoadError> {
    if matches!(text.trim(), "inf" | "-inf") {
        return Ok(Found::Infinite);
    }
    let origin = origin.clone().after(start);
    match parse(text) {
        Err(error) => {
            let error = DerivationError::syntax(&origin, &error);
            Err(LoadError::Derivation(Box::new(error)))
        }
        Ok(expr) => Ok(match constant(&expr) {
            Some(number) => Found::Number(number),
            // A constant formula that is not a number, such as 1/0, has no value.
            None if expr.names().iter().all(|name| *name == "pi") => Found::Nothing,
            None if expr.names().contains(&symbol) => Found::Nothing,
            None => Found::Formula(Written { expr, origin }),
        }),
    }
}

/// The value of a constant formula: a rational number plus a rational multiple of pi.
fn constant(expr: &Expr) -> Option<Constant> {
    use crate::formula::Operator;
    use num_traits::Zero;
    let zero = || rational::integer(0);
    let scaled = |c: Constant, q: &Rational| Constant {
        rational: c.rational * q,
        turns: c.turns * q,
    };
    Some(match &expr.node {
        Node::Number { value, .. } => value.clone().into(),
        Node::Name(name) if name == "pi" => Constant {
            rational: zero(),
            turns: rational::integer(1),
        },
        Node::Negative(inner) => scaled(constant(inner)?, &rational::integer(-1)),
        Node::Binary(operator, a, b) => {
            let (a, b) = (constant(a)?, constant(b)?);
            match operator {
                Operator::Add => Constant {
                    rational: a.rational + b.rational,
                    turns: a.turns + b.turns,
                },
                Operator::Subtract => Constant {
                    rational: a.rational - b.rational,
                    turns: a.turns - b.turns,
                },
                Operator::Multiply if a.turns.is_zero() => scaled(b, &a.rational),
                Operator::Multiply if b.turns.is_zero() => scaled(a, &b.rational),
                Operator::Divide if b.turns.is_zero() && !b.rational.is_zero() => {
                    scaled(a, &b.rational.recip())
                }
                _ => return None,
            }
        }
        _ => return None,
    })
}
