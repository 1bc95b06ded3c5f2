//! Edits of names: one name replaced by another, or two names exchanged, in a whole side or within one sum at any
//! depth.

use super::alphabet::Alphabet;
use super::edit::{Change, Edit, parts, placed, text, with_name};
use std::collections::BTreeMap;
use torse_syntax::formula::functions::is_function;
use torse_syntax::formula::{Expr, Node};

/// Maximum number of names of a formula that are exchanged or replaced.
const MAX_NAMES: usize = 14;
/// Stands for the first of two names while they are exchanged; no file can contain it.
const BETWEEN: &str = " ";

/// Returns all formulas in which two names are exchanged, or one replaced, in the whole or in a summand of a sum.
#[must_use]
pub fn edits(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let mut result = vec![];
    for (path, scope) in scopes(expr) {
        let place = match path.is_empty() {
            true => String::new(),
            false => format!(" in `{}`", text(scope)),
        };
        // A bound name is left alone: renaming it everywhere changes nothing.
        let bound = bound(scope);
        let mut counts = counted(scope);
        counts.retain(|name, _| !bound.contains(&name.as_str()));
        let inside: Vec<&String> = counts.keys().take(MAX_NAMES).collect();
        for (position, one) in inside.iter().enumerate() {
            for other in inside.iter().skip(position + 1) {
                let between = with_name(scope, one, BETWEEN);
                let half = with_name(&between, other, one);
                result.push(Edit {
                    expr: placed(expr, &path, with_name(&half, BETWEEN, other)),
                    change: Change::new(
                        "_ and _ exchanged",
                        [&Expr::name(one), &Expr::name(other)],
                    )
                    .at(&place),
                });
            }
        }
        let mut others: Vec<String> = counted(expr).into_keys().collect();
        others.extend(alphabet.names.iter().cloned());
        others.sort();
        others.dedup();
        for (old, count) in counts.iter().take(MAX_NAMES) {
            for new in others.iter().filter(|new| *new != old) {
                // A replacement in a single place is another edit, if both names are declared.
                if *count == 1 && alphabet.names.contains(new) {
                    continue;
                }
                let throughout = match path.is_empty() {
                    true if *count > 1 => " throughout",
                    _ => &place,
                };
                result.push(Edit {
                    expr: placed(expr, &path, with_name(scope, old, new)),
                    change: Change::replaced(&Expr::name(old), &Expr::name(new)).at(throughout),
                });
            }
        }
    }
    result
}

/// Returns the whole, and the summand of every sum in it.
fn scopes(expr: &Expr) -> Vec<(Vec<usize>, &Expr)> {
    let inner = parts(expr).into_iter().filter_map(|(path, part)| {
        let [_, _, _, body] = sum(part)? else {
            return None;
        };
        // The head is the first part of a call.
        Some(([path.as_slice(), &[4]].concat(), body))
    });
    std::iter::once((vec![], expr)).chain(inner).collect()
}

/// Returns the names that sums, products and integrals in a formula bind.
fn bound(expr: &Expr) -> Vec<&str> {
    let binder = |part: &'_ Expr| match &part.node {
        Node::Call(head, _) => match &head.node {
            Node::Name(name) if name == "sum" || name == "product" => Some(0),
            Node::Name(name) if name == "integral" => Some(1),
            _ => None,
        },
        _ => None,
    };
    let bound = parts(expr).into_iter().filter_map(|(_, part)| {
        let place = binder(part)?;
        match &part.node {
            Node::Call(_, arguments) => arguments.get(place),
            _ => None,
        }
    });
    bound.flat_map(Expr::names).collect()
}

/// The arguments of a sum.
fn sum(expr: &Expr) -> Option<&[Expr]> {
    let Node::Call(head, arguments) = &expr.node else {
        return None;
    };
    matches!(&head.node, Node::Name(name) if name == "sum").then_some(arguments)
}

/// Returns the names of a formula without primes, and how often each occurs.
fn counted(expr: &Expr) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for name in expr.names() {
        let name = name.trim_end_matches('\'');
        if name != "pi" && !is_function(name) {
            *counts.entry(name.to_owned()).or_insert(0) += 1;
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_syntax::formula::parse;

    fn texts(text: &str) -> Vec<String> {
        let expr = parse(text).unwrap();
        let found = edits(&expr, &Alphabet::default());
        found.iter().map(|edit| super::text(&edit.expr)).collect()
    }

    #[test]
    fn two_names_are_exchanged_with_their_primes() {
        let found = texts("(2 + m)*F'(0) - (3 + n)*G'(1)");
        assert!(found.contains(&"(2 + n)*F'(0) - (3 + m)*G'(1)".to_owned()));
        assert!(found.contains(&"(2 + m)*G'(0) - (3 + n)*F'(1)".to_owned()));
    }

    #[test]
    fn an_index_is_replaced_within_an_inner_sum_alone() {
        let found = texts("sum(k, 0, m, f[k,m]*sum(l, 0, n, f[k,n]*P[k]))");
        let inner = "sum(k, 0, m, f[k,m]*sum(l, 0, n, f[l,n]*P[l]))";
        assert!(found.contains(&inner.to_owned()), "{found:?}");
    }
}
