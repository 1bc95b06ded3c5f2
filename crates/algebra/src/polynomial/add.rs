//! Addition: a merge of two sorted lists of terms over a common denominator.

use super::{Polynomial, cost};
use crate::rational::{Integer, Rational};
use crate::symbol::Symbol;
use num_integer::Integer as _;
use num_traits::{One, Zero};
use std::cmp::Ordering;
use std::ops::{Add, Neg, Sub};
use std::sync::Arc;

/// The symbols of both polynomials, ascending.
pub(super) fn common_symbols(a: &Polynomial, b: &Polynomial) -> Arc<[Symbol]> {
    if a.symbols == b.symbols || b.symbols.is_empty() {
        return Arc::clone(&a.symbols);
    }
    if a.symbols.is_empty() {
        return Arc::clone(&b.symbols);
    }
    let mut all: Vec<Symbol> = a.symbols.iter().chain(b.symbols.iter()).cloned().collect();
    all.sort();
    all.dedup();
    Arc::from(all)
}

/// The exponents of `p` as rows over `symbols`, which contain those of `p`. The order of the rows is
/// kept: a new column is the same in all of them.
pub(super) fn widened(p: &Polynomial, symbols: &Arc<[Symbol]>) -> Vec<u16> {
    if p.symbols == *symbols {
        return p.exponents.clone();
    }
    let columns: Vec<usize> = p
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
    rows
}

fn sum(a: &Polynomial, b: &Polynomial, negated: &Integer) -> Polynomial {
    cost::sum(a, b);
    let symbols = common_symbols(a, b);
    let width = symbols.len();
    let (rows_a, rows_b) = (widened(a, &symbols), widened(b, &symbols));
    let denominator = a.denominator.lcm(&b.denominator);
    let (scale_a, scale_b) = (
        &denominator / &a.denominator,
        &denominator / &b.denominator * negated,
    );
    let row = |rows: &[u16], term: usize| {
        rows.get(term * width..(term + 1) * width)
            .map(<[u16]>::to_vec)
    };
    let mut exponents = Vec::with_capacity(rows_a.len() + rows_b.len());
    let mut coefficients = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    loop {
        let order = match (a.coefficients.get(i), b.coefficients.get(j)) {
            (None, None) => break,
            (Some(_), None) => Ordering::Greater,
            (None, Some(_)) => Ordering::Less,
            (Some(_), Some(_)) => rows_a
                .get(i * width..(i + 1) * width)
                .cmp(&rows_b.get(j * width..(j + 1) * width)),
        };
        let mut coefficient = Integer::zero();
        let mut taken = None;
        if order != Ordering::Less {
            coefficient += a
                .coefficients
                .get(i)
                .map_or_else(Integer::zero, |c| c * &scale_a);
            taken = row(&rows_a, i);
            i += 1;
        }
        if order != Ordering::Greater {
            coefficient += b
                .coefficients
                .get(j)
                .map_or_else(Integer::zero, |c| c * &scale_b);
            taken = row(&rows_b, j);
            j += 1;
        }
        if !coefficient.is_zero() {
            exponents.extend(taken.unwrap_or_default());
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
        let mut result = self.clone();
        for coefficient in &mut result.coefficients {
            *coefficient = -std::mem::take(coefficient);
        }
        result
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
        Self::normalized(
            Arc::clone(&self.symbols),
            self.exponents.clone(),
            self.coefficients
                .iter()
                .map(|c| c * factor.numer())
                .collect(),
            &self.denominator * factor.denom(),
        )
    }
}
