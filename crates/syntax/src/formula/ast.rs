//! The syntax tree of formulas. Every node has its place in the text, so that later stages can point at it in
//! messages.

use std::sync::Arc;
use torse_numbers::{Affine, Rational};

/// A range of bytes in the text of a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Place {
    /// The first byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Place {
    /// The smallest range that covers both.
    #[must_use]
    pub fn to(self, other: Self) -> Self {
        Self {
            start: self.start.min(other.start),
            end: self.end.max(other.end),
        }
    }
}

/// An operator between two formulas.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `^`
    Power,
}

impl Operator {
    /// The sign as written.
    #[must_use]
    pub fn sign(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Power => "^",
        }
    }
}

/// A comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Relation {
    /// `==`
    Equal,
    /// `!=`
    Different,
    /// `<`
    Less,
    /// `<=`
    AtMost,
    /// `>`
    Greater,
    /// `>=`
    AtLeast,
}

impl Relation {
    /// The sign as written.
    #[must_use]
    pub fn sign(self) -> &'static str {
        match self {
            Self::Equal => "==",
            Self::Different => "!=",
            Self::Less => "<",
            Self::AtMost => "<=",
            Self::Greater => ">",
            Self::AtLeast => ">=",
        }
    }

    /// The negation: the relation that holds where this one does not.
    #[must_use]
    pub fn opposite(self) -> Self {
        match self {
            Self::Equal => Self::Different,
            Self::Different => Self::Equal,
            Self::Less => Self::AtLeast,
            Self::AtMost => Self::Greater,
            Self::Greater => Self::AtMost,
            Self::AtLeast => Self::Less,
        }
    }

    /// The equivalent relation after the sides are exchanged.
    #[must_use]
    pub fn mirrored(self) -> Self {
        match self {
            Self::Less => Self::Greater,
            Self::AtMost => Self::AtLeast,
            Self::Greater => Self::Less,
            Self::AtLeast => Self::AtMost,
            symmetric @ (Self::Equal | Self::Different) => symmetric,
        }
    }
}

/// How two statements are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Connective {
    /// `and`
    And,
    /// `or`
    Or,
    /// `implies`
    Implies,
}

impl Connective {
    /// The word as written.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::And => "and",
            Self::Or => "or",
            Self::Implies => "implies",
        }
    }
}

/// A formula with its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Expr {
    /// The kind of formula, with its parts.
    pub node: Node,
    /// The place in the text.
    pub place: Place,
}

/// The kinds of formulas.
///
/// Parts are shared, so a copy with one small change costs only the nodes on the path to the change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Node {
    /// A number. `decimals` is the number of printed digits after the point, if there is a point.
    Number {
        /// The exact value.
        value: Rational,
        /// Printed digits after the decimal point.
        decimals: Option<u32>,
    },
    /// A name, primes included: `mu`, `H''`.
    Name(String),
    /// An application `f(x, y)`.
    Call(Arc<Expr>, Vec<Expr>),
    /// `R[i]`, `g[i,k]`, or the entry of a vector or matrix.
    Index(Arc<Expr>, Vec<Expr>),
    /// `-x`.
    Negative(Arc<Expr>),
    /// `a + b`.
    Binary(Operator, Arc<Expr>, Arc<Expr>),
    /// `[a, b, c]`: a vector, or a matrix as a list of rows.
    List(Vec<Expr>),
    /// `a == b`, `a < b <= c`: a chain of comparisons, all of which are asserted.
    Compare(Arc<Expr>, Vec<(Relation, Expr)>),
    /// `p and q`.
    Join(Connective, Arc<Expr>, Arc<Expr>),
    /// `not p`.
    Not(Arc<Expr>),
}

impl Expr {
    /// Makes a formula without a place, for formulas that do not come from a text.
    #[must_use]
    pub fn made(node: Node) -> Self {
        Self {
            node,
            place: Place::default(),
        }
    }

