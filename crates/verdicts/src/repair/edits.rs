//! Single edits of a formula: the slips of authors, typesetters and copyists.
//!
//! A sign, a coefficient, an exponent, an index shifted by one, one name for another, a missing or extra
//! factor or term, a prime more or less, a bracket moved.

use super::alphabet::Alphabet;
use super::edit::{Change, Edit, text};
use super::global_edits;
use std::sync::Arc;
use torse_algebra::Rational;
use torse_algebra::rational::{integer, ratio};
use torse_syntax::formula::{Expr, Node, Operator};

/// Returns all formulas one edit away.
#[must_use]
pub fn single(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let mut result = global_edits::edits(expr, alphabet);
    result.extend(local(expr, alphabet));
    result.extend(scaled(expr, alphabet));
    inside(expr, alphabet, &mut result);
    result
}

/// Returns edits of the parts, lifted to the whole.
fn inside(expr: &Expr, alphabet: &Alphabet, into: &mut Vec<Edit>) {
    let additive = matches!(
        &expr.node,
        Node::Binary(Operator::Add | Operator::Subtract, ..)
    );
    for (position, part) in expr.parts().into_iter().enumerate() {
        // The head of a call or an index is a function or family: only its name may change.
        let head = position == 0 && matches!(&expr.node, Node::Call(..) | Node::Index(..));
        let mut edits = if head { vec![] } else { local(part, alphabet) };
        if head {
            edits.extend(primes(part));
            if matches!(expr.node, Node::Index(..)) {
                edits.extend(families(part, alphabet));
            }
        }
        if additive
            || matches!(
                &part.node,
                Node::Binary(Operator::Add | Operator::Subtract, ..)
            )
        {
            edits.extend(scaled(part, alphabet));
        }
        if !head {
            inside(part, alphabet, &mut edits);
        }
        for edit in edits {
            if let Some(whole) = expr.with_part(position, edit.expr) {
                into.push(Edit {
                    expr: whole,
                    change: edit.change,
                });
            }
        }
    }
}

/// Returns edits at the top of a formula.
pub(super) fn local(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let replaced = |by: Expr| {
        let change = Change::replaced(expr, &by);
        Edit { expr: by, change }
    };
    let mut result = vec![];
    match &expr.node {
        Node::Number {
            value,
            decimals: None,
        } => {
            let near = numbers(value);
            result.extend(near.iter().map(|n| replaced(Expr::number(n))));
            if num_traits::Zero::is_zero(value) {
                result.extend(alphabet.members.iter().cloned().map(replaced));
            }
        }
        Node::Number { .. } => {}
        Node::Name(name) => {
            result.extend(
                alphabet
                    .names
                    .iter()
                    .filter(|other| *other != name)
                    .map(|other| replaced(Expr::name(other))),
            );
            result.extend(primes(expr));
            result.push(replaced(
                expr.clone()
                    .with(Operator::Power, Expr::number(&integer(2))),
            ));
        }
        Node::Negative(inner) => {
            result.push(Edit {
                expr: (**inner).clone(),
                change: Change::new("the sign of _ changed", [inner]),
            });
        }
        Node::Binary(operator, a, b) => binary(expr, *operator, a, b, &mut result),
        Node::Index(head, indices) => {
            if let [first, second] = indices.as_slice()
                && first.node != second.node
            {
                let exchanged = vec![second.clone(), first.clone()];
                result.push(replaced(Expr::made(Node::Index(head.clone(), exchanged))));
            }
            for (position, index) in indices.iter().enumerate() {
                for (operator, sentence) in [
                    (Operator::Add, "the index of _ shifted up by one"),
                    (Operator::Subtract, "the index of _ shifted down by one"),
                ] {
                    let mut moved = indices.clone();
                    if let Some(slot) = moved.get_mut(position) {
                        *slot = index.clone().with(operator, Expr::number(&integer(1)));
                        let by = Expr::made(Node::Index(head.clone(), moved));
                        result.push(Edit {
                            expr: by,
                            change: Change::new(sentence, [expr]),
                        });
                    }
                }
            }
        }
        Node::Call(head, arguments) => {
            for (position, pair) in arguments.windows(2).enumerate() {
                let [a, b] = pair else { continue };
                if !matches!((&a.node, &b.node), (Node::Name(_), Node::Name(_))) || a.node == b.node
                {
                    continue;
                }
                let mut swapped = arguments.clone();
                swapped.swap(position, position + 1);
                let by = Expr::made(Node::Call(head.clone(), swapped));
                let change = Change::new("_ and _ exchanged in _", [a, b, expr]);
                result.push(Edit { expr: by, change });
            }
            result.extend(argument_pairs(head, arguments, alphabet).map(replaced));
            // min <-> max.
            if let (Node::Name(name), [_, _]) = (&head.node, arguments.as_slice()) {
                let other = match name.as_str() {
                    "min" => Some("max"),
                    "max" => Some("min"),
                    _ => None,
                };
                result.extend(other.map(|other| {
                    let other = Arc::new(Expr::name(other));
                    replaced(Expr::made(Node::Call(other, arguments.clone())))
                }));
            }
            // sin <-> cos, sinh <-> cosh, and a function replaced by its variable.
            if let (Node::Name(name), [argument]) = (&head.node, arguments.as_slice()) {
                let other = match name.as_str() {
                    "sin" => Some("cos"),
                    "cos" => Some("sin"),
                    "sinh" => Some("cosh"),
                    "cosh" => Some("sinh"),
                    _ => None,
                };
                if let Some(other) = other {
                    let call = Node::Call(Arc::new(Expr::name(other)), vec![argument.clone()]);
                    result.push(replaced(Expr::made(call)));
                    for variable in argument.names().into_iter().filter(|n| *n != "pi") {
                        result.push(replaced(Expr::name(variable)));
                    }
                }
            }
        }
        _ => {}
    }
    result
}

