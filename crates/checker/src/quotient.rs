//! Quotients of polynomials: a numerator over powers of the divisors, never cancelled.

use super::gap::{Unsupported, Work};
use super::turn;
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};
use torse_certificate::polynomial::{Monomial, Polynomial};
use torse_certificate::ratio::Ratio;
use torse_certificate::symbol::{Symbol, Unit};
use torse_numbers::Rational;
use torse_numbers::rational::{integer, ratio};

/// `above / (factor^exponent * ...)`; the factors are monic and not constant.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Quotient {
    /// The numerator.
    pub above: Polynomial,
    /// The factors of the denominator with their exponents.
    pub below: BTreeMap<Polynomial, u32>,
}

impl From<Polynomial> for Quotient {
    fn from(above: Polynomial) -> Self {
        Self {
            above,
            below: BTreeMap::new(),
        }
    }
}

impl Quotient {
    /// A rational number.
    pub fn number(value: Rational) -> Self {
        Polynomial::constant(value).into()
    }

    /// The rational value, if the quotient is constant.
    pub fn as_rational(&self) -> Option<Rational> {
        if self.below.is_empty() || self.above.is_zero() {
            self.above.as_constant()
        } else {
            None
        }
    }

    pub fn negated(&self) -> Self {
        Self {
            above: self.above.negated(),
            below: self.below.clone(),
        }
    }

    /// The product of the factors with their exponents.
    fn product(
        factors: &BTreeMap<Polynomial, u32>,
        work: &Work,
    ) -> Result<Polynomial, Unsupported> {
        let mut product = Polynomial::one();
        for (factor, exponent) in factors {
            for _ in 0..*exponent {
                product = work.times(&product, factor)?;
            }
        }
        Ok(product)
    }

    /// The denominator as a polynomial.
    pub fn denominator(&self, work: &Work) -> Result<Polynomial, Unsupported> {
        Self::product(&self.below, work)
    }

    pub fn plus(&self, other: &Self, work: &Work) -> Result<Self, Unsupported> {
        if self.above.is_zero() {
            return Ok(other.clone());
        }
        if other.above.is_zero() {
            return Ok(self.clone());
        }
        if self.below == other.below {
            let above = self.above.plus(&other.above);
            let below = self.below.clone();
            return Ok(Self { above, below });
        }
        let mut below = self.below.clone();
        for (factor, exponent) in &other.below {
            let own = below.entry(factor.clone()).or_insert(0);
            *own = (*own).max(*exponent);
        }
        let lifted = |part: &Self| {
            let missing = below.iter().filter_map(|(factor, exponent)| {
                let own = part.below.get(factor).copied().unwrap_or(0);
                (exponent > &own).then(|| (factor.clone(), exponent - own))
            });
            let missing = Self::product(&missing.collect(), work)?;
            work.times(&part.above, &missing)
        };
        let above = lifted(self)?.plus(&lifted(other)?);
        Ok(Self { above, below })
    }

    /// Adds another quotient in place.
    fn add(&mut self, other: &Self, work: &Work) -> Result<(), Unsupported> {
        if self.below == other.below {
            self.above.add(&other.above);
        } else {
            *self = self.plus(other, work)?;
        }
        Ok(())
    }

    pub fn minus(&self, other: &Self, work: &Work) -> Result<Self, Unsupported> {
        self.plus(&other.negated(), work)
    }

    pub fn times(&self, other: &Self, work: &Work) -> Result<Self, Unsupported> {
        let above = work.times(&self.above, &other.above)?;
        if above.is_zero() {
            return Ok(Self::default());
        }
        let mut below = self.below.clone();
        for (factor, exponent) in &other.below {
            *below.entry(factor.clone()).or_insert(0) += exponent;
        }
        Ok(Self { above, below })
    }

    /// Sine and cosine of a polynomial angle.
    pub fn sine_cosine(&self, work: &Work) -> Result<(Self, Self), Unsupported> {
        if !self.below.is_empty() {
            return Err(Unsupported::ANGLE);
        }
        let (sine, cosine) = turn::sine_cosine(&self.above, work)?;
        Ok((sine.into(), cosine.into()))
    }

    /// One over it.
    pub fn inverse(&self, work: &Work) -> Result<Self, Unsupported> {
        if turn::holds_unknown_turn(&self.above) {
            return Err(Unsupported::ANGLE);
        }
        let zero = Unsupported::Undefined("a quotient with divisor zero");
        let (lead, factor) = self.above.monic().ok_or(zero)?;
        let above = self.denominator(work)?.scaled(&lead.recip());
        let below = match factor.as_constant() {
            Some(_) => BTreeMap::new(),
            None => BTreeMap::from([(factor, 1)]),
        };
        Ok(Self { above, below })
    }