    /// Makes the formula of a name.
    #[must_use]
    pub fn name(name: &str) -> Self {
        Self::made(Node::Name(name.to_owned()))
    }

    /// Makes the formula of a rational number: a quotient unless it is an integer, with a minus sign if negative.
    #[must_use]
    pub fn number(value: &Rational) -> Self {
        use num_traits::Signed;
        if value.is_negative() && value.is_integer() {
            return Self::made(Node::Negative(Arc::new(Self::number(&-value.clone()))));
        }
        let integer = |n: &torse_numbers::Integer| {
            Self::made(Node::Number {
                value: Rational::from_integer(n.clone()),
                decimals: None,
            })
        };
        if value.is_integer() {
            return integer(value.numer());
        }
        Self::made(Node::Binary(
            Operator::Divide,
            Arc::new(Self::number(&Rational::from_integer(value.numer().clone()))),
            Arc::new(integer(value.denom())),
        ))
    }

    /// Makes the formula `self operator other`.
    #[must_use]
    pub fn with(self, operator: Operator, other: Self) -> Self {
        Self::made(Node::Binary(operator, Arc::new(self), Arc::new(other)))
    }

    /// The direct parts, in the order of the text.
    #[must_use]
    pub fn parts(&self) -> Vec<&Expr> {
        match &self.node {
            Node::Number { .. } | Node::Name(_) => vec![],
            Node::Call(head, rest) | Node::Index(head, rest) => {
                std::iter::once(&**head).chain(rest.iter()).collect()
            }
            Node::Negative(inner) | Node::Not(inner) => vec![inner],
            Node::Binary(_, a, b) | Node::Join(_, a, b) => vec![a, b],
            Node::List(items) => items.iter().collect(),
            Node::Compare(first, rest) => std::iter::once(&**first)
                .chain(rest.iter().map(|(_, e)| e))
                .collect(),
        }
    }

    /// Replaces the direct part at this position; the other parts are shared. `None` if there is no such part.
    #[must_use]
    pub fn with_part(&self, position: usize, part: Self) -> Option<Self> {
        let mut copy = self.clone();
        let slot = match (&mut copy.node, position) {
            (Node::Call(head, _) | Node::Index(head, _), 0) => head,
            (Node::Call(_, rest) | Node::Index(_, rest), n) => {
                *rest.get_mut(n - 1)? = part;
                return Some(copy);
            }
            (Node::List(items), n) => {
                *items.get_mut(n)? = part;
                return Some(copy);
            }
            (Node::Compare(_, rest), n) if n > 0 => {
                rest.get_mut(n - 1)?.1 = part;
                return Some(copy);
            }
            (Node::Negative(only) | Node::Not(only), 0) => only,
            (Node::Binary(_, first, _) | Node::Join(_, first, _) | Node::Compare(first, _), 0) => {
                first
            }
            (Node::Binary(_, _, second) | Node::Join(_, _, second), 1) => second,
            _ => return None,
        };
        *slot = Arc::new(part);
        Some(copy)
    }

    /// Changes every direct part; unchanged parts are shared.
    #[must_use]
    pub fn with_parts(&self, change: impl Fn(&Self) -> Self) -> Self {
        let each = |items: &[Self]| items.iter().map(&change).collect();
        let one = |part: &Arc<Self>| {
            let changed = change(part);
            if changed.is_copy_of(part) {
                Arc::clone(part)
            } else {
                Arc::new(changed)
            }
        };
        let node = match &self.node {
            leaf @ (Node::Number { .. } | Node::Name(_)) => leaf.clone(),
            Node::Call(head, rest) => Node::Call(one(head), each(rest)),
            Node::Index(head, rest) => Node::Index(one(head), each(rest)),
            Node::Negative(inner) => Node::Negative(one(inner)),
            Node::Not(inner) => Node::Not(one(inner)),
            Node::Binary(operator, a, b) => Node::Binary(*operator, one(a), one(b)),
            Node::Join(connective, a, b) => Node::Join(*connective, one(a), one(b)),
            Node::List(items) => Node::List(each(items)),
            Node::Compare(first, rest) => {
                let rest = rest.iter().map(|(relation, e)| (*relation, change(e)));
                Node::Compare(one(first), rest.collect())
            }
        };
        Self {
            node,
            place: self.place,
        }
    }

