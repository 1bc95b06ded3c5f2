//! Writes formulas as exact SymPy code: quotients and decimals become rationals, never floats.

use super::names::identifier;
use super::walk::{Level, Notation, Piece, member, named_call, plain_integer, plain_name};
use crate::formula::{Connective, Expr, Node, Relation};

struct Sympy;

/// Reserved words of Python that could be names in a formula.
const RESERVED: [&str; 33] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue",
    "def", "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import",
    "in", "is", "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while",
];

impl Sympy {
    /// A call of the SymPy function `name`.
    fn apply(&self, name: &str, arguments: &[&Expr]) -> Piece {
        let arguments: Vec<String> = arguments.iter().map(|a| self.write(a).text).collect();
        Piece::atom(format!("{name}({})", arguments.join(", ")))
    }

    /// An applied member of a family of functions: `g(i, k, x)`.
    fn function(&self, name: &str, indices: &[Expr], arguments: &[Expr]) -> Piece {
        let all: Vec<&Expr> = indices.iter().chain(arguments).collect();
        self.apply(&identifier(name, &RESERVED), &all)
    }

    /// `diff(F(x), x, n)`. A named function is applied to the variable, because SymPy would take a bare name for a
    /// constant.
    fn derivative(&self, function: &Expr, rest: &[Expr]) -> Piece {
        let applied = match member(function) {
            Some((name, indices)) => self.function(name, indices, rest.get(..1).unwrap_or(&[])),
            None => self.write(function),
        };
        Piece::atom(format!("diff({}, {})", applied.text, self.listed(rest)))
    }

    /// An operand that must not be a bare Python number, since Python would divide it in floats.
    fn exact(&self, expr: &Expr, level: Level) -> String {
        if expr.names().is_empty() {
            format!("sympify({})", self.write(expr).text)
        } else {
            self.operand(expr, level)
        }
    }
}

impl Notation for Sympy {
    fn number(&self, digits: &str) -> Piece {
        Piece::atom(if digits.contains('.') {
            format!("Rational('{digits}')")
        } else {
            digits.to_owned()
        })
    }

    fn name(&self, name: &str) -> Piece {
        Piece::atom(identifier(name, &RESERVED))
    }

    fn quotient(&self, a: &Expr, b: &Expr) -> Piece {
        if let Node::Negative(positive) = &a.node
            && plain_integer(positive).is_some()
            && plain_integer(b).is_some()
        {
            return self.apply("Rational", &[a, b]);
        }
        if plain_integer(a).is_some() && plain_integer(b).is_some() {
            return self.apply("Rational", &[a, b]);
        }
        let (a, b) = (self.exact(a, Level::Product), self.operand(b, Level::Power));
        Piece::new(Level::Product, format!("{a}/{b}"))
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> Piece {
        let (base, exponent) = (
            self.exact(base, Level::Atom),
            self.operand(exponent, Level::Power),
        );
        Piece::new(Level::Power, format!("{base}**{exponent}"))
    }

    fn call(&self, head: &Expr, arguments: &[Expr]) -> Piece {
        let method = |object: &Expr, call: &str| {
            Piece::atom(format!("{}.{call}", self.operand(object, Level::Atom)))
        };
        if let (Some(("D", [_, variable, ..])), [value]) = (named_call(head), arguments) {
            let (variable, value) = (self.write(variable).text, self.write(value).text);
            return method(head, &format!("subs({variable}, {value})"));
        }
        if let Node::Index(..) = &head.node
            && let Some((name, indices)) = member(head)
        {
            return self.function(name, indices, arguments);
        }
        let name = plain_name(head).unwrap_or_default();
        match (name, arguments) {
            ("D", [function, rest @ ..]) => self.derivative(function, rest),
            ("binom", [n, k]) => self.apply("binomial", &[n, k]),
            ("abs", [x]) => self.apply("Abs", &[x]),
            ("min", [a, b]) => self.apply("Min", &[a, b]),
            ("max", [a, b]) => self.apply("Max", &[a, b]),
            ("sum", [variable, from, to, body]) => {
                let range = self.apply("", &[variable, from, to]).text;
                Piece::atom(format!("Sum({}, {range})", self.write(body).text))
            }
            ("product", [variable, from, to, body]) => {
                let range = self.apply("", &[variable, from, to]).text;
                Piece::atom(format!("Product({}, {range})", self.write(body).text))
            }
            ("integral", [body, variable, from, to]) => {
                let range = self.apply("", &[variable, from, to]).text;
                Piece::atom(format!("Integral({}, {range})", self.write(body).text))
            }
            ("dot" | "cross", [a, b]) => method(a, &format!("{name}({})", self.write(b).text)),
            ("det", [m]) => method(m, "det()"),
            ("norm", [v]) => method(v, "norm()"),
            ("inverse", [m]) => method(m, "inv()"),
            ("transpose", [m]) => method(m, "T"),
            _ => {
                let head = self.operand(head, Level::Atom);
                Piece::atom(format!("{head}({})", self.listed(arguments)))
            }
        }
    }

    fn list(&self, items: &[Expr]) -> Piece {
        // The rows are plain lists inside one matrix.
        let cell = |item: &Expr| match &item.node {
            Node::List(row) => format!("[{}]", self.listed(row)),
            _ => self.write(item).text,
        };
        let cells: Vec<String> = items.iter().map(cell).collect();
        Piece::atom(format!("Matrix([{}])", cells.join(", ")))
    }

    fn relation(&self, relation: Relation) -> &'static str {
        match relation {
            Relation::Equal => "Eq",
            Relation::Different => "Ne",
            Relation::Less => "Lt",
            Relation::AtMost => "Le",
            Relation::Greater => "Gt",
            Relation::AtLeast => "Ge",
        }
    }

    fn compare(&self, first: &Expr, rest: &[(Relation, Expr)]) -> Piece {
        let mut left = first;
        let mut all = vec![];
        for (relation, right) in rest {
            all.push(self.apply(self.relation(*relation), &[left, right]).text);
            left = right;
        }
        Piece::atom(match all.as_slice() {
            [one] => one.clone(),
            _ => format!("And({})", all.join(", ")),
        })
    }

    fn join(&self, connective: Connective, a: &Expr, b: &Expr) -> Piece {
        let name = match connective {
            Connective::And => "And",
            Connective::Or => "Or",
            Connective::Implies => "Implies",
        };
        self.apply(name, &[a, b])
    }

    fn not(&self, inner: &Expr) -> Piece {
        self.apply("Not", &[inner])
    }
}

/// The formula as exact SymPy code.
///
/// Points of a family are indexed (`R[k - 2]`, an `IndexedBase`), members of a family of functions are
/// called with the index (`g(i, k, x)`), lists are matrices, `H''` is `H_d2`.
///
/// ```
/// use torse_syntax::{notation, formula::parse};
/// let formula = parse("D(F, z, 2)(0) == 1/4*(Q[1] - Q[0])^2").unwrap();
/// assert_eq!(
///     notation::sympy(&formula),
///     "Eq(diff(F(z), z, 2).subs(z, 0), Rational(1, 4)*(Q[1] - Q[0])**2)"
/// );
/// ```
#[must_use]
pub fn sympy(formula: &Expr) -> String {
    Sympy.write(formula).text
}
