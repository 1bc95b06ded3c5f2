//! What is written in the derivation language is read back as the same tree.

use crate::formula::{Connective, Expr, Node, Operator, Relation, parse};
use crate::notation::{rust, sympy, text};
use proptest::prelude::*;
use std::sync::Arc;
use torse_numbers::rational::{integer, ratio};

fn atom() -> impl Strategy<Value = Node> {
    let names = prop::sample::select(vec![
        "x", "mu", "mu_1", "H''", "R", "length", "p0_u", "D", "sum", "sqrt", "sin", "_y", "det",
    ]);
    prop_oneof![
        names.prop_map(|name| Node::Name(name.to_owned())),
        (0..100i64).prop_map(|n| Node::Number {
            value: integer(n),
            decimals: None
        }),
        (0..10_000i64, 1..4u32).prop_map(|(n, places)| Node::Number {
            value: ratio(n, 10i64.pow(places)).unwrap(),
            decimals: Some(places),
        }),
    ]
}

/// What can be followed by arguments: a name, a member, a function of a function.
fn head() -> impl Strategy<Value = Expr> {
    let numbers = prop::collection::vec(atom().prop_map(Expr::made), 1..3);
    (atom(), numbers, 0..3u8).prop_map(|(name, rest, kind)| {
        let name = match name {
            Node::Number { .. } => Expr::name("f"),
            name => Expr::made(name),
        };
        match kind {
            0 => name,
            1 => Expr::made(Node::Index(Arc::new(name), rest)),
            _ => Expr::made(Node::Call(Arc::new(name), rest)),
        }
    })
}

/// Whether a formula can be an exponent: fractions cannot.
fn readable_exponent(expr: &Expr) -> bool {
    match &expr.node {
        Node::Number { value, .. } => value.is_integer(),
        Node::Negative(inner) => readable_exponent(inner),
        Node::Binary(Operator::Divide, ..) => false,
        _ => true,
    }
}

fn any_expr() -> impl Strategy<Value = Expr> {
    use Connective::{And, Implies, Or};
    use Operator::{Add, Divide, Multiply, Power, Subtract};
    use Relation::{AtLeast, AtMost, Different, Equal, Greater, Less};
    let operator = prop::sample::select(vec![Add, Subtract, Multiply, Divide, Power]);
    let relation = prop::sample::select(vec![Equal, Different, Less, AtMost, Greater, AtLeast]);
    let connective = prop::sample::select(vec![And, Or, Implies]);
    atom()
        .prop_map(Expr::made)
        .prop_recursive(5, 40, 4, move |inner| {
            let some = prop::collection::vec(inner.clone(), 1..4);
            let boxed = inner.clone().prop_map(Arc::new);
            prop_oneof![
                2 => (head(), some.clone()).prop_map(|(f, x)| Node::Call(Arc::new(f), x)),
                1 => (boxed.clone(), some.clone()).prop_map(|(f, i)| Node::Index(f, i)),
                2 => boxed.clone().prop_map(Node::Negative),
                8 => (operator.clone(), boxed.clone(), boxed.clone())
                    .prop_map(|(o, a, b)| if readable_exponent(&b) {
                        Node::Binary(o, a, b)
                    } else {
                        Node::Binary(Add, a, b)
                    }),
                1 => some.prop_map(Node::List),
                1 => (boxed.clone(), prop::collection::vec((relation.clone(), inner), 1..3))
                    .prop_map(|(a, rest)| Node::Compare(a, rest)),
                1 => (connective.clone(), boxed.clone(), boxed.clone())
                    .prop_map(|(c, a, b)| Node::Join(c, a, b)),
                1 => boxed.prop_map(Node::Not),
            ]
            .prop_map(Expr::made)
        })
}

/// Whether every bracket that opens is closed by its kind.
fn balanced(text: &str) -> bool {
    let mut open = vec![];
    for c in text.replace("\"(\"", "").chars() {
        match c {
            '(' => open.push(')'),
            '[' => open.push(']'),
            '{' => open.push('}'),
            ')' | ']' | '}' if open.pop() != Some(c) => return false,
            _ => {}
        }
    }
    open.is_empty()
}

proptest! {
    #[test]
    fn what_is_written_is_read_back_as_the_same_tree(expr in any_expr()) {
        let written = text(&expr);
        let read = parse(&written);
        prop_assert_eq!(read.map(|e| e.placeless()), Ok(expr), "{}", written);
    }

    #[test]
    fn every_notation_closes_its_brackets(expr in any_expr()) {
        for written in [text(&expr), rust(&expr), sympy(&expr)] {
            prop_assert!(balanced(&written), "{}", written);
        }
    }
}

#[test]
fn no_bracket_is_written_that_is_not_needed() {
    for plain in [
        "a + b*c^d - e/f",
        "-x^2",
        "a^b^c",
        "x^(-2)",
        "2*(-x)",
        "a - (b - c)",
        "a/(b*c)",
        "not a == b and c < d <= e or p implies q implies r",
        "(p implies q) implies r",
        "D(F, x, 2)(0) == g[i,k-1](x)",
        "[[1, 0], [0, 1]]*[x, 2.50]",
    ] {
        assert_eq!(text(&parse(plain).unwrap()), plain);
    }
}

#[test]
fn a_made_number_that_is_no_decimal_is_written_as_a_quotient() {
    let made = |value, decimals| text(&Expr::made(Node::Number { value, decimals }));
    assert_eq!(made(ratio(-1, 3).unwrap(), None), "-1/3");
    assert_eq!(made(ratio(1, 3).unwrap(), Some(2)), "1/3");
    assert_eq!(made(ratio(1, 20).unwrap(), Some(3)), "0.050");
}

#[test]
fn a_sum_of_many_thousand_terms_is_written() {
    let long = (0..20_000)
        .map(|i| format!("x{i}"))
        .collect::<Vec<_>>()
        .join(" + ");
    let mut sum = Expr::name("x0");
    for i in 1..20_000 {
        sum = sum.with(Operator::Add, Expr::name(&format!("x{i}")));
    }
    assert_eq!(text(&sum), long);
    // Dropping boxes recurses; take the tree apart instead.
    while let Node::Binary(_, a, _) = sum.node {
        sum = Arc::unwrap_or_clone(a);
    }
}