    pub fn over(&self, other: &Self, work: &Work) -> Result<Self, Unsupported> {
        self.times(&other.inverse(work)?, work)
    }

    pub fn power(&self, exponent: u32, work: &Work) -> Result<Self, Unsupported> {
        let one = Self::number(integer(1));
        (0..exponent).try_fold(one, |power, _| power.times(self, work))
    }

    /// The same value wherever it has one: factors of the denominator that divide the numerator are cancelled.
    pub fn cancelled(mut self, work: &Work) -> Result<Self, Unsupported> {
        let mut below = BTreeMap::new();
        for (factor, mut exponent) in std::mem::take(&mut self.below) {
            work.spend(factor.len().saturating_mul(self.above.len()))?;
            while exponent > 0
                && let Some(quotient) = self.above.quotient(&factor)
            {
                work.spend(factor.len().saturating_mul(self.above.len()))?;
                self.above = quotient;
                exponent -= 1;
            }
            if exponent > 0 {
                below.insert(factor, exponent);
            }
        }
        Ok(Self { below, ..self })
    }

    /// Whether the two are equal as functions.
    pub fn equals(&self, other: &Self, work: &Work) -> Result<bool, Unsupported> {
        self.minus(other, work)?.is_zero(work)
    }

    /// Whether it is the zero function.
    pub fn is_zero(&self, work: &Work) -> Result<bool, Unsupported> {
        work.spend(self.above.len())?;
        let refined = self.above.refined().ok_or(Unsupported::Large)?;
        Ok(refined.is_zero())
    }

    /// Converts the quotient of a proof.
    pub fn from_ratio(ratio: &Ratio<Polynomial>, work: &Work) -> Result<Self, Unsupported> {
        let below = Self::from(ratio.below.clone());
        Self::from(ratio.above.clone()).over(&below, work)
    }

    /// Substitutes values for symbols; the sines and cosines of a replaced name become those of its value.
    pub fn replaced(
        &self,
        value: &dyn Fn(&Symbol) -> Option<Self>,
        work: &Work,
    ) -> Result<Self, Unsupported> {
        let mut result =
            replaced(&self.above, value, work)?.unwrap_or_else(|| Self::from(self.above.clone()));
        for (factor, exponent) in &self.below {
            let inverse = match replaced(factor, value, work)? {
                None => Self {
                    above: Polynomial::one(),
                    below: BTreeMap::from([(factor.clone(), *exponent)]),
                },
                Some(new) => new.inverse(work)?.power(*exponent, work)?,
            };
            result = result.times(&inverse, work)?;
        }
        Ok(result)
    }

    /// Substitutes values for single symbols; a sine is a symbol of its own.
    pub fn replaced_symbols(
        &self,
        value: &dyn Fn(&Symbol) -> Option<Self>,
        work: &Work,
    ) -> Result<Self, Unsupported> {
        let mut sum = Self::default();
        for (monomial, coefficient) in self.above.terms() {
            let mut term = Self::number(coefficient.clone());
            for (symbol, exponent) in monomial {
                let own = || Polynomial::symbol(symbol.clone()).into();
                let factor = value(symbol).unwrap_or_else(own);
                term = term.times(&factor.power(*exponent, work)?, work)?;
            }
            sum.add(&term, work)?;
        }
        Ok(sum)
    }

    /// The derivative by a named symbol.
    pub fn derivative(&self, by: &Symbol, work: &Work) -> Result<Self, Unsupported> {
        // a/(b^m ...)' = a'/(b^m ...) - m b' a/(b^(m+1) ...) - ...
        let mut sum = Self {
            above: derivative(&self.above, by),
            below: self.below.clone(),
        };
        for (factor, exponent) in &self.below {
            let rate = derivative(factor, by).scaled(&-integer(i64::from(*exponent)));
            if rate.is_zero() {
                continue;
            }
            let mut below = self.below.clone();
            *below.entry(factor.clone()).or_insert(0) += 1;
            let above = work.times(&self.above, &rate)?;
            sum.add(&Self { above, below }, work)?;
        }
        Ok(sum)
    }
}

