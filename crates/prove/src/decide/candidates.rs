//! Values that are tried for a symbol: simple ones first, then those that its interval suggests. A number that has to differ
//! from 1 is rather 2 than 0: lengths and factors of 0 are degenerate.

use super::domain::Domain;
use super::order::truth;
use super::real_symbol::RealSymbol;
use crate::decide::interval::{Bound, Interval};
use num_traits::Signed;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Angle, Fraction, Polynomial, Rational, Scalar as _, Symbol};
use torse_syntax::formula::Relation;

/// Under which trigonometric functions a variable stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turns {
    /// None.
    None,
    /// Sine and cosine of so many parts of a quarter turn times it.
    Quarter(u16),
    /// Sine and cosine of so many parts of it, in radians.
    Radian(u16),
}

/// A list of fractions, as numerators and denominators.
type Numbers = &'static [(i64, i64)];

const POINTS: Numbers = &[(0, 1), (1, 1), (-1, 1), (2, 1), (3, 1), (-2, 1), (5, 1)];
#[rustfmt::skip]
const QUARTER: Numbers = &[
    (1, 2), (1, 3), (2, 3), (0, 1), (1, 1), (3, 2), (4, 3), (5, 3), (2, 1),
    (-1, 2), (-1, 3), (-2, 3), (-1, 1), (-3, 2), (-2, 1),
];
#[rustfmt::skip]
const RADIAN: Numbers = &[
    (1, 3), (1, 2), (1, 4), (1, 6), (2, 3), (1, 1), (3, 4), (4, 3), (3, 2), (5, 3), (0, 1), (2, 1),
    (-1, 3), (-1, 2), (-1, 6), (-1, 1),
];
#[rustfmt::skip]
const INTEGERS: Numbers = &[
    (0, 1), (1, 1), (2, 1), (3, 1), (4, 1), (5, 1), (6, 1), (7, 1), (-1, 1), (-2, 1), (8, 1), (9, 1),
];
#[rustfmt::skip]
const SIMPLE: Numbers = &[
    (1, 1), (2, 1), (0, 1), (1, 2), (-1, 1), (3, 1), (1, 3), (-1, 2), (2, 3), (3, 2), (-2, 1), (1, 4),
    (3, 4), (5, 1), (-3, 1), (1, 5), (4, 1), (-1, 3), (1, 10), (9, 10), (10, 1),
];

/// Tangents of arcs, those of angles with rational sines and cosines among them.
#[rustfmt::skip]
const TANGENTS: Numbers = &[
    (2, 1), (1, 2), (-2, 1), (-1, 2), (3, 4), (4, 3), (-3, 4), (3, 1), (1, 3), (10, 1), (1, 10), (-10, 1), (20, 1), (100, 1),
];

/// Whether a symbol stands for an arc.
fn is_arc(symbol: &Symbol) -> bool {
    let heads = ["atan(", "asin(", "arc#"];
    matches!(symbol, Symbol::Named(name) if heads.iter().any(|head| name.starts_with(head)))
}

