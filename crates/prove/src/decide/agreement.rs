//! Printed decimals: does an exact value round (or, failing that, cut off) to what is printed?
//!
//! A printed number with d digits after the point agrees with v if |v - printed| <= 10^-d / 2
//! (rounded), or if v lies between the printed number and the next one away from zero (cut off). Both
//! are decided by exact arithmetic or by a certified enclosure. An integer printed among decimals is
//! read with as many digits as its neighbours; integers alone are exact.

use super::domain::{enclosure, truth};
use super::{Decision, Refutation};
use crate::evidence::{Evidence, Witness};
use num_traits::Signed;
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Rational};
use torse_language::syntax::Relation;

/// How a printed number agrees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Agreement {
    Exact,
    Rounded,
    CutOff,
}

fn agreement(value: &Fraction, printed: &Rational, decimals: u32) -> Option<Agreement> {
    let gap = value.clone() - Fraction::from(printed.clone());
    if gap.is_zero() {
        return Some(Agreement::Exact);
    }
    if decimals == 0 {
        return None;
    }
    let unit = Rational::new(
        1.into(),
        torse_algebra::Integer::from(10).pow(decimals as usize),
    );
    let below = |value: Fraction, bound: Rational| {
        truth(&(value - Fraction::from(bound)), Relation::AtMost) == Some(true)
    };
    let half = &unit / integer(2);
    if below(gap.clone(), half.clone()) && below(-gap.clone(), half) {
        return Some(Agreement::Rounded);
    }
    let outward = if printed.is_negative() { -gap } else { gap };
    let positive = truth(&outward, Relation::AtLeast) == Some(true);
    (positive && truth(&(outward - Fraction::from(unit)), Relation::Less) == Some(true))
        .then_some(Agreement::CutOff)
}

/// Decides whether the printed numbers agree with the values.
#[must_use]
pub fn decide(values: &[Fraction], printed: &[(Rational, u32)]) -> Decision {
    let digits = printed.iter().map(|(_, d)| *d).max().unwrap_or(0);
    let shown = |value: &Fraction| {
        enclosure(value, 256).map(|ball| ball.decimal(usize::try_from(digits).unwrap_or(0) + 8))
    };
    let decimals: Option<Vec<String>> = values.iter().map(shown).collect();
    let Some(decimals) = decimals else {
        return Decision::Open {
            reason: "the value still depends on symbols".to_owned(),
            tried: vec!["an enclosure of the value".to_owned()],
        };
    };
    let found: Vec<Option<Agreement>> = values
        .iter()
        .zip(printed)
        .map(|(v, (p, _))| agreement(v, p, digits))
        .collect();
    let as_printed = |(value, decimals): &(Rational, u32)| {
        let scaled = value
            * Rational::from_integer(torse_algebra::Integer::from(10).pow(*decimals as usize));
        let digits = scaled.to_integer().abs().to_string();
        let sign = if value.is_negative() { "-" } else { "" };
        let decimals = *decimals as usize;
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
