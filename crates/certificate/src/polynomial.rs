//! Polynomials as maps from monomials to coefficients: slow, but simple enough to be trusted. Independent of
//! `algebra` on purpose: do not share.
//!
//! The relations s^2 = 1 - c^2 and r^2 = p are applied to every monomial, so sines and roots have degree at most one.
//! The remaining monomials are independent over the rational numbers if the sines and cosines of each variable use
//! *one* fraction of its angle (see [`Polynomial::refined`]). Then a polynomial is zero as a function if and only if
//! it has no terms.

use crate::symbol::{Angle, Symbol};
use num_traits::{One, Signed, Zero};
use serde::{Serialize, Serializer};
use std::cmp::Ordering;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::Arc;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// Symbols with their exponents, all positive, in ascending order of the symbols.
pub type Monomial = Vec<(Symbol, u32)>;

/// A polynomial: each monomial with its nonzero coefficient. Clones share the terms until one is changed.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Default, Hash)]
pub struct Polynomial(Arc<BTreeMap<Monomial, Rational>>);

impl Polynomial {
    /// Zero.
    #[must_use]
    pub fn zero() -> Self {
        Self::default()
    }

    /// One.
    #[must_use]
    pub fn one() -> Self {
        Self::constant(Rational::one())
    }

    /// A number.
    #[must_use]
    pub fn constant(value: Rational) -> Self {
        let mut result = Self::default();
        result.enter(vec![], value);
        result
    }

    /// A symbol.
    #[must_use]
    pub fn symbol(symbol: Symbol) -> Self {
        let mut result = Self::default();
        result.enter(vec![(symbol, 1)], Rational::one());
        result
    }

