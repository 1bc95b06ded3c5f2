//! Polynomials as plain maps and quotients without any cancelling.

use super::Obstacle;
use num_traits::{One, Zero};
use std::cell::Cell;
use std::collections::BTreeMap;
use torse_algebra::{Angle, Rational, Symbol, rational};

/// The terms that replaying one claim may touch.
const MAX_TERMS: u64 = 250_000;

/// Symbols with their exponents, all positive.
type Monomial = BTreeMap<Symbol, u32>;

/// Counts the work of one claim, in terms touched.
#[derive(Debug, Default)]
pub struct Work(Cell<u64>);

impl Work {
    /// Takes so many steps.
    pub fn spend(&self, steps: usize) -> Result<(), Obstacle> {
        let total = self
            .0
            .get()
            .saturating_add(u64::try_from(steps).unwrap_or(u64::MAX));
        self.0.set(total);
        if total > MAX_TERMS {
            return Err(Obstacle::TooMuchWork);
        }
        Ok(())
    }
}

/// A polynomial: each monomial with its nonzero coefficient. The relations `sin^2 = 1 - cos^2` and
/// `sqrt(p)^2 = p` are applied to every monomial that enters.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Sum(BTreeMap<Monomial, Rational>);

impl Sum {
    pub fn constant(value: Rational) -> Self {
        let mut sum = Self::default();
        sum.enter(Monomial::new(), value);
        sum
    }

    pub fn symbol(symbol: Symbol) -> Self {
        let mut sum = Self::default();
        sum.enter(Monomial::from([(symbol, 1)]), Rational::one());
        sum
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The number, if there is no symbol.
    pub fn as_constant(&self) -> Option<Rational> {
        match (self.0.len(), self.0.first_key_value()) {
            (0, _) => Some(Rational::zero()),
            (1, Some((monomial, value))) if monomial.is_empty() => Some(value.clone()),
            _ => None,
        }
    }

    /// The terms.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &Rational)> {
        self.0.iter()
    }

