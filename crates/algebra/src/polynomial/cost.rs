//! What operations on polynomials cost, in the units of [`torse_numbers::work`].
//!
//! An operation whose cost is refused answers at once: a sum with zero, a product with a factor, so that what cannot vanish
//! does not, a division with "there is none", a common divisor with one. The job is over then, and what it comes to is dropped.

use super::Polynomial;
use torse_numbers::work::{self, Spent, room, spend};

/// Products of more pairs of terms than this also cost memory.
const LARGE: u64 = 1 << 18;

/// What any operation costs besides, for the lists that it makes.
const OVERHEAD: u64 = 16;

/// Spends what a product will cost: a unit a pair of terms, more for long coefficients, and more than in proportion once
/// the result may be too large to hold.
pub(super) fn product(a: &Polynomial, b: &Polynomial) -> Result<(), Spent> {
    let pairs = number(a.len()).saturating_mul(number(b.len()));
    let words = 1 + words(a).saturating_mul(words(b)) / 4;
    let all = pairs
        .saturating_mul(words)
        .saturating_mul(1 + pairs / LARGE);
    spend(all.saturating_add(OVERHEAD))
}

/// Spends what a sum over so many symbols will cost: a unit a term. There has to be room for all terms of both.
pub(super) fn sum(a: &Polynomial, b: &Polynomial, symbols: usize) -> Result<(), Spent> {
    let terms = a.len().saturating_add(b.len());
    room(terms.saturating_mul(bytes_of_a_term(symbols)))?;
    spend(number(terms) + OVERHEAD)
}

/// Ends the job of an operation whose result has an exponent above `u16::MAX`.
///
/// # Panics
/// Outside of a job: no row holds the exponent, and a wrong result would be worse than none.
pub(super) fn exponent_overflow() {
    let limit = Spent::Exponent { limit: u16::MAX };
    assert!(work::end(limit), "{limit}");
}

/// Spends what it costs to write even powers of a sine by its cosine, so many in all, or of a root by a number: a unit a
/// term and word.
pub(super) fn rewriting(terms: usize, highest: u16, symbols: usize) -> Result<(), Spent> {
    room(terms.saturating_mul(bytes_of_a_term(symbols) + usize::from(highest) / 8))?;
    spend(number(terms).saturating_mul(1 + u64::from(highest) / 64))
}

/// The bytes of a term in so many symbols whose coefficient is a word or two.
pub(super) fn bytes_of_a_term(symbols: usize) -> usize {
    symbols * size_of::<u16>() + size_of::<crate::Integer>()
}

/// Spends what the images of two polynomials modulo a prime will cost, by which a common divisor is looked for.
pub(super) fn gcd(a: &Polynomial, b: &Polynomial) -> Result<(), Spent> {
    let symbols = number(a.body.symbols.len() + b.body.symbols.len());
    spend((number(a.len()) + number(b.len())).saturating_mul(symbols))
}

/// Spends what one step of a division by so many terms, besides the leading one, will cost.
pub(super) fn division_step(terms: usize) -> Result<(), Spent> {
    spend(4 * (number(terms) + 1))
}

/// The words of the first and last coefficients, which stand for all.
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
