//! The parts of mathematical typesetting that Typst and LaTeX share.
//!
//! A typesetting language defines its primitives ([`Typeset`]: attachments, fractions, brackets); every such language
//! is then a [`Notation`].

use super::names::{Name, Word};
use super::walk::{Level, Notation, Piece, member, named_call, plain_integer, plain_name};
use crate::formula::{Connective, Expr, Node, Operator, Relation};

/// The brackets of a matrix.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fence {
    /// Round brackets: the matrix.
    Round,
    /// Bars: its determinant.
    Bars,
}

/// The primitives of a language for setting mathematics.
pub(super) trait Typeset {
    const DOT: &'static str;
    const TIMES: &'static str;
    const NOT: &'static str;
    const TRANSPOSED: &'static str;
    const PARTIAL: &'static str;

    /// A word: a letter, a Greek letter, a known function or upright text.
    fn word(&self, word: &Word<'_>) -> String;
    /// A word that is set as an operator with arguments.
    fn operator(&self, word: &str) -> String;
    /// A base with primes, subscript and superscript; empty strings if there are none.
    fn attached(&self, base: &str, primes: usize, below: &str, above: &str) -> String;
    fn fraction(&self, above: &str, below: &str) -> String;
    fn root(&self, radicand: &str) -> String;
    fn binomial(&self, n: &str, k: &str) -> String;
    fn norm(&self, inner: &str) -> String;
    fn absolute(&self, inner: &str) -> String;
    fn round(&self, inner: &str) -> String;
    fn matrix(&self, rows: &[Vec<String>], fence: Fence) -> String;
    fn sigma(&self, variable: &str, from: &str, to: &str, body: &str) -> String;
    fn product(&self, variable: &str, from: &str, to: &str, body: &str) -> String;
    fn integral(&self, body: &str, variable: &str, from: &str, to: &str) -> String;
    /// `derivative` at `variable = value`, with a bar.
    fn restricted(&self, derivative: &str, variable: &str, value: &str) -> String;
    /// A product without a sign between the factors.
    fn juxtaposed(&self, a: &str, b: &str) -> String;
    fn relation_sign(&self, relation: Relation) -> &'static str;
    fn connective_sign(&self, connective: Connective) -> &'static str;

    /// A name with additional primes and subscripts.
    fn decorated(&self, name: &str, primes: usize, indices: &[String]) -> String {
        let name = Name::new(name);
        self.with_parts(self.word(&Word::new(name.stem)), &name, primes, indices)
    }

    /// A name at the head of a call; a word is set as an operator.
    fn function(&self, name: &str) -> String {
        let name = Name::new(name);
        let stem = match Word::new(name.stem) {
            Word::Text(word) => self.operator(word),
            word => self.word(&word),
        };
        self.with_parts(stem, &name, 0, &[])
    }

    /// `stem` with the primes and subscripts of `name` and additional ones.
    fn with_parts(
        &self,
        stem: String,
        name: &Name<'_>,
        primes: usize,
        indices: &[String],
    ) -> String {
        let words = name
            .subscripts
            .iter()
            .map(|part| self.word(&Word::new(part)));
        let below: Vec<String> = words.chain(indices.iter().cloned()).collect();
        self.attached(&stem, name.primes + primes, &below.join(", "), "")
    }
}

impl<T: Typeset> Notation for T {
    fn bracketed(&self, inner: &str) -> String {
        self.round(inner)
    }

    fn relation(&self, relation: Relation) -> &'static str {
        self.relation_sign(relation)
    }

