//! What operations on polynomials cost, in the units of [`torse_numbers::work`].

use super::Polynomial;
use torse_numbers::work::spend;

/// Products of more pairs of terms than this also cost memory.
const LARGE: u64 = 1 << 18;

/// What any operation costs besides, for the lists that it makes.
const OVERHEAD: u64 = 16;

/// Spends what a product will cost: a unit a pair of terms, more for long coefficients, and more than in proportion once
/// the result may be too large to hold.
pub(super) fn product(a: &Polynomial, b: &Polynomial) {
    let pairs = number(a.len()).saturating_mul(number(b.len()));
    let words = 1 + words(a).saturating_mul(words(b)) / 4;
    let all = pairs
        .saturating_mul(words)
        .saturating_mul(1 + pairs / LARGE);
    spend(all.saturating_add(OVERHEAD));
}

/// Spends what a sum or a multiple will cost: a unit a term.
pub(super) fn sum(a: &Polynomial, b: &Polynomial) {
    spend(number(a.len()) + number(b.len()) + OVERHEAD);
}

/// Spends what the images of two polynomials modulo a prime will cost, by which a common divisor is looked for.
pub(super) fn gcd(a: &Polynomial, b: &Polynomial) {
    let symbols = number(a.body.symbols.len() + b.body.symbols.len());
    spend((number(a.len()) + number(b.len())).saturating_mul(symbols));
}

/// Spends what one step of a division by so many terms, besides the leading one, will cost.
pub(super) fn division_step(terms: usize) {
    spend(4 * (number(terms) + 1));
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
