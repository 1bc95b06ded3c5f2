//! Printed decimals: whether a value rounds, or is truncated, to a printed number.

use super::gap::{Unsupported, Work};
use super::quotient::Quotient;
use std::cmp::Ordering;
use torse_certificate::enclosure::{Agreement, Enclosure};
use torse_certificate::number::order;
use torse_certificate::polynomial::Polynomial;
use torse_core::Printed;
use torse_numbers::rational::integer;
use torse_numbers::{Integer, Rational};

/// The largest number of decimals.
const MAX_DIGITS: u32 = 2_000;

/// How each value agrees with its printed number; `None` if it does not. An integer among decimals has as many digits
/// as the decimal with the fewest digits; integers alone are exact.
pub fn agreements(
    values: &[Quotient],
    printed: &[Printed],
    work: &Work,
) -> Result<Vec<Option<Agreement>>, Unsupported> {
    if values.len() != printed.len() {
        return Err(Unsupported::Construct("as many printed numbers as values"));
    }
    let pointed = printed.iter().filter_map(|p| p.decimals).filter(|d| *d > 0);
    let fewest = pointed.min().unwrap_or(0);
    let pairs = values.iter().zip(printed);
    let all = pairs.map(|(value, own)| {
        let digits = own.decimals.filter(|d| *d > 0).unwrap_or(fewest);
        agreement(value, own, digits, work)
    });
    all.collect()
}

fn agreement(
    value: &Quotient,
    printed: &Printed,
    digits: u32,
    work: &Work,
) -> Result<Option<Agreement>, Unsupported> {
    let number = Quotient::number(printed.value.clone());
    let gap = value.minus(&number, work)?;
    let compare = |gap: &Quotient, bound: &Rational| -> Result<Ordering, Unsupported> {
        let gap = gap.minus(&Quotient::number(bound.clone()), work)?;
        let below = gap.denominator(work)?;
        let own = |p: &Polynomial| order(p).ok_or(Unsupported::Near);
        Ok(match own(&below)? {
            Ordering::Less => own(&gap.above)?.reverse(),
            _ => own(&gap.above)?,
        })
    };
    if compare(&gap, &integer(0))?.is_eq() {
        return Ok(Some(Agreement::Exact));
    }
    if digits == 0 {
        return Ok(None);
    }
    if digits > MAX_DIGITS {
        return Err(Unsupported::Large);
    }
    let places = usize::try_from(digits).map_err(|_| Unsupported::Large)?;
    let unit = Rational::new(1.into(), Integer::from(10).pow(places));
    let half = &unit / integer(2);
    if compare(&gap, &half)?.is_le() && compare(&gap.negated(), &half)?.is_le() {
        return Ok(Some(Agreement::Rounded));
    }
    let outward = if printed.negative { gap.negated() } else { gap };
    let cut = compare(&outward, &integer(0))?.is_ge() && compare(&outward, &unit)?.is_lt();
    Ok(cut.then_some(Agreement::CutOff))
}

/// Whether these are the values of an enclosure.
pub fn same_values(
    values: &[Quotient],
    enclosure: &Enclosure<Polynomial>,
    work: &Work,
) -> Result<bool, Unsupported> {
    if values.len() != enclosure.entries.len() {
        return Ok(false);
    }
    for (value, entry) in values.iter().zip(&enclosure.entries) {
        if !value.equals(&Quotient::from_ratio(&entry.value, work)?, work)? {
            return Ok(false);
        }
    }
    Ok(true)
}