    /// Adds a term, relations applied.
    fn enter(&mut self, mut monomial: Monomial, mut coefficient: Rational) {
        if coefficient.is_zero() {
            return;
        }
        let square = |(s, e): (&Symbol, &u32)| {
            (*e >= 2 && matches!(s, Symbol::Sin(..) | Symbol::Root(_))).then(|| (s.clone(), *e))
        };
        if let Some((symbol, exponent)) = monomial.iter().find_map(square) {
            monomial.remove(&symbol);
            if exponent > 2 {
                monomial.insert(symbol.clone(), exponent - 2);
            }
            if let Symbol::Sin(name, angle) = symbol {
                let mut other = monomial.clone();
                *other.entry(Symbol::Cos(name, angle)).or_insert(0) += 2;
                self.enter(other, -coefficient.clone());
            } else if let Symbol::Root(prime) = symbol {
                coefficient *= rational::integer(i64::from(prime));
            }
            return self.enter(monomial, coefficient);
        }
        let total = self.0.remove(&monomial).unwrap_or_else(Rational::zero) + coefficient;
        if !total.is_zero() {
            self.0.insert(monomial, total);
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

    pub fn times(&self, other: &Self, work: &Work) -> Result<Self, Obstacle> {
        work.spend(self.0.len().saturating_mul(other.0.len()))?;
        let mut sum = Self::default();
        for (a, x) in self.terms() {
            for (b, y) in other.terms() {
                let mut monomial = a.clone();
                for (symbol, exponent) in b {
                    *monomial.entry(symbol.clone()).or_insert(0) += exponent;
                }
                sum.enter(monomial, x * y);
            }
        }
        Ok(sum)
    }

    /// The derivative by the variable `name`: the product rule, term by term.
    pub fn derivative(&self, name: &str, work: &Work) -> Result<Self, Obstacle> {
        let mut sum = Self::default();
        for (monomial, coefficient) in self.terms() {
            for (symbol, exponent) in monomial {
                let Some(inner) = derivative_of(symbol, name) else {
                    continue;
                };
                let mut rest = monomial.clone();
                rest.remove(symbol);
                if *exponent > 1 {
                    rest.insert(symbol.clone(), exponent - 1);
                }
                let mut outer = Self::default();
                outer.enter(rest, coefficient * rational::integer(i64::from(*exponent)));
                for (monomial, coefficient) in outer.times(&inner, work)?.0 {
                    sum.enter(monomial, coefficient);
                }
            }
        }
        Ok(sum)
    }

    /// `coefficient * symbol + rest` with neither containing the symbol; `None` if it is not linear.
    pub fn split(&self, symbol: &Symbol) -> Option<(Self, Self)> {
        let (mut coefficient, mut rest) = (Self::default(), Self::default());
        for (monomial, value) in self.terms() {
            let mut others = monomial.clone();
            match others.remove(symbol) {
                None => rest.enter(others, value.clone()),
                Some(1) => coefficient.enter(others, value.clone()),
                Some(_) => return None,
            }
        }
        Some((coefficient, rest))
    }
}

/// The derivative of a symbol by the variable `name`; `None` for zero.
fn derivative_of(symbol: &Symbol, name: &str) -> Option<Sum> {
    let rate = |angle: &Angle| match angle {
        Angle::Radian => Sum::constant(Rational::one()),
        Angle::QuarterTurn => Sum::symbol(Symbol::Pi).scaled(&Rational::new(1.into(), 2.into())),
    };
    let chain =
        |outer: Symbol, angle: &Angle| rate(angle).times(&Sum::symbol(outer), &Work::default());
    match symbol {
        Symbol::Named(n) if **n == *name => Some(Sum::constant(Rational::one())),
        Symbol::Sin(n, angle) if **n == *name => chain(Symbol::Cos(n.clone(), *angle), angle).ok(),
        Symbol::Cos(n, angle) if **n == *name => {
            let sine = chain(Symbol::Sin(n.clone(), *angle), angle).ok()?;
            Some(sine.scaled(&-Rational::one()))
        }
        _ => None,
    }
}

/// A numerator over a denominator, never cancelled (except by numbers).
#[derive(Debug, Clone)]
pub struct Quotient {
    /// The numerator.
    pub above: Sum,
    /// The denominator, not zero.
    pub below: Sum,
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
    pub fn number(value: Rational) -> Self {
        Sum::constant(value).into()
    }

    pub fn integer(value: i64) -> Self {
        Self::number(rational::integer(value))
    }

    pub fn is_zero(&self) -> bool {
        self.above.is_zero()
    }

    /// Whether the variable `name` occurs.
    pub fn mentions(&self, name: &str) -> bool {
        let mut terms = self.above.terms().chain(self.below.terms());
        terms.any(|(monomial, _)| monomial.keys().any(|symbol| symbol.depends_on(name)))
    }

    /// The number, if there is no symbol.
    pub fn as_constant(&self) -> Option<Rational> {
        let below = self.below.as_constant()?;
        self.above.as_constant().map(|above| above / below)
    }

    /// The symbol, if it is nothing else.
    pub fn as_symbol(&self) -> Option<Symbol> {
        let [(monomial, value)] = self.above.terms().collect::<Vec<_>>()[..] else {
            return None;
        };
        let one = value.is_one() && self.below.as_constant().is_some_and(|b| b.is_one());
        match monomial.iter().next() {
            Some((symbol, 1)) if one && monomial.len() == 1 => Some(symbol.clone()),
            _ => None,
        }
    }

    /// With a constant denominator divided out, and zero over one.
    fn tidy(above: Sum, below: Sum) -> Result<Self, Obstacle> {
        match below.as_constant() {
            Some(number) if number.is_zero() => Err(Obstacle::ZeroDivisor),
            Some(number) if number.is_one() => Ok(above.into()),
            Some(number) => Ok(above.scaled(&number.recip()).into()),
            None if above.is_zero() => Ok(Sum::default().into()),
            None => Ok(Self { above, below }),
        }
    }

    pub fn plus(&self, other: &Self, work: &Work) -> Result<Self, Obstacle> {
        work.spend(self.above.0.len() + other.above.0.len())?;
        if self.below == other.below {
            return Self::tidy(self.above.plus(&other.above), self.below.clone());
        }
        let left = self.above.times(&other.below, work)?;
        let right = other.above.times(&self.below, work)?;
        Self::tidy(left.plus(&right), self.below.times(&other.below, work)?)
    }

    pub fn negated(&self) -> Self {
        Self {
            above: self.above.scaled(&-Rational::one()),
            below: self.below.clone(),
        }
    }

    pub fn times(&self, other: &Self, work: &Work) -> Result<Self, Obstacle> {
        Self::tidy(
            self.above.times(&other.above, work)?,
            self.below.times(&other.below, work)?,
        )
    }

    pub fn over(&self, other: &Self, work: &Work) -> Result<Self, Obstacle> {
        Self::tidy(
            self.above.times(&other.below, work)?,
            self.below.times(&other.above, work)?,
        )
    }

    /// The quotient rule; a constant denominator stays as it is.
    pub fn derivative(&self, name: &str, work: &Work) -> Result<Self, Obstacle> {
        let (above, below) = (
            self.above.derivative(name, work)?,
            self.below.derivative(name, work)?,
        );
        if below.is_zero() {
            return Self::tidy(above, self.below.clone());
        }
        let left = above.times(&self.below, work)?;
        let right = self.above.times(&below, work)?;
        let above = left.plus(&right.scaled(&-Rational::one()));
        Self::tidy(above, self.below.times(&self.below, work)?)
    }

    /// One symbol replaced; nothing is expanded where it occurs to the first power.
    pub fn with(&self, symbol: &Symbol, value: &Self, work: &Work) -> Result<Self, Obstacle> {
        let free = |sum: &Sum| {
            !sum.terms()
                .any(|(monomial, _)| monomial.contains_key(symbol))
        };
        match self.above.split(symbol) {
            _ if free(&self.above) && free(&self.below) => Ok(self.clone()),
            Some((coefficient, rest)) if free(&self.below) => {
                let sum = value
                    .times(&coefficient.into(), work)?
                    .plus(&rest.into(), work)?;
                sum.over(&self.below.clone().into(), work)
            }
            _ => self.replaced(&|s| Ok((s == symbol).then(|| value.clone())), work),
        }
    }

    /// Every symbol replaced, where there is a replacement.
    pub fn replaced(
        &self,
        value: &impl Fn(&Symbol) -> Result<Option<Quotient>, Obstacle>,
        work: &Work,
    ) -> Result<Self, Obstacle> {
        let sum = |sum: &Sum| -> Result<Self, Obstacle> {
            let mut total = Self::integer(0);
            for (monomial, coefficient) in sum.terms() {
                let mut term = Self::number(coefficient.clone());
                for (symbol, exponent) in monomial {
                    let factor =
                        value(symbol)?.unwrap_or_else(|| Sum::symbol(symbol.clone()).into());
                    for _ in 0..*exponent {
                        term = term.times(&factor, work)?;
                    }
                }
                total = total.plus(&term, work)?;
            }
            Ok(total)
        };
        sum(&self.above)?.over(&sum(&self.below)?, work)
    }
}
