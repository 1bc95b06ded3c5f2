//! The prime factors of integers, by trial division.

use crate::Integer;
use crate::scalar::ExactError;
use dashu_int::ops::BitTest;

/// The largest number of bits of an integer that is factored.
const MAX_BITS: usize = 1 << 14;
/// The largest number by which is divided.
const MAX_DIVISOR: u32 = 1_000_000;

/// The primes that divide a positive integer, with their exponents; `None` where what is left after division by all
/// numbers up to one million is not known to be a prime.
///
/// # Errors
/// [`ExactError::TooLarge`] for an integer of more than 2^14 binary digits.
pub(super) fn prime_factors(number: &Integer) -> Result<Option<Vec<(Integer, usize)>>, ExactError> {
    let bits = number.bit_len();
    if bits > MAX_BITS {
        let limit = MAX_BITS;
        return Err(ExactError::TooLarge { bits, limit });
    }
    let (two, limit) = (Integer::from(2), Integer::from(MAX_DIVISOR));
    let (mut rest, mut prime, mut found) = (number.clone(), two.clone(), vec![]);
    while &prime * &prime <= rest && prime <= limit {
        let mut exponent = 0;
        while (&rest % &prime).is_zero() {
            rest /= &prime;
            exponent += 1;
        }
        if exponent > 0 {
            found.push((prime.clone(), exponent));
        }
        // After 2 only odd numbers are tried.
        prime += if prime == two { 1 } else { 2 };
    }
    if rest.is_one() {
        return Ok(Some(found));
    }
    let is_prime = &prime * &prime > rest;
    found.push((rest, 1));
    Ok(is_prime.then_some(found))
}
