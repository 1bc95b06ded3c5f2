//! Writes formulas as Rust code in `f64`; [`rust()`] documents the conventions.

use super::names::identifier;
use super::walk::{Level, Notation, Piece, member, named_call, plain_integer, plain_name};
use crate::formula::{Connective, Expr, Node, Relation};
use std::collections::BTreeSet;

/// Reserved words of Rust that could be names in a formula.
const RESERVED: [&str; 38] = [
    "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern",
    "false", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut",
    "pub", "ref", "return", "self", "Self", "static", "struct", "super", "trait", "true", "type",
    "use", "where", "while",
];

/// The largest order of a derivative that is written as a function name.
const MAX_ORDER: usize = 9;

/// Writes code in `f64`; knows which names are integers.
struct Doubles<'a> {
    integers: BTreeSet<&'a str>,
}

/// Writes code in `i32`, for indices and ranges.
struct Integers;

impl Notation for Integers {
    fn name(&self, name: &str) -> Piece {
        Piece::atom(identifier(name, &RESERVED))
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> Piece {
        let base = self.operand(base, Level::Atom);
        let exponent = self.operand(exponent, Level::Atom);
        Piece::atom(format!("{base}.pow({exponent} as u32)"))
    }
}

impl Doubles<'_> {
    /// The object that is indexed or called; a name is that of an array or function, never of an integer.
    fn head(&self, head: &Expr) -> String {
        match plain_name(head) {
            Some(name) => identifier(name, &RESERVED),
            None => self.operand(head, Level::Atom),
        }
    }

    /// What a method is called of: a literal needs a suffix that says its type.
    fn object(&self, x: &Expr) -> String {
        match &x.node {
            Node::Number { .. } => format!("{}_f64", self.write(x).text),
            _ => self.operand(x, Level::Atom),
        }
    }

    /// The function name of a member of a family, or of a derivative of a named function, and the indices that become
    /// its first arguments.
    fn function<'e>(&self, head: &'e Expr) -> Option<(String, &'e [Expr])> {
        if let Node::Index(..) = &head.node {
            let (name, indices) = member(head)?;
            return Some((identifier(name, &RESERVED), indices));
        }
        let ("D", [function, _, order @ ..]) = named_call(head)? else {
            return None;
        };
        let order = order.first().map_or(Some(1), plain_integer)?;
        let (name, indices) = member(function)?;
        let primes = "'".repeat(usize::try_from(order).ok().filter(|n| *n <= MAX_ORDER)?);
        Some((identifier(&format!("{name}{primes}"), &RESERVED), indices))
    }

    /// Conditions joined by `&&`.
    fn all(conditions: Vec<String>) -> Piece {
        let level = if conditions.len() == 1 {
            Level::Relation
        } else {
            Level::And
        };
        Piece::new(level, conditions.join(" && "))
    }
}