    /// The terms.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &Rational)> {
        self.0.iter()
    }

    /// The number of terms.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are no terms.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether it is the zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The rational value, if it is constant.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        let mut terms = self.0.iter();
        match (terms.next(), terms.next()) {
            (None, _) => Some(Rational::zero()),
            (Some((monomial, value)), None) if monomial.is_empty() => Some(value.clone()),
            _ => None,
        }
    }

    /// Whether no symbol occurs except pi and square roots.
    #[must_use]
    pub fn is_number(&self) -> bool {
        self.symbols().all(Symbol::is_number)
    }

    /// The symbols of all terms, with repetitions.
    pub fn symbols(&self) -> impl Iterator<Item = &Symbol> {
        self.0.keys().flatten().map(|(symbol, _)| symbol)
    }

    /// The highest exponent of a symbol.
    #[must_use]
    pub fn degree_in(&self, symbol: &Symbol) -> u32 {
        let exponents = self.0.keys().map(|monomial| exponent(monomial, symbol));
        exponents.max().unwrap_or(0)
    }

    /// Adds a term and applies the relations.
    pub fn enter(&mut self, mut monomial: Monomial, coefficient: Rational) {
        if coefficient.is_zero() {
            return;
        }
        let reducible = |(symbol, exponent): &(Symbol, u32)| *exponent >= 2 && has_relation(symbol);
        let Some(place) = monomial.iter().position(reducible) else {
            match Arc::make_mut(&mut self.0).entry(monomial) {
                Entry::Vacant(place) => {
                    place.insert(coefficient);
                }
                Entry::Occupied(mut own) => {
                    let total = own.get() + &coefficient;
                    if total.is_zero() {
                        own.remove();
                    } else {
                        own.insert(total);
                    }
                }
            }
            return;
        };
        let (symbol, exponent) = monomial.remove(place);
        if exponent > 2 {
            monomial.insert(place, (symbol.clone(), exponent - 2));
        }
        match symbol {
            Symbol::Root(prime) => {
                self.enter(monomial, coefficient * integer(i64::from(prime)));
            }
            Symbol::Sine(name, angle) => {
                let square = vec![(Symbol::Cosine(name, angle), 2)];
                self.enter(product(&monomial, &square), -coefficient.clone());
                self.enter(monomial, coefficient);
            }
            Symbol::Named(_) | Symbol::Pi | Symbol::Cosine(..) | Symbol::Exponential(_) => {}
        }
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let (longer, shorter) = if self.len() < other.len() {
            (other, self)
        } else {
            (self, other)
        };
        let mut sum = longer.clone();
        sum.add(shorter);
        sum
    }

    /// Adds a polynomial in place.
    pub fn add(&mut self, other: &Self) {
        for (monomial, coefficient) in other.terms() {
            self.enter(monomial.clone(), coefficient.clone());
        }
    }

    /// The multiple by a number.
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::default();
        }
        if factor.is_one() {
            return self.clone();
        }
        let term = |(monomial, value): (&Monomial, &Rational)| (monomial.clone(), value * factor);
        Self(Arc::new(self.terms().map(term).collect()))
    }

    /// The negative.
    #[must_use]
    pub fn negated(&self) -> Self {
        self.scaled(&integer(-1))
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.negated())
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        for (one, number) in [(other, self), (self, other)] {
            if let Some(factor) = number.as_constant() {
                return one.scaled(&factor);
            }
        }
        let mut result = Self::default();
        for (a, x) in self.terms() {
            for (b, y) in other.terms() {
                result.enter(product(a, b), x * y);
            }
        }
        result
    }

    /// The power.
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        (0..exponent).fold(Self::one(), |power, _| power.times(self))
    }

    /// The coefficients of the powers of a symbol, from the zeroth power on; the symbol must have no relation.
    #[must_use]
    pub fn coefficients_in(&self, symbol: &Symbol) -> Vec<Self> {
        let degree = usize::try_from(self.degree_in(symbol)).unwrap_or(0);
        let mut all = vec![Self::default(); degree + 1];
        for (monomial, coefficient) in self.terms() {
            let power = usize::try_from(exponent(monomial, symbol)).unwrap_or(0);
            let rest = monomial.iter().filter(|(own, _)| own != symbol);
            if let Some(slot) = all.get_mut(power) {
                slot.enter(rest.cloned().collect(), coefficient.clone());
            }
        }
        all
    }

    /// The leading term in the lexicographic order.
    #[must_use]
    pub fn leading(&self) -> Option<(&Monomial, &Rational)> {
        self.terms().max_by(|(a, _), (b, _)| lexicographic(a, b))
    }

    /// Returns the leading coefficient and the polynomial divided by it; `None` for zero.
    #[must_use]
    pub fn monic(&self) -> Option<(Rational, Self)> {
        let (_, lead) = self.leading()?;
        let lead = lead.clone();
        Some((lead.clone(), self.scaled(&lead.recip())))
    }

    /// The quotient, if one is found. Long division finds it if no sine or root is in the leading term of the
    /// divisor. Otherwise both polynomials are first multiplied by conjugates of the divisor until the divisor
    /// contains none. For long polynomials an existing quotient may be missed.
    #[must_use]
    pub fn quotient(&self, divisor: &Self) -> Option<Self> {
        self.long_division(divisor)
            .or_else(|| self.divided_by_norm(divisor))
    }

    /// Divides after multiplying by the conjugates of the divisor; the product of the divisor with them is its norm,
    /// which contains no sine or root.
    fn divided_by_norm(&self, divisor: &Self) -> Option<Self> {
        const MAX_TERMS: usize = 4_000;
        let related = |symbol: &&Symbol| has_relation(symbol);
        let related: BTreeSet<&Symbol> = divisor.symbols().filter(related).collect();
        if related.is_empty() {
            return None;
        }
        let (mut above, mut below) = (self.clone(), divisor.clone());
        for symbol in related {
            if above.len().saturating_mul(below.len()) > MAX_TERMS {
                return None;
            }
            let conjugate = below.conjugate(symbol);
            above = above.times(&conjugate);
            below = below.times(&conjugate);
        }
        let found = above.long_division(&below)?;
        (found.times(divisor) == *self).then_some(found)
    }

    /// The polynomial with a sine or a root replaced by its negative.
    fn conjugate(&self, symbol: &Symbol) -> Self {
        let mut result = Self::default();
        for (monomial, coefficient) in self.terms() {
            let sign = match exponent(monomial, symbol) % 2 {
                0 => coefficient.clone(),
                _ => -coefficient.clone(),
            };
            result.enter(monomial.clone(), sign);
        }
        result
    }

    fn long_division(&self, divisor: &Self) -> Option<Self> {
        let (lead, number) = divisor.leading()?;
        let (mut rest, mut found) = (self.clone(), Self::default());
        // Every step lowers the leading monomial.
        for _ in 0..=self.len().saturating_mul(64) {
            let Some((own, coefficient)) = rest.leading() else {
                return Some(found);
            };
            let mut term = Self::default();
            term.enter(divided(own, lead)?, coefficient / number);
            let before = own.clone();
            rest = rest.minus(&term.times(divisor));
            let next = rest.leading().map(|(monomial, _)| monomial);
            if next.is_some_and(|next| lexicographic(next, &before).is_ge()) {
                return None;
            }
            found = found.plus(&term);
        }
        None
    }

    /// Rewrites the sines and cosines of each variable in the coarsest fraction of its angle of which all occurring
    /// fractions are multiples, because different fractions are not independent. `None` if that fraction would be too
    /// fine.
    #[must_use]
    pub fn refined(&self) -> Option<Self> {
        const MAX_EXPONENT: u16 = 48;
        let mut finest: BTreeMap<(&str, crate::symbol::Unit), u16> = BTreeMap::new();
        let mut differ = false;
        for symbol in self.symbols() {
            if let Symbol::Sine(name, angle) | Symbol::Cosine(name, angle) = symbol {
                let known = finest.entry((name, angle.unit)).or_insert(angle.parts);
                differ |= *known != angle.parts;
                *known = common_multiple(*known, angle.parts).filter(|n| *n <= MAX_EXPONENT)?;
            }
        }
        if !differ {
            return Some(self.clone());
        }
        let mut result = Self::default();
        for (monomial, coefficient) in self.terms() {
            let mut term = Self::constant(coefficient.clone());
            for (symbol, exponent) in monomial {
                let factor = match symbol {
                    Symbol::Sine(name, angle) | Symbol::Cosine(name, angle) => {
                        let parts = *finest.get(&(&**name, angle.unit))?;
                        let part = Angle { parts, ..*angle };
                        let one = (
                            Self::symbol(Symbol::Sine(name.clone(), part)),
                            Self::symbol(Symbol::Cosine(name.clone(), part)),
                        );
                        let (sine, cosine) = multiple(&one, parts / angle.parts.max(1));
                        match symbol {
                            Symbol::Sine(..) => sine,
                            _ => cosine,
                        }
                    }
                    other => Self::symbol(other.clone()),
                };
                term = term.times(&factor.power(*exponent));
            }
            result = result.plus(&term);
        }
        Some(result)
    }
}

