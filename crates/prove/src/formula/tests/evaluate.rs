//! A tiny evaluator, independent of the crate's own: formulas to exact fractions.

use torse_algebra::{Affine, Fraction, Polynomial, Symbol};
use torse_syntax::formula::{Expr, Node, Operator, parse};

/// The value of a formula without statements; panics on anything else, this is a test.
pub(super) fn value(expr: &Expr) -> Fraction {
    match &expr.node {
        Node::Number { value, .. } => value.clone().into(),
        Node::Name(name) if name == "pi" => Fraction::symbol(Symbol::Pi),
        Node::Name(name) => Fraction::named(name),
        Node::Index(head, indices) => {
            let [name] = head.names()[..] else {
                panic!("{head:?}")
            };
            Fraction::symbol(Symbol::indexed(name, indices.iter().map(index).collect()))
        }
        Node::Call(head, arguments) => match (head.names()[0], &arguments[..]) {
            ("sqrt", [x]) => Polynomial::square_root(&value(x).as_rational().unwrap())
                .unwrap()
                .into(),
            ("sin", [x]) => value(x).sine_cosine().unwrap().0,
            ("cos", [x]) => value(x).sine_cosine().unwrap().1,
            other => panic!("{other:?}"),
        },
        Node::Negative(inner) => -value(inner),
        Node::Binary(operator, a, b) => {
            let (left, right) = (value(a), value(b));
            match operator {
                Operator::Add => left + right,
                Operator::Subtract => left - right,
                Operator::Multiply => left * right,
                Operator::Divide => left.over(&right).unwrap(),
                Operator::Power => {
                    let n = right.as_rational().unwrap().to_integer();
                    left.power(i32::try_from(n).unwrap()).unwrap()
                }
            }
        }
        other => panic!("{other:?}"),
    }
}

/// The value of a text.
pub(super) fn evaluated(text: &str) -> Fraction {
    value(&parse(text).unwrap())
}

fn index(expr: &Expr) -> Affine {
    match &expr.node {
        Node::Number { value, .. } => Affine::number(i64::try_from(value.to_integer()).unwrap()),
        Node::Name(name) => Affine::symbol(name),
        Node::Negative(inner) => index(inner) * -1,
        Node::Binary(Operator::Add, a, b) => index(a) + index(b),
        Node::Binary(Operator::Subtract, a, b) => index(a) - index(b),
        Node::Binary(Operator::Multiply, a, b) => index(b) * index(a).as_number().unwrap(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_evaluator_knows_the_relations() {
    assert_eq!(evaluated("sin(pi/2*x)^2 + cos(pi/2*x)^2"), evaluated("1"));
    assert_eq!(evaluated("sqrt(8)*sqrt(2)"), evaluated("4"));
    assert_eq!(evaluated("R[2*k-1-k]"), evaluated("R[k-1]"));
}
