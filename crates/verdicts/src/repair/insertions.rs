//! What a print leaves out most easily: the exponent of a bracket, a call or an index, and a shift by one in a bound, a
//! binomial coefficient or an exponent. Another number in an exponent, on which a side does not depend as on those that are
//! solved for.

use super::edit::{Change, Edit, parts, placed};
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_syntax::formula::{Expr, Node, Operator};

/// Heads of calls whose arguments count something.
const COUNTING: [&str; 4] = ["binom", "factorial", "sum", "product"];

/// The largest exponent that is tried in the place of another.
const MAX_EXPONENT: i64 = 12;

/// All formulas with one such thing put in.
#[must_use]
pub fn edits(expr: &Expr) -> Vec<Edit> {
    let mut found = vec![];
    for (path, part) in parts(expr) {
        let parent = path.split_last().and_then(|(last, before)| {
            let parent = before
                .iter()
                .try_fold(expr, |e, position| e.parts().into_iter().nth(*position))?;
            Some((parent, *last))
        });
        if takes_square(part) && !is_base(parent) {
            let square = part
                .clone()
                .with(Operator::Power, Expr::number(&integer(2)));
            found.push(Edit {
                change: Change::replaced(part, &square),
                expr: placed(expr, &path, square),
            });
        }
        if let Some(value) = exponent(part, parent) {
            for other in (1..=MAX_EXPONENT).map(integer).filter(|n| n != value) {
                let number = Expr::number(&other);
                found.push(Edit {
                    change: Change::replaced(part, &number),
                    expr: placed(expr, &path, number),
                });
            }
        }
        if counts(part, parent) {
            for operator in [Operator::Add, Operator::Subtract] {
                let shifted = part.clone().with(operator, Expr::number(&integer(1)));
                found.push(Edit {
                    change: Change::replaced(part, &shifted),
                    expr: placed(expr, &path, shifted),
                });
            }
        }
    }
    found
}

/// A number that is an exponent.
fn exponent<'e>(part: &'e Expr, parent: Option<(&Expr, usize)>) -> Option<&'e Rational> {
    let (parent, 1) = parent? else {
        return None;
    };
    match (&parent.node, &part.node) {
        (Node::Binary(Operator::Power, ..), Node::Number { value, .. }) => Some(value),
        _ => None,
    }
}

/// Whether a square of it may have lost its exponent: a bracket, a call, a member of a family.
fn takes_square(part: &Expr) -> bool {
    matches!(
        &part.node,
        Node::Binary(Operator::Add | Operator::Subtract, ..) | Node::Call(..) | Node::Index(..)
    )
}

/// Whether a part is the base of a power, or the head of a call.
fn is_base(parent: Option<(&Expr, usize)>) -> bool {
    match parent {
        Some((parent, 0)) => matches!(
            &parent.node,
            Node::Binary(Operator::Power, ..) | Node::Call(..) | Node::Index(..)
        ),
        _ => false,
    }
}

/// Whether a name is an exponent, or counts something.
fn counts(part: &Expr, parent: Option<(&Expr, usize)>) -> bool {
    if !matches!(part.node, Node::Name(_)) {
        return false;
    }
    match parent.map(|(parent, place)| (&parent.node, place)) {
        Some((Node::Binary(Operator::Power, ..), 1)) => true,
        Some((Node::Call(head, arguments), place)) => {
            let counting =
                matches!(&head.node, Node::Name(name) if COUNTING.contains(&name.as_str()));
            // The first argument of a sum is its index, the last what is added up.
            let bound = arguments.len() < 4 || (2..=3).contains(&place);
            counting && bound
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_syntax::formula::parse;
    use torse_syntax::notation::text;

    fn edited(formula: &str) -> Vec<String> {
        let all = edits(&parse(formula).unwrap());
        all.iter().map(|edit| text(&edit.expr)).collect()
    }

    #[test]
    fn a_bracket_a_call_and_an_index_get_the_exponent_that_they_lack() {
        assert!(edited("a/(1 + b)").contains(&"a/(1 + b)^2".to_owned()));
        assert!(edited("1 + f'(x)").contains(&"1 + f'(x)^2".to_owned()));
        assert!(edited("2*P[0]").contains(&"2*P[0]^2".to_owned()));
        assert!(
            edited("(1 + b)^3")
                .iter()
                .all(|text| !text.contains("^2)^3"))
        );
    }

    #[test]
    fn what_counts_is_shifted_by_one() {
        let all = edited("sum(i, 0, n, binom(n, i)*t^i)");
        for text in [
            "sum(i, 0, n - 1, binom(n, i)*t^i)",
            "sum(i, 0, n, binom(n + 1, i)*t^i)",
            "sum(i, 0, n, binom(n, i)*t^(i + 1))",
        ] {
            assert!(all.contains(&text.to_owned()), "{text} in {all:?}");
        }
    }
}
