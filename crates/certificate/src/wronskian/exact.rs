//! Small determinants expanded symbolically: which Bernstein coefficients vanish identically, and the orders at 0 of
//! the others.

use super::operator::{Operator, parts, weight};
use super::series::taylor;
use super::{SHAPES, Unfit};
use crate::polynomial::Polynomial;
use crate::symbol::Symbol;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The largest size of a determinant that is expanded.
const MAX_RANK: usize = 3;
/// The number of Taylor coefficients that are computed.
const LENGTH: usize = 16;

/// The orders at 0 of the Bernstein coefficients of a determinant, for given degrees in the parameters; `None` for a
/// coefficient that is zero.
///
/// # Errors
/// [`Unfit::Rank`] for a determinant that is too large.
pub(super) fn orders(
    operator: &Operator,
    degree: usize,
    rank: usize,
    sizes: [usize; SHAPES],
) -> Result<Vec<Vec<Option<usize>>>, Unfit> {
    if rank == 0 || rank > MAX_RANK.min(degree) {
        return Err(Unfit::Rank(rank));
    }
    let powers = powers(&multiplied(operator, degree, rank), operator);
    let mut all = vec![];
    for a in 0..sizes[0] {
        let mut row = vec![];
        for b in 0..sizes[1] {
            let mut coefficient = Polynomial::zero();
            for (shape, function) in &powers {
                let [i, j] = shape.map(|n| usize::try_from(n).unwrap_or(usize::MAX));
                // `binom(a, i)/binom(n, i)` for both parameters, which is zero for i above a.
                let share = weight(i, a, sizes[0] - 1) * weight(j, b, sizes[1] - 1);
                coefficient.add(&function.scaled(&share));
            }
            row.push(if coefficient.is_zero() {
                None
            } else {
                let terms = parts(&coefficient, &operator.seeds)?;
                let terms = terms
                    .into_iter()
                    .flat_map(|part| part.terms)
                    .collect::<Vec<_>>();
                let series = taylor(&terms, LENGTH);
                let order = series.iter().position(|c| !c.is_zero());
                Some(order.unwrap_or(LENGTH))
            });
        }
        all.push(row);
    }
    Ok(all)
}

/// The determinant as a polynomial.
fn multiplied(operator: &Operator, degree: usize, rank: usize) -> Polynomial {
    // Entry e: the e-th Taylor coefficients that the determinant needs.
    let series: Vec<Vec<Polynomial>> = operator
        .functions
        .iter()
        .map(|function| {
            let mut all = vec![function.clone()];
            for e in 1..rank + operator.order() {
                let share = integer(i64::try_from(e).unwrap_or(1)).recip();
                let last = all.last().cloned().unwrap_or_default();
                all.push(derivative(&last, operator).scaled(&share));
            }
            all
        })
        .collect();
    let entry = |m: usize, j: usize| {
        let mut entry = Polynomial::constant(integer(i64::from(m == j)));
        for (i, own) in (1..).zip(&series).filter(|(i, _)| *i <= j && m + i >= j) {
            if let Some(coefficient) = own.get(m + i - j) {
                entry.add(&coefficient.scaled(&weight(i, j, degree)));
            }
        }
        entry
    };
    let rows: Vec<Vec<Polynomial>> = (1..=rank)
        .map(|m| (1..=rank).map(|j| entry(m, j)).collect())
        .collect();
    determinant(&rows)
}

/// The coefficient of each monomial in the parameters.
fn powers(function: &Polynomial, operator: &Operator) -> Vec<([u32; SHAPES], Polynomial)> {
    let mut all: Vec<([u32; SHAPES], Polynomial)> = vec![];
    for (monomial, coefficient) in function.terms() {
        let (mut shape, mut rest) = ([0; SHAPES], vec![]);
        for (symbol, exponent) in monomial {
            let named = |name| matches!(symbol, Symbol::Named(own) if own == name);
            let place = operator.seeds.shapes.iter().position(named);
            match place.and_then(|place| shape.get_mut(place)) {
                Some(slot) => *slot += *exponent,
                None => rest.push((symbol.clone(), *exponent)),
            }
        }
        let place = match all.iter().position(|(own, _)| *own == shape) {
            Some(place) => place,
            None => {
                all.push((shape, Polynomial::zero()));
                all.len() - 1
            }
        };
        all[place].1.enter(rest, coefficient.clone());
    }
    all
}

/// The derivative by the variable.
fn derivative(function: &Polynomial, operator: &Operator) -> Polynomial {
    let x = operator.seeds.x();
    let [sine, cosine] = operator.seeds.turn();
    let speed = Polynomial::symbol(Symbol::Pi).scaled(&Rational::new(1.into(), 2.into()));
    let rate = |symbol: &Symbol| match symbol {
        symbol if *symbol == x => Polynomial::one(),
        symbol if *symbol == sine => speed.times(&Polynomial::symbol(cosine.clone())),
        symbol if *symbol == cosine => speed.times(&Polynomial::symbol(sine.clone())).negated(),
        _ => Polynomial::zero(),
    };
    let mut total = Polynomial::zero();
    for (monomial, coefficient) in function.terms() {
        for (place, (symbol, exponent)) in monomial.iter().enumerate() {
            let mut rest = monomial.clone();
            match rest.get_mut(place) {
                Some(own) if own.1 > 1 => own.1 -= 1,
                _ => {
                    rest.remove(place);
                }
            }
            let mut term = Polynomial::zero();
            term.enter(rest, coefficient * integer(i64::from(*exponent)));
            total.add(&term.times(&rate(symbol)));
        }
    }
    total
}

/// The determinant, by expansion along the first row.
fn determinant(rows: &[Vec<Polynomial>]) -> Polynomial {
    let Some((first, rest)) = rows.split_first() else {
        return Polynomial::one();
    };
    let mut total = Polynomial::zero();
    for (place, entry) in first.iter().enumerate() {
        let minor: Vec<Vec<Polynomial>> = rest
            .iter()
            .map(|row| {
                let others = row.iter().enumerate().filter(|(n, _)| *n != place);
                others.map(|(_, entry)| entry.clone()).collect()
            })
            .collect();
        let part = entry.times(&determinant(&minor));
        total.add(&if place % 2 == 0 { part } else { part.negated() });
    }
    total
}
