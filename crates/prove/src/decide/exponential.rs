//! Where exponentials run, and how they are ordered.
//!
//! The exponential function increases, so the range of an exponent is that of its power, and of two powers the one with
//! the larger exponent is larger. The first bounds a power as any symbol is bounded; the second becomes a constraint of
//! the domain, for exponents that are ordered on all of it: with `0 <= t <= a` the constraint
//! `exp(a) - exp(t) >= 0` is what a proof that `sinh(a - t)` is not negative rests on. Beside its own exponent a power and
//! its inverse are bounded by their tangents at zero.

use super::domain::{Constraint, Domain};
use super::interval::{Bound, Interval};
use super::order::{enclosure, truth};
use super::sign::{self, Sign};
use crate::evaluate::value::Statement;
use num_integer::lcm;
use std::borrow::Cow;
use std::sync::Arc;
use torse_algebra::{Exponent, Finest, Fraction, Polynomial, Rational, Scalar as _, Symbol};
use torse_syntax::formula::Relation;

/// Bits of the enclosures of ends.
const BITS: usize = 128;
/// The most exponents that are compared in pairs.
const MAX_EXPONENTS: usize = 8;

impl Domain<'_> {
    /// The range of an exponential.
    #[must_use]
    pub fn range_of_power(&self, exponent: &Exponent) -> Interval {
        let monomial = match exponent.powers() {
            [] => return Interval::default(),
            [(name, 1)] => self.interval(&Symbol::named(name)),
            powers => self.range_of_monomial(powers),
        };
        let part = Rational::new(1.into(), exponent.parts().into());
        let power = |bound: Bound, up: bool| {
            let end = bound.value.scaled(&part);
            if let Ok(value) = end.exponential() {
                let closed = bound.closed;
                return Some(Bound { value, closed });
            }
            // An end without an exact power, such as pi, is moved outward to an integer.
            let ball = enclosure(&end, BITS)?;
            let moved = match up {
                true => ball.upper().ceil(),
                false => ball.lower().floor(),
            };
            let value = Fraction::from(moved).exponential().ok()?;
            Some(Bound {
                value,
                closed: true,
            })
        };
        let positive = Bound {
            value: Fraction::zero(),
            closed: false,
        };
        Interval {
            lower: monomial
                .lower
                .and_then(|bound| power(bound, false))
                .or(Some(positive)),
            upper: monomial.upper.and_then(|bound| power(bound, true)),
        }
    }

    /// The range of a product of powers, where no factor is negative or all powers are even.
    fn range_of_monomial(&self, powers: &[(Arc<str>, u16)]) -> Interval {
        let factors = powers.iter().map(|(name, power)| {
            let interval = self.interval(&Symbol::named(name));
            let lower = interval.lower?;
            let positive = truth(&lower.value, Relation::AtLeast) == Some(true);
            positive.then_some((lower, interval.upper, i32::from(*power)))
        });
        let Some(factors) = factors.collect::<Option<Vec<_>>>() else {
            let even = powers.iter().all(|(_, power)| power % 2 == 0);
            let zero = Bound {
                value: Fraction::zero(),
                closed: true,
            };
            return Interval {
                lower: even.then_some(zero),
                upper: None,
            };
        };
        let mut range = Interval {
            lower: Some(Bound {
                value: Fraction::integer(1),
                closed: true,
            }),
            upper: Some(Bound {
                value: Fraction::integer(1),
                closed: true,
            }),
        };
        for (low, high, power) in factors {
            range.lower = range.lower.and_then(|own| times(own, &low, power));
            range.upper = range
                .upper
                .zip(high)
                .and_then(|(own, high)| times(own, &high, power));
        }
        range
    }

    /// Adds the constraints that order the exponentials among these symbols, where the exponents are ordered on the
    /// domain.
    pub fn order_exponentials(&mut self, symbols: &[Symbol]) {
        let ordered = self.ordered_exponentials(symbols);
        self.constraints.extend(ordered);
    }

    /// The domain with the constraints that order the exponentials among these symbols.
    #[must_use]
    pub fn with_ordered_exponentials(&self, symbols: &[Symbol]) -> Cow<'_, Self> {
        let ordered = self.ordered_exponentials(symbols);
        match ordered.is_empty() {
            true => Cow::Borrowed(self),
            false => {
                let mut domain = self.clone();
                domain.constraints.extend(ordered);
                Cow::Owned(domain)
            }
        }
    }

    /// What bounds exponentials by the symbols of their exponents, where these stand outside as well.
    fn bounds_beside(&self, exponents: &[&Exponent], symbols: &[Symbol]) -> Vec<Constraint> {
        let mut found: Vec<Constraint> = vec![];
        // A parameter of exponents that also stands outside makes sums strict by its open end.
        for symbol in symbols.iter().filter(|s| matches!(s, Symbol::Named(_))) {
            let inside = exponents.iter().any(|exponent| {
                let mut names = exponent.powers().iter();
                names.any(|(name, _)| *symbol == Symbol::Named(Arc::clone(name)))
            });
            if inside && let Some(end) = self.interval(symbol).lower.filter(|end| !end.closed) {
                let value = Fraction::symbol(symbol.clone()) - end.value;
                let relation = Relation::Greater;
                let known = |c: &Constraint| c.relation == relation && c.value == value;
                if !found.iter().any(known) {
                    found.push(Constraint { value, relation });
                }
            }
        }
        for exponent in exponents {
            // `exp(m) >= 1 + m` and `exp(-m) >= 1 - m`, where the exponent stands outside as well.
            let exponent = (*exponent).clone();
            let mut names = exponent.powers().iter();
            if names.all(|(name, _)| symbols.contains(&Symbol::Named(Arc::clone(name)))) {
                let (one, outside) = (Polynomial::integer(1), exponent.polynomial());
                let power = Polynomial::symbol(Symbol::Exp(exponent));
                let above = &power - &(&one + &outside);
                let below = &one - &(&power * &(&one - &outside));
                found.extend([above, below].map(|value| Constraint {
                    value: value.into(),
                    relation: Relation::AtLeast,
                }));
            }
        }
        found
    }

    fn ordered_exponentials(&self, symbols: &[Symbol]) -> Vec<Constraint> {
        let finest = Finest::new(symbols.iter());
        let mut exponents: Vec<&Exponent> = symbols
            .iter()
            .filter_map(|symbol| match symbol {
                Symbol::Exp(exponent) if !symbol.is_number() => {
                    finest.value(symbol).is_none().then_some(exponent)
                }
                _ => None,
            })
            .collect();
        exponents.sort();
        exponents.dedup();
        if exponents.len() > MAX_EXPONENTS {
            return vec![];
        }
        let mut found = self.bounds_beside(&exponents, symbols);
        for (place, first) in exponents.iter().enumerate() {
            for second in exponents.iter().skip(place + 1) {
                let Ok(parts) = u16::try_from(lcm(u32::from(first.parts()), second.parts().into()))
                else {
                    continue;
                };
                let [first, second] = [first.over(parts), second.over(parts)];
                let gap = &first.polynomial() - &second.polynomial();
                let relation = match sign::sign(&gap, self) {
                    Some(Sign::Positive) => Relation::Greater,
                    Some(Sign::Nonnegative) => Relation::AtLeast,
                    Some(Sign::Negative) => Relation::Less,
                    Some(Sign::Nonpositive) => Relation::AtMost,
                    None => continue,
                };
                let power = |exponent| Polynomial::symbol(Symbol::Exp(exponent));
                let value = Fraction::from(&power(first) - &power(second));
                found.push(Constraint { value, relation });
            }
        }
        found
    }
}