impl Domain<'_> {
    /// Simple values of a symbol inside its interval, simplest first. A variable under a sine or cosine
    /// gets values at which these are exact.
    #[must_use]
    pub fn candidates(&self, symbol: &Symbol, turns: Turns) -> Vec<Fraction> {
        let interval = self.interval(symbol);
        let is_integer = self.is_integer(symbol);
        let numbers = match (symbol, turns) {
            (Symbol::Indexed(..), _) => POINTS,
            _ if is_integer => INTEGERS,
            (_, Turns::Quarter(_)) => QUARTER,
            (_, Turns::Radian(_)) => RADIAN,
            _ => SIMPLE,
        };
        let (unit, parts) = match turns {
            Turns::Radian(parts) if !is_integer => (Fraction::symbol(Symbol::Pi), parts),
            Turns::Quarter(parts) if !is_integer => (Fraction::integer(1), parts),
            _ => (Fraction::integer(1), 1),
        };
        let simple = numbers.iter().filter_map(|(n, d)| ratio(*n, *d));
        let mut found: Vec<Fraction> = simple
            .clone()
            .map(|q| unit.scaled(&q))
            .filter(|value| inside(&interval, value))
            .collect();
        if parts == 1 && is_arc(symbol) {
            // Where the tangent is a simple one.
            let tangents = TANGENTS.iter().filter_map(|(n, d)| ratio(*n, *d));
            let arcs = tangents.filter_map(|q| Polynomial::arctangent(&q).ok());
            found.extend(
                arcs.map(Fraction::from)
                    .filter(|arc| inside(&interval, arc)),
            );
        }
        if parts > 1 {
            // Where a part of the angle is a simple one.
            for value in simple.map(|q| unit.scaled(&(q * integer(i64::from(parts))))) {
                if inside(&interval, &value) && !found.contains(&value) {
                    found.push(value);
                }
            }
        }
        let own = if is_integer {
            steps(&interval)
        } else {
            suggested(&interval)
        };
        for value in roots(
            symbol,
            self.constraints.iter().map(|c| (&c.value, c.relation)),
        )
        .into_iter()
        .chain(own)
        {
            if inside(&interval, &value)
                && !found.contains(&value)
                && (!is_integer || is_whole(&value))
            {
                found.push(value);
            }
        }
        found
    }

    /// Whether a number is a value of the symbol, as far as its interval tells.
    #[must_use]
    pub(crate) fn admits(&self, symbol: &RealSymbol, value: &Fraction) -> bool {
        inside(&self.interval(symbol.symbol()), value)
    }

    /// Whether a symbol is a root, a logarithm or an arc, which the others determine.
    pub(crate) fn is_implicit(&self, symbol: &Symbol) -> bool {
        let is_root = self.roots.iter().any(|root| root.symbol == *symbol);
        let is_arc = self.arcs.iter().any(|arc| arc.symbol == *symbol);
        is_root || is_arc || self.logarithms.iter().any(|log| log.symbol == *symbol)
    }

    /// The values of a root, a logarithm or an arc in its interval that equations such as `2*w^2 == 3`, `exp(w) == 3` and
    /// `sin(w) == 3*cos(w)` leave.
    pub(crate) fn implicit_values(
        &self,
        symbol: &Symbol,
        constraints: &[(Fraction, Relation)],
    ) -> Vec<Fraction> {
        let interval = self.interval(symbol);
        let equations = || constraints.iter().map(|(value, r)| (value, *r));
        let mut values = roots(symbol, equations());
        values.extend(logarithms(symbol, equations()));
        values.extend(arcs(symbol, equations()));
        values.retain(|value| inside(&interval, value));
        values.dedup();
        values
    }
}

/// The values of a symbol that equations such as `2*w^2 == 3` leave.
fn roots<'c>(
    symbol: &Symbol,
    constraints: impl Iterator<Item = (&'c Fraction, Relation)>,
) -> Vec<Fraction> {
    let equations = constraints.filter(|(_, relation)| *relation == Relation::Equal);
    let square = |value: &Fraction| {
        let polynomial = value.numerator();
        if polynomial.symbols() != std::slice::from_ref(symbol) {
            return None;
        }
        match polynomial.coefficients_in(symbol).as_slice() {
            [constant, linear, square] if linear.is_zero() => {
                let radicand = -constant.as_constant()? / square.as_constant()?;
                Polynomial::square_root(&radicand).ok()
            }
            _ => None,
        }
    };
    let roots = equations.filter_map(|(value, _)| square(value));
    roots
        .flat_map(|root| [Fraction::from(root.clone()), Fraction::from(-root)])
        .collect()
}

