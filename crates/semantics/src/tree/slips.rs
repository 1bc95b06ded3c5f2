//! Tests whether the sample points are able to show errors: deliberate slips in a statement must be noticed at the
//! points at which it holds.
//!
//! A slip adds one to the value of a leaf of the statement (a number, a symbol, a member, the value of a function),
//! or to the first entry of a vector. It is noticed at a point if it changes the value of a side of a comparison. If
//! no slip is noticed, the points say nothing about the statement, since its sides are undefined, zero, cached, or
//! constant there.

use super::environment::Environment;
use super::evaluate::Evaluator;
use crate::arithmetic::{Arithmetic, Comparison};
use crate::no_value::NoValue;
use crate::series::Series;
use crate::value::Value;
use torse_syntax::formula::{Expr, Node, Operator};

/// The number of slips that are tried, spread over the statement.
const SLIPS: usize = 6;

/// The built-in functions that are statements: they have no value, and no leaves except the value of `agrees`.
const STATEMENTS: [&str; 5] = [
    "agrees",
    "fails",
    "independent",
    "nonnegative",
    "variation_diminishing",
];

/// The leaves at which slips are tried; empty for statements without leaves, such as properties of a basis.
pub(super) fn leaves(statement: &Expr) -> Vec<&Expr> {
    let mut all = vec![];
    collect(statement, &mut all);
    let step = all.len().div_ceil(SLIPS).max(1);
    all.into_iter().step_by(step).collect()
}

fn collect<'a>(tree: &'a Expr, leaves: &mut Vec<&'a Expr>) {
    let parts = tree.parts();
    let parts: &[&'a Expr] = match &tree.node {
        Node::Number { .. } | Node::Name(_) => {
            leaves.push(tree);
            &[]
        }
        // Indices and exponents are integers, mostly with a range.
        Node::Index(..) => {
            leaves.push(tree);
            &[]
        }
        Node::Binary(Operator::Power, ..) => &parts[..1],
        Node::Call(head, arguments) => {
            let name = match &head.node {
                Node::Name(name) => name.as_str(),
                _ => "",
            };
            // Bound names and functions have no value; printed numbers and bases are not evaluated.
            match (name, arguments.len()) {
                ("sum" | "product", 4) => &parts[4..],
                ("integral", 4) => &parts[1..2],
                ("agrees" | "at" | "coefficients", 2..) => &parts[1..2],
                ("D" | "nonnegative" | "independent" | "variation_diminishing" | "fails", _) => &[],
                _ => &parts[1..],
            }
        }
        _ => &parts,
    };
    if let Node::Call(head, _) = &tree.node
        && !matches!(&head.node, Node::Name(name) if STATEMENTS.contains(&name.as_str()))
    {
        leaves.push(tree);
    }
    for part in parts {
        collect(part, leaves);
    }
}

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// Whether a slip at one of these leaves changes a side of a comparison in the statement.
    pub(super) fn sees_a_slip(&self, statement: &'a Expr, leaves: &[&'a Expr]) -> bool {
        let outermost = Environment::outermost();
        let sides = sides(statement);
        // From the end, because right sides are mostly simpler.
        leaves.iter().rev().any(|leaf| {
            let mut sides = sides.iter().rev().filter(|side| contains(side, leaf));
            sides.any(|side| {
                let right = self.value(side, &outermost);
                self.slip.set(Some(std::ptr::from_ref(*leaf).addr()));
                let wrong = self.value(side, &outermost);
                self.slip.set(None);
                match (right, wrong) {
                    (Ok(x), Ok(y)) => self.are_apart(&x, &y).unwrap_or(false),
                    _ => false,
                }
            })
        })
    }

    /// The value of a leaf with a slip: one more, or one more in its first entry.
    pub(super) fn slipped(&self, value: Value<A::Number>) -> Result<Value<A::Number>, NoValue> {
        let a = self.arithmetic;
        Ok(match value {
            Value::Number(number) => Value::Number(number.plus(&Series::integer(1, a), a)?),
            Value::Many(mut items) => {
                if !items.is_empty() {
                    let first = items.remove(0);
                    items.insert(0, self.slipped(first)?);
                }
                Value::Many(items)
            }
        })
    }

    fn are_apart(&self, x: &Value<A::Number>, y: &Value<A::Number>) -> Result<bool, NoValue> {
        for (x, y) in x.pairs(y, self.arithmetic)? {
            if let (Some(x), Some(y)) = (x.as_number(), y.as_number()) {
                let comparison = self.arithmetic.compare(x, y)?;
                let apart = [Comparison::Less, Comparison::Greater, Comparison::Apart];
                if apart.contains(&comparison) {
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }
}

fn contains(tree: &Expr, part: &Expr) -> bool {
    std::ptr::eq(tree, part) || tree.parts().into_iter().any(|inner| contains(inner, part))
}

/// The sides of all comparisons in a statement, in the order of the text.
fn sides(statement: &Expr) -> Vec<&Expr> {
    match &statement.node {
        Node::Compare(first, rest) => {
            let rest = rest.iter().map(|(_, side)| side);
            std::iter::once(&**first).chain(rest).collect()
        }
        Node::Join(_, a, b) => [sides(a), sides(b)].concat(),
        Node::Not(inner) => sides(inner),
        Node::Call(head, arguments) => match (&head.node, arguments.first()) {
            (Node::Name(name), Some(value)) if name == "agrees" => vec![value],
            _ => vec![],
        },
        _ => vec![],
    }
}
