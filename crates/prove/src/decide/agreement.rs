//! Printed decimals: does an exact value round (or, failing that, cut off) to what is printed?
//!
//! A printed number with d digits after the point agrees with v if |v - printed| <= 10^-d / 2
//! (rounded), or if v lies between the printed number and the next one away from zero (cut off). Both
//! are decided by exact arithmetic or by a certified enclosure. An integer printed among decimals is
//! read with as many digits as the neighbour that has the fewest; integers alone are exact.

use super::order::{enclosure, truth};
use super::{Decision, Refutation};
use crate::evidence::{Evidence, Witness};
use num_traits::Signed;
use torse_algebra::planted::{Planted, planted};
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Rational};
use torse_language::core::Printed;
use torse_language::syntax::Relation;

/// The most printed decimals.
const MAX_DIGITS: u32 = 2_000;

/// How a printed number agrees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Agreement {
    Exact,
    Rounded,
    CutOff,
}

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
    let half = match planted(Planted::RoundingTooWide) {
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
    let open = |reason: &str| Decision::Open {
        reason: reason.to_owned(),
        tried: vec!["an enclosure of the value".to_owned()],
    };
    if digits > MAX_DIGITS {
        return open(&format!(
            "numbers with more than {MAX_DIGITS} decimals are not compared"
        ));
    }
    let shown = |value: &Fraction| {
        enclosure(value, 256).map(|ball| ball.decimal(usize::try_from(digits).unwrap_or(0) + 8))
    };
    let decimals: Option<Vec<String>> = values.iter().map(shown).collect();
    let Some(decimals) = decimals else {
        return open("the value still depends on symbols");
    };
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
    let as_printed = |printed: &Printed| {
        let decimals = printed.decimals.unwrap_or(0) as usize;
        let scaled =
            &printed.value * Rational::from_integer(torse_algebra::Integer::from(10).pow(decimals));
        let digits = scaled.to_integer().abs().to_string();
        let sign = if printed.negative { "-" } else { "" };
        if decimals == 0 {
            return format!("{sign}{digits}");
        }
        let padded = format!("{digits:0>width$}", width = decimals + 1);
        let (whole, fraction) = padded.split_at(padded.len() - decimals);
        format!("{sign}{whole}.{fraction}")
    };
    let listed = |parts: Vec<String>| {
        if let [one] = parts.as_slice() {
            one.clone()
        } else {
            format!("[{}]", parts.join(", "))
        }
    };
    if found.iter().any(Option::is_none) {
        let exact: Vec<String> = values
            .iter()
            .map(|v| torse_language::notation::text(&crate::formula::expression(v)))
            .collect();
        let positions: Vec<String> = found
            .iter()
            .enumerate()
            .filter(|(_, f)| f.is_none())
            .map(|(i, _)| (i + 1).to_string())
            .collect();
        let mut steps = vec!["the value is computed exactly and enclosed".to_owned()];
        if values.len() > 1 {
            steps.push(format!("entry {} differs", positions.join(", ")));
        }
        let witness = Witness {
            at: vec![],
            left: listed(exact),
            right: listed(printed.iter().map(as_printed).collect()),
            left_decimal: listed(decimals),
            right_decimal: listed(printed.iter().map(as_printed).collect()),
        };
        return Decision::Refuted(Box::new(Refutation {
            witness,
            sides: None,
            steps,
            evidence: Evidence::Witness,
        }));
    }
    let exact = found.iter().all(|f| *f == Some(Agreement::Exact));
    let cut = found.contains(&Some(Agreement::CutOff));
    let how = match (exact, cut) {
        (true, _) => "the printed numbers are exact".to_owned(),
        (false, false) => {
            format!("the printed numbers are the values rounded to {digits} decimals")
        }
        (false, true) => format!(
            "the printed numbers are the values cut off (not rounded) after {digits} decimals"
        ),
    };
    Decision::Proven {
        evidence: if exact {
            Evidence::Identity
        } else {
            Evidence::Enclosure
        },
        conditions: vec![],
        steps: vec![format!("the exact values begin {}", listed(decimals)), how],
    }
}
