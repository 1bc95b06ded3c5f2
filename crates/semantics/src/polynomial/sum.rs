//! Polynomials as maps from monomials to coefficients.
//!
//! The variables are the numbers of a point, pi, square roots of primes, sines and cosines of variables, and
//! exponentials of products of them. The relations `sin^2 = 1 - cos^2` and `sqrt(p)^2 = p` are applied to every
//! monomial. Then a polynomial is zero as a function if and only if it has no terms, because the remaining monomials
//! are independent over the rational numbers.

use crate::name::Name;
use crate::no_value::{NoValue, Work};
use num_traits::{One, Zero};
use std::collections::BTreeMap;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The unit of the angle of a sine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Angle {
    /// `sin(x)`.
    Radian,
    /// `sin(pi/2*x)`.
    QuarterTurn,
}

/// A variable of a polynomial.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Variable {
    /// A number of the point.
    Named(Name),
    /// The number pi.
    Pi,
    /// The square root of a prime.
    Root(u32),
    /// The sine of a number of the point.
    Sine(Name, Angle),
    /// The cosine of a number of the point.
    Cosine(Name, Angle),
    /// The exponential of a product of numbers of the point.
    Power(BTreeMap<Name, u32>),
}

/// Variables with their exponents, all positive.
type Monomial = BTreeMap<Variable, u32>;

/// A polynomial: each monomial with its nonzero coefficient.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct Sum(BTreeMap<Monomial, Rational>);

impl Sum {
    pub fn constant(value: Rational) -> Self {
        let mut sum = Self::default();
        sum.enter(Monomial::new(), value);
        sum
    }

    pub fn variable(variable: Variable) -> Self {
        let mut sum = Self::default();
        sum.enter(Monomial::from([(variable, 1)]), Rational::one());
        sum
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The constant value, if there is no variable.
    pub fn as_constant(&self) -> Option<Rational> {
        match (self.0.len(), self.0.first_key_value()) {
            (0, _) => Some(Rational::zero()),
            (1, Some((monomial, value))) if monomial.is_empty() => Some(value.clone()),
            _ => None,
        }
    }

    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &Rational)> {
        self.0.iter()
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Adds a term and applies the relations.
    fn enter(&mut self, mut monomial: Monomial, coefficient: Rational) {
        if coefficient.is_zero() {
            return;
        }
        let square = monomial.iter().find_map(|(variable, exponent)| {
            let reducible = matches!(variable, Variable::Sine(..) | Variable::Root(_));
            (*exponent >= 2 && reducible).then(|| (variable.clone(), *exponent))
        });
        let Some((variable, exponent)) = square else {
            let total = self.0.remove(&monomial).unwrap_or_else(Rational::zero) + coefficient;
            if !total.is_zero() {
                self.0.insert(monomial, total);
            }
            return;
        };
        monomial.remove(&variable);
        if exponent > 2 {
            monomial.insert(variable.clone(), exponent - 2);
        }
        match variable {
            Variable::Root(prime) => {
                self.enter(monomial, coefficient * integer(i64::from(prime)));
            }
            Variable::Sine(name, angle) => {
                let mut other = monomial.clone();
                *other.entry(Variable::Cosine(name, angle)).or_insert(0) += 2;
                self.enter(other, -coefficient.clone());
                self.enter(monomial, coefficient);
            }
            Variable::Named(_) | Variable::Pi | Variable::Cosine(..) | Variable::Power(_) => {}
        }
    }

    pub fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (monomial, coefficient) in other.terms() {
            sum.enter(monomial.clone(), coefficient.clone());
        }
        sum
    }

    pub fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::default();
        }
        let term = |(monomial, value): (&Monomial, &Rational)| (monomial.clone(), value * factor);
        Self(self.terms().map(term).collect())
    }

    pub fn times(&self, other: &Self, work: &Work) -> Result<Self, NoValue> {
        let products = self.len().saturating_mul(other.len());
        work.spend(u64::try_from(products).unwrap_or(u64::MAX))?;
        let mut sum = Self::default();
        for (a, x) in self.terms() {
            for (b, y) in other.terms() {
                let mut monomial = a.clone();
                for (variable, exponent) in b {
                    *monomial.entry(variable.clone()).or_insert(0) += exponent;
                }
                sum.enter(monomial, x * y);
            }
        }
        Ok(sum)
    }
}