    fn connective(&self, connective: Connective) -> &'static str {
        self.connective_sign(connective)
    }

    fn name(&self, name: &str) -> Piece {
        // Primes occupy the place of an exponent.
        let level = if name.ends_with('\'') {
            Level::Power
        } else {
            Level::Atom
        };
        Piece::new(level, self.decorated(name, 0, &[]))
    }

    fn negative(&self, inner: &Expr) -> Piece {
        let piece = self.write(inner);
        if piece.level < Level::Term || piece.text.starts_with('-') {
            return Piece::new(Level::Negative, format!("-{}", self.round(&piece.text)));
        }
        Piece::new(piece.level.min(Level::Negative), format!("-{}", piece.text))
    }

    fn product(&self, a: &Expr, b: &Expr) -> Piece {
        let left = self.operand(a, Level::Product);
        let right = self.write(b);
        let (level, right) = match right.level {
            Level::Open => (Level::Open, right.text),
            level if level >= Level::Power => (Level::Product, right.text),
            _ => (Level::Product, self.round(&right.text)),
        };
        let dotted = begins_with_number(b) || (ends_with_number(a) && is_fraction(b));
        let text = if dotted {
            format!("{left} {} {right}", T::DOT)
        } else {
            self.juxtaposed(&left, &right)
        };
        Piece::new(level, text)
    }

    fn quotient(&self, a: &Expr, b: &Expr) -> Piece {
        let (above, below) = (self.write(a), self.write(b).text);
        // A minus sign of the numerator is set before the fraction.
        match above.text.strip_prefix('-') {
            Some(positive) if above.level >= Level::Product => Piece::new(
                Level::Negative,
                format!("-{}", self.fraction(positive, &below)),
            ),
            _ => Piece::new(Level::Power, self.fraction(&above.text, &below)),
        }
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> Piece {
        let above = self.write(exponent).text;
        // sin^2 (x)
        if let (Some((name, arguments)), Some(_)) = (named_call(base), plain_integer(exponent))
            && let Word::Function(_) = Word::new(name)
        {
            let head = self.attached(&self.function(name), 0, "", &above);
            let arguments = self.round(&self.listed(arguments));
            return Piece::new(Level::Power, format!("{head} {arguments}"));
        }
        let base = self.operand(base, Level::Atom);
        Piece::new(Level::Power, self.attached(&base, 0, "", &above))
    }

    fn index(&self, head: &Expr, indices: &[Expr]) -> Piece {
        // `A[1][2]` gets one subscript, 1, 2.
        let mut all = indices.iter().collect::<Vec<_>>();
        let mut head = head;
        while let Node::Index(inner, more) = &head.node {
            all.splice(0..0, more);
            head = inner;
        }
        let all: Vec<String> = all.iter().map(|index| self.write(index).text).collect();
        match plain_name(head) {
            Some(name) => Piece::new(self.name(name).level, self.decorated(name, 0, &all)),
            None => {
                let head = self.operand(head, Level::Atom);
                Piece::atom(self.attached(&head, 0, &all.join(", "), ""))
            }
        }
    }

    fn list(&self, items: &[Expr]) -> Piece {
        Piece::atom(match rows(items) {
            Some(rows) => self.matrix(&written(self, &rows), Fence::Round),
            None => self.round(&self.listed(items)),
        })
    }

    fn not(&self, inner: &Expr) -> Piece {
        Piece::new(
            Level::Not,
            format!("{} {}", T::NOT, self.operand(inner, Level::Sum)),
        )
    }

    fn call(&self, head: &Expr, arguments: &[Expr]) -> Piece {
        if let Some(piece) = plain_name(head).and_then(|name| special(self, name, arguments)) {
            return piece;
        }
        if let (Some(("D", derivative)), [value]) = (named_call(head), arguments)
            && let Some(piece) = derivative_at(self, derivative, value)
        {
            return piece;
        }
        let head = match plain_name(head) {
            Some(name) => self.function(name),
            None => match &head.node {
                Node::Index(..) => self.write(head).text,
                _ => self.operand(head, Level::Atom),
            },
        };
        let arguments = self.round(&self.listed(arguments));
        Piece::atom(format!("{head} {arguments}"))
    }
}

/// The built-in functions that have a notation of their own.
fn special<T: Typeset>(t: &T, name: &str, arguments: &[Expr]) -> Option<Piece> {
    let inner = |expr| t.write(expr).text;
    Some(match (name, arguments) {
        ("sqrt", [x]) => Piece::atom(t.root(&inner(x))),
        ("binom", [n, k]) => Piece::atom(t.binomial(&inner(n), &inner(k))),
        ("norm", [v]) => Piece::atom(t.norm(&inner(v))),
        ("abs", [x]) => Piece::atom(t.absolute(&inner(x))),
        ("sum", [variable, from, to, body]) => {
            let body = t.operand(body, Level::Open);
            let text = t.sigma(&inner(variable), &inner(from), &inner(to), &body);
            Piece::new(Level::Open, text)
        }
        ("product", [variable, from, to, body]) => {
            let body = t.operand(body, Level::Product);
            let text = t.product(&inner(variable), &inner(from), &inner(to), &body);
            Piece::new(Level::Open, text)
        }
        ("integral", [body, variable, from, to]) => {
            let body = t.operand(body, Level::Term);
            let text = t.integral(&body, &inner(variable), &inner(from), &inner(to));
            Piece::new(Level::Open, text)
        }
        ("dot" | "cross", [a, b]) => {
            let sign = if name == "dot" { T::DOT } else { T::TIMES };
            let (a, b) = (t.operand(a, Level::Power), t.operand(b, Level::Power));
            Piece::new(Level::Term, format!("{a} {sign} {b}"))
        }
        ("det", [matrix]) => match &matrix.node {
            Node::List(items) => Piece::atom(t.matrix(&written(t, &rows(items)?), Fence::Bars)),
            _ => return None,
        },
        ("transpose", [m]) => raised(t, m, T::TRANSPOSED),
        ("inverse", [m]) => raised(t, m, "-1"),
        ("D", [function, variable]) => derivative(t, function, variable, ""),
        ("D", [function, variable, order]) => match plain_integer(order) {
            Some(1) => derivative(t, function, variable, ""),
            _ => derivative(t, function, variable, &inner(order)),
        },
        _ => return None,
    })
}

