//! Addition: a merge of two sorted lists of terms over a common denominator.

use super::{Polynomial, cost};
use crate::rational::{Integer, Rational};
use crate::symbol::Symbol;
use num_integer::Integer as _;
use num_traits::{One, Zero};
use std::borrow::Cow;
use std::cmp::Ordering;
use std::ops::{Add, Neg, Sub};
use std::sync::Arc;

/// The symbols of both polynomials, ascending.
pub(super) fn common_symbols(a: &Polynomial, b: &Polynomial) -> Arc<[Symbol]> {
    if a.body.symbols == b.body.symbols || b.body.symbols.is_empty() {
        return Arc::clone(&a.body.symbols);
    }
    if a.body.symbols.is_empty() {
        return Arc::clone(&b.body.symbols);
    }
    let mut all: Vec<Symbol> = a
        .body
        .symbols
        .iter()
        .chain(b.body.symbols.iter())
        .cloned()
        .collect();
    all.sort();
    all.dedup();
    Arc::from(all)
}

/// The exponents of `p` as rows over `symbols`, which contain those of `p`. Rows stay in order, since every row gets
/// the same zeros in the new columns.
pub(super) fn widened<'p>(p: &'p Polynomial, symbols: &Arc<[Symbol]>) -> Cow<'p, [u16]> {
    if p.body.symbols == *symbols {
        return Cow::Borrowed(&p.body.exponents);
    }
    let columns: Vec<usize> = p
        .body
        .symbols
        .iter()
        .filter_map(|s| symbols.binary_search(s).ok())
        .collect();
    let mut rows = vec![0; p.len() * symbols.len()];
    for (wide, row) in rows.chunks_exact_mut(symbols.len().max(1)).zip(p.rows()) {
        for (column, exponent) in columns.iter().zip(row) {
            if let Some(slot) = wide.get_mut(*column) {
                *slot = *exponent;
            }
        }
    }
    Cow::Owned(rows)
}

fn sum(a: &Polynomial, b: &Polynomial, negated: &Integer) -> Polynomial {
    let symbols = common_symbols(a, b);
    let width = symbols.len();
    if cost::sum(a, b, width).is_err() {
        return Polynomial::zero();
    }
    let (rows_a, rows_b) = (widened(a, &symbols), widened(b, &symbols));
    let (denominator, scale_a, scale_b) = if a.body.denominator == b.body.denominator {
        (a.body.denominator.clone(), Integer::ONE, negated.clone())
    } else {
        let denominator = a.body.denominator.lcm(&b.body.denominator);
        let scale_a = &denominator / &a.body.denominator;
        let scale_b = &denominator / &b.body.denominator * negated;
        (denominator, scale_a, scale_b)
    };
    let scaled = |c: &Integer, scale: &Integer| if scale.is_one() { c.clone() } else { c * scale };
    let row = |rows: &'_ [u16], term: usize| term * width..((term + 1) * width).min(rows.len());
    let mut exponents = Vec::with_capacity((a.len() + b.len()) * width);
    let mut coefficients = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    loop {
        let (from_a, from_b) = (
            rows_a.get(row(&rows_a, i)).unwrap_or_default(),
            rows_b.get(row(&rows_b, j)).unwrap_or_default(),
        );
        let (x, y) = (a.body.coefficients.get(i), b.body.coefficients.get(j));
        let order = match (x, y) {
            (Some(_), Some(_)) => from_a.cmp(from_b),
            (Some(_), None) => Ordering::Greater,
            (None, _) => Ordering::Less,
        };
        let first = x.filter(|_| order != Ordering::Less);
        let second = y.filter(|_| order != Ordering::Greater);
        (i, j) = (
            i + usize::from(first.is_some()),
            j + usize::from(second.is_some()),
        );
        let taken = if first.is_some() { from_a } else { from_b };
        let first = first.map(|c| scaled(c, &scale_a));
        let second = second.map(|c| scaled(c, &scale_b));
        let coefficient = match (first, second) {
            (Some(first), Some(second)) => first + second,
            (Some(only), None) | (None, Some(only)) => only,
            (None, None) => break,
        };
        if !coefficient.is_zero() {
            exponents.extend_from_slice(taken);
            coefficients.push(coefficient);
        }
    }
    Polynomial::normalized(symbols, exponents, coefficients, denominator)
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        sum(self, other, &Integer::one())
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        if other.is_zero() {
            return self.clone();
        }
        sum(self, other, &-Integer::one())
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        let body = &self.body;
        Polynomial::new(
            Arc::clone(&body.symbols),
            body.exponents.clone(),
            body.coefficients.iter().map(|c| -c).collect(),
            body.denominator.clone(),
        )
    }
}

impl Add for Polynomial {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        &self + &other
    }
}

impl Sub for Polynomial {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        &self - &other
    }
}

impl Neg for Polynomial {
    type Output = Self;
    fn neg(self) -> Self {
        -&self
    }
}

impl Polynomial {
    /// `factor * self` for a rational factor.
    #[must_use]
    pub fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        self.multiple(factor.numer(), factor.denom())
    }

    /// The multiple by a nonzero number in lowest terms.
    ///
    /// Numerator and denominator of the number are coprime, and so are the coefficients and the denominator of the
    /// polynomial. So only the numerator and the polynomial's denominator, and the coefficients and the number's
    /// denominator, can have common factors.
    pub(super) fn multiple(&self, numerator: &Integer, denominator: &Integer) -> Self {
        if numerator.is_one() && denominator.is_one() {
            return self.clone();
        }
        let body = &self.body;
        if denominator.is_one() && body.denominator.is_one() {
            return Self::new(
                Arc::clone(&body.symbols),
                body.exponents.clone(),
                body.coefficients.iter().map(|c| c * numerator).collect(),
                Integer::ONE,
            );
        }
        let above = numerator.gcd(&body.denominator);
        let below = body.content_within(denominator);
        let factor = numerator / &above;
        let coefficients = body.coefficients.iter();
        let coefficients = if below.is_one() {
            coefficients.map(|c| c * &factor).collect()
        } else {
            coefficients.map(|c| c / &below * &factor).collect()
        };
        Self::new(
            Arc::clone(&body.symbols),
            body.exponents.clone(),
            coefficients,
            &body.denominator / above * (denominator / below),
        )
    }
}
