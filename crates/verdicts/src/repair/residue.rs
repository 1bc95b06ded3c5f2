//! Linear equations modulo a prime: exact unknowns from values at pseudo-random points.
//!
//! Formulas are evaluated modulo `2^61 - 1`; each symbol is replaced by a residue that depends on its name and the
//! point alone, sine and cosine by a point of the unit circle. If a system with more equations than unknowns has a
//! solution there, it has one as formulas, except with a chance of about one in 10^17; and the result is proved
//! afterwards.

use num_traits::One;
use torse_algebra::mersenne::{self, PRIME, inverse, minus, plus, times};
use torse_algebra::{Fraction, Integer, Polynomial, Rational, Symbol};

/// Maximum numerator and denominator that are recovered from a residue.
const MAX_PART: u64 = 1 << 29;

/// Returns the residue of a power; for a negative exponent only if the base is not zero.
#[must_use]
pub fn power(base: u64, exponent: i32) -> Option<u64> {
    let base = match exponent < 0 {
        true => inverse(base)?,
        false => base,
    };
    Some(mersenne::power(base, exponent.unsigned_abs().into()))
}

/// The residue of a rational number.
#[must_use]
pub fn of_rational(value: &Rational) -> Option<u64> {
    let above = mersenne::residue(value.numer());
    if value.is_integer() {
        return Some(above);
    }
    let below = mersenne::residue(value.denom());
    Some(times(above, inverse(below)?))
}

/// The rational number of small numerator and denominator with this residue (Wang's algorithm: the
/// Euclidean algorithm, stopped half way).
#[must_use]
pub fn to_rational(residue: u64) -> Option<Rational> {
    let (mut above, mut rest) = (i128::from(PRIME), i128::from(residue));
    let (mut before, mut below) = (0_i128, 1_i128);
    while rest > i128::from(MAX_PART) {
        let quotient = above / rest;
        (above, rest) = (rest, above - quotient * rest);
        (before, below) = (below, before - quotient * below);
    }
    if below == 0 || below.unsigned_abs() > u128::from(MAX_PART) {
        return None;
    }
    Some(Rational::new(Integer::from(rest), Integer::from(below)))
}

/// Returns the residue that stands for a symbol at a point; none for a square root.
fn number(symbol: &Symbol, point: u64) -> Option<u64> {
    let circle = |name: &std::sync::Arc<str>, angle| {
        let t = mixed(&Symbol::Cos(name.clone(), angle), point);
        let square = times(t, t);
        let below = inverse(plus(1, square))?;
        let cosine = times(minus(1, square), below);
        Some((times(times(2, t), below), cosine))
    };
    match symbol {
        Symbol::Root(_) => None,
        // The angle is twice its half: the values are those of squares.
        Symbol::Exp(exponent) if exponent.parts() == 1 => {
            let half = mixed(&Symbol::Exp(exponent.over(2)), point);
            Some(times(half, half))
        }
        Symbol::Sin(name, angle) => Some(circle(name, *angle)?.0),
        Symbol::Cos(name, angle) => Some(circle(name, *angle)?.1),
        other => Some(mixed(other, point)),
    }
}