/// Whether the square of the symbol is a polynomial that does not contain it.
fn has_relation(symbol: &Symbol) -> bool {
    matches!(symbol, Symbol::Sine(..) | Symbol::Root(_))
}

/// Sine and cosine of a multiple of an angle, by the addition theorems.
pub fn multiple((s, c): &(Polynomial, Polynomial), times: u16) -> (Polynomial, Polynomial) {
    let start = (Polynomial::zero(), Polynomial::one());
    (0..times).fold(start, |(sine, cosine), _| {
        (
            sine.times(c).plus(&cosine.times(s)),
            cosine.times(c).minus(&sine.times(s)),
        )
    })
}

fn common_multiple(a: u16, b: u16) -> Option<u16> {
    let (mut x, mut y) = (a, b);
    while y != 0 {
        (x, y) = (y, x % y);
    }
    a.checked_div(x)?.checked_mul(b)
}

fn exponent(monomial: &Monomial, symbol: &Symbol) -> u32 {
    let own = monomial.iter().find(|(own, _)| own == symbol);
    own.map_or(0, |(_, exponent)| *exponent)
}

/// The product of two monomials, without applying the relations.
fn product(a: &Monomial, b: &Monomial) -> Monomial {
    let mut result = Vec::with_capacity(a.len() + b.len());
    let (mut left, mut right) = (a.iter().peekable(), b.iter().peekable());
    loop {
        let order = match (left.peek(), right.peek()) {
            (None, None) => return result,
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (Some((x, _)), Some((y, _))) => x.cmp(y),
        };
        match order {
            Ordering::Less => result.extend(left.next().cloned()),
            Ordering::Greater => result.extend(right.next().cloned()),
            Ordering::Equal => {
                if let (Some((symbol, m)), Some((_, n))) = (left.next(), right.next()) {
                    result.push((symbol.clone(), m.saturating_add(*n)));
                }
            }
        }
    }
}

/// The quotient of two monomials, if there is one.
fn divided(a: &Monomial, b: &Monomial) -> Option<Monomial> {
    let mut result = vec![];
    for (symbol, own) in a {
        let less = own.checked_sub(exponent(b, symbol))?;
        if less > 0 {
            result.push((symbol.clone(), less));
        }
    }
    b.iter()
        .all(|(symbol, _)| exponent(a, symbol) > 0)
        .then_some(result)
}

/// The lexicographic order in which the first symbol weighs most.
fn lexicographic(a: &Monomial, b: &Monomial) -> Ordering {
    for ((x, m), (y, n)) in a.iter().zip(b) {
        let order = y.cmp(x).then(m.cmp(n));
        if order != Ordering::Equal {
            return order;
        }
    }
    a.len().cmp(&b.len())
}

impl fmt::Display for Polynomial {
    /// A sum of products that the formula language reads: `-3/2*x^2*P[0,1] + sin(pi/2*x) - 1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut terms: Vec<_> = self.terms().collect();
        terms.sort_by(|(a, _), (b, _)| lexicographic(b, a));
        if terms.is_empty() {
            return f.write_str("0");
        }
        for (place, (monomial, coefficient)) in terms.into_iter().enumerate() {
            f.write_str(match (place, coefficient.is_negative()) {
                (0, true) => "-",
                (0, false) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            })?;
            let size = coefficient.abs();
            let mut factors: Vec<String> = vec![];
            if monomial.is_empty() || !size.is_one() {
                factors.push(size.to_string());
            }
            factors.extend(monomial.iter().map(|(symbol, exponent)| match exponent {
                1 => symbol.to_string(),
                _ => format!("{symbol}^{exponent}"),
            }));
            f.write_str(&factors.join("*"))?;
        }
        Ok(())
    }
}

impl Serialize for Polynomial {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
