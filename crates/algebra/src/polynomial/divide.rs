//! Exact division: long division by leading terms that stops at the first term that does not divide.
//!
//! The quotient is computed in the free polynomial ring. A quotient in that ring is also a quotient modulo the
//! relations, so a result is always correct; `None` means only that no quotient exists without use of the relations.
//!
//! Most divisions are attempts that fail, so cheap tests come first. The degree of the quotient in each symbol is the
//! difference of the degrees, and its first and last terms are the quotients of the first and last terms. **Gauss'
//! lemma:** if a polynomial with integer coefficients has a quotient by a primitive one, the quotient has integer
//! coefficients. So no fractions are needed, and the division ends at a coefficient that does not divide.

use super::add::widened;
use super::packed::{Difference, Row, widths};
use super::{Polynomial, cost};
use crate::rational::Integer;
use num_integer::Integer as _;
use num_traits::Zero;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;

/// The largest number of steps of one division; divisions of the prover end long before.
const MAX_STEPS: usize = 200_000;

/// Rows of exponents, descending, with their integer coefficients.
#[derive(Clone, Copy)]
struct Terms<'a> {
    width: usize,
    exponents: &'a [u16],
    coefficients: &'a [Integer],
}

impl Terms<'_> {
    /// The highest exponent of each column.
    fn degrees(&self) -> Vec<u16> {
        let mut degrees = vec![0; self.width];
        for row in self.exponents.chunks_exact(self.width) {
            for (degree, exponent) in degrees.iter_mut().zip(row) {
                *degree = (*exponent).max(*degree);
            }
        }
        degrees
    }

    /// The rows of the first and of the last term; `None` if there are no terms.
    fn ends(&self) -> Option<[&[u16]; 2]> {
        let mut rows = self.exponents.chunks_exact(self.width);
        let first = rows.next()?;
        Some([first, rows.next_back().unwrap_or(first)])
    }

    fn packed<'r, R: Row>(&'r self, widths: &'r [u32]) -> impl Iterator<Item = (R, &'r Integer)> {
        let rows = self.exponents.chunks_exact(self.width);
        rows.map(|row| R::pack(row, widths)).zip(self.coefficients)
    }
}

/// The difference of two rows, or `None` if an exponent would be negative.
fn less(a: &[u16], b: &[u16]) -> Option<Vec<u16>> {
    a.iter().zip(b).map(|(a, b)| a.checked_sub(*b)).collect()
}

/// The quotient of two integers, or `None` if it is not an integer.
fn integer_quotient(a: &Integer, b: &Integer) -> Option<Integer> {
    if b.is_one() {
        return Some(a.clone());
    }
    let (quotient, remainder) = a.div_rem(b);
    remainder.is_zero().then_some(quotient)
}

