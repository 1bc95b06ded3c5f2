//! Quotients of polynomials: a numerator over powers of polynomials that were divided by, never cancelled.

use super::gap::{Beyond, Work};
use super::turn;
use crate::polynomial::Polynomial;
use crate::ratio::Ratio;
use crate::symbol::{Symbol, Unit};
use num_traits::Zero;
use std::collections::BTreeMap;
use torse_numbers::Rational;
use torse_numbers::rational::{integer, ratio};

/// `above / (factor^exponent * ...)`; the factors have leading coefficient one and are no rational numbers.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Quotient {
    /// The numerator.
    pub above: Polynomial,
    /// The factors of the denominator.
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

    /// The rational number, if it is one.
    pub fn as_rational(&self) -> Option<Rational> {
        match self.below.is_empty() || self.above.is_zero() {
            true => self.above.as_constant(),
            false => None,
        }
    }

    pub fn negated(&self) -> Self {
        Self {
            above: self.above.negated(),
            below: self.below.clone(),
        }
    }

    /// The factors with these exponents multiplied out.
    fn product(factors: &BTreeMap<Polynomial, u32>, work: &Work) -> Result<Polynomial, Beyond> {
        let mut product = Polynomial::one();
        for (factor, exponent) in factors {
            for _ in 0..*exponent {
                product = work.times(&product, factor)?;
            }
        }
        Ok(product)
    }

    /// The denominator multiplied out.
    pub fn denominator(&self, work: &Work) -> Result<Polynomial, Beyond> {
        Self::product(&self.below, work)
    }

    pub fn plus(&self, other: &Self, work: &Work) -> Result<Self, Beyond> {
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

    /// Adds another one in place.
    fn add(&mut self, other: &Self, work: &Work) -> Result<(), Beyond> {
        if self.below == other.below {
            self.above.add(&other.above);
        } else {
            *self = self.plus(other, work)?;
        }
        Ok(())
    }

    pub fn minus(&self, other: &Self, work: &Work) -> Result<Self, Beyond> {
        self.plus(&other.negated(), work)
    }

    pub fn times(&self, other: &Self, work: &Work) -> Result<Self, Beyond> {
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

    /// Sine and cosine of an angle without a denominator.
    pub fn sine_cosine(&self, work: &Work) -> Result<(Self, Self), Beyond> {
        if !self.below.is_empty() {
            return Err(turn::STRANGE);
        }
        let (sine, cosine) = turn::sine_cosine(&self.above, work)?;
        Ok((sine.into(), cosine.into()))
    }

    /// One over it.
    pub fn inverse(&self, work: &Work) -> Result<Self, Beyond> {
        let zero = Beyond::Undefined("a quotient with divisor zero");
        let (lead, factor) = self.above.monic().ok_or(zero)?;
        let above = self.denominator(work)?.scaled(&lead.recip());
        let below = match factor.as_constant() {
            Some(_) => BTreeMap::new(),
            None => BTreeMap::from([(factor, 1)]),
        };
        Ok(Self { above, below })
    }

    pub fn over(&self, other: &Self, work: &Work) -> Result<Self, Beyond> {
        self.times(&other.inverse(work)?, work)
    }

    pub fn power(&self, exponent: u32, work: &Work) -> Result<Self, Beyond> {
        let one = Self::number(integer(1));
        (0..exponent).try_fold(one, |power, _| power.times(self, work))
    }

    /// Whether it is the same as another one, as a function.
    pub fn equals(&self, other: &Self, work: &Work) -> Result<bool, Beyond> {
        self.minus(other, work)?.is_zero(work)
    }

    /// Whether it is zero as a function.
    pub fn is_zero(&self, work: &Work) -> Result<bool, Beyond> {
        work.spend(self.above.len())?;
        let refined = self.above.refined().ok_or(Beyond::Large)?;
        Ok(refined.is_zero())
    }

    /// The quotient of a proof.
    pub fn of(ratio: &Ratio<Polynomial>, work: &Work) -> Result<Self, Beyond> {
        let below = Self::from(ratio.below.clone());
        Self::from(ratio.above.clone()).over(&below, work)
    }

    /// The quotient with symbols replaced; sines and cosines of a replaced name are those of its value.
    pub fn replaced(
        &self,
        value: &dyn Fn(&Symbol) -> Option<Self>,
        work: &Work,
    ) -> Result<Self, Beyond> {
        let touched = |p: &Polynomial| {
            let name = |s: &Symbol| s.variable().and_then(|name| value(&Symbol::named(name)));
            p.symbols().any(|s| name(s).is_some())
        };
        let of = |p: &Polynomial| -> Result<Self, Beyond> {
            if !touched(p) {
                return Ok(p.clone().into());
            }
            let mut sum = Self::default();
            for (monomial, coefficient) in p.terms() {
                let mut term = Self::number(coefficient.clone());
                for (symbol, exponent) in monomial {
                    let factor = replaced(symbol, value, work)?;
                    term = term.times(&factor.power(*exponent, work)?, work)?;
                }
                sum.add(&term, work)?;
            }
            Ok(sum)
        };
        let mut result = of(&self.above)?;
        for (factor, exponent) in &self.below {
            match touched(factor) {
                false => {
                    let one = Polynomial::one();
                    let below = BTreeMap::from([(factor.clone(), *exponent)]);
                    result = result.times(&Self { above: one, below }, work)?;
                }
                true => {
                    let inverse = of(factor)?.inverse(work)?;
                    result = result.times(&inverse.power(*exponent, work)?, work)?;
                }
            }
        }
        Ok(result)
    }

    /// The quotient with symbols replaced one by one: a sine is a symbol of its own.
    pub fn replaced_symbols(
        &self,
        value: &dyn Fn(&Symbol) -> Option<Self>,
        work: &Work,
    ) -> Result<Self, Beyond> {
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
    pub fn derivative(&self, by: &Symbol, work: &Work) -> Result<Self, Beyond> {
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

/// A symbol with its variable replaced.
fn replaced(
    symbol: &Symbol,
    value: &dyn Fn(&Symbol) -> Option<Quotient>,
    work: &Work,
) -> Result<Quotient, Beyond> {
    let (Symbol::Sine(name, angle) | Symbol::Cosine(name, angle)) = symbol else {
        let own = || Polynomial::symbol(symbol.clone()).into();
        return Ok(value(symbol).unwrap_or_else(own));
    };
    let Some(new) = value(&Symbol::Named(name.clone())) else {
        return Ok(Polynomial::symbol(symbol.clone()).into());
    };
    let (sine, cosine) = new.times(&rate(*angle), work)?.sine_cosine(work)?;
    Ok(match symbol {
        Symbol::Sine(..) => sine,
        _ => cosine,
    })
}

/// What the variable of an angle is multiplied with.
pub(super) fn rate(angle: crate::symbol::Angle) -> Quotient {
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
                own if own == by => Polynomial::one(),
                Symbol::Sine(name, angle) if by.variable() == Some(&**name) => {
                    let cosine = Symbol::Cosine(name.clone(), *angle);
                    Polynomial::symbol(cosine).times(&rate(*angle).above)
                }
                Symbol::Cosine(name, angle) if by.variable() == Some(&**name) => {
                    let sine = Symbol::Sine(name.clone(), *angle);
                    Polynomial::symbol(sine)
                        .negated()
                        .times(&rate(*angle).above)
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
            let mut term = Polynomial::zero();
            term.enter(rest, coefficient * integer(i64::from(*exponent)));
            sum.add(&term.times(&inner));
        }
    }
    sum
}
