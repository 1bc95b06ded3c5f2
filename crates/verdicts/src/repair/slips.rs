//! Returns what a number may have been before a slip: another sign, two digits exchanged, one digit changed, the same
//! figure from another place of the example, a round number near by.

use num_traits::{Signed, ToPrimitive, Zero};
use std::collections::BTreeMap;
use torse_algebra::Rational;
use torse_algebra::rational::{integer, ratio};

/// The distance of a slip from the print: one for slips of copying, more for numbers that are only round.
pub type Cost = u32;

/// A number that differs by its sign, by one digit or an exchange of digits, or is printed elsewhere.
const COPIED: Cost = 1;
/// A multiple of ten.
const TENS: Cost = 2;
/// A multiple of five.
const FIVES: Cost = 3;
/// Any number of few digits.
const FEW_DIGITS: Cost = 5;
/// Maximum round number, in fives.
const MAX_FIVES: i64 = 20;
/// Maximum number of few digits, in tenths.
const MAX_TENTHS: i64 = 2_000;
/// Maximum integer of few digits.
const MAX_UNITS: i64 = 1_000;

/// The numbers that a slip may have turned into this one, with the cost of the slip; `others` are the
/// numbers printed elsewhere in the example.
///
/// ```
/// use torse_algebra::rational::integer;
/// use torse_verdicts::repair::slips::slips;
/// let read = slips(&integer(-60), &[]);
/// assert_eq!(read.get(&integer(-50)), Some(&1)); // one digit
/// assert_eq!(read.get(&integer(60)), Some(&1)); // the sign
/// assert_eq!(read.get(&integer(35)), Some(&3)); // just a round number
/// ```
#[must_use]
pub fn slips(value: &Rational, others: &[Rational]) -> BTreeMap<Rational, Cost> {
    let mut read = BTreeMap::new();
    let mut add = |number: Rational, cost: Cost| {
        if number != *value {
            let least = read.entry(number).or_insert(cost);
            *least = cost.min(*least);
        }
    };
    for digits in digit_slips(value) {
        add(digits.clone(), COPIED);
        add(-digits, COPIED + 1);
    }
    add(-value.clone(), COPIED);
    for other in others {
        add(other.clone(), COPIED);
        add(-other.clone(), COPIED + 1);
    }
    for fives in -MAX_FIVES..=MAX_FIVES {
        let cost = if fives % 2 == 0 { TENS } else { FIVES };
        add(integer(5 * fives), cost);
    }
    read
}

/// Returns [`slips`], and every number of few digits.
#[must_use]
pub fn few_digits(value: &Rational, others: &[Rational]) -> BTreeMap<Rational, Cost> {
    let mut read = slips(value, others);
    let tenths = (-MAX_TENTHS..=MAX_TENTHS).filter_map(|n| ratio(n, 10));
    let units = (-MAX_UNITS..=MAX_UNITS).map(integer);
    for number in tenths.chain(units).filter(|n| n != value) {
        read.entry(number).or_insert(FEW_DIGITS);
    }
    read
}

/// Returns the numbers with one digit changed or two neighbours exchanged, in the decimals of the print.
fn digit_slips(value: &Rational) -> Vec<Rational> {
    let scale = [1, 10, 100].map(integer);
    let Some(scale) = scale.into_iter().find(|s| (value * s).is_integer()) else {
        return vec![];
    };
    let Some(figure) = (value.abs() * &scale).to_integer().to_i64() else {
        return vec![];
    };
    let digits: Vec<u8> = figure.to_string().into_bytes();
    let number = |digits: &[u8]| {
        let text = String::from_utf8_lossy(digits);
        let figure: i64 = text.parse().ok()?;
        let sign = if value.is_negative() { -1 } else { 1 };
        Some(integer(sign * figure) / &scale)
    };
    let mut changed = vec![];
    for position in 0..digits.len() {
        for digit in b'0'..=b'9' {
            let mut other = digits.clone();
            if let Some(slot) = other.get_mut(position) {
                *slot = digit;
            }
            changed.extend(number(&other));
        }
        if position > 0 {
            let mut other = digits.clone();
            other.swap(position - 1, position);
            changed.extend(number(&other));
        }
    }
    changed.retain(|n| n != value && (!n.is_zero() || digits.len() == 1));
    changed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exchanged_digits_and_changed_decimals_are_slips_of_copying() {
        let printed = ratio(125, 10).unwrap_or_default();
        let read = slips(&printed, &[]);
        for (n, d) in [(215, 10), (152, 10), (135, 10), (126, 10), (-125, 10)] {
            let number = ratio(n, d).unwrap_or_default();
            assert_eq!(read.get(&number), Some(&COPIED), "{number}");
        }
        assert_eq!(read.get(&integer(90)), Some(&TENS));
        assert_eq!(read.get(&integer(91)), None);
        assert_eq!(
            few_digits(&printed, &[]).get(&integer(91)),
            Some(&FEW_DIGITS)
        );
    }

    #[test]
    fn a_number_is_no_slip_of_itself() {
        for n in [-60, 0, 5, 30] {
            assert!(!few_digits(&integer(n), &[integer(n)]).contains_key(&integer(n)));
        }
    }
}
