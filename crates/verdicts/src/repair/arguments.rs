//! Edits of arguments: one argument replaced by another of the same call while the others stay, one curve or end
//! replaced by another, and a square whose two factors should differ by a name.

use super::alphabet::Alphabet;
use super::edit::{Change, Edit, parts, placed, with_name};
use torse_algebra::rational::integer;
use torse_syntax::formula::{Expr, Node, Operator};

/// Returns all formulas with one such edit.
#[must_use]
pub fn edits(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let expr = &expr.placeless();
    let mut names: Vec<&str> = expr.names();
    names.extend(alphabet.names.iter().map(String::as_str));
    names.retain(|name| *name != "pi");
    names.sort_unstable();
    names.dedup();
    let mut result = vec![];
    for (path, part) in parts(expr) {
        let found = match &part.node {
            Node::Call(head, arguments) => match arguments.as_slice() {
                [_] => other_calls(head, alphabet),
                _ => other_arguments(head, arguments),
            },
            Node::Binary(Operator::Power, base, exponent) => split(base, exponent, &names),
            _ => continue,
        };
        result.extend(found.into_iter().filter(|by| by != part).map(|by| Edit {
            change: Change::replaced(part, &by),
            expr: placed(expr, &path, by),
        }));
    }
    result
}

/// Replaces one argument of the call by another of its arguments.
fn other_arguments(head: &Expr, arguments: &[Expr]) -> Vec<Expr> {
    let mut seen: Vec<&Expr> = vec![];
    for argument in arguments {
        if !seen.contains(&argument) {
            seen.push(argument);
        }
    }
    let mut found = vec![];
    for (position, own) in arguments.iter().enumerate().rev() {
        for other in seen.iter().filter(|other| **other != own) {
            let mut changed = arguments.to_vec();
            if let Some(slot) = changed.get_mut(position) {
                *slot = (*other).clone();
            }
            found.push(Expr::made(Node::Call(head.clone().into(), changed)));
        }
    }
    found
}

/// Returns `F'(1)` for `G'(0)`: other functions of one variable and other places that the claim uses, with primes kept.
fn other_calls(head: &Expr, alphabet: &Alphabet) -> Vec<Expr> {
    let Node::Name(name) = &head.node else {
        return vec![];
    };
    let base = name.trim_end_matches('\'');
    if !alphabet.functions.iter().any(|known| known == base) {
        return vec![];
    }
    let primes = name.get(base.len()..).unwrap_or("");
    let functions = alphabet.functions.iter();
    functions
        .flat_map(|function| {
            let head = Expr::name(&format!("{function}{primes}"));
            let called = alphabet.places.iter();
            called
                .map(move |place| Expr::made(Node::Call(head.clone().into(), vec![place.clone()])))
        })
        .collect()
}

/// Returns `(v - c)*(v - d)` for `(v - c)^2`.
fn split(base: &Expr, exponent: &Expr, names: &[&str]) -> Vec<Expr> {
    let square = Expr::number(&integer(2));
    if exponent.node != square.node {
        return vec![];
    }
    let mut own = base.names();
    own.sort_unstable();
    own.dedup();
    let pairs = own
        .iter()
        .flat_map(|old| names.iter().map(move |new| (old, new)));
    pairs
        .filter(|(old, new)| old != new)
        .map(|(old, new)| {
            base.clone()
                .with(Operator::Multiply, with_name(base, old, new))
        })
        .collect()
}
