//! Rejects corrections that make the rest of the print irrelevant.
//!
//! `x^0`, `sum(i, 0, -3, f(i))`, `cross(r', r')` and `a + b - a` have one value, whatever stands in the place of x, f,
//! r' and a. Where an edit makes one of these the statement may well become true, and says nothing: it would be true of
//! any other print as well.
//!
//! An operand *matters* if the side changes its value, at some point of the domain, when the operand is doubled or negated.
//! Equal operands of one operation are changed together; a chain of sums, or of products, is one operation. A correction is
//! rejected if an operand beside the edit mattered in the print and no longer does, or if a name that a sum, a derivative or
//! a value at a place binds no longer occurs in what it is bound in.

use super::edit::placed;
use super::subject::Subject;
use num_traits::Zero as _;
use std::mem::discriminant;
use std::sync::Arc;
use torse_algebra::rational::integer;
use torse_semantics::judge_samples;
use torse_semantics::tree::Reading;
use torse_syntax::derivation::Claim;
use torse_syntax::formula::{Expr, Node, Operator, Relation};

/// The points at which two values are compared, and the work on them in operations on numbers.
const POINTS: u64 = 6;
const MAX_WORK: u64 = 60_000;

/// Parts of both formulas in one place, and where the operation begins to which they belong.
struct Pair<'e> {
    path: Vec<usize>,
    before: &'e Expr,
    after: &'e Expr,
    operation: Operation<'e>,
}

/// The outermost part of a chain, in both formulas.
#[derive(Clone)]
struct Operation<'e> {
    path: Vec<usize>,
    before: &'e Expr,
    after: &'e Expr,
}

/// Whether an operand beside the edit mattered in the printed formula and does not in the edited one.
#[must_use]
pub(super) fn one_ceases_to_matter(claim: &Claim, subject: &Subject, edited: &Expr) -> bool {
    let (printed, edited) = (subject.formula.placeless(), edited.placeless());
    if idle_operands(&edited) > idle_operands(&printed) {
        return true;
    }
    let whole = Operation {
        path: vec![],
        before: &printed,
        after: &edited,
    };
    let mut pending = vec![Pair {
        path: vec![],
        before: &printed,
        after: &edited,
        operation: whole,
    }];
    while let Some(pair) = pending.pop() {
        let Operation {
            path,
            before,
            after,
        } = &pair.operation;
        let (old, new) = (pair.before.parts(), pair.after.parts());
        let is_alike = discriminant(&pair.before.node) == discriminant(&pair.after.node);
        if !is_alike || old.len() != new.len() {
            continue;
        }
        for (place, (old, new)) in old.into_iter().zip(new).enumerate() {
            if old != new || continues(before, old) && continues(after, new) {
                pending.push(inner(&pair, place, (old, new)));
            } else if place >= first_operand(pair.before)
                && matters((claim, subject), (&edited, path, after), new) == Some(false)
                && matters((claim, subject), (&printed, path, before), old) == Some(true)
            {
                return true;
            }
        }
    }
    false
}

/// Counts the calls in which a bound name does not occur in what it is bound in, the ranges of numbers that are empty,
/// and zeros as exponents, terms and factors.
fn idle_operands(expr: &Expr) -> usize {
    let own = match &expr.node {
        Node::Call(head, arguments) => match (&head.node, arguments.as_slice()) {
            (Node::Name(name), [bound, first, last, body])
                if name == "sum" || name == "product" =>
            {
                is_idle(bound, body) || is_empty(first, last)
            }
            (Node::Name(name), [body, bound, ..]) if name == "D" || name == "at" => {
                is_idle(bound, body)
            }
            _ => false,
        },
        Node::Binary(Operator::Power, _, exponent) => is_zero(exponent),
        Node::Binary(Operator::Add | Operator::Subtract | Operator::Multiply, a, b) => {
            is_zero(a) || is_zero(b)
        }
        _ => false,
    };
    let parts = expr.parts().into_iter();
    usize::from(own) + parts.map(idle_operands).sum::<usize>()
}

/// Whether a formula is the number zero.
fn is_zero(expr: &Expr) -> bool {
    matches!(&expr.node, Node::Number { value, .. } if value.is_zero())
}

/// Whether both ends of a range are numbers, and the first is larger than the last.
fn is_empty(first: &Expr, last: &Expr) -> bool {
    match (&first.node, &last.node) {
        (Node::Number { value: first, .. }, Node::Number { value: last, .. }) => first > last,
        _ => false,
    }
}

/// Whether a bound name does not occur in a body.
fn is_idle(bound: &Expr, body: &Expr) -> bool {
    matches!(&bound.node, Node::Name(bound) if !occurs(bound, body))
}