/// Replaces two neighbouring names among the arguments of a call by those of another call: the shape parameters of
/// another curve.
fn argument_pairs<'e>(
    head: &'e Arc<Expr>,
    arguments: &'e [Expr],
    alphabet: &'e Alphabet,
) -> impl Iterator<Item = Expr> + 'e {
    let windows = arguments.windows(2).enumerate();
    windows.flat_map(move |(position, own)| {
        let named = |e: &Expr| matches!(e.node, Node::Name(_));
        let here = own.iter().all(named);
        let others = alphabet.pairs.iter().filter(move |_| here);
        // A pair is replaced by one of the same letters: mu1, nu1 for mu, nu.
        let kin = others.filter(move |pair| {
            let letters = |name: &str| {
                name.trim_end_matches(|c: char| c.is_ascii_digit())
                    .to_owned()
            };
            own.iter()
                .zip(*pair)
                .all(|(e, other)| letters(&text(e)) == letters(other))
                && own.iter().zip(*pair).all(|(e, other)| text(e) != **other)
        });
        kin.map(move |pair| {
            let mut changed = arguments.to_vec();
            for (slot, name) in changed.iter_mut().skip(position).zip(pair) {
                *slot = Expr::name(name);
            }
            Expr::made(Node::Call(head.clone(), changed))
        })
    })
}