/// Computes the terms of the quotient: rows, descending, and coefficients. `limits` are the largest exponents of the
/// quotient; `widths` are the bits of the columns, one more than the exponents of the dividend need.
fn quotient<R: Difference>(
    dividend: Terms<'_>,
    (divisor, content): (Terms<'_>, &Integer),
    limits: &[u16],
    widths: &[u32],
) -> Option<(Vec<u16>, Vec<Integer>)> {
    let guards = R::guards(widths);
    let limits = R::pack(limits, widths);
    let mut divisor = divisor
        .packed::<R>(widths)
        .map(|(row, c)| (row, c / content));
    let (lead, lead_coefficient) = divisor.next()?;
    let divisor: Vec<(R, Integer)> = divisor.collect();
    let mut rest: BTreeMap<R, Integer> = dividend
        .packed::<R>(widths)
        .map(|(row, c)| (row, c.clone()))
        .collect();
    let (mut exponents, mut coefficients) = (vec![], vec![]);
    for _ in 0..MAX_STEPS {
        let Some((row, coefficient)) = rest.pop_last() else {
            return Some((exponents, coefficients));
        };
        let step = row.less(&lead, &guards)?;
        limits.less(&step, &guards)?;
        cost::division_step(divisor.len()).ok()?;
        let factor = integer_quotient(&coefficient, &lead_coefficient)?;
        for (other, c) in &divisor {
            match rest.entry(step.plus(other)) {
                Entry::Vacant(slot) => {
                    slot.insert(-(&factor * c));
                }
                Entry::Occupied(mut slot) => {
                    *slot.get_mut() -= &factor * c;
                    if slot.get().is_zero() {
                        slot.remove();
                    }
                }
            }
        }
        step.unpack(widths, &mut exponents);
        coefficients.push(factor);
    }
    None
}

impl Polynomial {
    /// Returns the quotient `self / divisor` if the division leaves no remainder, without use of the relations.
    ///
    /// ```
    /// use torse_algebra::Polynomial;
    /// let (x, y) = (Polynomial::named("x"), Polynomial::named("y"));
    /// let product = &(&x + &y) * &(&x - &y);
    /// assert_eq!(product.exact_quotient(&(&x - &y)), Some(&x + &y));
    /// assert_eq!(x.exact_quotient(&y), None);
    /// ```
    #[must_use]
    pub fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        if let Some(value) = divisor.as_constant() {
            return (!value.is_zero()).then(|| self.scaled(&value.recip()));
        }
        if self.is_zero() {
            return Some(Self::zero());
        }
        // Division fails if the divisor has a symbol that does not occur in the dividend.
        let occurs = |s| self.body.symbols.binary_search(s).is_ok();
        if !divisor.body.symbols.iter().all(occurs) {
            return None;
        }
        let wide = widened(divisor, &self.body.symbols);
        let below = Terms {
            width: self.body.symbols.len(),
            exponents: &wide,
            coefficients: &divisor.body.coefficients,
        };
        let above = Terms {
            width: self.body.symbols.len(),
            exponents: &self.body.exponents,
            coefficients: &self.body.coefficients,
        };
        let degrees = above.degrees();
        let limits = less(&degrees, &below.degrees())?;
        for (a, b) in above.ends()?.into_iter().zip(below.ends()?) {
            less(&limits, &less(a, b)?)?;
        }
        let content = divisor.content();
        // One more bit for each column, which shows whether a difference of two rows is negative there.
        let widths: Vec<u32> = widths(&degrees).iter().map(|w| w + 1).collect();
        let bits: u32 = widths.iter().sum();
        let divide = if bits <= u64::BITS {
            quotient::<u64>
        } else if bits <= u128::BITS {
            quotient::<u128>
        } else {
            quotient::<Box<[u16]>>
        };
        let (exponents, coefficients) = divide(above, (below, &content), &limits, &widths)?;
        let scaled = coefficients
            .into_iter()
            .map(|c| c * &divisor.body.denominator);
        Some(Self::normalized(
            Arc::clone(&self.body.symbols),
            exponents,
            scaled.collect(),
            &self.body.denominator * content,
        ))
    }

    /// The greatest common divisor of the integer coefficients.
    fn content(&self) -> Integer {
        let mut content = Integer::zero();
        for c in &self.body.coefficients {
            content = content.gcd(c);
            if content.is_one() {
                break;
            }
        }
        content
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A polynomial in so many symbols, each to this power or a lower one.
    fn polynomials(symbols: usize, highest: u32) -> impl Strategy<Value = Polynomial> {
        let term = (-9i64..10, prop::collection::vec(0..=highest, symbols));
        prop::collection::vec(term, 1..6).prop_map(|terms| {
            let terms = terms.into_iter().map(|(coefficient, exponents)| {
                let powers = exponents.into_iter().enumerate();
                powers.fold(
                    Polynomial::integer(coefficient),
                    |product, (n, exponent)| {
                        &product * &Polynomial::named(&format!("s{n}")).power(exponent)
                    },
                )
            });
            terms.fold(Polynomial::zero(), |sum, term| &sum + &term)
        })
    }

    /// Pairs whose product has rows of one word, of two, and of more.
    fn pairs() -> impl Strategy<Value = (Polynomial, Polynomial)> {
        let pair =
            |symbols, highest| (polynomials(symbols, highest), polynomials(symbols, highest));
        prop_oneof![pair(3, 4), pair(9, 300), pair(12, 9_000)]
    }

    proptest! {
        #[test]
        fn a_quotient_times_the_divisor_is_the_dividend((p, q) in pairs(), scale in 1i64..7) {
            prop_assume!(!q.is_zero());
            let q = q.scaled(&crate::Rational::new(scale.into(), 3.into()));
            prop_assert_eq!((&p * &q).exact_quotient(&q), Some(p.clone()));
            if let Some(quotient) = p.exact_quotient(&q) {
                prop_assert_eq!(&quotient * &q, p);
            }
        }

        #[test]
        fn what_leaves_a_remainder_has_no_quotient((p, q) in pairs(), n in 1i64..9) {
            prop_assume!(q.as_constant().is_none());
            let beside = &(&p * &q) + &Polynomial::integer(n);
            prop_assert_eq!(beside.exact_quotient(&q), None);
        }

        #[test]
        fn a_linear_polynomial_divides_where_its_root_is_one_of_the_dividend(
            (a, b) in (1i64..5, -4i64..5),
            dividend in prop::collection::vec(-4i64..5, 2..4),
        ) {
            let x = Polynomial::named("x");
            let along = |coefficients: &[i64]| {
                let terms = coefficients.iter().map(|c| Polynomial::integer(*c));
                terms.fold(Polynomial::zero(), |sum, c| &(&sum * &x) + &c)
            };
            let n = i32::try_from(dividend.len()).unwrap_or(0);
            // The value at -b/a, times a power of a.
            let powers = (0..n).map(|i| (-b).pow((n - 1 - i).unsigned_abs()) * a.pow(i.unsigned_abs()));
            let value: i64 = dividend.iter().zip(powers).map(|(c, power)| c * power).sum();
            let quotient = along(&dividend).exact_quotient(&along(&[a, b]));
            prop_assert_eq!(quotient.is_some(), value == 0);
        }

        #[test]
        fn words_are_subtracted_as_rows_are(a in prop::collection::vec(0u16..40, 4), b in prop::collection::vec(0u16..40, 4)) {
            let widths = [7; 4];
            let expected = less(&a, &b).map(|row| u64::pack(&row, &widths));
            let [a, b] = [&a, &b].map(|row| u64::pack(row, &widths));
            prop_assert_eq!(a.less(&b, &u64::guards(&widths)), expected);
        }
    }
}
