//! Fractions of polynomials that record what they were divided by.
//!
//! The denominator is kept as a product of primitive factors with exponents: sums use the least common
//! multiple of the factor lists, and a factor cancels when it divides the numerator exactly. Every
//! divisor ever used stays in [`Fraction::conditions`], even after it cancels: the value is known only
//! where none of them vanishes, and a verdict must say so.
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

/// `numerator / product of factors`, with the conditions under which it is defined.
#[derive(Clone, Debug)]
pub struct Fraction {
    numerator: Polynomial,
    /// Primitive nonconstant factors and their exponents.
    denominator: BTreeMap<Polynomial, u32>,
    /// Everything that was divided by, primitive: each must not vanish.
    conditions: Vec<Polynomial>,
}

impl Fraction {
    /// Whether both are the same in form, with the same conditions; equal fractions need not be.
    ///
    /// ```
    /// use torse_algebra::Fraction;
    /// let x = Fraction::named("x");
    /// let one = x.clone().over(&x).unwrap();
    /// assert!(one == Fraction::integer(1) && !one.is_identical(&Fraction::integer(1)));
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

    /// The divisors that were used on the way here, primitive and in order; none may vanish.
    #[must_use]
    pub fn conditions(&self) -> &[Polynomial] {
        &self.conditions
    }

    /// Whether this is zero wherever it is defined.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The polynomial, if there is no denominator.
    #[must_use]
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.is_empty().then_some(&self.numerator)
    }

    /// The rational number, if no symbol occurs.
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

    /// The same value with nothing recorded but its denominator: for a value that is known where its divisors vanish, too.
    #[must_use]
    pub fn without_conditions(mut self) -> Self {
        let divisors = self.denominator.keys().filter(|p| !p.is_exponential());
        self.conditions = divisors.cloned().collect();
        self
    }

    /// The same value with `conditions` recorded as well (primitive, nonconstant ones are kept).
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
