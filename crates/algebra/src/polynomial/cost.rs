//! The cost of operations on polynomials, in the units of [`torse_numbers::work`].
//!
//! An operation whose cost is refused returns at once: a sum returns zero, a product one of its factors (so that a
//! nonzero product stays nonzero), a division `None`, a common divisor one. The job is then over, and its result is
//! dropped.

use super::Polynomial;
use torse_numbers::work::{self, Spent, room, spend};

/// Above this number of pairs of terms the cost of a product grows faster than in proportion, because it also needs memory.
const MAX_CHEAP_PAIRS: u64 = 1 << 18;

/// The fixed cost of any operation, for the lists that it allocates.
const OVERHEAD: u64 = 16;

/// Spends the cost of a product: one unit for a pair of terms, more for long coefficients, and more than in
/// proportion once the result may be too large for memory.
pub(super) fn product(a: &Polynomial, b: &Polynomial) -> Result<(), Spent> {
    let pairs = number(a.len()).saturating_mul(number(b.len()));
    let words = 1 + words(a).saturating_mul(words(b)) / 4;
    let all = pairs
        .saturating_mul(words)
        .saturating_mul(1 + pairs / MAX_CHEAP_PAIRS);
    spend(all.saturating_add(OVERHEAD))
}

/// Spends the cost of a sum over `symbols` symbols: one unit for a term. Memory must allow all terms of both
/// summands.
pub(super) fn sum(a: &Polynomial, b: &Polynomial, symbols: usize) -> Result<(), Spent> {
    let terms = a.len().saturating_add(b.len());
    room(terms.saturating_mul(bytes_of_a_term(symbols)))?;
    spend(number(terms) + OVERHEAD)
}

/// Ends the job because an exponent of the result is above `u16::MAX`.
///
/// # Panics
/// Outside of a job: the exponent cannot be stored, and a wrong result would be worse than no result.
pub(super) fn exponent_overflow() {
    let limit = Spent::Exponent { limit: u16::MAX };
    assert!(work::end(limit), "{limit}");
}

/// Spends the cost of replacing even powers of a sine by its cosine, or of a root by a number, with `terms` resulting
/// terms: one unit for a term and word.
pub(super) fn rewriting(terms: usize, highest: u16, symbols: usize) -> Result<(), Spent> {
    room(terms.saturating_mul(bytes_of_a_term(symbols) + usize::from(highest) / 8))?;
    spend(number(terms).saturating_mul(1 + u64::from(highest) / 64))
}

/// The bytes of a term in `symbols` symbols whose coefficient has one or two words.
pub(super) fn bytes_of_a_term(symbols: usize) -> usize {
    symbols * size_of::<u16>() + size_of::<crate::Integer>()
}

/// Spends the cost of computing images of two polynomials modulo a prime, from which degrees of common divisors are
/// bounded.
pub(super) fn gcd(a: &Polynomial, b: &Polynomial) -> Result<(), Spent> {
    let symbols = number(a.body.symbols.len() + b.body.symbols.len());
    spend((number(a.len()) + number(b.len())).saturating_mul(symbols))
}

/// Spends the cost of one division step by a divisor that has `terms` terms besides the leading one.
pub(super) fn division_step(terms: usize) -> Result<(), Spent> {
    spend(4 * (number(terms) + 1))
}

/// The words of the longer of the first and last coefficients, as an estimate for all.
fn words(p: &Polynomial) -> u64 {
    let bits = |c: &crate::Integer| dashu_int::ops::BitTest::bit_len(c);
    let ends = p
        .body
        .coefficients
        .first()
        .into_iter()
        .chain(p.body.coefficients.last());
    let longest = ends.chain([&p.body.denominator]).map(bits).max();
    number(longest.unwrap_or(0)) / 64 + 1
}

fn number(n: usize) -> u64 {
    u64::try_from(n).unwrap_or(u64::MAX)
}
