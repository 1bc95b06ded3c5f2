//! Quotients of polynomials: in this arithmetic a statement at fixed integers is an identity.

mod exponential;
mod sum;
mod turn;

use crate::arithmetic::Arithmetic;
use crate::name::Name;
use crate::no_value::{NoValue, Undefined, Unknown, Work};
use num_traits::{One, Signed, Zero};
use sum::{Sum, Variable};
use torse_numbers::rational::integer;
use torse_numbers::{Integer, Rational};

/// A quotient of polynomials whose denominator is not zero. Only constant denominators are cancelled.
#[derive(Debug, Clone, PartialEq)]
pub struct Quotient {
    above: Sum,
    below: Sum,
}

impl From<Sum> for Quotient {
    fn from(above: Sum) -> Self {
        Self {
            above,
            below: Sum::constant(Rational::one()),
        }
    }
}

impl Quotient {
    fn number(value: Rational) -> Self {
        Sum::constant(value).into()
    }

    /// A number of the point, as a variable.
    #[must_use]
    pub fn variable(name: Name) -> Self {
        Sum::variable(Variable::Named(name)).into()
    }

    /// The number of terms of the numerator.
    #[must_use]
    pub fn terms(&self) -> usize {
        self.above.len()
    }

    fn as_constant(&self) -> Option<Rational> {
        let below = self.below.as_constant()?;
        self.above.as_constant().map(|above| above / below)
    }

    /// Divides by a constant denominator, and writes zero as zero over one.
    fn tidy(above: Sum, below: Sum) -> Result<Self, NoValue> {
        match below.as_constant() {
            Some(number) if number.is_zero() => Err(Undefined::ZeroDivisor.into()),
            Some(number) if number.is_one() => Ok(above.into()),
            Some(number) => Ok(above.scaled(&number.recip()).into()),
            None if above.is_zero() => Ok(Sum::default().into()),
            None => Ok(Self { above, below }),
        }
    }

    fn plus(&self, other: &Self, work: &Work) -> Result<Self, NoValue> {
        work.spend(u64::try_from(self.above.len() + other.above.len()).unwrap_or(u64::MAX))?;
        if self.below == other.below {
            return Self::tidy(self.above.plus(&other.above), self.below.clone());
        }
        let left = self.above.times(&other.below, work)?;
        let right = other.above.times(&self.below, work)?;
        Self::tidy(left.plus(&right), self.below.times(&other.below, work)?)
    }

    fn negated(&self) -> Self {
        Self {
            above: self.above.scaled(&-Rational::one()),
            below: self.below.clone(),
        }
    }

    fn times(&self, other: &Self, work: &Work) -> Result<Self, NoValue> {
        Self::tidy(
            self.above.times(&other.above, work)?,
            self.below.times(&other.below, work)?,
        )
    }

    fn over(&self, other: &Self, work: &Work) -> Result<Self, NoValue> {
        Self::tidy(
            self.above.times(&other.below, work)?,
            self.below.times(&other.above, work)?,
        )
    }
}

/// The arithmetic of quotients of polynomials.
///
/// A quotient is zero if it is the zero function. A divisor that is not the zero function counts as nonzero, so
/// results are valid where all divisors are nonzero.
#[derive(Debug)]
pub struct Polynomials<'a> {
    /// The budget.
    pub work: &'a Work,
}

impl Arithmetic for Polynomials<'_> {
    type Number = Quotient;

    fn work(&self) -> &Work {
        self.work
    }

    fn rational(&self, value: &Rational) -> Quotient {
        Quotient::number(value.clone())
    }

    fn pi(&self) -> Quotient {
        Sum::variable(Variable::Pi).into()
    }

    fn plus(&self, a: &Quotient, b: &Quotient) -> Result<Quotient, NoValue> {
        a.plus(b, self.work)
    }

    fn negated(&self, a: &Quotient) -> Quotient {
        a.negated()
    }

    fn times(&self, a: &Quotient, b: &Quotient) -> Result<Quotient, NoValue> {
        a.times(b, self.work)
    }

    fn over(&self, a: &Quotient, b: &Quotient) -> Result<Quotient, NoValue> {
        a.over(b, self.work)
    }

    fn square_root(&self, a: &Quotient) -> Result<Quotient, NoValue> {
        root(a, self.work)
    }

    fn sine_cosine(&self, a: &Quotient) -> Result<(Quotient, Quotient), NoValue> {
        turn::sine_cosine(a, self.work)
    }

    fn exponential(&self, a: &Quotient) -> Result<Quotient, NoValue> {
        exponential::exponential_quotient(a, self.work)
    }

    fn is_zero(&self, a: &Quotient) -> Option<bool> {
        Some(a.above.is_zero())
    }

    fn as_rational(&self, a: &Quotient) -> Option<Rational> {
        a.as_constant()
    }

    fn bit_length(&self, _: &Quotient) -> Option<u64> {
        None
    }
}

/// The square root of a nonnegative rational number: `sqrt(p/q) = sqrt(p q)/q`, with square factors extracted.
fn root(value: &Quotient, work: &Work) -> Result<Quotient, NoValue> {
    let large = || NoValue::from(Unknown::Large { what: "a root" });
    let number = value.as_constant().ok_or(Unknown::NotCovered {
        what: "a square root of a formula",
    })?;
    if number.is_negative() {
        return Err(Undefined::NegativeRoot.into());
    }
    if number.is_zero() {
        return Ok(Sum::default().into());
    }
    let product: Integer = number.numer() * number.denom();
    let mut rest = i64::try_from(&product)
        .ok()
        .filter(|p| *p < 1 << 36)
        .ok_or_else(large)?;
    let mut sum = Sum::constant(Rational::new(1.into(), number.denom().clone()));
    let mut prime = 2;
    while rest > 1 {
        if prime * prime > rest {
            prime = rest;
        }
        let mut exponent = 0;
        while rest % prime == 0 {
            rest /= prime;
            exponent += 1;
        }
        let extracted = (0..exponent / 2).map(|_| integer(prime)).product();
        sum = sum.scaled(&extracted);
        if exponent % 2 == 1 {
            let prime = u32::try_from(prime).map_err(|_| large())?;
            sum = sum.times(&Sum::variable(Variable::Root(prime)), work)?;
        }
        prime += 1;
    }
    Ok(sum.into())
}
