//! Functions that are defined by cases of their index, as one definition for each index.
//!
//! `f_i(t) = \begin{cases} a, & i = 0, \\ b, & i = 1 \end{cases}` says `f_0(t) = a` and `f_1(t) = b`. Cases of anything else are left
//! as they are.

use torse_syntax::latex::item::{Nucleus, TexItem};

/// The definitions of the members, with a wide blank between; the formula itself if it is no definition by cases of an index.
pub(super) fn by_members(items: Vec<TexItem>) -> Vec<TexItem> {
    members(&items).unwrap_or(items)
}

fn members(items: &[TexItem]) -> Option<Vec<TexItem>> {
    let equals = items.iter().position(|item| item.is_sign("="))?;
    let (left, grid) = (items.get(..equals)?, items.get(equals + 1)?);
    // What stands behind the cases, such as the range of the index, is kept.
    let behind = items.get(equals + 2..)?;
    let separated = behind
        .first()
        .is_none_or(|next| next.is_sign(",") || next.is_sign("quad"));
    let (Nucleus::Grid(name, rows), true, true) = (&grid.nucleus, grid.is_bare(), separated) else {
        return None;
    };
    if !matches!(name.as_str(), "cases" | "dcases") {
        return None;
    }
    let head = left.first()?;
    let index = match (&head.nucleus, head.below.as_deref()?) {
        (Nucleus::Letter(..), [index]) if matches!(index.nucleus, Nucleus::Letter(..)) => index,
        _ => return None,
    };
    let mut found = vec![];
    for row in rows {
        let [body, condition] = row.as_slice() else {
            return None;
        };
        let number = number_of(condition, index)?;
        let body = without_comma(body);
        // A body that uses the index says more than a list.
        if body.is_empty() || contains(body, index) {
            return None;
        }
        if !found.is_empty() {
            found.push(sign("quad", grid));
        }
        found.push(TexItem {
            below: Some(vec![number.clone()]),
            ..head.clone()
        });
        found.extend(left.get(1..)?.iter().cloned());
        found.push(items.get(equals)?.clone());
        found.extend(body.iter().cloned());
    }
    found.extend(behind.iter().cloned());
    Some(found)
}

/// The number of a condition `i = 0`, words such as `if` before it left out.
fn number_of<'i>(condition: &'i [TexItem], index: &TexItem) -> Option<&'i TexItem> {
    let start = condition
        .iter()
        .position(|item| !matches!(item.nucleus, Nucleus::Words(_)) && !item.is_sign("quad"))?;
    match without_comma(condition.get(start..)?) {
        [letter, equals, number]
            if letter.nucleus == index.nucleus
                && letter.is_bare()
                && equals.is_sign("=")
                && matches!(number.nucleus, Nucleus::Number(_))
                && number.is_bare() =>
        {
            Some(number)
        }
        _ => None,
    }
}

/// A list without the punctuation and the words at its end.
fn without_comma(list: &[TexItem]) -> &[TexItem] {
    let is_end = |item: &TexItem| {
        [",", ";", ".", "quad"]
            .iter()
            .any(|sign| item.is_sign(sign))
            || matches!(item.nucleus, Nucleus::Words(_))
    };
    let end = list.iter().rposition(|item| !is_end(item));
    list.get(..end.map_or(0, |end| end + 1)).unwrap_or(&[])
}

fn contains(list: &[TexItem], letter: &TexItem) -> bool {
    list.iter().any(|item| {
        item.nucleus == letter.nucleus
            || item
                .lists()
                .into_iter()
                .any(|inner| contains(inner, letter))
    })
}

fn sign(name: &str, beside: &TexItem) -> TexItem {
    TexItem {
        nucleus: Nucleus::Sign(name.to_owned()),
        below: None,
        above: None,
        primes: 0,
        place: beside.place,
    }
}
