//! Counterexamples in words: exact values as one would write them by hand, and their decimals.

use super::order::enclosure;
use super::value::{fraction, plain};
use crate::evidence::Witness;
use crate::formula;
use num_traits::Signed;
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational};
use torse_certificate::enclosure::{Enclosure, text as printed};
use torse_certificate::point::Failure;
use torse_certificate::{Ratio, Refuted};
use torse_syntax::notation;

/// Digits of the decimals shown.
const DIGITS: usize = 12;

/// The counterexample of a refutation.
pub(super) fn witness(refuted: &Refuted<Polynomial>) -> Witness {
    let counterexample = refuted.counterexample();
    let point: Vec<(String, String)> = counterexample
        .at
        .iter()
        .map(|value| (value.symbol.to_string(), exact(&value.value)))
        .collect();
    let chosen = refuted.integers().into_iter();
    let mut at: Vec<(String, String)> = chosen
        .filter(|(name, _)| point.iter().all(|(own, _)| own != name))
        .map(|(name, value)| (name.to_owned(), value.to_string()))
        .collect();
    let (more, [left, right, left_decimal, right_decimal]) = sides(&counterexample.failure);
    let degree = more.iter().take_while(|(name, _)| name == "degree").count();
    let (degree, more) = more.split_at(degree);
    at.extend(degree.iter().cloned());
    at.extend(point);
    at.extend(more.iter().cloned());
    Witness {
        at,
        left,
        right,
        left_decimal,
        right_decimal,
    }
}

/// What stands beside the point, and both sides, exact and as decimals.
fn sides(failure: &Failure<Polynomial>) -> (Vec<(String, String)>, [String; 4]) {
    let degree_of = |degree: &u32| ("degree".to_owned(), degree.to_string());
    match failure {
        Failure::Sides { left, right, .. } => {
            let (left, right) = (side(left), side(right));
            (vec![], [left.0, right.0, left.1, right.1])
        }
        Failure::Printed(enclosure) => {
            let values = enclosure.entries.iter().map(|entry| exact(&entry.value));
            let numbers = enclosure.entries.iter().map(|e| printed(&e.printed));
            let (values, numbers) = (listed(values.collect()), listed(numbers.collect()));
            let plain: Enclosure<torse_certificate::Polynomial> = enclosure.map(&plain);
            (vec![], [values, numbers.clone(), plain.decimals(), numbers])
        }
        Failure::Dependent {
            family,
            degree,
            combination,
        } => {
            let one = integer(1);
            let terms: Vec<String> = combination
                .iter()
                .enumerate()
                .filter(|(_, c)| !c.above.is_zero())
                .map(|(i, c)| match fraction(c).and_then(|c| c.as_rational()) {
                    Some(number) if number == one => format!("{family}[{i},{degree}]"),
                    _ => format!("({})*{family}[{i},{degree}]", exact(c)),
                })
                .collect();
            let zero = || "0".to_owned();
            let sides = [terms.join(" + "), zero(), zero(), zero()];
            (vec![degree_of(degree)], sides)
        }
        Failure::Turning {
            degree,
            control,
            places,
            values,
        } => {
            let mut more = vec![degree_of(degree)];
            for (place, value) in control {
                more.push((format!("control value {place}"), exact(value)));
            }
            more.push(("all others".to_owned(), "0".to_owned()));
            more.push(("places".to_owned(), places.each_ref().map(exact).join(", ")));
            let list = |parts: [String; 3]| format!("[{}]", parts.join(", "));
            let once = || "one change of sign".to_owned();
            let left = list(values.each_ref().map(exact));
            let decimals = list(values.each_ref().map(decimal));
            (more, [left, once(), decimals, once()])
        }
        Failure::Beyond {
            degree,
            control,
            low,
            high,
            level,
        } => {
            let mut more = vec![degree_of(degree)];
            match control {
                None => more.push(("all control values".to_owned(), "1".to_owned())),
                Some(place) => {
                    more.push((format!("control value {place}"), "1".to_owned()));
                    more.push(("all others".to_owned(), "0".to_owned()));
                }
            }
            more.push((
                "places".to_owned(),
                format!("{}, {}", exact(&low.0), exact(&high.0)),
            ));
            let list = |low: String, high: String| format!("[{low}, {high}]");
            let left = list(exact(&low.1), exact(&high.1));
            let decimals = list(decimal(&low.1), decimal(&high.1));
            // The control values are on one side of a level, and the curve is on both.
            let one_side = || format!("one side of {}", exact(level));
            (more, [left, one_side(), decimals, one_side()])
        }
    }
}

fn listed(parts: Vec<String>) -> String {
    match parts.as_slice() {
        [one] => one.clone(),
        _ => format!("[{}]", parts.join(", ")),
    }
}

/// The entries of a side, exact and as decimals.
fn side(values: &[Ratio<Polynomial>]) -> (String, String) {
    let shown = values.iter().filter_map(fraction).map(|v| shown(&v));
    let (exact, decimals): (Vec<String>, Vec<String>) = shown.unzip();
    (listed(exact), listed(decimals))
}

/// An exact number as one would write it by hand.
fn exact(value: &Ratio<Polynomial>) -> String {
    fraction(value).map_or_else(String::new, |value| {
        notation::text(&formula::expression(&value))
    })
}

/// Its decimals.
fn decimal(value: &Ratio<Polynomial>) -> String {
    let ball = fraction(value).and_then(|value| enclosure(&value, 192));
    ball.map_or_else(String::new, |ball| ball.decimal(DIGITS))
}

/// An exact number as text: the formula, and its decimals.
fn shown(value: &Fraction) -> (String, String) {
    let text = notation::text(&formula::expression(value));
    let terminating = value.as_rational().and_then(|q| terminating(&q));
    let decimal = terminating.or_else(|| Some(enclosure(value, 192)?.decimal(DIGITS)));
    (text, decimal.unwrap_or_default())
}

/// The decimals of a rational number, if they end.
fn terminating(q: &Rational) -> Option<String> {
    let shift = integer(10).pow(i32::try_from(DIGITS).ok()?);
    let shifted = q.abs() * shift;
    if !shifted.is_integer() {
        return None;
    }
    let digits = shifted.to_integer().to_string();
    let padded = format!("{digits:0>width$}", width = DIGITS + 1);
    let (whole, rest) = padded.split_at(padded.len() - DIGITS);
    let rest = rest.trim_end_matches('0');
    let sign = if q.is_negative() { "-" } else { "" };
    let point = if rest.is_empty() { "" } else { "." };
    Some(format!("{sign}{whole}{point}{rest}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::rational::ratio;

    #[test]
    fn decimals_that_end_are_told_exactly() {
        for (n, d, text) in [
            (0, 1, "0"),
            (3, 5, "0.6"),
            (-275, 2, "-137.5"),
            (12, 1, "12"),
        ] {
            let value = Fraction::from(ratio(n, d).unwrap());
            assert_eq!(shown(&value).1, text);
        }
        let third = Fraction::from(ratio(1, 3).unwrap());
        assert_eq!(shown(&third).1, "0.333333333333...");
    }
}