/// The values of a symbol that equations such as `2*exp(w) == 3` leave.
fn logarithms<'c>(
    symbol: &Symbol,
    constraints: impl Iterator<Item = (&'c Fraction, Relation)>,
) -> Vec<Fraction> {
    let equations = constraints.filter(|(_, relation)| *relation == Relation::Equal);
    let value = |value: &Fraction| {
        let polynomial = value.numerator();
        let own = match polynomial.symbols() {
            [own @ Symbol::Exp(exponent)] if exponent.parts() == 1 => own,
            _ => return None,
        };
        let mut names = own.names();
        let alone = names.next().cloned().map(Symbol::Named) == Some(symbol.clone());
        if !alone || names.next().is_some() {
            return None;
        }
        match polynomial.coefficients_in(own).as_slice() {
            [constant, slope] => {
                let power = -constant.as_constant()? / slope.as_constant()?;
                Polynomial::logarithm(&power).ok().map(Fraction::from)
            }
            _ => None,
        }
    };
    equations
        .filter_map(|(equation, _)| value(equation))
        .collect()
}

/// The values between `-pi/2` and `pi/2` of a symbol that equations such as `sin(w) == 3*cos(w)` and `2*sin(w) == 1` leave.
fn arcs<'c>(
    symbol: &Symbol,
    constraints: impl Iterator<Item = (&'c Fraction, Relation)>,
) -> Vec<Fraction> {
    let Symbol::Named(name) = symbol else {
        return vec![];
    };
    let sine = Symbol::Sin(name.clone(), Angle::RADIAN);
    let cosine = Symbol::Cos(name.clone(), Angle::RADIAN);
    let is_known = |own: &Symbol| own.is_number() || *own == sine || *own == cosine;
    let equations = constraints.filter(|(_, relation)| *relation == Relation::Equal);
    let value = |value: &Fraction| {
        let polynomial = value.numerator();
        if !polynomial.symbols().iter().all(is_known) {
            return None;
        }
        // a sin(w) + b cos(w) + c, with numbers.
        let [rest, a] = linear(polynomial, &sine)?;
        let [c, b] = linear(&rest, &cosine)?;
        let is_number = |p: &Polynomial| p.symbols().iter().all(Symbol::is_number);
        if ![&a, &b, &c].into_iter().all(is_number) {
            return None;
        }
        match (b.is_zero(), c.is_zero()) {
            (false, true) => Fraction::from(-b).over(&a.into()).ok()?.arctangent().ok(),
            (true, _) => Fraction::from(-c).over(&a.into()).ok()?.arcsine().ok(),
            (false, false) => None,
        }
    };
    equations
        .filter_map(|(equation, _)| value(equation))
        .map(Fraction::without_conditions)
        .collect()
}

/// The parts of a polynomial of first degree, or of none, without and with a symbol.
fn linear(polynomial: &Polynomial, symbol: &Symbol) -> Option<[Polynomial; 2]> {
    match polynomial.coefficients_in(symbol).as_slice() {
        [rest] => Some([rest.clone(), Polynomial::zero()]),
        [rest, slope] => Some([rest.clone(), slope.clone()]),
        _ => None,
    }
}

/// Whether a value is an integer.
pub(crate) fn is_whole(value: &Fraction) -> bool {
    value.as_rational().is_some_and(|q| q.is_integer())
}

fn inside(interval: &Interval, value: &Fraction) -> bool {
    let fits = |bound: &Option<Bound>, closed: Relation, open: Relation| {
        bound.as_ref().is_none_or(|b| {
            let gap = value.clone() - b.value.clone();
            truth(&gap, if b.closed { closed } else { open }) == Some(true)
        })
    };
    fits(&interval.lower, Relation::AtLeast, Relation::Greater)
        && fits(&interval.upper, Relation::AtMost, Relation::Less)
}

