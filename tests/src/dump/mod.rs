//! Trees and claims as the crates read them, written so that another program can compare: `tests/judges`.

pub mod ball;
pub mod claim;

use torse_syntax::formula::{Expr, Node};

/// A tree with all its brackets: `(+ a (* 2 b))`.
///
/// ```
/// use torse_syntax::formula::parse;
/// use torse_tests::dump::tree;
/// let read = |text: &str| parse(text).map(|expr| tree(&expr));
/// assert_eq!(read("a - b - c^2 < 0.50").unwrap(), "(cmp (- (- a b) (^ c 2)) < 1/2@2)");
/// ```
#[must_use]
pub fn tree(expr: &Expr) -> String {
    let bracketed = |word: &str, parts: &[&Expr]| {
        let parts = parts.iter().map(|part| format!(" {}", tree(part)));
        format!("({word}{})", parts.collect::<String>())
    };
    match &expr.node {
        Node::Number {
            value,
            decimals: None,
        } => value.to_string(),
        Node::Number {
            value,
            decimals: Some(digits),
        } => format!("{value}@{digits}"),
        Node::Name(name) => name.clone(),
        Node::Call(..) => bracketed("call", &expr.parts()),
        Node::Index(..) => bracketed("index", &expr.parts()),
        Node::List(_) => bracketed("list", &expr.parts()),
        Node::Negative(_) => bracketed("neg", &expr.parts()),
        Node::Not(_) => bracketed("not", &expr.parts()),
        Node::Binary(operator, ..) => bracketed(operator.sign(), &expr.parts()),
        Node::Join(connective, ..) => bracketed(connective.word(), &expr.parts()),
        Node::Compare(first, rest) => {
            let rest = rest
                .iter()
                .map(|(relation, side)| format!(" {} {}", relation.sign(), tree(side)));
            format!("(cmp {}{})", tree(first), rest.collect::<String>())
        }
    }
}
