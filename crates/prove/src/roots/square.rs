//! Square roots of fractions that are squares.
//!
//! A polynomial with the leading term c m^2, in an order of monomials that products respect, is c times a square only of what begins with
//! m; the other terms follow one after the other. A polynomial in sines and cosines may be a square in the one form and not in
//! the other, `1 - cos^2`, so squares of cosines are also written by sines. What is found is squared again by those who ask.

use std::collections::{BTreeMap, BTreeSet};
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational, Symbol};

/// The most terms of a root.
const MAX_TERMS: usize = 60;
/// The most angles whose cosines are written by sines.
const MAX_ANGLES: usize = 3;

/// Something whose square is the fraction, if it is found.
#[must_use]
pub(crate) fn root_of(value: &Fraction) -> Option<Fraction> {
    let (mut above, mut below) = (value.numerator().clone(), Polynomial::integer(1));
    for (factor, exponent) in value.denominator_factors() {
        if exponent % 2 == 1 {
            above = &above * factor;
        }
        below = &below * &factor.power(exponent.div_ceil(2));
    }
    let root = Fraction::from(polynomial_root(&above)?);
    root.over(&below.into()).ok()
}

fn polynomial_root(square: &Polynomial) -> Option<Polynomial> {
    if square.is_zero() {
        return Some(Polynomial::zero());
    }
    let angles: BTreeSet<&Symbol> = square
        .symbols()
        .iter()
        .filter(|s| matches!(s, Symbol::Cos(..)))
        .collect();
    let angles: Vec<&Symbol> = angles.into_iter().take(MAX_ANGLES).collect();
    let all = Free::from_polynomial(square);
    let mut forms = vec![all.clone()];
    for chosen in 1_u32..(1 << angles.len()) {
        let of = |(place, _): &(usize, &&Symbol)| chosen & (1 << place) != 0;
        let angles = angles.iter().enumerate().filter(of);
        forms.push(angles.fold(all.clone(), |form, (_, angle)| form.by_sines(angle)));
    }
    forms.iter().find_map(Free::root)
}

/// The exponents of symbols. Products keep the order.
type Monomial = Vec<u16>;

/// A polynomial in symbols without relations.
#[derive(Debug, Clone)]
struct Free {
    symbols: Vec<Symbol>,
    terms: BTreeMap<Monomial, Rational>,
}

impl Free {
    fn from_polynomial(polynomial: &Polynomial) -> Self {
        let mut symbols = polynomial.symbols().to_vec();
        let sines = symbols.iter().filter_map(sine_of);
        let sines: Vec<Symbol> = sines.filter(|s| !symbols.contains(s)).collect();
        symbols.extend(sines);
        let mut terms = BTreeMap::new();
        for term in polynomial.terms() {
            let exponent = |symbol: &Symbol| {
                let own = term.powers.iter().find(|(s, _)| *s == symbol);
                own.map_or(0, |(_, exponent)| *exponent)
            };
            terms.insert(symbols.iter().map(exponent).collect(), term.coefficient);
        }
        Self { symbols, terms }
    }

    fn add(&mut self, monomial: Monomial, coefficient: &Rational) {
        let sum = match self.terms.remove(&monomial) {
            Some(before) => before + coefficient,
            None => coefficient.clone(),
        };
        if sum != integer(0) {
            self.terms.insert(monomial, sum);
        }
    }

    /// Squares of this cosine as one minus squares of the sine.
    fn by_sines(&self, cosine: &Symbol) -> Self {
        let place = |symbol: &Symbol| self.symbols.iter().position(|s| s == symbol);
        let (Some(c), Some(s)) = (place(cosine), sine_of(cosine).as_ref().and_then(place)) else {
            return self.clone();
        };
        let mut result = Self {
            symbols: self.symbols.clone(),
            terms: BTreeMap::new(),
        };
        for (monomial, coefficient) in &self.terms {
            let exponent = monomial.get(c).copied().unwrap_or(0);
            let half = exponent / 2;
            // (1 - s^2)^half
            let mut binomial = coefficient.clone();
            for j in 0..=half {
                let mut own = monomial.clone();
                if let Some(slot) = own.get_mut(c) {
                    *slot = exponent % 2;
                }
                if let Some(slot) = own.get_mut(s) {
                    *slot += 2 * j;
                }
                result.add(own, &binomial);
                let next = i64::from(half - j);
                binomial = -binomial * integer(next) / integer(i64::from(j) + 1);
            }
        }
        result
    }

    fn root(&self) -> Option<Polynomial> {
        let (lead, number) = self.terms.last_key_value()?;
        let half = |e: &u16| e.is_multiple_of(2).then_some(e / 2);
        let lead: Monomial = lead.iter().map(half).collect::<Option<_>>()?;
        let factor = Polynomial::square_root(number).ok()?;
        let mut rest = self.clone();
        for coefficient in rest.terms.values_mut() {
            *coefficient /= number;
        }
        // The root begins with the monomial, and its other terms are smaller.
        let mut root: Vec<(Monomial, Rational)> = vec![];
        rest.subtract(&lead, &lead, &integer(1))?;
        root.push((lead.clone(), integer(1)));
        while let Some((next, coefficient)) = rest.terms.last_key_value() {
            let pairs = next.iter().zip(&lead);
            let own: Option<Monomial> = pairs.map(|(a, b)| a.checked_sub(*b)).collect();
            let (own, coefficient) = (own?, coefficient / integer(2));
            let is_smaller = root.last().is_some_and(|(last, _)| own < *last);
            if !is_smaller || root.len() >= MAX_TERMS {
                return None;
            }
            for (monomial, before) in &root {
                rest.subtract(monomial, &own, &(before * &coefficient * integer(2)))?;
            }
            rest.subtract(&own, &own, &(&coefficient * &coefficient))?;
            root.push((own, coefficient));
        }
        let sum = root.iter().fold(Polynomial::zero(), |sum, (m, c)| {
            &sum + &self.polynomial(m).scaled(c)
        });
        Some(&sum * &factor)
    }

    /// Subtracts the product of two monomials, so many times.
    fn subtract(&mut self, a: &Monomial, b: &Monomial, times: &Rational) -> Option<()> {
        let product: Option<Monomial> = a.iter().zip(b).map(|(a, b)| a.checked_add(*b)).collect();
        self.add(product?, &-times.clone());
        Some(())
    }

    fn polynomial(&self, monomial: &Monomial) -> Polynomial {
        let factors = self.symbols.iter().zip(monomial);
        factors.fold(Polynomial::integer(1), |product, (symbol, exponent)| {
            let power = Polynomial::symbol(symbol.clone()).power(u32::from(*exponent));
            &product * &power
        })
    }
}

/// The sine beside a cosine.
fn sine_of(cosine: &Symbol) -> Option<Symbol> {
    match cosine {
        Symbol::Cos(name, angle) => Some(Symbol::Sin(name.clone(), *angle)),
        _ => None,
    }
}