/// The first integers from an end on.
fn steps(interval: &Interval) -> Vec<Fraction> {
    let from = |bound: &Option<Bound>, direction: i64| {
        let end = bound.as_ref().map(|b| b.value.clone());
        let steps = (0..4).map(move |n| Fraction::integer(direction * n));
        end.into_iter()
            .flat_map(move |end| steps.clone().map(move |step| end.clone() + step))
    };
    from(&interval.lower, 1)
        .chain(from(&interval.upper, -1))
        .collect()
}

/// The ends, the simplest number between them, and points that divide the interval.
fn suggested(interval: &Interval) -> Vec<Fraction> {
    let part = |n, d| Fraction::integer(1).scaled(&ratio(n, d).unwrap_or_else(|| integer(0)));
    match (&interval.lower, &interval.upper) {
        (Some(a), Some(b)) => {
            let between = a.value.as_rational().zip(b.value.as_rational());
            let simplest = between.and_then(|(a, b)| simplest_between(&a, &b));
            let width = b.value.clone() - a.value.clone();
            let inner =
                [(1, 2), (1, 4), (3, 4)].map(|(n, d)| a.value.clone() + width.clone() * part(n, d));
            let ends = [a.value.clone(), b.value.clone()];
            let simplest = simplest.map(Fraction::from);
            ends.into_iter().chain(simplest).chain(inner).collect()
        }
        (Some(a), None) => [(0, 1), (1, 1), (1, 2), (2, 1), (1, 10)]
            .map(|(n, d)| a.value.clone() + part(n, d))
            .to_vec(),
        (None, Some(b)) => [(0, 1), (1, 1), (1, 2), (2, 1), (1, 10)]
            .map(|(n, d)| b.value.clone() - part(n, d))
            .to_vec(),
        (None, None) => vec![],
    }
}

/// The rational number of least denominator (then of least size) strictly between two.
///
/// ```
/// use torse_algebra::rational::ratio;
/// use torse_prove::decide::candidates::simplest_between;
/// let (a, b) = (ratio(314, 100).unwrap(), ratio(315, 100).unwrap());
/// assert_eq!(simplest_between(&a, &b), ratio(22, 7));
/// ```
#[must_use]
pub fn simplest_between(a: &Rational, b: &Rational) -> Option<Rational> {
    if a >= b {
        return None;
    }
    if a.is_negative() && b.is_positive() {
        return Some(integer(0));
    }
    if !b.is_positive() {
        return simplest_between(&-b, &-a).map(|q| -q);
    }
    // Continued fractions: the common whole part, then the reciprocals of the rests, in the other order.
    let (mut low, mut high) = (a.clone(), Some(b.clone()));
    let mut wholes = vec![];
    loop {
        let whole = low.floor();
        let next = &whole + integer(1);
        if high.as_ref().is_none_or(|high| next < *high) {
            let value = wholes.into_iter().rev();
            return Some(value.fold(next, |value: Rational, whole: Rational| {
                whole + value.recip()
            }));
        }
        let rest = high.map(|high| (high - &whole).recip())?;
        let below = &low - &whole;
        wholes.push(whole);
        high = (below > integer(0)).then(|| below.recip());
        low = rest;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_simplest_number_lies_between_ends_of_any_sign_and_has_the_least_denominator() {
        let ends = || (-12..=12).flat_map(|n| (1..=7).filter_map(move |d| ratio(n, d)));
        for a in ends() {
            for b in ends() {
                let found = simplest_between(&a, &b);
                if a >= b {
                    assert_eq!(found, None);
                    continue;
                }
                let q = found.unwrap_or_else(|| panic!("nothing between {a} and {b}"));
                assert!(a < q && q < b, "{q} between {a} and {b}");
                // No smaller denominator: the multiples of 1/d skip the interval.
                let least = i64::try_from(q.denom().clone()).unwrap_or(i64::MAX);
                for d in 1..least {
                    let next = (&a * integer(d)).floor() + integer(1);
                    assert!(next >= &b * integer(d), "{q} between {a} and {b}");
                }
            }
        }
    }
}
