//! Single edits of a formula: the slips of authors, typesetters and copyists.
//!
//! A sign, a coefficient, an exponent, an index shifted by one, one name for another, a missing or extra
//! factor or term, a prime more or less, a bracket moved.

use crate::syntax::{Expr, Node, Operator};
use std::sync::Arc;
use torse_algebra::Rational;
use torse_algebra::rational::{integer, ratio};

/// A changed formula and what was changed, in words.
#[derive(Debug, Clone)]
pub struct Edit {
    /// The formula after the edit.
    pub expr: Expr,
    /// The change in words.
    pub change: String,
}

/// The names that an edit may put in.
#[derive(Debug, Clone, Default)]
pub struct Alphabet {
    /// Numbers and vectors that occur in the claim.
    pub names: Vec<String>,
    /// Families of points or scalars that occur in the claim.
    pub families: Vec<String>,
}

/// All formulas one edit away.
#[must_use]
pub fn single(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let mut result = renamed(expr);
    result.extend(functions_dropped(expr));
    result.extend(local(expr, alphabet));
    result.extend(scaled(expr, alphabet));
    inside(expr, alphabet, &mut result);
    result
}

/// One name taken for another throughout a bracket, primes kept: the slip of copying a bracket.
fn renamed(expr: &Expr) -> Vec<Edit> {
    let mut result = vec![];
    let bases = |expr: &Expr| {
        let names: Vec<String> = expr
            .names()
            .into_iter()
            .map(|n| n.trim_end_matches('\'').to_owned())
            .collect();
        names
    };
    let mut all = bases(expr);
    all.sort();
    all.dedup();
    let mut pending: Vec<(Vec<usize>, &Expr)> = vec![(vec![], expr)];
    while let Some((path, part)) = pending.pop() {
        let own = bases(part);
        let sum = matches!(
            &part.node,
            Node::Binary(Operator::Add | Operator::Subtract, ..)
        );
        if sum && part.size() <= MAX_RENAMED {
            let mut repeated: Vec<&String> = own
                .iter()
                .filter(|n| own.iter().filter(|o| o == n).count() > 1)
                .collect();
            repeated.sort();
            repeated.dedup();
            for old in repeated {
                for new in all.iter().filter(|n| *n != old) {
                    let changed = with_name(part, old, new);
                    let change = format!("`{old}` replaced by `{new}` in `{}`", text(part));
                    result.push(Edit {
                        expr: placed(expr, &path, changed),
                        change,
                    });
                }
            }
        }
        for (position, inner) in part.parts().into_iter().enumerate() {
            let mut deeper = path.clone();
            deeper.push(position);
            pending.push((deeper, inner));
        }
    }
    result
}

/// A sine or cosine that occurs more than once taken for its variable, throughout.
fn functions_dropped(expr: &Expr) -> Vec<Edit> {
    let mut calls: Vec<&Expr> = vec![];
    let mut pending = vec![expr];
    while let Some(part) = pending.pop() {
        if let Node::Call(head, _) = &part.node
            && matches!(&head.node, Node::Name(name) if name == "sin" || name == "cos")
        {
            calls.push(part);
        }
        pending.extend(part.parts());
    }
    let mut result = vec![];
    let mut seen: Vec<String> = vec![];
    for call in &calls {
        let old = text(call);
        let repeated = calls.iter().filter(|other| text(other) == old).count() > 1;
        if !repeated || seen.contains(&old) {
            continue;
        }
        for variable in call
            .names()
            .into_iter()
            .filter(|n| !["sin", "cos", "pi"].contains(n))
        {
            let change = format!("`{old}` replaced by `{variable}` throughout");
            result.push(Edit {
                expr: with_part(expr, &old, &Expr::name(variable)),
                change,
            });
        }
        seen.push(old);
    }
    result
}

fn with_part(expr: &Expr, old: &str, new: &Expr) -> Expr {
    if matches!(expr.node, Node::Call(..)) && text(expr) == old {
        return new.clone();
    }
    let mut result = expr.clone();
    for part in result.parts_mut() {
        *part = with_part(part, old, new);
    }
    result
}

/// The largest bracket in which names are replaced throughout.
const MAX_RENAMED: usize = 15;

fn with_name(expr: &Expr, old: &str, new: &str) -> Expr {
    let mut result = expr.clone();
    if let Node::Name(name) = &mut result.node {
        let base = name.trim_end_matches('\'');
        if base == old {
            *name = format!("{new}{}", name.get(base.len()..).unwrap_or(""));
        }
    }
    for part in result.parts_mut() {
        *part = with_name(part, old, new);
    }
    result
}

/// The formula with the part at `path` replaced.
pub(super) fn placed(expr: &Expr, path: &[usize], by: Expr) -> Expr {
    let Some((first, rest)) = path.split_first() else {
        return by;
    };
    let mut result = expr.clone();
    if let Some(part) = result.parts_mut().into_iter().nth(*first) {
        *part = placed(part, rest, by);
    }
    result
}

/// Edits of the parts, lifted to the whole.
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
            let mut whole = expr.clone();
            if let Some(slot) = whole.parts_mut().into_iter().nth(position) {
                *slot = edit.expr;
                into.push(Edit {
                    expr: whole,
                    change: edit.change,
                });
            }
        }
    }
}

fn text(expr: &Expr) -> String {
    crate::notation::text(expr)
}

