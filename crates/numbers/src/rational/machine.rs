//! Arithmetic of rational numbers whose parts are machine words, without big integers.
//!
//! Most rational numbers of a proof are short, and the general operations of the inner type spend their time on
//! divisions of two-word integers. Here greatest common divisors are taken of single words, and a product of two
//! words has at most two words, so nothing can overflow (Knuth, The Art of Computer Programming 2, section 4.5.1).

use super::{Integer, Rational};
use num_integer::Integer as _;
use std::cmp::Ordering;

/// Numerator and denominator as words, if they fit. `i64::MIN` is refused because it has no negative.
fn words(q: &Rational) -> Option<(i64, i64)> {
    let numerator = i64::try_from(q.numer()).ok().filter(|n| *n != i64::MIN)?;
    Some((numerator, i64::try_from(q.denom()).ok()?))
}

/// The greatest common divisor of a number of any sign and a positive one.
#[inline]
fn common(n: i64, positive: i64) -> i64 {
    match positive {
        1 => 1,
        _ => n.gcd(&positive),
    }
}

#[inline]
fn made(numerator: i128, denominator: i128) -> Rational {
    Rational::in_lowest_terms(Integer::from(numerator), Integer::from(denominator))
}

/// `a/b * c/d`, cancelled crosswise before the multiplication.
#[inline]
fn product((a, b): (i64, i64), (c, d): (i64, i64)) -> Rational {
    let (first, second) = (common(a, d), common(c, b));
    made(
        i128::from(a / first) * i128::from(c / second),
        i128::from(b / second) * i128::from(d / first),
    )
}

fn sum((a, b): (i64, i64), (c, d): (i64, i64)) -> Rational {
    let shared = common(b, d);
    if shared == 1 {
        let numerator = i128::from(a) * i128::from(d) + i128::from(c) * i128::from(b);
        return made(numerator, i128::from(b) * i128::from(d));
    }
    let numerator = i128::from(a) * i128::from(d / shared) + i128::from(c) * i128::from(b / shared);
    // A remaining common factor divides the shared part of the denominators.
    let remainder = i64::try_from(numerator % i128::from(shared)).unwrap_or(0);
    let cancelled = remainder.gcd(&shared);
    let numerator = match cancelled {
        1 => numerator,
        by => numerator / i128::from(by),
    };
    made(
        numerator,
        i128::from(b / shared) * i128::from(d / cancelled),
    )
}

/// The sum, if both numbers are short.
pub(super) fn add(x: &Rational, y: &Rational) -> Option<Rational> {
    Some(sum(words(x)?, words(y)?))
}

/// The difference, if both numbers are short.
pub(super) fn sub(x: &Rational, y: &Rational) -> Option<Rational> {
    let (c, d) = words(y)?;
    Some(sum(words(x)?, (-c, d)))
}

/// The product, if both numbers are short.
pub(super) fn mul(x: &Rational, y: &Rational) -> Option<Rational> {
    Some(product(words(x)?, words(y)?))
}

/// The quotient, if both numbers are short and the divisor is not zero.
pub(super) fn div(x: &Rational, y: &Rational) -> Option<Rational> {
    let (c, d) = words(y)?;
    let inverse = match c {
        0 => return None,
        1.. => (d, c),
        _ => (-d, -c),
    };
    Some(product(words(x)?, inverse))
}

/// Compares two short numbers by cross-multiplication, since denominators are positive; `None` if one is not short.
pub(super) fn cmp(x: &Rational, y: &Rational) -> Option<Ordering> {
    let ((a, b), (c, d)) = (words(x)?, words(y)?);
    Some((i128::from(a) * i128::from(d)).cmp(&(i128::from(c) * i128::from(b))))
}

/// Returns `None`: remainders are computed by the inner type.
pub(super) fn rem(_: &Rational, _: &Rational) -> Option<Rational> {
    None
}

#[cfg(test)]
mod tests {
    use super::super::Inner;
    use super::*;
    use proptest::prelude::*;

    /// Words of all lengths, those at the ends of their range often.
    fn word() -> impl Strategy<Value = i64> {
        prop_oneof![
            -40_i64..40,
            any::<i64>(),
            any::<i64>().prop_map(|n| n >> 31),
            (0_i64..3).prop_map(|n| i64::MAX - n),
            (0_i64..3).prop_map(|n| i64::MIN + n),
        ]
    }

    fn number() -> impl Strategy<Value = Rational> {
        let denominator = word().prop_filter("a divisor of zero", |d| *d != 0);
        (word(), denominator).prop_map(|(n, d)| Rational::new(n.into(), d.into()))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2_000))]

        #[test]
        fn short_numbers_are_computed_as_the_inner_type_computes_them(x in number(), y in number()) {
            let inner = |q: Inner| Rational(q);
            let same = |short: Option<Rational>, general: Rational| {
                short.is_none_or(|q| q.numer() == general.numer() && q.denom() == general.denom())
            };
            prop_assert!(same(add(&x, &y), inner(&x.0 + &y.0)));
            prop_assert!(same(sub(&x, &y), inner(&x.0 - &y.0)));
            prop_assert!(same(mul(&x, &y), inner(&x.0 * &y.0)));
            let across = (x.numer() * y.denom()).cmp(&(y.numer() * x.denom()));
            prop_assert_eq!(x.cmp(&y), across);
            if *y.numer() != Integer::ZERO {
                prop_assert!(same(div(&x, &y), inner(&x.0 / &y.0)));
            }
        }
    }

    #[test]
    fn the_short_way_is_taken_up_to_the_ends_of_a_word_and_not_beyond() {
        let [most, least] = [i64::MAX, i64::MIN].map(|n| Rational::from_integer(n.into()));
        assert!(add(&most, &-most.clone()).is_some());
        assert!(mul(&least, &most).is_none() && sub(&most, &least).is_none());
        assert!(div(&most, &Rational::from_integer(Integer::ZERO)).is_none());
    }
}