fn binary(expr: &Expr, operator: Operator, a: &Expr, b: &Expr, result: &mut Vec<Edit>) {
    let mut push = |expr: Expr, change: Change| result.push(Edit { expr, change });
    match operator {
        Operator::Add | Operator::Subtract => {
            let flipped = if operator == Operator::Add {
                Operator::Subtract
            } else {
                Operator::Add
            };
            push(
                a.clone().with(flipped, b.clone()),
                Change::new("the sign of _ changed", [b]),
            );
            push(a.clone(), Change::new("the term _ removed", [b]));
            let rest = if operator == Operator::Add {
                b.clone()
            } else {
                Expr::made(Node::Negative(Arc::new(b.clone())))
            };
            push(rest, Change::new("the term _ removed", [a]));
            // a*b + c -> a*(b + c)
            if let Node::Binary(Operator::Multiply, x, y) = &a.node {
                let inner = (**y).clone().with(operator, b.clone());
                push(
                    (**x).clone().with(Operator::Multiply, inner),
                    Change::new("the bracket moved to include _", [b]),
                );
            }
        }
        Operator::Multiply => {
            push(a.clone(), Change::new("the factor _ removed", [b]));
            push(b.clone(), Change::new("the factor _ removed", [a]));
            // (a + b)*c -> a + b*c, a*(b + c) -> a*b + c
            if let Node::Binary(plus @ (Operator::Add | Operator::Subtract), x, y) = &a.node {
                let last = (**y).clone().with(Operator::Multiply, b.clone());
                push(
                    (**x).clone().with(*plus, last),
                    Change::new("the bracket around _ removed", [a]),
                );
            }
            if let Node::Binary(plus @ (Operator::Add | Operator::Subtract), x, y) = &b.node {
                let first = a.clone().with(Operator::Multiply, (**x).clone());
                push(
                    first.with(*plus, (**y).clone()),
                    Change::new("the bracket around _ removed", [b]),
                );
            }
        }
        Operator::Divide => {
            push(a.clone(), Change::new("the divisor _ removed", [b]));
            push(
                a.clone().with(Operator::Multiply, b.clone()),
                Change::new("_ moved from the denominator to the numerator", [b]),
            );
            push(
                b.clone().with(Operator::Divide, a.clone()),
                Change::new("the quotient _ turned over", [expr]),
            );
        }
        Operator::Power => {
            push(a.clone(), Change::new("the exponent of _ removed", [expr]));
            // m^2 for m*(m - 1), the slip of counting pairs.
            if let (Node::Name(_), Node::Number { value, .. }) = (&a.node, &b.node)
                && *value == integer(2)
            {
                let less = a
                    .clone()
                    .with(Operator::Subtract, Expr::number(&integer(1)));
                let pairs = a.clone().with(Operator::Multiply, less);
                let change = Change::replaced(expr, &pairs);
                push(pairs, change);
            }
        }
    }
}

/// Inserts a factor before a formula, or changes its sign.
pub(super) fn scaled(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let mut factors: Vec<Expr> = [
        (2, 1),
        (3, 1),
        (4, 1),
        (1, 2),
        (1, 3),
        (1, 4),
        (6, 1),
        (8, 1),
    ]
    .into_iter()
    .filter_map(|(n, d)| ratio(n, d))
    .map(|q| Expr::number(&q))
    .collect();
    factors.extend(alphabet.names.iter().map(|name| Expr::name(name)));
    factors.push(Expr::name("pi"));
    let mut edits: Vec<Edit> = factors
        .into_iter()
        .map(|factor| {
            let change = Change::new("the factor _ inserted before _", [&factor, expr]);
            Edit {
                expr: factor.with(Operator::Multiply, expr.clone()),
                change,
            }
        })
        .collect();
    if !matches!(expr.node, Node::Negative(_)) {
        let change = Change::new("the sign of _ changed", [expr]);
        edits.push(Edit {
            expr: Expr::made(Node::Negative(Arc::new(expr.clone()))),
            change,
        });
    }
    edits
}

/// Returns numbers that are easily mistaken for this one.
fn numbers(value: &Rational) -> Vec<Rational> {
    let mut near = vec![
        value + integer(1),
        value - integer(1),
        value * integer(2),
        value / integer(2),
        value * integer(3),
        value * integer(4),
        value + integer(2),
        value - integer(2),
        -value.clone(),
        value / integer(4),
        value * integer(10),
        value / integer(10),
    ];
    near.retain(|n| n != value);
    near.dedup();
    near
}

/// Replaces one family by another.
fn families(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let Node::Name(name) = &expr.node else {
        return vec![];
    };
    if !alphabet.families.contains(name) {
        return vec![];
    }
    let others = alphabet.families.iter().filter(|other| *other != name);
    others.map(|other| named(expr, other)).collect()
}

/// Adds or removes a prime.
fn primes(expr: &Expr) -> Vec<Edit> {
    let Node::Name(name) = &expr.node else {
        return vec![];
    };
    let more = format!("{name}'");
    let less = name.strip_suffix('\'').map(str::to_owned);
    std::iter::once(more)
        .chain(less)
        .map(|other| named(expr, &other))
        .collect()
}

/// Replaces a name by another.
fn named(expr: &Expr, name: &str) -> Edit {
    let by = Expr::name(name);
    Edit {
        change: Change::replaced(expr, &by),
        expr: by,
    }
}