/// A matrix with a superscript.
fn raised<T: Typeset>(t: &T, matrix: &Expr, above: &str) -> Piece {
    let base = t.operand(matrix, Level::Atom);
    Piece::new(Level::Power, t.attached(&base, 0, "", above))
}

/// `d^n F / d x^n`, or the operator `d^n / d x^n` followed by the expression; an empty order means the first
/// derivative.
fn derivative<T: Typeset>(t: &T, function: &Expr, variable: &Expr, order: &str) -> Piece {
    // Partial if there are several arguments, or if a derivative was taken already.
    let partial = match named_call(function) {
        Some(("D", _)) => true,
        Some((_, arguments)) => arguments.len() > 1,
        None => false,
    };
    let d = if partial { T::PARTIAL } else { "d" };
    let above = t.attached(d, 0, "", order);
    let below = format!("{d} {}", t.attached(&t.write(variable).text, 0, "", order));
    let quotient = |name| t.fraction(&format!("{above} {}", t.write(name).text), &below);
    match &function.node {
        Node::Name(_) => return Piece::new(Level::Power, quotient(function)),
        // If the arguments are plain variables, only the function name is set in the numerator.
        Node::Call(head, arguments)
            if plain_name(head).is_some_and(|name| name != "D")
                && arguments.iter().all(|x| plain_name(x).is_some()) =>
        {
            let arguments = t.round(&t.listed(arguments));
            return Piece::new(Level::Power, format!("{} {arguments}", quotient(head)));
        }
        _ => {}
    }
    let operand = t.write(function);
    let operand = if operand.level >= Level::Power || operand.level == Level::Open {
        operand.text
    } else {
        t.round(&operand.text)
    };
    Piece::new(
        Level::Open,
        t.juxtaposed(&t.fraction(&above, &below), &operand),
    )
}

/// `F''(0)` for at most three derivatives of a named function or member of a family by its own variable; partial
/// differentials for a derivative by a parameter; otherwise the derivative with a bar.
fn derivative_at<T: Typeset>(t: &T, derivative: &[Expr], value: &Expr) -> Option<Piece> {
    let (function, variable, order) = match derivative {
        [function, variable] => (function, variable, Some(1)),
        [function, variable, order] => (function, variable, plain_integer(order)),
        _ => return None,
    };
    let at = t.write(value).text;
    // Primes denote derivatives by the function's own variable; another name is a parameter.
    let by_parameter = plain_name(value).is_some_and(|name| plain_name(variable) != Some(name));
    if by_parameter && plain_name(function).is_some() {
        let power = derivative.get(2).map(|order| t.write(order).text);
        let power = power.unwrap_or_default();
        let above = t.attached(T::PARTIAL, 0, "", &power);
        let below = t.attached(&t.write(variable).text, 0, "", &power);
        let (above, below) = (
            format!("{above} {}", t.write(function).text),
            format!("{} {below}", T::PARTIAL),
        );
        let text = format!("{} {}", t.fraction(&above, &below), t.round(&at));
        return Some(Piece::new(Level::Power, text));
    }
    if let (Some(primes @ 1..=3), Some((name, indices))) = (order, member(function)) {
        let indices: Vec<String> = indices.iter().map(|index| t.write(index).text).collect();
        let head = t.decorated(name, usize::try_from(primes).ok()?, &indices);
        return Some(Piece::atom(format!("{head} {}", t.round(&at))));
    }
    let rate = special(t, "D", derivative)?;
    let text = t.restricted(&rate.text, &t.write(variable).text, &at);
    Some(Piece::new(Level::Power, text))
}

/// The rows of a matrix: a list of lists of one nonzero length.
fn rows(items: &[Expr]) -> Option<Vec<&[Expr]>> {
    let rows: Vec<&[Expr]> = items
        .iter()
        .map(|item| match &item.node {
            Node::List(row) => Some(row.as_slice()),
            _ => None,
        })
        .collect::<Option<_>>()?;
    let width = rows.first()?.len();
    (width > 0 && rows.iter().all(|row| row.len() == width)).then_some(rows)
}

fn written<T: Typeset>(t: &T, rows: &[&[Expr]]) -> Vec<Vec<String>> {
    let cells = |row: &&[Expr]| row.iter().map(|cell| t.write(cell).text).collect();
    rows.iter().map(cells).collect()
}

/// Whether the text begins with a digit, so that a factor before it needs a dot.
fn begins_with_number(expr: &Expr) -> bool {
    match &expr.node {
        Node::Number { .. } => true,
        Node::Binary(Operator::Power, base, _) => begins_with_number(base),
        _ => false,
    }
}

/// Whether the text ends with a number, so that a following fraction would look like a mixed number.
fn ends_with_number(expr: &Expr) -> bool {
    match &expr.node {
        Node::Number { .. } => true,
        Node::Negative(inner) => ends_with_number(inner),
        Node::Binary(Operator::Multiply, _, last) => ends_with_number(last),
        _ => false,
    }
}

fn is_fraction(expr: &Expr) -> bool {
    matches!(expr.node, Node::Binary(Operator::Divide, ..))
}