/// Substitutes values for symbols of a polynomial; `None` if none of its symbols is replaced.
fn replaced(
    p: &Polynomial,
    value: &dyn Fn(&Symbol) -> Option<Quotient>,
    work: &Work,
) -> Result<Option<Quotient>, Unsupported> {
    let symbols: BTreeSet<&Symbol> = p.symbols().collect();
    let mut powers: BTreeMap<&Symbol, Vec<Quotient>> = BTreeMap::new();
    for symbol in symbols {
        if let Some(new) = image(symbol, value, work)? {
            powers.insert(symbol, vec![new]);
        }
    }
    if powers.is_empty() {
        return Ok(None);
    }
    let mut sum = Quotient::default();
    for (monomial, coefficient) in p.terms() {
        let (moved, fixed): (Monomial, Monomial) =
            (monomial.iter().cloned()).partition(|(symbol, _)| powers.contains_key(symbol));
        let mut above = Polynomial::zero();
        above.enter(fixed, coefficient.clone());
        let mut term = Quotient::from(above);
        for (symbol, exponent) in &moved {
            if let Some(known) = powers.get_mut(symbol) {
                term = term.times(power(known, *exponent, work)?, work)?;
            }
        }
        sum.add(&term, work)?;
    }
    Ok(Some(sum))
}

/// The power of a known base, computed from the powers in `known`, which is extended. The first element is the base.
fn power<'p>(
    known: &'p mut Vec<Quotient>,
    exponent: u32,
    work: &Work,
) -> Result<&'p Quotient, Unsupported> {
    let place = usize::try_from(exponent).map_err(|_| Unsupported::Large)?;
    while known.len() < place
        && let (Some(first), Some(last)) = (known.first(), known.last())
    {
        known.push(last.times(first, work)?);
    }
    known.get(place.saturating_sub(1)).ok_or(Unsupported::Large)
}

/// The value of a symbol; `None` if its variable is not replaced.
fn image(
    symbol: &Symbol,
    value: &dyn Fn(&Symbol) -> Option<Quotient>,
    work: &Work,
) -> Result<Option<Quotient>, Unsupported> {
    let (Symbol::Sine(name, angle) | Symbol::Cosine(name, angle)) = symbol else {
        return Ok(value(symbol));
    };
    let Some(new) = value(&Symbol::Named(name.clone())) else {
        return Ok(None);
    };
    let (sine, cosine) = new.times(&rate(*angle), work)?.sine_cosine(work)?;
    Ok(Some(match symbol {
        Symbol::Sine(..) => sine,
        _ => cosine,
    }))
}

/// The factor of the variable in an angle.
pub(super) fn rate(angle: torse_certificate::symbol::Angle) -> Quotient {
    let part = |n: i64| ratio(1, n).unwrap_or_else(Rational::zero);
    let parts = i64::from(angle.parts.max(1));
    match angle.unit {
        Unit::Radian => Quotient::number(part(parts)),
        Unit::QuarterTurn => Polynomial::symbol(Symbol::Pi)
            .scaled(&part(2 * parts))
            .into(),
    }
}

/// The derivative of a polynomial by a named symbol.
fn derivative(p: &Polynomial, by: &Symbol) -> Polynomial {
    let mut sum = Polynomial::zero();
    for (monomial, coefficient) in p.terms() {
        for (place, (symbol, exponent)) in monomial.iter().enumerate() {
            let inner = match symbol {
                own if own == by => None,
                Symbol::Sine(name, angle) if by.variable() == Some(&**name) => {
                    let cosine = Symbol::Cosine(name.clone(), *angle);
                    Some(Polynomial::symbol(cosine).times(&rate(*angle).above))
                }
                Symbol::Cosine(name, angle) if by.variable() == Some(&**name) => {
                    let sine = Symbol::Sine(name.clone(), *angle);
                    let negative = Polynomial::symbol(sine).negated();
                    Some(negative.times(&rate(*angle).above))
                }
                _ => continue,
            };
            let mut rest = monomial.clone();
            match exponent {
                1 => {
                    rest.remove(place);
                }
                _ => {
                    if let Some((_, own)) = rest.get_mut(place) {
                        *own -= 1;
                    }
                }
            }
            let coefficient = coefficient * integer(i64::from(*exponent));
            match inner {
                None => sum.enter(rest, coefficient),
                Some(inner) => {
                    let mut term = Polynomial::zero();
                    term.enter(rest, coefficient);
                    sum.add(&term.times(&inner));
                }
            }
        }
    }
    sum
}
