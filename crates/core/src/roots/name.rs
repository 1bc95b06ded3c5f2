//! Names of roots and logarithms: their texts, if these can be written in the symbols of the claim.

use crate::{BuiltIn, Node, Term};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_syntax::formula::{self, Expr, Operator};
use torse_syntax::notation;

/// The largest length of a name.
const MAX_NAME: usize = 160;
/// The largest number of parts of a formula that is written.
const MAX_PARTS: usize = 200;

/// The text of `sqrt(r)`, `norm(v)` or `abs(a)`, which parses to the same formula; `None` if the text would be too
/// long.
pub(super) fn root_text(radicand: &Term) -> Option<String> {
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

/// The terms that variables abbreviate.
type Names = BTreeMap<u32, Expr>;

/// The text of `log(a)`, `atan(a)` or `asin(a)`, as for a root.
pub(super) fn applied_text(function: BuiltIn, argument: &Term) -> Option<String> {
    let argument = Writer { parts: 0 }.written(argument, &BTreeMap::new())?;
    let text = notation::text(&call(head(function), vec![argument]));
    (text.len() <= MAX_NAME).then_some(text)
}

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
            // The name of a symbol that stands for the derivative of a smooth function is itself a formula.
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
                // The derivative is by a symbol, at the value of that symbol.
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
        BuiltIn::Logarithm => "log",
        BuiltIn::ArcTangent => "atan",
        BuiltIn::ArcSine => "asin",
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