    /// Whether this is a copy of `other` that shares its parts. Equal formulas need not be copies of each other.
    fn is_copy_of(&self, other: &Self) -> bool {
        let same = Arc::ptr_eq;
        let copies = |xs: &[Self], ys: &[Self]| {
            xs.len() == ys.len() && xs.iter().zip(ys).all(|(x, y)| x.is_copy_of(y))
        };
        self.place == other.place
            && match (&self.node, &other.node) {
                (Node::Number { .. }, Node::Number { .. }) | (Node::Name(_), Node::Name(_)) => {
                    self.node == other.node
                }
                (Node::Call(f, xs), Node::Call(g, ys))
                | (Node::Index(f, xs), Node::Index(g, ys)) => same(f, g) && copies(xs, ys),
                (Node::Negative(x), Node::Negative(y)) | (Node::Not(x), Node::Not(y)) => same(x, y),
                (Node::Binary(one, a, b), Node::Binary(other, c, d)) => {
                    one == other && same(a, c) && same(b, d)
                }
                (Node::Join(one, a, b), Node::Join(other, c, d)) => {
                    one == other && same(a, c) && same(b, d)
                }
                (Node::List(xs), Node::List(ys)) => copies(xs, ys),
                (Node::Compare(a, rest), Node::Compare(b, others)) => {
                    let mut links = rest.iter().zip(others);
                    same(a, b)
                        && rest.len() == others.len()
                        && links.all(|((one, x), (other, y))| one == other && x.is_copy_of(y))
                }
                _ => false,
            }
    }

    /// Removes all places, so that formulas compare equal wherever they were written.
    #[must_use]
    pub fn placeless(&self) -> Self {
        Self {
            place: Place::default(),
            ..self.with_parts(Self::placeless)
        }
    }

    /// The number of nodes.
    #[must_use]
    pub fn size(&self) -> usize {
        1 + self.parts().into_iter().map(Self::size).sum::<usize>()
    }

    /// Every name that occurs, in the order of the text.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        match &self.node {
            Node::Name(name) => vec![name],
            _ => self.parts().into_iter().flat_map(Self::names).collect(),
        }
    }

    /// The formula as a sum of multiples of names, with whole numbers; none if it is another one.
    ///
    /// ```
    /// use torse_numbers::Affine;
    /// let formula = |text: &str| torse_syntax::formula::parse(text).ok();
    /// let twice = Affine::symbol("n") * 2 - Affine::number(1);
    /// assert_eq!(formula("2*n - 1").and_then(|read| read.affine()), Some(twice));
    /// assert_eq!(formula("n*n").and_then(|read| read.affine()), None);
    /// ```
    #[must_use]
    pub fn affine(&self) -> Option<Affine> {
        use Operator::{Add, Multiply, Subtract};
        match &self.node {
            Node::Number { value, .. } if value.is_integer() => {
                i64::try_from(value.to_integer()).ok().map(Affine::number)
            }
            Node::Name(name) => Some(Affine::symbol(name)),
            Node::Negative(inner) => Some(inner.affine()? * -1),
            Node::Binary(Add, a, b) => Some(a.affine()? + b.affine()?),
            Node::Binary(Subtract, a, b) => Some(a.affine()? - b.affine()?),
            Node::Binary(Multiply, a, b) => {
                let (a, b) = (a.affine()?, b.affine()?);
                a.as_number()
                    .map(|n| b.clone() * n)
                    .or_else(|| b.as_number().map(|n| a * n))
            }
            _ => None,
        }
    }
}
