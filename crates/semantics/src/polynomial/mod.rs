//! Quotients of polynomials: in this arithmetic a statement at fixed integers is an identity.

mod exponential;
mod sum;
mod turn;

use crate::arithmetic::Arithmetic;
use crate::name::Name;
use crate::no_value::{NoValue, Undefined, Unknown, Work};
use num_traits::{One, Signed, Zero};
use sum::{Sum, Variable};
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

    /// Supports one only.
    fn logarithm(&self, a: &Quotient) -> Result<Quotient, NoValue> {
        match a.as_constant() {
            Some(number) if !number.is_positive() => Err(Undefined::NoLogarithm.into()),
            Some(number) if number.is_one() => Ok(Sum::default().into()),
            _ => Err(Unknown::NotCovered {
                what: "the logarithm of this formula",
            }
            .into()),
        }
    }

    /// Supports zero only.
    fn arctangent(&self, a: &Quotient) -> Result<Quotient, NoValue> {
        match a.above.is_zero() {
            true => Ok(Sum::default().into()),
            false => Err(Unknown::NotCovered {
                what: "the arc tangent of this formula",
            }
            .into()),
        }
    }

    /// Supports zero only.
    fn arcsine(&self, a: &Quotient) -> Result<Quotient, NoValue> {
        match a.above.is_zero() {
            true => Ok(Sum::default().into()),
            false => Err(Unknown::NotCovered {
                what: "the arc sine of this formula",
            }
            .into()),
        }
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

/// Radicands are below this number, times the square of a denominator.
const MAX_RADICAND: u64 = 1 << 36;

/// The square root of a nonnegative rational number: `sqrt(p/q) = sqrt(p q)/q`. Squares are taken out first, whatever they are
/// squares of; what is left is a product of different primes. Independent of the root of `checker`, on purpose.
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
    let mut inside = u64::try_from(&product)
        .ok()
        .filter(|p| *p < MAX_RADICAND)
        .ok_or_else(large)?;
    let (mut outside, mut base) = (1_u64, 2);
    while base * base <= inside {
        if inside.is_multiple_of(base * base) {
            inside /= base * base;
            outside *= base;
        } else {
            base += 1;
        }
    }
    let mut result = Sum::constant(Rational::new(outside.into(), number.denom().clone()));
    for prime in 2.. {
        if inside == 1 {
            break;
        }
        // A factor is a prime if it is the first one, or if no smaller number can divide what is left.
        let factor = if prime * prime > inside {
            inside
        } else {
            prime
        };
        if inside.is_multiple_of(factor) {
            inside /= factor;
            let factor = u32::try_from(factor).map_err(|_| large())?;
            result = result.times(&Sum::variable(Variable::Root(factor)), work)?;
        }
    }
    Ok(result.into())
}
