//! Drawing numbers from declared sets, and membership tests.

use super::stream::Stream;
use crate::arithmetic::Arithmetic;
use crate::no_value::Work;
use crate::real::{Real, Reals, SLACK_BITS};
use std::cmp::Ordering;
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::{Bound, Interval};

/// Integers are drawn at most `SPAN` beyond their bound. The distance grows by one after every `ATTEMPTS_PER_STEP`
/// attempts.
const SPAN: i64 = 5;
const ATTEMPTS_PER_STEP: u64 = 3;
/// From a bounded range of at most this many integers, all are drawn.
const SHORT_RANGE: i64 = 12;
/// The finite bound that replaces an infinite one where a number between two bounds is needed.
const FINITE_BOUND: i64 = 4;

/// `a + share * b`; exact if both numbers are. An enclosed `a` is returned unchanged.
fn moved(a: &Real, b: &Real, share: &Rational) -> Real {
    match (a.parts(), b.parts()) {
        (Some((p, s)), Some((q, t))) => Real::exact(&*p + share * &*q, &*s + share * &*t),
        _ => a.clone(),
    }
}

fn value(bound: &Bound) -> Real {
    Real::exact(bound.value.rational.clone(), bound.value.turns.clone())
}

/// The number at this fraction of the way through an interval; infinite bounds are replaced by finite ones.
fn between(interval: &Interval, share: &Rational) -> Real {
    let (lower, upper) = (
        interval.lower.as_ref().map(value),
        interval.upper.as_ref().map(value),
    );
    let far = |n: i64| Real::from(integer(n));
    let (lower, upper) = match (lower, upper) {
        (Some(lower), Some(upper)) => (lower, upper),
        (Some(lower), None) => (
            lower.clone(),
            moved(&lower, &far(FINITE_BOUND), &integer(1)),
        ),
        (None, Some(upper)) => (moved(&upper, &far(-FINITE_BOUND), &integer(1)), upper),
        (None, None) => (far(-FINITE_BOUND), far(FINITE_BOUND)),
    };
    let rest = integer(1) - share;
    let zero = far(0);
    moved(&moved(&zero, &lower, &rest), &upper, share)
}

/// A random rational number without bounds: small, and often an integer.
pub(crate) fn anywhere(stream: &Stream, label: &str) -> Rational {
    if stream.corner || (stream.edges && stream.below(&format!("{label} zero"), 2) == 0) {
        return integer(0);
    }
    let denominator = match stream.below(&format!("{label}/"), 8) {
        0..=2 => 1,
        3 | 4 => 2,
        5 => 3,
        6 => 5,
        _ => 7,
    };
    // Every third point is near the origin, where hypotheses about squares are true more often.
    let size = match stream.attempt % 3 {
        0 => 6,
        1 => 1,
        _ => 3,
    };
    let numerator = stream.below(label, 2 * size * denominator + 1) - size * denominator;
    Rational::new(numerator.into(), denominator.into())
}

/// A random number of an interval: mostly between the bounds, sometimes a closed bound itself.
pub(crate) fn in_interval(interval: &Interval, stream: &Stream, label: &str) -> Real {
    let ends: Vec<&Bound> = [&interval.lower, &interval.upper]
        .into_iter()
        .flatten()
        .filter(|end| end.closed)
        .collect();
    let often = match (stream.corner, stream.edges) {
        (true, _) => 1,
        (false, true) => 2,
        (false, false) => 8,
    };
    if stream.below(&format!("{label} end"), often) == 0
        && let Some(end) = usize::try_from(stream.below(&format!("{label} which"), 2))
            .ok()
            .and_then(|which| ends.get(which))
    {
        return value(end);
    }
    let parts = match stream.below(&format!("{label} parts"), 8) {
        0 => 2,
        1 => 3,
        2 | 3 => 4,
        4 => 6,
        5 => 7,
        6 => 12,
        _ => 16,
    };
    let part = 1 + stream.below(label, parts - 1);
    let share = Rational::new(part.into(), parts.into());
    match (&interval.lower, &interval.upper) {
        (Some(_), Some(_)) => between(interval, &share),
        (Some(lower), None) => {
            let far = 1 + stream.below(&format!("{label} far"), 6);
            moved(&value(lower), &Real::from(integer(far)), &share)
        }
        (None, Some(upper)) => {
            let far = 1 + stream.below(&format!("{label} far"), 6);
            moved(&value(upper), &Real::from(integer(-far)), &share)
        }
        (None, None) => anywhere(stream, label).into(),
    }
}

/// A random integer between bounds, near the lower one in early attempts; `None` if there is none.
pub(crate) fn integer_between(
    least: Option<i64>,
    most: Option<i64>,
    stream: &Stream,
    label: &str,
) -> Option<i64> {
    let reach = i64::try_from(stream.attempt / ATTEMPTS_PER_STEP)
        .unwrap_or(SPAN)
        .min(SPAN);
    let near = stream.below(label, reach + 1);
    match (least, most) {
        (Some(least), Some(most)) if least > most => None,
        (Some(least), Some(most)) => {
            let length = most.saturating_sub(least).saturating_add(1);
            Some(if length <= SHORT_RANGE {
                least + stream.below(label, length)
            } else {
                least + near
            })
        }
        (Some(least), None) => least.checked_add(near),
        (None, Some(most)) => most.checked_sub(near),
        (None, None) => Some(stream.below(label, 2 * reach + 3) - reach - 1),
    }
}

/// Whether a number lies in an interval; `None` if that is not known. One that satisfies equations only nearly is in there only if
/// it is not nearly an open end: the number that satisfies them may be the end.
pub(crate) fn contains(interval: &Interval, number: &Real, near: bool) -> Option<bool> {
    let work = Work::new(8);
    let reals = Reals::new(1024, &work);
    let inside = |bound: &Option<Bound>, outside: Ordering| match bound {
        None => Some(true),
        Some(bound) => {
            let gap = reals.minus(number, &value(bound)).ok()?;
            let sign = gap.sign()?;
            if near && !bound.closed && sign != outside && gap.ball(1024).is_within(SLACK_BITS) {
                return None;
            }
            Some(sign != outside && (bound.closed || sign.is_ne()))
        }
    };
    let lower = inside(&interval.lower, Ordering::Less);
    let upper = inside(&interval.upper, Ordering::Greater);
    match (lower, upper) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}