impl Notation for Doubles<'_> {
    fn number(&self, digits: &str) -> Piece {
        let point = if digits.contains('.') { "" } else { ".0" };
        Piece::atom(format!("{digits}{point}"))
    }

    fn name(&self, name: &str) -> Piece {
        Piece::atom(if name == "pi" {
            "std::f64::consts::PI".to_owned()
        } else if self.integers.contains(name) {
            format!("f64::from({})", identifier(name, &RESERVED))
        } else {
            identifier(name, &RESERVED)
        })
    }

    fn product(&self, a: &Expr, b: &Expr) -> Piece {
        let (a, b) = (
            self.operand(a, Level::Product),
            self.operand(b, Level::Power),
        );
        Piece::new(Level::Product, format!("{a} * {b}"))
    }

    fn quotient(&self, a: &Expr, b: &Expr) -> Piece {
        let (a, b) = (
            self.operand(a, Level::Product),
            self.operand(b, Level::Power),
        );
        Piece::new(Level::Product, format!("{a} / {b}"))
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> Piece {
        let object = match &base.node {
            // A literal needs a type suffix before a method call.
            Node::Number { .. } => format!("{}_f64", self.operand(base, Level::Atom)),
            _ => self.operand(base, Level::Atom),
        };
        let inner = match &exponent.node {
            Node::Negative(inner) => inner,
            _ => exponent,
        };
        let is_integer = plain_integer(inner).is_some()
            || plain_name(inner).is_some_and(|name| self.integers.contains(name));
        Piece::atom(if is_integer {
            format!("{object}.powi({})", Integers.write(exponent).text)
        } else {
            format!("{object}.powf({})", self.write(exponent).text)
        })
    }

    fn index(&self, head: &Expr, indices: &[Expr]) -> Piece {
        let head = self.head(head);
        let subscript = |index: &Expr| match plain_integer(index) {
            Some(number) => format!("[{number}]"),
            None => format!("[{} as usize]", Integers.operand(index, Level::Atom)),
        };
        Piece::atom(
            indices
                .iter()
                .fold(head, |text, index| text + &subscript(index)),
        )
    }

    fn call(&self, head: &Expr, arguments: &[Expr]) -> Piece {
        if let Some((name, indices)) = self.function(head) {
            let all = indices.iter().map(|index| Integers.write(index).text);
            let all = all.chain(arguments.iter().map(|x| self.write(x).text));
            return Piece::atom(format!("{name}({})", all.collect::<Vec<_>>().join(", ")));
        }
        let name = plain_name(head).unwrap_or_default();
        match (name, arguments) {
            (
                "sqrt" | "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "exp" | "log" | "atan"
                | "asin" | "acos" | "abs",
                [x],
            ) => {
                let name = if name == "log" { "ln" } else { name };
                Piece::atom(format!("{}.{name}()", self.object(x)))
            }
            ("min" | "max", [a, b]) => {
                Piece::atom(format!("{}.{name}({})", self.object(a), self.write(b).text))
            }
            ("binom", [n, k]) => Piece::atom(format!(
                "binom({}, {})",
                Integers.write(n).text,
                Integers.write(k).text
            )),
            ("sum" | "product", [variable, from, to, body]) => Piece::atom(format!(
                "({}..={}).map(|{}| {}).{name}::<f64>()",
                Integers.operand(from, Level::Sum),
                Integers.operand(to, Level::Sum),
                Integers.write(variable).text,
                self.write(body).text
            )),
            ("D", [function, variable, order @ ..]) => {
                let (function, variable) = (self.write(function).text, self.write(variable).text);
                let order = order
                    .first()
                    .map_or("1".to_owned(), |n| Integers.write(n).text);
                Piece::atom(format!("derivative({function}, {variable}, {order})"))
            }
            _ => {
                let head = self.head(head);
                Piece::atom(format!("{head}({})", self.listed(arguments)))
            }
        }
    }

    fn connective(&self, connective: Connective) -> &'static str {
        match connective {
            Connective::And => "&&",
            Connective::Or | Connective::Implies => "||",
        }
    }

    fn compare(&self, first: &Expr, rest: &[(Relation, Expr)]) -> Piece {
        let mut left = self.operand(first, Level::Sum);
        let mut all = vec![];
        for (relation, side) in rest {
            let right = self.operand(side, Level::Sum);
            all.push(format!("{left} {} {right}", self.relation(*relation)));
            left = right;
        }
        Self::all(all)
    }

    fn join(&self, connective: Connective, a: &Expr, b: &Expr) -> Piece {
        let (level, a) = match connective {
            Connective::And => (Level::And, self.operand(a, Level::And)),
            Connective::Or => (Level::Or, self.operand(a, Level::Or)),
            Connective::Implies => (Level::Or, self.not(a).text),
        };
        let right = match connective {
            Connective::And => Level::Not,
            Connective::Or | Connective::Implies => Level::Or,
        };
        let b = self.operand(b, right);
        Piece::new(level, format!("{a} {} {b}", self.connective(connective)))
    }

    fn not(&self, inner: &Expr) -> Piece {
        Piece::new(
            Level::Negative,
            format!("!{}", self.operand(inner, Level::Atom)),
        )
    }
}

/// The names in an index, a range or a binomial.
fn integers(expr: &Expr) -> BTreeSet<&str> {
    let mut found = BTreeSet::new();
    let mut pending = vec![expr];
    while let Some(next) = pending.pop() {
        pending.extend(next.parts());
        let counting: Vec<&Expr> = match &next.node {
            Node::Index(_, indices) => indices.iter().collect(),
            _ => match named_call(next) {
                Some(("sum" | "product", [variable, from, to, _])) => vec![variable, from, to],
                Some(("binom", [n, k])) => vec![n, k],
                _ => vec![],
            },
        };
        found.extend(counting.into_iter().flat_map(Expr::names));
    }
    found
}

/// The formula as Rust code in doubles.
///
/// Names that occur in an index, in the range of a sum or in a binomial are `i32` variables; every other name is an
/// `f64` (or a point with the same operators). A member of a family of functions is called with its index, `g(i, k,
/// x)`. The user of the code must supply functions of vectors (`dot`, `det`, ...), `binom`, and derivatives: `H''`
/// and `D(H, x, 2)` at a point become `H_d2`, others `derivative(f, x, n)`.
///
/// ```
/// use torse_syntax::{notation, formula::parse};
/// let formula = parse("1/4*(k - 2)*sin(pi*x)^2*R[k-2]").unwrap();
/// assert_eq!(
///     notation::rust(&formula),
///     "1.0 / 4.0 * (f64::from(k) - 2.0) * (std::f64::consts::PI * x).sin().powi(2) * R[(k - 2) as usize]"
/// );
/// ```
#[must_use]
pub fn rust(formula: &Expr) -> String {
    let integers = integers(formula);
    Doubles { integers }.write(formula).text
}
