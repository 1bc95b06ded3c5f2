//! Fractions of polynomials that record every divisor.
//!
//! The denominator is kept as a product of primitive factors with exponents. A sum uses the least common multiple of
//! the factor lists, and a factor cancels if it divides the numerator exactly. Every divisor stays in
//! [`Fraction::conditions`], even after it cancels: the value is established only where no divisor vanishes, and a
//! verdict must say so.
//!
//! **Theorem.** The polynomial ring modulo its relations is an integral domain, so a fraction is zero
//! wherever it is defined if and only if its numerator has no terms.

mod add;
mod calculus;
mod display;
mod divide;
mod multiply;
mod scalar;
mod substitute;

use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::symbol::Symbol;
use std::collections::BTreeMap;

/// A quotient `numerator / product of factors` of polynomials, with the divisors that must not vanish.
///
/// Invariants: factors and conditions are primitive and not constant; conditions are sorted; no factor divides the
/// numerator (except inside of an operation).
#[derive(Clone, Debug)]
pub struct Fraction {
    numerator: Polynomial,
    /// Primitive nonconstant factors and their exponents.
    denominator: BTreeMap<Polynomial, u32>,
    /// Every divisor that was used, in primitive form, sorted.
    conditions: Vec<Polynomial>,
}

impl Fraction {
    /// Whether the two have the same form and the same conditions. Equal fractions may differ in either.
    ///
    /// ```
    /// use torse_algebra::Fraction;
    /// let x = Fraction::named("x");
    /// let quotient = x.clone().over(&x).unwrap();
    /// assert!(quotient == Fraction::integer(1) && !quotient.is_identical(&Fraction::integer(1)));
    /// ```
    #[must_use]
    pub fn is_identical(&self, other: &Self) -> bool {
        self.numerator == other.numerator
            && self.denominator == other.denominator
            && self.conditions == other.conditions
    }

    /// Zero.
    #[must_use]
    pub fn zero() -> Self {
        Polynomial::zero().into()
    }

    /// An integer.
    #[must_use]
    pub fn integer(value: i64) -> Self {
        Polynomial::integer(value).into()
    }

    /// A single symbol.
    #[must_use]
    pub fn symbol(symbol: Symbol) -> Self {
        Polynomial::symbol(symbol).into()
    }

    /// The symbol with this name.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Polynomial::named(name).into()
    }

    /// The numerator.
    #[must_use]
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The factors of the denominator with their exponents; empty for a polynomial.
    pub fn denominator_factors(&self) -> impl Iterator<Item = (&Polynomial, u32)> {
        self.denominator
            .iter()
            .map(|(factor, exponent)| (factor, *exponent))
    }

    /// The denominator multiplied out.
    #[must_use]
    pub fn denominator(&self) -> Polynomial {
        let powers = self.denominator.iter().map(|(f, e)| f.power(*e));
        powers.fold(Polynomial::integer(1), |product, power| &product * &power)
    }

    /// The divisors that were used in computing this fraction, primitive and sorted. The value is established where
    /// none of them vanishes.
    #[must_use]
    pub fn conditions(&self) -> &[Polynomial] {
        &self.conditions
    }

    /// Whether the fraction is zero wherever it is defined.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Returns the numerator if there is no denominator.
    #[must_use]
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.is_empty().then_some(&self.numerator)
    }

    /// Returns the rational number if no symbol occurs.
    #[must_use]
    pub fn as_rational(&self) -> Option<Rational> {
        self.as_polynomial().and_then(Polynomial::as_constant)
    }

    /// The symbols that occur, ascending, without repetition.
    #[must_use]
    pub fn symbols(&self) -> Vec<Symbol> {
        let mut all: Vec<Symbol> = self
            .denominator
            .keys()
            .chain(std::iter::once(&self.numerator))
            .flat_map(|p| p.symbols().iter().cloned())
            .collect();
        all.sort();
        all.dedup();
        all
    }

    /// Keeps as conditions only the factors of the denominator: for a value that is known to be right also where
    /// other divisors vanish.
    #[must_use]
    pub fn without_conditions(mut self) -> Self {
        let divisors = self.denominator.keys().filter(|p| !p.is_exponential());
        self.conditions = divisors.cloned().collect();
        self
    }

    /// Adds primitive `conditions` to the recorded ones, except constants and exponentials, which cannot vanish.
    #[must_use]
    pub fn under(mut self, conditions: &[Polynomial]) -> Self {
        self.conditions = merged(&self.conditions, conditions);
        self
    }
}

/// The union of two sorted lists of conditions.
fn merged(a: &[Polynomial], b: &[Polynomial]) -> Vec<Polynomial> {
    if b.is_empty() {
        return a.to_vec();
    }
    let mut all: Vec<Polynomial> = a
        .iter()
        .chain(b)
        .filter(|p| !p.is_constant() && !p.is_exponential())
        .cloned()
        .collect();
    all.sort();
    all.dedup();
    all
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Self {
            numerator,
            denominator: BTreeMap::new(),
            conditions: vec![],
        }
    }
}

impl From<Rational> for Fraction {
    fn from(value: Rational) -> Self {
        Polynomial::from(value).into()
    }
}
