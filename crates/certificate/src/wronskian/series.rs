//! Exact Taylor series at 0.

use super::operator::Term;
use crate::polynomial::Polynomial;
use crate::symbol::Symbol;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The Taylor coefficients at 0, which are polynomials in pi.
pub(super) fn taylor(terms: &[Term], length: usize) -> Vec<Polynomial> {
    let (sine, cosine) = (turn(length, 1), turn(length, 0));
    let mut total = vec![Polynomial::zero(); length];
    for term in terms {
        let mut series = vec![Polynomial::zero(); length];
        let start = usize::try_from(term.x).unwrap_or(length);
        if let Some(slot) = series.get_mut(start) {
            // Higher powers are beyond the computed length.
            let pi = Polynomial::symbol(Symbol::Pi).power(term.pi);
            *slot = pi.scaled(&term.coefficient);
        }
        for (factor, exponent) in [(&sine, term.sine), (&cosine, term.cosine)] {
            for _ in 0..exponent {
                series = product(&series, factor);
            }
        }
        for (slot, coefficient) in total.iter_mut().zip(&series) {
            slot.add(coefficient);
        }
    }
    total
}

/// The series of `sin(pi/2*x)`, which has odd powers, or of the cosine, which has even ones.
fn turn(length: usize, odd: usize) -> Vec<Polynomial> {
    let quarter = Polynomial::symbol(Symbol::Pi).scaled(&Rational::new(1.into(), 2.into()));
    let mut power = Polynomial::one();
    let mut all = vec![];
    for n in 0..length {
        if n > 0 {
            let share = integer(i64::try_from(n).unwrap_or(1)).recip();
            power = power.times(&quarter).scaled(&share);
        }
        all.push(match (n % 2 == odd, n % 4 < 2) {
            (false, _) => Polynomial::zero(),
            (true, true) => power.clone(),
            (true, false) => power.negated(),
        });
    }
    all
}

fn product(a: &[Polynomial], b: &[Polynomial]) -> Vec<Polynomial> {
    let mut result = vec![Polynomial::zero(); a.len()];
    for (i, x) in a.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
        for (j, y) in b.iter().enumerate().filter(|(_, y)| !y.is_zero()) {
            if let Some(slot) = result.get_mut(i + j) {
                slot.add(&x.times(y));
            }
        }
    }
    result
}
