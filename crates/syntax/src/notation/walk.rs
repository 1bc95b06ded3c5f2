//! The traversal of syntax trees that all notations share.
//!
//! A notation defines how each construct looks; the traversal decides which operands need brackets. It compares
//! levels: every written piece has the level of its loosest operator, and every operand position requires a level.

use crate::formula::{Connective, Expr, Node, Operator, Relation};
use torse_numbers::{Integer, Rational};

/// The largest number of decimals that are written out; it bounds the work (no file has so many).
const MAX_DECIMALS: u32 = 10_000;

/// How tightly a piece of text binds, loosest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    Implies,
    Or,
    And,
    Not,
    Relation,
    Sum,
    Product,
    /// Begins with a minus sign.
    Negative,
    /// Can be a factor without brackets, but not the base of a power.
    Power,
    Atom,
}

/// A written text with its level.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub text: String,
    pub level: Level,
}

impl Piece {
    pub fn new(level: Level, text: String) -> Self {
        Self { text, level }
    }

    pub fn atom(text: impl Into<String>) -> Self {
        Self::new(Level::Atom, text.into())
    }
}

/// A notation for formulas. The provided methods write the derivation language; other notations override those that
/// differ.
pub(super) trait Notation {
    /// A number from its digits, with at most one decimal point.
    fn number(&self, digits: &str) -> Piece {
        Piece::atom(digits)
    }

    /// A name with its primes.
    fn name(&self, name: &str) -> Piece {
        Piece::atom(name)
    }

    /// `f(x, y)`.
    fn call(&self, head: &Expr, arguments: &[Expr]) -> Piece {
        let head = self.operand(head, Level::Atom);
        Piece::atom(format!("{head}({})", self.listed(arguments)))
    }

    /// `R[i]`.
    fn index(&self, head: &Expr, indices: &[Expr]) -> Piece {
        let head = self.operand(head, Level::Atom);
        Piece::atom(format!("{head}[{}]", self.listed(indices)))
    }

    /// `-x`.
    fn negative(&self, inner: &Expr) -> Piece {
        Piece::new(
            Level::Negative,
            format!("-{}", self.operand(inner, Level::Power)),
        )
    }

    /// A sum `a + b - c`, given its first operand and the signed others.
    fn sum(&self, first: &Expr, rest: &[(Operator, &Expr)]) -> Piece {
        let mut text = self.operand(first, Level::Sum);
        for (operator, term) in rest {
            let piece = self.write(term);
            let loose = piece.level < Level::Product || piece.text.starts_with('-');
            let term = if loose {
                self.bracketed(&piece.text)
            } else {
                piece.text
            };
            text.extend([" ", operator.sign(), " ", &term]);
        }
        Piece::new(Level::Sum, text)
    }

    /// `a*b`.
    fn product(&self, a: &Expr, b: &Expr) -> Piece {
        let (a, b) = (
            self.operand(a, Level::Product),
            self.operand(b, Level::Power),
        );
        Piece::new(Level::Product, format!("{a}*{b}"))
    }

    /// `a/b`.
    fn quotient(&self, a: &Expr, b: &Expr) -> Piece {
        let (a, b) = (
            self.operand(a, Level::Product),
            self.operand(b, Level::Power),
        );
        Piece::new(Level::Product, format!("{a}/{b}"))
    }

    /// `a^b`.
    fn power(&self, base: &Expr, exponent: &Expr) -> Piece {
        let (base, exponent) = (
            self.operand(base, Level::Atom),
            self.operand(exponent, Level::Power),
        );
        Piece::new(Level::Power, format!("{base}^{exponent}"))
    }

    /// `[a, b, c]`.
    fn list(&self, items: &[Expr]) -> Piece {
        Piece::atom(format!("[{}]", self.listed(items)))
    }

