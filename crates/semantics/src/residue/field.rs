//! The field of residues modulo a prime, with a root of unity.

use dashu_int::ops::Gcd;
use torse_numbers::{Integer, Rational};

/// The prime: the largest below 2^61 that is 1 modulo [`ORDER`].
pub(crate) const PRIME: u64 = 2_305_842_961_527_705_601;
/// The order of [`ROOT`]: 2^12 3^3 5^2 7^2 11 13. The sine and cosine of `u pi/v` are residues if v divides half of it.
pub(crate) const ORDER: u64 = 19_372_953_600;
/// A number of exactly this order, `23^((PRIME - 1)/ORDER)`.
pub(crate) const ROOT: u64 = 520_556_968_199_573_244;

/// The residue of 2^61 modulo the prime; it is below 2^36.
const TWO_POWER_61: u64 = (1 << 61) - PRIME;

/// The sum of two residues.
pub(crate) fn sum(a: u64, b: u64) -> u64 {
    once_less(a + b)
}

/// The residue of a number below twice the prime.
fn once_less(n: u64) -> u64 {
    if n >= PRIME { n - PRIME } else { n }
}

pub(crate) fn negative(a: u64) -> u64 {
    once_less(PRIME - a)
}

/// The product of two residues. Since 2^61 is congruent to [`TWO_POWER_61`], `2^61 h + l` may be replaced by
/// `TWO_POWER_61 h + l`. This leads from a number below 2^122 to one below 2^98, then below 2^74, then below 2^61 +
/// 2^49, which is less than twice the prime.
#[expect(
    clippy::cast_possible_truncation,
    reason = "what is left is below 2^62"
)]
pub(crate) fn product(a: u64, b: u64) -> u64 {
    const LOW: u128 = (1 << 61) - 1;
    let folded = |n: u128| (n >> 61) * u128::from(TWO_POWER_61) + (n & LOW);
    let n = folded(folded(folded(u128::from(a) * u128::from(b)))) as u64;
    once_less(n)
}

/// `a^exponent`, by squaring.
pub(crate) fn power(a: u64, mut exponent: u64) -> u64 {
    let (mut power, mut square) = (1, a);
    while exponent > 0 {
        if exponent % 2 == 1 {
            power = product(power, square);
        }
        square = product(square, square);
        exponent /= 2;
    }
    power
}

/// `1/a`, by Euclid's algorithm; `None` for 0.
pub(crate) fn inverse(a: u64) -> Option<u64> {
    let signed = |n: u64| i64::try_from(n).ok();
    let (mut rest, mut next) = (signed(PRIME)?, signed(a)?);
    let (mut before, mut factor) = (0_i64, 1_i64);
    while next != 0 {
        let digit = rest / next;
        (rest, next) = (next, rest - digit * next);
        (before, factor) = (factor, before - digit * factor);
    }
    // The greatest common divisor is 1 unless a is 0.
    let size = u64::try_from(before.rem_euclid(signed(PRIME)?)).ok()?;
    (rest == 1).then_some(size)
}

/// The residue of a machine integer.
pub(crate) fn integer(n: i64) -> u64 {
    let size = n.unsigned_abs() % PRIME;
    if n < 0 { negative(size) } else { size }
}

/// The residue of an integer.
fn whole(n: &Integer) -> u64 {
    // The truncated remainder has the sign of n.
    let short = i64::try_from(n);
    integer(
        short.unwrap_or_else(|_| i64::try_from(&(n % Integer::from(PRIME))).unwrap_or_default()),
    )
}

/// The residue of a rational number; `None` if the prime divides its denominator.
pub(crate) fn residue(q: &Rational) -> Option<u64> {
    let numerator = whole(q.numer());
    if q.is_integer() {
        return Some(numerator);
    }
    Some(product(numerator, inverse(whole(q.denom()))?))
}

