//! Edits of a repeated part: a coefficient, an exponent, a factor or any other part that occurs several times is edited
//! in all places at once.

use super::alphabet::Alphabet;
use super::edit::{Edit, parts};
use super::edits::{local, scaled};
use torse_syntax::formula::Expr;

/// Maximum size of such a part.
const MAX_PART: usize = 12;
/// Maximum number of different parts that occur more than once.
const MAX_PARTS: usize = 24;

/// Returns all formulas in which the equal occurrences of one part have the same edit.
#[must_use]
pub fn edits(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let expr = expr.placeless();
    let mut counts: Vec<(&Expr, usize)> = vec![];
    for (_, part) in parts(&expr) {
        if part.size() > MAX_PART {
            continue;
        }
        match counts.iter_mut().find(|(known, _)| *known == part) {
            Some((_, count)) => *count += 1,
            None => counts.push((part, 1)),
        }
    }
    counts.retain(|(_, count)| *count > 1);
    // The slip was made in the smallest part.
    counts.sort_by_key(|(part, _)| part.size());
    counts.truncate(MAX_PARTS);
    let mut result = vec![];
    for (part, count) in counts {
        let places = match count {
            2 => " in both places".to_owned(),
            _ => format!(" in all {count} places"),
        };
        let edits = local(part, alphabet)
            .into_iter()
            .chain(scaled(part, alphabet));
        result.extend(edits.map(|edit| Edit {
            change: edit.change.at(&places),
            expr: replaced(&expr, part, &edit.expr),
        }));
    }
    result
}

/// Replaces every occurrence of a part in the formula.
fn replaced(expr: &Expr, old: &Expr, new: &Expr) -> Expr {
    if expr == old {
        return new.clone();
    }
    expr.with_parts(|part| replaced(part, old, new))
}

#[cfg(test)]
mod tests {
    use super::super::edit::text;
    use super::*;
    use torse_syntax::formula::parse;

    #[test]
    fn an_edit_is_made_in_all_places_or_none() {
        let expr = parse("(a + c*w*b)/(1 + c*w)").unwrap();
        let found = edits(&expr, &Alphabet::default());
        let texts: Vec<String> = found.iter().map(|edit| text(&edit.expr)).collect();
        assert!(texts.contains(&"(a + c^2*w*b)/(1 + c^2*w)".to_owned()));
        assert!(texts.contains(&"(a + 2*(c*w)*b)/(1 + 2*(c*w))".to_owned()));
        assert!(!texts.contains(&"(a + c^2*w*b)/(1 + c*w)".to_owned()));
    }

    #[test]
    fn what_occurs_once_is_left_to_single_edits() {
        let expr = parse("a + 2*b").unwrap();
        assert!(edits(&expr, &Alphabet::default()).is_empty());
    }
}
