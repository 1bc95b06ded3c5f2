//! Terms of composed statements, and how they are written.

use std::fmt;
use std::sync::Arc;

/// A shared part.
pub type Part = Arc<Term>;

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Function {
    /// `sin`
    Sine,
    /// `cos`
    Cosine,
    /// `exp`
    Exponential,
    /// `log`
    Logarithm,
    /// `sqrt`
    Root,
    /// `abs`
    Size,
}

/// An operation on two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `min`
    Least,
    /// `max`
    Greatest,
}

/// A term worth a number.
#[derive(Debug, Clone, PartialEq)]
pub enum Term {
    /// A fraction, above and below.
    Number(i64, i64),
    /// A symbol, or a variable that is bound.
    Name(String),
    /// `-a`
    Negative(Part),
    /// `a + b` and so on.
    Binary(Operation, Part, Part),
    /// `a^n` with an integer n.
    Power(Part, Part),
    /// `sin(a)` and so on.
    Apply(Function, Part),
    /// `f''(a)`: a smooth function, the order of its derivative, the place.
    Smooth(String, usize, Part),
    /// `D(body, by, order)`
    Rate(Part, String, usize),
    /// `at(body, by, value)`
    At(Part, String, Part),
    /// `sum(index, low, high, body)`
    Sum(String, Part, Part, Part),
    /// `product(index, low, high, body)`
    Product(String, Part, Part, Part),
    /// `integral(body, by, low, high)`
    Integral(Part, String, Part, Part),
    /// `F(a, b)`, or `E` without arguments.
    Defined(String, Vec<Part>),
    /// `P[i]`
    Member(String, Part),
    /// `B[i,k](a)`, or `B[i,k]` without arguments.
    Basis(String, Part, Part, Vec<Part>),
}

impl Term {
    /// An integer.
    #[must_use]
    pub fn int(n: i64) -> Part {
        Arc::new(Self::Number(n, 1))
    }

    /// A name.
    #[must_use]
    pub fn name(name: &str) -> Part {
        Arc::new(Self::Name(name.to_owned()))
    }

    /// `a + b` and so on.
    #[must_use]
    pub fn binary(operation: Operation, a: &Part, b: &Part) -> Part {
        Arc::new(Self::Binary(operation, Arc::clone(a), Arc::clone(b)))
    }

    /// `a + b`, shortened where one is zero.
    #[must_use]
    pub fn plus(a: &Part, b: &Part) -> Part {
        match (&**a, &**b) {
            (Self::Number(0, _), _) => Arc::clone(b),
            (_, Self::Number(0, _)) => Arc::clone(a),
            _ => Self::binary(Operation::Add, a, b),
        }
    }

    /// `a*b`, shortened where one is zero or one.
    #[must_use]
    pub fn times(a: &Part, b: &Part) -> Part {
        match (&**a, &**b) {
            (Self::Number(0, _), _) | (_, Self::Number(0, _)) => Self::int(0),
            (Self::Number(1, 1), _) => Arc::clone(b),
            (_, Self::Number(1, 1)) => Arc::clone(a),
            _ => Self::binary(Operation::Multiply, a, b),
        }
    }

    /// `-a`, shortened for zero.
    #[must_use]
    pub fn minus(a: &Part) -> Part {
        match &**a {
            Self::Number(0, _) => Self::int(0),
            _ => Arc::new(Self::Negative(Arc::clone(a))),
        }
    }

    /// The direct parts, in the order of the text.
    #[must_use]
    pub fn parts(&self) -> Vec<&Part> {
        match self {
            Self::Number(..) | Self::Name(_) => vec![],
            Self::Negative(a)
            | Self::Apply(_, a)
            | Self::Smooth(_, _, a)
            | Self::Rate(a, ..)
            | Self::Member(_, a) => vec![a],
            Self::Binary(_, a, b) | Self::Power(a, b) | Self::At(a, _, b) => vec![a, b],
            Self::Sum(_, a, b, c) | Self::Product(_, a, b, c) | Self::Integral(a, _, b, c) => {
                vec![a, b, c]
            }
            Self::Defined(_, all) => all.iter().collect(),
            Self::Basis(_, index, degree, all) => [index, degree].into_iter().chain(all).collect(),
        }
    }

