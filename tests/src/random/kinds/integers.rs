//! Integers, also of ranges that depend on one another: all cases of a finite range are counted through.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::number::Q;
use crate::random::polynomial::Polynomial;
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(5) {
        0..3 => finite(stream),
        3 => unbounded(stream),
        _ => aliases(stream),
    }
}

/// Whether an assumption holds for m and i.
type Keep = fn(&(i128, i128)) -> bool;

/// Every pair of m in `low..high` and i in the range that depends on it.
fn pairs(low: i128, high: i128, first: i128, last: impl Fn(i128) -> i128) -> Vec<(i128, i128)> {
    let all = (low..=high).flat_map(|m| (first..=last(m)).map(move |i| (m, i)));
    all.collect()
}

/// An extreme value over all pairs, or one beyond it.
fn finite(stream: &mut Stream) -> Claim {
    let low = stream.integer(1, 3);
    let high = low + stream.integer(0, 2);
    let first = stream.integer(0, 1);
    let (range, last): (&str, fn(i128) -> i128) = match stream.below(3) {
        0 => ("m", |m| m),
        1 => ("m-1", |m| m - 1),
        _ => ("m+1", |m| m + 1),
    };
    let mut all = pairs(low, high, first, last);
    let mut assume = None;
    if stream.once_in(4) {
        let (text, keep): (&str, Keep) = match stream.below(3) {
            0 => ("i < m", |&(m, i)| i < m),
            1 => ("m != 2", |&(m, _)| m != 2),
            _ => ("m >= 2", |&(m, _)| m >= 2),
        };
        all.retain(keep);
        assume = Some(text);
    }
    let names = ["m", "i"];
    let form = &Polynomial::some(stream, 2, 2, 2) + &Polynomial::variable(1);
    let sum = stream.once_in(3);
    let value = |&(m, i): &(i128, i128)| match sum {
        true => (1..=i).fold(Q::ZERO, |total, j| {
            total + form.value(&[Q::int(m), Q::int(j), Q::ZERO, Q::ZERO])
        }),
        false => form.value(&[Q::int(m), Q::int(i), Q::ZERO, Q::ZERO]),
    };
    let left = match sum {
        true => format!("sum(j, 1, i, {})", form.text(stream, &["m", "j"])),
        false => form.text(stream, &names),
    };
    let values: Vec<Q> = all.iter().map(value).collect();
    let most = stream.once_in(2);
    let extreme = match most {
        true => values.iter().copied().max(),
        false => values.iter().copied().min(),
    };
    let slip = stream.once_in(2);
    let step = Q::new(1, stream.integer(1, 3));
    let (bound, truth) = match extreme {
        None => (Q::ONE, Truth::Vacuous),
        Some(extreme) => {
            let place = values.iter().position(|v| *v == extreme).unwrap_or(0);
            let (m, i) = all[place];
            match (slip, most) {
                (false, _) => (extreme, Truth::Holds),
                (true, true) => (extreme - step, Truth::Fails(format!("m = {m}, i = {i}"))),
                (true, false) => (extreme + step, Truth::Fails(format!("m = {m}, i = {i}"))),
            }
        }
    };
    let relation = if most { "<=" } else { ">=" };
    let states = States::Compare(left, relation, bound.to_string());
    let claim = Claim::new(Kind::Integers, states, truth)
        .symbol("m", format!("{{ integer = '{low}..{high}' }}"))
        .symbol("i", format!("{{ integer = '{first}..{range}' }}"));
    match assume {
        Some(text) => claim.assuming(text),
        None => claim,
    }
}

/// Integers with a least value only.
fn unbounded(stream: &mut Stream) -> Claim {
    let least = stream.integer(1, 3);
    let k = stream.integer(1, 4);
    let all = || Truth::Holds;
    let fails = |m: i128| Truth::Fails(format!("m = {m}"));
    let (states, truth): (States, Truth) = match stream.below(8) {
        0 => (
            States::Compare(
                "m*(m + 1)".to_owned(),
                ">=",
                (least * (least + 1)).to_string(),
            ),
            all(),
        ),
        1 => (
            States::Compare(
                format!("m^2 - {k}*m"),
                "<=",
                (least * least * 4).to_string(),
            ),
            fails(least * 4 + k),
        ),
        2 => (
            States::Compare("binom(m, 2)".to_owned(), "==", "m*(m - 1)/2".to_owned()),
            all(),
        ),
        3 => (
            States::Compare(
                "binom(m, 2)".to_owned(),
                "==",
                format!("m*(m - 1)/2 + m - {}", least + k),
            ),
            fails(least + k + 1),
        ),
        4 => {
            let bound = (1..=least + k).sum::<i128>();
            (
                States::Compare("sum(j, 1, m, j)".to_owned(), "<=", bound.to_string()),
                fails(least + k + 1),
            )
        }
        5 => (States::Compare("i".to_owned(), "<=", "m".to_owned()), all()),
        6 => (
            States::Compare(format!("i + {k}"), "<=", "m".to_owned()),
            Truth::Fails("i = m".to_owned()),
        ),
        _ => (
            States::Compare("i*(m - i)".to_owned(), ">=", "0".to_owned()),
            all(),
        ),
    };
    let claim = Claim::new(Kind::Integers, states, truth)
        .symbol("m", format!("{{ integer = '>= {least}' }}"));
    claim.symbol("i", "{ integer = '0..m' }")
}

/// An index that chooses between points, and what is true of integers only.
fn aliases(stream: &mut Stream) -> Claim {
    let (u, v) = (stream.integer(0, 2), stream.integer(0, 2));
    let equal = u == v;
    let (text, relation, right, truth): (String, _, String, _) = match stream.below(5) {
        0 => (
            format!("(1 - o)*P[{u}] + o*P[{}]", u + 1),
            "==",
            format!("P[{u} + o]"),
            Truth::Holds,
        ),
        1 => (
            format!("(1 - o)*P[{u}] + o*P[{v}]"),
            "==",
            "P[o]".to_owned(),
            match u == 0 && v == 1 {
                true => Truth::Holds,
                false => Truth::Fails("all P different".to_owned()),
            },
        ),
        2 => ("o*(o - 1)".to_owned(), "==", "0".to_owned(), Truth::Holds),
        3 => (
            format!("P[o + {u}] - P[o + {v}]"),
            "==",
            "0".to_owned(),
            match equal {
                true => Truth::Holds,
                false => Truth::Fails("all P different".to_owned()),
            },
        ),
        _ => ("2*o".to_owned(), "!=", "1".to_owned(), Truth::Holds),
    };
    Claim::new(
        Kind::Integers,
        States::Compare(text, relation, right),
        truth,
    )
    .symbol("m", "{ integer = '3..4' }")
    .symbol("o", "{ integer = '0..1' }")
    .symbol("P", "{ family = 1, indices = ['0..m'] }")
}