/// The symbols of the comparisons in a statement, as far as they are free of symbolic degrees, and of what they were
/// divided by.
#[must_use]
pub fn symbols_of(statement: &Statement) -> Vec<Symbol> {
    let of = |value: &Fraction| {
        let divisors = value.conditions().iter();
        let divisors = divisors.flat_map(|p| p.symbols().to_vec());
        value
            .symbols()
            .into_iter()
            .chain(divisors)
            .collect::<Vec<_>>()
    };
    match statement {
        Statement::Compare { left, right, .. } => {
            let entries = left.entries().into_iter().chain(right.entries());
            entries
                .filter_map(|q| q.as_fraction())
                .flat_map(of)
                .collect()
        }
        Statement::Join(_, a, b) => [symbols_of(a), symbols_of(b)].concat(),
        Statement::Not(inner) => symbols_of(inner),
        Statement::Agrees { .. } | Statement::Family { .. } => vec![],
    }
}

/// An end of a product of factors that are not negative; it is attained if all ends are, or one that is zero.
fn times(own: Bound, factor: &Bound, power: i32) -> Option<Bound> {
    let value = own.value.clone() * factor.value.power(power).ok()?;
    let zero = |bound: &Bound| bound.closed && bound.value.is_zero();
    let closed = (own.closed && factor.closed) || zero(&own) || zero(factor);
    Some(Bound { value, closed })
}