    /// The same with its parts changed; `change` is told the place of each.
    #[must_use]
    pub fn with_parts(&self, mut change: impl FnMut(usize, &Part) -> Part) -> Self {
        let mut place = 0;
        let mut next = |part: &Part| {
            place += 1;
            change(place - 1, part)
        };
        match self {
            leaf @ (Self::Number(..) | Self::Name(_)) => leaf.clone(),
            Self::Negative(a) => Self::Negative(next(a)),
            Self::Apply(function, a) => Self::Apply(*function, next(a)),
            Self::Smooth(name, order, a) => Self::Smooth(name.clone(), *order, next(a)),
            Self::Rate(a, by, order) => Self::Rate(next(a), by.clone(), *order),
            Self::Member(name, a) => Self::Member(name.clone(), next(a)),
            Self::Binary(operation, a, b) => Self::Binary(*operation, next(a), next(b)),
            Self::Power(a, b) => Self::Power(next(a), next(b)),
            Self::At(a, by, b) => Self::At(next(a), by.clone(), next(b)),
            Self::Sum(index, a, b, c) => Self::Sum(index.clone(), next(a), next(b), next(c)),
            Self::Product(index, a, b, c) => {
                Self::Product(index.clone(), next(a), next(b), next(c))
            }
            Self::Integral(a, by, b, c) => Self::Integral(next(a), by.clone(), next(b), next(c)),
            Self::Defined(name, all) => {
                Self::Defined(name.clone(), all.iter().map(&mut next).collect())
            }
            Self::Basis(name, index, degree, all) => Self::Basis(
                name.clone(),
                next(index),
                next(degree),
                all.iter().map(&mut next).collect(),
            ),
        }
    }

    /// The number of nodes.
    #[must_use]
    pub fn size(&self) -> usize {
        1 + self.parts().iter().map(|part| part.size()).sum::<usize>()
    }

    /// How tightly it binds: 0 for sums, 1 for products, 2 for signs, 3 for powers, 4 for all else.
    fn strength(&self) -> u8 {
        match self {
            Self::Binary(Operation::Add | Operation::Subtract, ..) => 0,
            Self::Binary(Operation::Multiply | Operation::Divide, ..) => 1,
            Self::Number(above, below) if *below != 1 || *above < 0 => 1,
            Self::Negative(_) => 2,
            Self::Power(..) => 3,
            _ => 4,
        }
    }

    fn write(&self, least: u8, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.strength() < least {
            f.write_str("(")?;
            self.write(0, f)?;
            return f.write_str(")");
        }
        let listed = |f: &mut fmt::Formatter<'_>, all: &[&Part]| {
            for (place, part) in all.iter().enumerate() {
                f.write_str(if place == 0 { "" } else { ", " })?;
                part.write(0, f)?;
            }
            Ok(())
        };
        match self {
            Self::Number(above, 1) => write!(f, "{above}"),
            Self::Number(above, below) => write!(f, "{above}/{below}"),
            Self::Name(name) => f.write_str(name),
            Self::Negative(a) => {
                f.write_str("-")?;
                a.write(3, f)
            }
            Self::Binary(Operation::Least, a, b) => write!(f, "min({a}, {b})"),
            Self::Binary(Operation::Greatest, a, b) => write!(f, "max({a}, {b})"),
            Self::Binary(operation, a, b) => {
                let (sign, left, right) = match operation {
                    Operation::Add => (" + ", 0, 1),
                    Operation::Subtract => (" - ", 0, 1),
                    Operation::Multiply => ("*", 1, 2),
                    _ => ("/", 1, 2),
                };
                a.write(left, f)?;
                f.write_str(sign)?;
                b.write(right, f)
            }
            Self::Power(a, n) => {
                a.write(4, f)?;
                f.write_str("^")?;
                n.write(4, f)
            }
            Self::Apply(function, a) => {
                let word = match function {
                    Function::Sine => "sin",
                    Function::Cosine => "cos",
                    Function::Exponential => "exp",
                    Function::Logarithm => "log",
                    Function::Root => "sqrt",
                    Function::Size => "abs",
                };
                write!(f, "{word}({a})")
            }
            Self::Smooth(name, order, a) => write!(f, "{name}{}({a})", "'".repeat(*order)),
            Self::Rate(a, by, 1) => write!(f, "D({a}, {by})"),
            Self::Rate(a, by, order) => write!(f, "D({a}, {by}, {order})"),
            Self::At(a, by, value) => write!(f, "at({a}, {by}, {value})"),
            Self::Sum(index, low, high, a) => write!(f, "sum({index}, {low}, {high}, {a})"),
            Self::Product(index, low, high, a) => {
                write!(f, "product({index}, {low}, {high}, {a})")
            }
            Self::Integral(a, by, low, high) => write!(f, "integral({a}, {by}, {low}, {high})"),
            Self::Member(name, index) => write!(f, "{name}[{index}]"),
            Self::Defined(name, all) => {
                f.write_str(name)?;
                if all.is_empty() {
                    return Ok(());
                }
                f.write_str("(")?;
                listed(f, &all.iter().collect::<Vec<_>>())?;
                f.write_str(")")
            }
            Self::Basis(name, index, degree, all) => {
                write!(f, "{name}[{index},{degree}]")?;
                if all.is_empty() {
                    return Ok(());
                }
                f.write_str("(")?;
                listed(f, &all.iter().collect::<Vec<_>>())?;
                f.write_str(")")
            }
        }
    }
}

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(0, f)
    }
}
