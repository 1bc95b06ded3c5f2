//! Rows of a formula that goes over several lines.
//!
//! A row goes on with the one before it where it begins with a sign that asks for an operand on its left, or where that one ends
//! with a sign that asks for an operand on its right. Two rows that each have a relation are two formulas. Nothing else is joined:
//! two operands at the ends of two rows are no product.

use super::super::commands::is_relation_sign;
use super::super::error::LatexError;
use super::super::item::{Nucleus, TexItem};
use super::is_operator;
use crate::formula::Place;

/// The sign of the end of a row, while a list is laid out.
pub(super) const END_OF_ROW: &str = "\\";

/// Joins the rows between the signs [`END_OF_ROW`] of a list.
pub(super) fn without_ends_of_rows(list: Vec<TexItem>) -> Result<Vec<TexItem>, LatexError> {
    if !list.iter().any(|item| item.is_sign(END_OF_ROW)) {
        return Ok(list);
    }
    let rows = list.split(|item| item.is_sign(END_OF_ROW));
    joined(rows.map(<[TexItem]>::to_vec).collect())
}

/// Joins rows.
pub(super) fn joined(rows: Vec<Vec<TexItem>>) -> Result<Vec<TexItem>, LatexError> {
    let mut list: Vec<TexItem> = vec![];
    let mut has_relation = false;
    for row in rows {
        let row: Vec<TexItem> = match list.is_empty() {
            true => row,
            // Space before a row that goes on.
            false => row.into_iter().skip_while(is_space).collect(),
        };
        let Some(first) = row.first() else {
            continue;
        };
        let goes_on = is_operator(first) && !is_applied(first);
        while list.last().is_some_and(is_space) {
            list.pop();
        }
        let waits = list
            .last()
            .is_none_or(|last| is_operator(last) && !last.is_sign(","));
        let place = first.place;
        let is_formula = row.iter().any(is_relation);
        if goes_on || waits {
            has_relation |= is_formula;
        } else if list.last().is_some_and(|last| last.is_sign(",")) {
            has_relation = is_formula;
        } else if has_relation && is_formula {
            list.push(comma(place));
        } else {
            let error = LatexError::new(
                place,
                "a new row begins with an operand: is it a factor, or a formula of its own?",
            );
            return Err(error.with_help(
                "begin the row with `\\cdot` or another sign, or end the one before with a comma",
            ));
        }
        list.extend(row);
    }
    Ok(list)
}

fn comma(place: Place) -> TexItem {
    TexItem::new(Nucleus::Sign(",".to_owned()), place)
}

/// Whether an item is a space, or nothing at all: `{}`.
fn is_space(item: &TexItem) -> bool {
    item.is_sign("quad") || matches!(&item.nucleus, Nucleus::Group(inner) if inner.is_empty())
}

/// Whether an item is applied to what stands behind it: a function, a sum.
fn is_applied(item: &TexItem) -> bool {
    matches!(item.nucleus, Nucleus::Operator(_) | Nucleus::Big(_))
}

fn is_relation(item: &TexItem) -> bool {
    matches!(&item.nucleus, Nucleus::Sign(sign) if is_relation_sign(sign))
}
