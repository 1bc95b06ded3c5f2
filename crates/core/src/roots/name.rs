//! The name of a root: the text of the formula, where it can be written in the symbols of the claim.

use crate::{BuiltIn, Node, Term};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_syntax::formula::{self, Expr, Operator};
use torse_syntax::notation;

/// The longest name.
const MAX_NAME: usize = 160;
/// The most parts of a formula that is written.
const MAX_PARTS: usize = 200;

/// `sqrt(r)`, `norm(v)` or `abs(a)` as a text that is read as the same formula; nothing if that would be long.
pub(super) fn of_root(radicand: &Term) -> Option<String> {
    let same = |a: &Term, b: &Term| Arc::ptr_eq(&a.node, &b.node);
    let (head, argument) = match &*radicand.node {
        Node::Apply(BuiltIn::Dot, items) => match items.as_slice() {
            [a, b] if same(a, b) => ("norm", a),
            _ => ("sqrt", radicand),
        },
        Node::Binary(Operator::Multiply, a, b) if same(a, b) => ("abs", a),
        _ => ("sqrt", radicand),
    };
    let mut writer = Writer { parts: 0 };
    let argument = writer.written(argument, &BTreeMap::new())?;
    let text = notation::text(&call(head, vec![argument]));
    (text.len() <= MAX_NAME).then_some(text)
}

/// What the variables of names stand for.
type Names = BTreeMap<u32, Expr>;

struct Writer {
    parts: usize,
}

fn call(head: &str, arguments: Vec<Expr>) -> Expr {
    Expr::made(formula::Node::Call(Arc::new(Expr::name(head)), arguments))
}

impl Writer {
    fn written(&mut self, term: &Term, names: &Names) -> Option<Expr> {
        self.parts += 1;
        if self.parts > MAX_PARTS {
            return None;
        }
        let node = match &*term.node {
            Node::Number(value) => return Some(Expr::number(value)),
            Node::Pi => return Some(Expr::name("pi")),
            // The derivative of a smooth function at a place has a formula for a name.
            Node::Symbol(name) | Node::Vector(name, _) => return formula::parse(name).ok(),
            Node::Variable(variable) => return names.get(&variable.number()).cloned(),
            Node::Opened {
                name, closed: true, ..
            } if formula::is_name(name) => return Some(Expr::name(name)),
            Node::Opened { body, .. } => return self.written(body, names),
            Node::Let {
                variable,
                value,
                body,
            } => {
                let mut inside = names.clone();
                inside.insert(variable.number(), self.written(value, names)?);
                return self.written(body, &inside);
            }
            Node::Member(points, indices) => formula::Node::Index(
                Arc::new(Expr::name(&points.name)),
                self.all(indices, names)?,
            ),
            Node::Entry(of, indices) => formula::Node::Index(
                Arc::new(self.written(of, names)?),
                self.all(indices, names)?,
            ),
            Node::Negative(inner) => formula::Node::Negative(Arc::new(self.written(inner, names)?)),
            Node::Binary(operator, a, b) => formula::Node::Binary(
                *operator,
                Arc::new(self.written(a, names)?),
                Arc::new(self.written(b, names)?),
            ),
            Node::List(items) => formula::Node::List(self.all(items, names)?),
            Node::Apply(function, arguments) => {
                let arguments = self.all(arguments, names)?;
                return Some(call(head(*function), arguments));
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => {
                // By a symbol, at its value.
                let symbol = self.written(at, names)?;
                let formula::Node::Name(name) = &symbol.node else {
                    return None;
                };
                let mut outside = false;
                body.declared_names(&mut |other| outside |= **other == **name);
                if outside {
                    return None;
                }
                let mut inside = names.clone();
                inside.insert(variable.number(), symbol.clone());
                let body = self.written(body, &inside)?;
                let order = self.written(order, names)?;
                return Some(call("D", vec![body, symbol, order]));
            }
            Node::Basis { .. }
            | Node::Sum { .. }
            | Node::Product { .. }
            | Node::Integral { .. } => return None,
        };
        Some(Expr::made(node))
    }

    fn all(&mut self, items: &[Term], names: &Names) -> Option<Vec<Expr>> {
        let items = items.iter();
        items.map(|item| self.written(item, names)).collect()
    }
}

fn head(function: BuiltIn) -> &'static str {
    match function {
        BuiltIn::Binomial => "binom",
        BuiltIn::Factorial => "factorial",
        BuiltIn::SquareRoot => "sqrt",
        BuiltIn::Sine => "sin",
        BuiltIn::Cosine => "cos",
        BuiltIn::Exponential => "exp",
        BuiltIn::Dot => "dot",
        BuiltIn::Cross => "cross",
        BuiltIn::Norm => "norm",
        BuiltIn::Determinant => "det",
        BuiltIn::Transpose => "transpose",
        BuiltIn::Inverse => "inverse",
        BuiltIn::Solve => "solve",
        BuiltIn::Identity => "identity",
        BuiltIn::Coefficients => "coefficients",
    }
}