/// The rational number with this residue whose numerator and denominator are at most `bound` in size, if there is
/// one.
///
/// If `2 bound^2` is below the prime there is at most one: for u/v and w/z with the same residue, uz - vw is a
/// multiple of the prime, but smaller than the prime. It is a convergent of Euclid's algorithm (Wang 1981).
pub(crate) fn rational_with_residue(a: u64, bound: u64) -> Option<(i64, i64)> {
    let signed = |n: u64| i64::try_from(n).ok();
    let (mut rest, mut next) = (signed(PRIME)?, signed(a)?);
    let (mut before, mut factor) = (0_i64, 1_i64);
    let bound = signed(bound)?;
    while next > bound {
        let digit = rest / next;
        (rest, next) = (next, rest - digit * next);
        (before, factor) = (factor, before - digit * factor);
        if factor.abs() > bound {
            return None;
        }
    }
    // The algorithm may find a multiple of the fraction.
    let common = next.unsigned_abs().gcd(factor.unsigned_abs());
    (common == 1).then(|| (next * factor.signum(), factor.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_of_unity_has_its_order() {
        assert_eq!(ROOT, power(23, (PRIME - 1) / ORDER));
        assert_eq!((PRIME - 1) % ORDER, 0);
        assert_eq!(power(ROOT, ORDER), 1);
        for prime in [2, 3, 5, 7, 11, 13] {
            assert_ne!(power(ROOT, ORDER / prime), 1, "{prime}");
        }
    }

    /// Pocklington's theorem: for q dividing p - 1, larger than the root of p, `a^(p-1) = 1` and a power `a^((p-1)/r)` that is
    /// not 1 for each prime r of q prove that p is a prime.
    #[test]
    fn the_modulus_is_a_prime() {
        assert!(u128::from(ORDER) * u128::from(ORDER) > u128::from(PRIME));
        assert_eq!(power(23, PRIME - 1), 1);
        for prime in [2, 3, 5, 7, 11, 13] {
            let other = power(23, (PRIME - 1) / prime);
            assert_eq!(sum(other, negative(1)).gcd(PRIME), 1, "{prime}");
        }
    }

    #[test]
    fn products_are_the_remainders_of_the_long_ones() {
        let ends = [
            0,
            1,
            2,
            1 << 36,
            TWO_POWER_61,
            PRIME / 2,
            ROOT,
            1 << 60,
            PRIME - 2,
            PRIME - 1,
        ];
        for a in ends {
            for b in ends {
                let long = u128::from(a) * u128::from(b) % u128::from(PRIME);
                assert_eq!(u128::from(product(a, b)), long);
                assert_eq!(
                    u128::from(sum(a, b)),
                    (u128::from(a) + u128::from(b)) % u128::from(PRIME)
                );
            }
            assert_eq!(sum(a, negative(a)), 0);
        }
    }

    #[test]
    fn an_inverse_times_its_number_is_one() {
        for a in [1, 2, 3, ROOT, PRIME - 1, PRIME / 2, 1 << 60] {
            assert_eq!(inverse(a).map(|inverse| product(a, inverse)), Some(1));
            assert_eq!(inverse(a), Some(power(a, PRIME - 2)), "Fermat");
        }
        assert_eq!(inverse(0), None);
    }

    #[test]
    fn small_fractions_come_back_from_their_residues() {
        for v in 1..40_i64 {
            for u in -40..=40_i64 {
                if u.unsigned_abs().gcd(v.unsigned_abs()) != 1 {
                    continue;
                }
                let q = Rational::new(u.into(), v.into());
                let found = residue(&q).and_then(|a| rational_with_residue(a, 1 << 20));
                assert_eq!(found, Some((u, v)));
            }
        }
        assert_eq!(rational_with_residue(ROOT, 1 << 20), None);
    }

    #[test]
    fn a_denominator_that_the_prime_divides_has_no_residue() {
        let q = Rational::new(1.into(), Integer::from(PRIME) * Integer::from(6));
        assert_eq!(residue(&q), None);
    }
}
