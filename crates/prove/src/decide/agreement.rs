//! Printed decimals: does an exact value round (or, failing that, cut off) to what is printed?
//!
//! A printed number with d digits after the point agrees with v if |v - printed| <= 10^-d / 2
//! (rounded), or if v lies between the printed number and the next one away from zero (cut off). Both
//! are decided by exact arithmetic or by a certified enclosure. An integer printed among decimals is
//! read with as many digits as the neighbour that has the fewest; integers alone are exact.

use super::order::{enclosure, truth};
use super::value::{Proof, quotient};
use super::{Decision, Refutation};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Rational};
use torse_certificate::enclosure::{Agreeing, Agreement, Enclosure};
use torse_certificate::point::{Counterexample, Failure};
use torse_core::Printed;
use torse_syntax::formula::Relation;

/// The most printed decimals.
const MAX_DIGITS: u32 = 2_000;

/// How the number agrees: `Some(None)` if it does not, `None` if the enclosures do not tell.
fn agreement(value: &Fraction, printed: &Printed, decimals: u32) -> Option<Option<Agreement>> {
    let gap = value.clone() - Fraction::from(printed.value.clone());
    if gap.is_zero() {
        return Some(Some(Agreement::Exact));
    }
    if decimals == 0 {
        return Some(None);
    }
    let unit = Rational::new(
        1.into(),
        torse_algebra::Integer::from(10).pow(decimals as usize),
    );
    let below = |value: Fraction, bound: &Rational, relation: Relation| {
        truth(&(value - Fraction::from(bound.clone())), relation)
    };
    let half = match injected(InjectedFault::RoundingTooWide) {
        true => unit.clone(),
        false => &unit / integer(2),
    };
    let rounded = below(gap.clone(), &half, Relation::AtMost)?
        && below(-gap.clone(), &half, Relation::AtMost)?;
    if rounded {
        return Some(Some(Agreement::Rounded));
    }
    let outward = if printed.negative { -gap } else { gap };
    let cut = truth(&outward, Relation::AtLeast)? && below(outward, &unit, Relation::Less)?;
    Some(cut.then_some(Agreement::CutOff))
}

/// Decides whether the printed numbers agree with the values.
#[must_use]
pub fn decide(values: &[Fraction], printed: &[Printed]) -> Decision {
    let digits = printed.iter().filter_map(|p| p.decimals).max().unwrap_or(0);
    let open = |reason: &str| Decision::open(reason, &["an enclosure of the value"]);
    if digits > MAX_DIGITS {
        return open(&format!(
            "numbers with more than {MAX_DIGITS} decimals are not compared"
        ));
    }
    if values.iter().any(|value| enclosure(value, 64).is_none()) {
        return open("the value still depends on symbols");
    }
    // An integer without a point among decimals is read with as many digits as the neighbour that has the fewest.
    let pointed = printed.iter().filter_map(|p| p.decimals).filter(|d| *d > 0);
    let fewest = pointed.min().unwrap_or(0);
    let found: Option<Vec<Option<Agreement>>> = values
        .iter()
        .zip(printed)
        .map(|(v, p)| agreement(v, p, p.decimals.filter(|d| *d > 0).unwrap_or(fewest)))
        .collect();
    let Some(found) = found else {
        return open("the value is too near to the border between two printed numbers");
    };
    let entries = values.iter().zip(printed).zip(found);
    let enclosure = Enclosure {
        entries: entries
            .map(|((value, printed), how)| Agreeing {
                value: quotient(value),
                printed: printed.clone(),
                how,
            })
            .collect(),
    };
    if enclosure.differing().is_empty() {
        return Decision::Proven(Proof::Enclosure(enclosure));
    }
    Decision::Refuted(Box::new(Refutation::at(Counterexample {
        at: vec![],
        others: vec![],
        failure: Failure::Printed(enclosure),
    })))
}