/// Edits at the top of a formula.
fn local(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let replaced = |by: Expr| {
        let change = format!("`{}` replaced by `{}`", text(expr), text(&by));
        Edit { expr: by, change }
    };
    let mut result = vec![];
    match &expr.node {
        Node::Number {
            value,
            decimals: None,
        } => result.extend(
            numbers(value)
                .into_iter()
                .map(|n| replaced(Expr::number(&n))),
        ),
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
                change: format!("the sign of `{}` changed", text(inner)),
            });
        }
        Node::Binary(operator, a, b) => binary(expr, *operator, a, b, &mut result),
        Node::Index(head, indices) => {
            for (position, index) in indices.iter().enumerate() {
                for (operator, word) in [(Operator::Add, "up"), (Operator::Subtract, "down")] {
                    let mut moved = indices.clone();
                    if let Some(slot) = moved.get_mut(position) {
                        *slot = index.clone().with(operator, Expr::number(&integer(1)));
                        let by = Expr::made(Node::Index(head.clone(), moved));
                        result.push(Edit {
                            expr: by,
                            change: format!("the index of `{}` shifted {word} by one", text(expr)),
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
                let change = format!(
                    "`{}` and `{}` exchanged in `{}`",
                    text(a),
                    text(b),
                    text(expr)
                );
                result.push(Edit { expr: by, change });
            }
            // sin <-> cos, and a function in place of its variable.
            if let (Node::Name(name), [argument]) = (&head.node, arguments.as_slice()) {
                let other = match name.as_str() {
                    "sin" => Some("cos"),
                    "cos" => Some("sin"),
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

fn binary(expr: &Expr, operator: Operator, a: &Expr, b: &Expr, result: &mut Vec<Edit>) {
    let mut push = |expr: Expr, change: String| result.push(Edit { expr, change });
    match operator {
        Operator::Add | Operator::Subtract => {
            let flipped = if operator == Operator::Add {
                Operator::Subtract
            } else {
                Operator::Add
            };
            push(
                a.clone().with(flipped, b.clone()),
                format!("the sign of `{}` changed", text(b)),
            );
            push(a.clone(), format!("the term `{}` removed", text(b)));
            let rest = if operator == Operator::Add {
                b.clone()
            } else {
                Expr::made(Node::Negative(Arc::new(b.clone())))
            };
            push(rest, format!("the term `{}` removed", text(a)));
            // a*b + c -> a*(b + c)
            if let Node::Binary(Operator::Multiply, x, y) = &a.node {
                let inner = (**y).clone().with(operator, b.clone());
                push(
                    (**x).clone().with(Operator::Multiply, inner),
                    format!("the bracket moved to include `{}`", text(b)),
                );
            }
        }
        Operator::Multiply => {
            push(a.clone(), format!("the factor `{}` removed", text(b)));
            push(b.clone(), format!("the factor `{}` removed", text(a)));
            // (a + b)*c -> a + b*c, a*(b + c) -> a*b + c
            if let Node::Binary(plus @ (Operator::Add | Operator::Subtract), x, y) = &a.node {
                let last = (**y).clone().with(Operator::Multiply, b.clone());
                push(
                    (**x).clone().with(*plus, last),
                    format!("the bracket around `{}` removed", text(a)),
                );
            }
            if let Node::Binary(plus @ (Operator::Add | Operator::Subtract), x, y) = &b.node {
                let first = a.clone().with(Operator::Multiply, (**x).clone());
                push(
                    first.with(*plus, (**y).clone()),
                    format!("the bracket around `{}` removed", text(b)),
                );
            }
        }
        Operator::Divide => {
            push(a.clone(), format!("the divisor `{}` removed", text(b)));
            push(
                a.clone().with(Operator::Multiply, b.clone()),
                format!("`{}` moved from the denominator to the numerator", text(b)),
            );
        }
        Operator::Power => {
            push(
                a.clone(),
                format!("the exponent of `{}` removed", text(expr)),
            );
        }
    }
}

/// A factor in front of a formula, or its sign changed.
fn scaled(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
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
            let change = format!(
                "the factor `{}` inserted before `{}`",
                text(&factor),
                text(expr)
            );
            Edit {
                expr: factor.with(Operator::Multiply, expr.clone()),
                change,
            }
        })
        .collect();
    if !matches!(expr.node, Node::Negative(_)) {
        let change = format!("the sign of `{}` changed", text(expr));
        edits.push(Edit {
            expr: Expr::made(Node::Negative(Arc::new(expr.clone()))),
            change,
        });
    }
    edits
}

/// Numbers that are easily mistaken for this one.
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

/// One family taken for another.
fn families(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let Node::Name(name) = &expr.node else {
        return vec![];
    };
    if !alphabet.families.contains(name) {
        return vec![];
    }
    let others = alphabet.families.iter().filter(|other| *other != name);
    others
        .map(|other| Edit {
            change: format!("`{name}` replaced by `{other}`"),
            expr: Expr::name(other),
        })
        .collect()
}

/// A prime more or less.
fn primes(expr: &Expr) -> Vec<Edit> {
    let Node::Name(name) = &expr.node else {
        return vec![];
    };
    let more = format!("{name}'");
    let less = name.strip_suffix('\'').map(str::to_owned);
    std::iter::once(more)
        .chain(less)
        .map(|other| Edit {
            change: format!("`{name}` replaced by `{other}`"),
            expr: Expr::name(&other),
        })
        .collect()
}