/// Whether a name occurs in a formula where no sum, product, integral or value at a place binds it anew.
fn occurs(name: &str, expr: &Expr) -> bool {
    if let Node::Name(own) = &expr.node {
        return own == name;
    }
    let body = match &expr.node {
        Node::Call(head, arguments) => binding(head, arguments.len()).filter(|(bound, _)| {
            let bound = arguments.get(*bound).map(|own| &own.node);
            matches!(bound, Some(Node::Name(own)) if own == name)
        }),
        _ => None,
    };
    let parts = expr.parts().into_iter().enumerate();
    // The head is the first part of a call.
    let is_bound =
        |place: usize| body.is_some_and(|(bound, body)| place == bound + 1 || place == body + 1);
    parts
        .filter(|(place, _)| !is_bound(*place))
        .any(|(_, part)| occurs(name, part))
}

/// The places of the bound name and of the body among the arguments of a call.
fn binding(head: &Expr, arguments: usize) -> Option<(usize, usize)> {
    match (&head.node, arguments) {
        (Node::Name(name), 4) if name == "sum" || name == "product" => Some((0, 3)),
        (Node::Name(name), 3) if name == "at" => Some((1, 0)),
        (Node::Name(name), 4) if name == "integral" => Some((1, 0)),
        _ => None,
    }
}

/// The parts in one place of a pair of parts.
fn inner<'e>(outer: &Pair<'e>, place: usize, (before, after): (&'e Expr, &'e Expr)) -> Pair<'e> {
    let path = [outer.path.as_slice(), &[place]].concat();
    let operation = match continues(outer.operation.before, before)
        && continues(outer.operation.after, after)
    {
        true => outer.operation.clone(),
        false => Operation {
            path: path.clone(),
            before,
            after,
        },
    };
    Pair {
        path,
        before,
        after,
        operation,
    }
}

/// What chains of operations make.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Chain {
    Sum,
    Product,
}

/// The chain that an operation belongs to.
fn chain(expr: &Expr) -> Option<Chain> {
    match &expr.node {
        Node::Binary(Operator::Add | Operator::Subtract, ..) => Some(Chain::Sum),
        Node::Binary(Operator::Multiply | Operator::Divide, ..) => Some(Chain::Product),
        _ => None,
    }
}

/// Whether a part of a chain belongs to it: a sign may, in either.
fn continues(operation: &Expr, part: &Expr) -> bool {
    let is_sign = matches!(&part.node, Node::Negative(_));
    chain(operation).is_some_and(|own| is_sign || chain(part) == Some(own))
}

/// The place of the first operand: the heads of calls and members are none.
fn first_operand(expr: &Expr) -> usize {
    usize::from(matches!(&expr.node, Node::Call(..) | Node::Index(..)))
}

/// Whether an operand of the operation at this path matters; `None` where that is not seen at the points that are looked at.
fn matters(
    (claim, subject): (&Claim, &Subject),
    (formula, path, operation): (&Expr, &[usize], &Expr),
    operand: &Expr,
) -> Option<bool> {
    let two = Expr::number(&integer(2));
    let changed = [
        two.with(Operator::Multiply, operand.clone()),
        Expr::made(Node::Negative(Arc::new(operand.clone()))),
    ];
    let mut same = Some(false);
    for other in changed {
        let operation = with_operand(operation, operation, operand, &other);
        let sides = [formula, &placed(formula, path, operation)].map(|side| subject.side(side));
        match differ(claim, sides) {
            Some(true) => return Some(true),
            Some(false) => {}
            None => same = None,
        }
    }
    same
}

/// A part of an operation with another operand in all places of this one.
fn with_operand(operation: &Expr, part: &Expr, operand: &Expr, other: &Expr) -> Expr {
    let places = part.parts().into_iter().enumerate();
    let places = places.skip(first_operand(part));
    places.fold(part.clone(), |changed, (place, own)| {
        let own = if own == operand {
            other.clone()
        } else if continues(operation, own) {
            with_operand(operation, own, operand, other)
        } else {
            return changed;
        };
        changed.with_part(place, own).unwrap_or(changed)
    })
}

/// Whether two formulas have different values at a point of the domain; `None` where no point shows it, and none that
/// they are equal.
fn differ(claim: &Claim, [left, right]: [Expr; 2]) -> Option<bool> {
    let equal = Expr::made(Node::Compare(
        Arc::new(left),
        vec![(Relation::Equal, right)],
    ));
    let reading = Reading::new(claim, &equal, []);
    let found = judge_samples(&reading, &[], "operands", POINTS, MAX_WORK);
    match found.failing {
        Some(_) => Some(true),
        None => (found.holding > 0).then_some(false),
    }
}