/// A residue that depends on the text of the symbol and the point (Fowler-Noll-Vo hash).
fn mixed(symbol: &Symbol, point: u64) -> u64 {
    let start = 0xcbf2_9ce4_8422_2325_u64;
    let bytes = symbol.to_string().into_bytes().into_iter();
    let hash = bytes.chain(point.to_le_bytes()).fold(start, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    times(hash % PRIME, hash % PRIME)
}

/// The residue of a fraction at a point; none where a divisor vanishes or a square root occurs.
#[must_use]
pub fn of_fraction(value: &Fraction, point: u64) -> Option<u64> {
    let mut result = of_polynomial(value.numerator(), point)?;
    for (factor, exponent) in value.denominator_factors() {
        let inverse = inverse(of_polynomial(factor, point)?)?;
        result = times(result, power(inverse, i32::try_from(exponent).ok()?)?);
    }
    Some(result)
}

fn of_polynomial(polynomial: &Polynomial, point: u64) -> Option<u64> {
    let symbols = polynomial.symbols();
    let values = symbols
        .iter()
        .map(|s| number(s, point))
        .collect::<Option<Vec<u64>>>()?;
    // One inversion for the common denominator.
    let scale = Rational::from_integer(polynomial.denominator().clone());
    let mut sum = 0;
    for term in polynomial.terms() {
        let mut product = match scale.is_one() {
            true => of_rational(&term.coefficient)?,
            false => of_rational(&(term.coefficient * &scale))?,
        };
        for (symbol, exponent) in term.powers {
            let position = symbols.binary_search(symbol).ok()?;
            let value = values.get(position)?;
            product = times(product, power(*value, i32::from(exponent))?);
        }
        sum = plus(sum, product);
    }
    match scale.is_one() {
        true => Some(sum),
        false => Some(times(sum, inverse(of_rational(&scale)?)?)),
    }
}

/// Solves linear equations with the right side last in each row. An unknown whose column depends on earlier ones is
/// zero; none if there is no solution.
#[must_use]
pub fn solved(mut rows: Vec<Vec<u64>>, unknowns: usize) -> Option<Vec<u64>> {
    let mut pivots = vec![];
    for column in 0..unknowns {
        let done = pivots.len();
        let entry = |row: &[u64]| row.get(column).copied().unwrap_or(0);
        let Some(found) = (done..rows.len()).find(|r| rows.get(*r).is_some_and(|r| entry(r) != 0))
        else {
            continue;
        };
        rows.swap(done, found);
        let mut pivot = rows.get(done)?.clone();
        let scale = inverse(entry(&pivot))?;
        for value in &mut pivot {
            *value = times(*value, scale);
        }
        for (position, row) in rows.iter_mut().enumerate() {
            let factor = entry(row);
            if position == done || factor == 0 {
                continue;
            }
            for (value, above) in row.iter_mut().zip(&pivot).skip(column) {
                *value = minus(*value, times(factor, *above));
            }
        }
        if let Some(slot) = rows.get_mut(done) {
            *slot = pivot;
        }
        pivots.push(column);
    }
    let right = |row: &Vec<u64>| row.get(unknowns).copied().unwrap_or(0);
    if rows.iter().skip(pivots.len()).any(|row| right(row) != 0) {
        return None;
    }
    let mut solution = vec![0; unknowns];
    for (row, column) in rows.iter().zip(pivots) {
        if let Some(slot) = solution.get_mut(column) {
            *slot = right(row);
        }
    }
    Some(solution)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use torse_algebra::rational::ratio;

    proptest! {
        #[test]
        fn a_rational_is_read_back_from_its_residue(n in -9_999_i64..9_999, d in 1_i64..9_999) {
            let value = ratio(n, d).unwrap_or_default();
            prop_assert_eq!(of_rational(&value).and_then(to_rational), Some(value));
        }

        #[test]
        fn earlier_columns_carry_the_solution(a in 1_u64..999, b in 1_u64..999) {
            // The second column is twice the first; the third is independent of both.
            let rows: Vec<Vec<u64>> = (1..6_u64)
                .map(|x| vec![x, 2 * x, x * x, a * x + b * x * x])
                .collect();
            prop_assert_eq!(solved(rows, 3), Some(vec![a, 0, b]));
        }
    }

    #[test]
    fn a_right_side_outside_the_span_has_no_solution() {
        let rows = (1..6_u64).map(|x| vec![x, x * x * x]).collect();
        assert_eq!(solved(rows, 1), None);
    }

    #[test]
    fn identities_hold_modulo_the_prime() {
        let x = std::sync::Arc::<str>::from("x");
        let angle = torse_algebra::Angle::QUARTER_TURN;
        let sine = number(&Symbol::Sin(x.clone(), angle), 7).unwrap_or(0);
        let cosine = number(&Symbol::Cos(x, angle), 7).unwrap_or(0);
        assert_eq!(plus(times(sine, sine), times(cosine, cosine)), 1);
        assert_ne!(sine, 0);
    }
}