    /// The sign of a relation.
    fn relation(&self, relation: Relation) -> &'static str {
        relation.sign()
    }

    /// The sign of a connective.
    fn connective(&self, connective: Connective) -> &'static str {
        connective.word()
    }

    /// `a < b <= c`.
    fn compare(&self, first: &Expr, rest: &[(Relation, Expr)]) -> Piece {
        let mut text = self.operand(first, Level::Sum);
        for (relation, side) in rest {
            text.extend([
                " ",
                self.relation(*relation),
                " ",
                &self.operand(side, Level::Sum),
            ]);
        }
        Piece::new(Level::Relation, text)
    }

    /// `p and q`.
    fn join(&self, connective: Connective, a: &Expr, b: &Expr) -> Piece {
        // `and` and `or` group to the left, `implies` to the right.
        let (level, left, right) = match connective {
            Connective::And => (Level::And, Level::And, Level::Not),
            Connective::Or => (Level::Or, Level::Or, Level::And),
            Connective::Implies => (Level::Implies, Level::Or, Level::Implies),
        };
        let (a, b) = (self.operand(a, left), self.operand(b, right));
        Piece::new(level, format!("{a} {} {b}", self.connective(connective)))
    }

    /// `not p`.
    fn not(&self, inner: &Expr) -> Piece {
        Piece::new(
            Level::Not,
            format!("not {}", self.operand(inner, Level::Not)),
        )
    }

    /// Puts a text in brackets.
    fn bracketed(&self, inner: &str) -> String {
        format!("({inner})")
    }

    /// Writes any formula.
    fn write(&self, expr: &Expr) -> Piece {
        match &expr.node {
            Node::Number { value, decimals } => match digits(value, *decimals) {
                Some(digits) => self.number(&digits),
                None => self.write(&Expr::number(value)),
            },
            Node::Name(name) => self.name(name),
            Node::Call(head, arguments) => self.call(head, arguments),
            Node::Index(head, indices) => self.index(head, indices),
            Node::Negative(inner) => self.negative(inner),
            Node::Binary(Operator::Add | Operator::Subtract, ..) => {
                let (first, rest) = summands(expr);
                self.sum(first, &rest)
            }
            Node::Binary(Operator::Multiply, a, b) => self.product(a, b),
            Node::Binary(Operator::Divide, a, b) => self.quotient(a, b),
            Node::Binary(Operator::Power, a, b) => self.power(a, b),
            Node::List(items) => self.list(items),
            Node::Compare(first, rest) => self.compare(first, rest),
            Node::Join(connective, a, b) => self.join(*connective, a, b),
            Node::Not(inner) => self.not(inner),
        }
    }

    /// Writes an operand for a position that requires `level`, in brackets if it binds more loosely.
    fn operand(&self, expr: &Expr, level: Level) -> String {
        let piece = self.write(expr);
        if piece.level < level {
            self.bracketed(&piece.text)
        } else {
            piece.text
        }
    }

    /// Formulas separated by commas.
    fn listed(&self, items: &[Expr]) -> String {
        let items: Vec<String> = items.iter().map(|item| self.write(item).text).collect();
        items.join(", ")
    }
}

/// The operands of a sum that groups to the left. Computed by a loop, because normal forms have thousands of terms.
fn summands(expr: &Expr) -> (&Expr, Vec<(Operator, &Expr)>) {
    let (mut first, mut rest) = (expr, vec![]);
    while let Node::Binary(operator @ (Operator::Add | Operator::Subtract), a, b) = &first.node {
        rest.push((*operator, &**b));
        first = a;
    }
    rest.reverse();
    (first, rest)
}

/// The digits of a number as printed; `None` if it is not a nonnegative decimal with this many places.
fn digits(value: &Rational, decimals: Option<u32>) -> Option<String> {
    let places = usize::try_from(decimals.unwrap_or(0).min(MAX_DECIMALS)).ok()?;
    let scaled = value * Rational::from_integer(Integer::from(10).pow(places));
    if !scaled.is_integer() || *scaled.numer() < Integer::from(0) {
        return None;
    }
    let all = scaled.numer().to_string();
    if places == 0 {
        return Some(all);
    }
    let all = format!("{all:0>width$}", width = places + 1);
    let (whole, fraction) = all.split_at(all.len() - places);
    Some(format!("{whole}.{fraction}"))
}

/// The name, if the formula is a name.
pub(super) fn plain_name(expr: &Expr) -> Option<&str> {
    match &expr.node {
        Node::Name(name) => Some(name),
        _ => None,
    }
}

/// The integer, if the formula is a small nonnegative integer literal.
pub(super) fn plain_integer(expr: &Expr) -> Option<u32> {
    match &expr.node {
        Node::Number {
            value,
            decimals: None,
        } if value.is_integer() => u32::try_from(value.numer().clone()).ok(),
        _ => None,
    }
}

/// A function applied by name: the name and the arguments.
pub(super) fn named_call(expr: &Expr) -> Option<(&str, &[Expr])> {
    match &expr.node {
        Node::Call(head, arguments) => Some((plain_name(head)?, arguments)),
        _ => None,
    }
}

/// A name, or a member of a named family with its indices.
pub(super) fn member(expr: &Expr) -> Option<(&str, &[Expr])> {
    match &expr.node {
        Node::Name(name) => Some((name, &[])),
        Node::Index(head, indices) => Some((plain_name(head)?, indices)),
        _ => None,
    }
}
