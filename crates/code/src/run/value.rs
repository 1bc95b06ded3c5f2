//! Values of a program that is run on symbols.

use crate::grammar::small;
use crate::program::{Kind, Type};
use num_traits::{Signed, Zero};
use std::sync::Arc;
use torse_numbers::{Affine, Rational};
use torse_syntax::formula::{Expr, Node, Operator, Place};

/// A value.
#[derive(Debug, Clone)]
pub(crate) enum Value {
    /// A number or a point, as a formula of the claim's symbols.
    Term(Term),
    Truth(bool),
    List(List),
    /// A family of the claim, with the indices that are given so far.
    Family(Family),
}

/// A list, a tuple, or an array.
#[derive(Debug, Clone)]
pub(crate) struct List {
    pub(crate) values: Vec<Value>,
    pub(crate) shape: Shape,
    /// The object that it is: names of one object show its changes. Parts of an array are the object that the array is.
    pub(crate) object: Object,
    /// The objects that are read only when this is gone through.
    pub(crate) sources: Vec<Object>,
}

/// What a list does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    /// It is joined to others by `+`.
    List,
    /// An array: added and multiplied by numbers entry by entry, and its parts are no copies.
    Vector,
    /// A matrix of SymPy: one index counts its entries row by row.
    Matrix,
    /// It is gone through once.
    Iterator,
    /// A list or an array: what both do alike is read.
    Either,
}

/// The number of an object, in the order in which they are made.
pub(crate) type Object = usize;

/// What was made outside of the function that is compared.
pub(crate) const FOREIGN: Object = 0;

/// A formula with its size and height.
#[derive(Debug, Clone)]
pub(crate) struct Term {
    pub(crate) expr: Expr,
    pub(crate) size: usize,
    pub(crate) height: usize,
    /// The type of its numbers.
    pub(crate) kind: Kind,
    /// Whether it may be a point, which is an array in programs.
    pub(crate) is_point: bool,
    /// The object that it is, if it is a point.
    pub(crate) object: Object,
    /// Its value, if it is a number that is written down.
    pub(crate) constant: Option<Rational>,
    /// Whether floating-point numbers that were computed may be near it, and not be it.
    pub(crate) is_rounded: bool,
    /// Whether it is an integer of an array, which NumPy raises to no negative power.
    pub(crate) is_of_array: bool,
}

/// A family of points or numbers.
#[derive(Debug, Clone)]
pub(crate) struct Family {
    pub(crate) name: String,
    /// The range of each index, both ends included, if it is declared.
    pub(crate) ranges: Vec<(Affine, Affine)>,
    pub(crate) given: Vec<Expr>,
    /// Whether its members may be points.
    pub(crate) is_of_points: bool,
    /// The type of its numbers.
    pub(crate) kind: Kind,
}

impl Term {
    /// A number that is written down.
    pub(crate) fn number(value: Rational, is_whole: bool) -> Self {
        let expr = Expr::number(&value);
        let is_leaf = value.is_integer() && !value.is_negative();
        Self {
            expr,
            size: if is_leaf { 1 } else { 3 },
            height: if is_leaf { 1 } else { 2 },
            kind: Kind::from_whole(is_whole),
            is_point: false,
            object: FOREIGN,
            constant: Some(value),
            is_rounded: false,
            is_of_array: false,
        }
    }

    /// A formula of numbers that is no number written down.
    pub(crate) fn formula(expr: Expr, kind: Kind) -> Self {
        Self {
            size: expr.size(),
            height: height(&expr),
            expr,
            kind,
            is_point: false,
            object: FOREIGN,
            constant: None,
            is_rounded: false,
            is_of_array: false,
        }
    }

    /// A call of a function of formulas.
    pub(crate) fn call(name: &str, arguments: Vec<Term>) -> Self {
        let size = arguments.iter().map(|a| a.size).sum::<usize>() + 2;
        let height = arguments.iter().map(|a| a.height).max().unwrap_or(0) + 1;
        let arguments = arguments.into_iter().map(|argument| argument.expr);
        let head = Arc::new(Expr::name(name));
        Self {
            expr: Expr::made(Node::Call(head, arguments.collect())),
            size,
            height,
            kind: Kind::Float,
            is_point: false,
            object: FOREIGN,
            constant: None,
            is_rounded: false,
            is_of_array: false,
        }
    }

    /// `self operator other`, without looking at values.
    pub(crate) fn joined(self, operator: Operator, other: Self) -> Self {
        Self {
            size: self.size + other.size + 1,
            height: self.height.max(other.height) + 1,
            kind: self.kind.joined(other.kind),
            is_point: self.is_point || other.is_point,
            object: FOREIGN,
            constant: None,
            is_rounded: false,
            is_of_array: self.is_of_array || other.is_of_array,
            expr: self.expr.with(operator, other.expr),
        }
    }

    /// The same sum of as few levels as it may have: a loop that adds a term in each turn makes a level of each.
    pub(crate) fn balanced(self) -> Self {
        let mut summands = vec![];
        let mut pending = vec![(self.expr.clone(), false)];
        while let Some((expr, is_negative)) = pending.pop() {
            match expr.node {
                Node::Binary(operator @ (Operator::Add | Operator::Subtract), left, right) => {
                    let is_subtracted = operator == Operator::Subtract;
                    pending.push((Arc::unwrap_or_clone(right), is_negative != is_subtracted));
                    pending.push((Arc::unwrap_or_clone(left), is_negative));
                }
                node => {
                    let expr = Expr::made(node);
                    summands.push(match is_negative {
                        true => Expr::made(Node::Negative(Arc::new(expr))),
                        false => expr,
                    });
                }
            }
        }
        while summands.len() > 1 {
            let mut halves = vec![];
            let mut rest = summands.into_iter();
            while let Some(left) = rest.next() {
                halves.push(match rest.next() {
                    Some(right) => left.with(Operator::Add, right),
                    None => left,
                });
            }
            summands = halves;
        }
        match summands.pop() {
            Some(expr) => Self {
                size: expr.size(),
                height: height(&expr),
                expr,
                ..self
            },
            None => self,
        }
    }

    pub(crate) fn negative(self) -> Self {
        if let Some(value) = self.constant {
            return Self {
                kind: self.kind,
                is_rounded: self.is_rounded,
                is_of_array: self.is_of_array,
                ..Self::number(-value, false)
            };
        }
        Self {
            size: self.size + 1,
            height: self.height + 1,
            kind: self.kind,
            is_point: self.is_point,
            object: FOREIGN,
            constant: None,
            is_rounded: false,
            is_of_array: false,
            expr: Expr::made(Node::Negative(Arc::new(self.expr))),
        }
    }

    /// Its value as a small integer.
    pub(crate) fn integer(&self) -> Option<i64> {
        small(self.constant.as_ref()?)
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.constant.as_ref().is_some_and(Zero::is_zero)
    }
}

/// The most levels of a formula.
fn height(expr: &Expr) -> usize {
    1 + expr.parts().into_iter().map(height).max().unwrap_or(0)
}

impl Value {
    /// The value as a formula of the language; none for what is no number, point or list of such.
    pub(crate) fn formula(self) -> Option<Term> {
        match self {
            Self::Term(term) => Some(term),
            Self::List(list) if list.shape == Shape::Iterator => None,
            Self::List(list) => {
                let items: Vec<Term> = list
                    .values
                    .into_iter()
                    .map(Self::formula)
                    .collect::<Option<_>>()?;
                let size = items.iter().map(|item| item.size).sum::<usize>() + 1;
                let height = items.iter().map(|item| item.height).max().unwrap_or(0) + 1;
                let exprs = items.into_iter().map(|item| item.expr).collect();
                Some(Term {
                    expr: Expr {
                        node: Node::List(exprs),
                        place: Place::default(),
                    },
                    size,
                    height,
                    kind: Kind::Unknown,
                    is_point: true,
                    object: FOREIGN,
                    constant: None,
                    is_rounded: false,
                    is_of_array: false,
                })
            }
            Self::Truth(_) | Self::Family(_) => None,
        }
    }

    /// How many entries it has, with those of its entries; at most so many are counted.
    pub(crate) fn entries(&self, most: usize) -> usize {
        let mut count = 1_usize;
        if let Self::List(list) = self {
            for value in &list.values {
                if count >= most {
                    break;
                }
                count = count.saturating_add(value.entries(most - count));
            }
        }
        count
    }

    /// The type that all its numbers have.
    pub(crate) fn number_kind(&self) -> Kind {
        match self {
            Self::Term(term) => term.kind,
            Self::List(list) => {
                let kinds = list.values.iter().map(Self::number_kind);
                kinds.reduce(Kind::joined).unwrap_or(Kind::Unknown)
            }
            Self::Family(family) => family.kind,
            Self::Truth(_) => Kind::Unknown,
        }
    }

    /// What it is, in words.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Term(term) if term.is_point => "a point",
            Self::Term(_) => "a number",
            Self::Truth(_) => "true or false",
            Self::List(list) => match list.shape {
                Shape::List => "a list",
                Shape::Vector => "a vector",
                Shape::Matrix => "a matrix",
                Shape::Iterator => "an iterator",
                Shape::Either => "a list or an array",
            },
            Self::Family(_) => "a family of points",
        }
    }

    /// Whether it is a list that can be changed.
    pub(crate) fn is_list(&self) -> bool {
        matches!(self, Self::List(_))
    }

    /// The objects that it consists of.
    pub(crate) fn objects(&self, into: &mut Vec<Object>) {
        match self {
            Self::List(list) => {
                into.push(list.object);
                into.extend(&list.sources);
                list.values.iter().for_each(|value| value.objects(into));
            }
            Self::Term(term) if term.is_point => into.push(term.object),
            _ => {}
        }
    }

    /// The same as an object that was made outside of the function.
    pub(crate) fn foreign(self) -> Self {
        match self {
            Self::List(list) => Self::List(List {
                object: FOREIGN,
                values: list.values.into_iter().map(Self::foreign).collect(),
                ..list
            }),
            Self::Term(term) => Self::Term(Term {
                object: FOREIGN,
                ..term
            }),
            other => other,
        }
    }

    /// The same with numbers of a declared type.
    pub(crate) fn typed(self, declared: &Type) -> Self {
        match (self, declared) {
            (value, Type::Open) => value,
            (Self::List(list), Type::Tuple(types)) if list.values.len() == types.len() => {
                let pairs = list.values.into_iter().zip(types);
                let values = pairs.map(|(value, own)| value.typed(own)).collect();
                Self::List(List { values, ..list })
            }
            (Self::List(list), own) => {
                let inner = match own {
                    Type::Each(inner) => inner,
                    other => other,
                };
                let values = list.values.into_iter().map(|value| value.typed(inner));
                Self::List(List {
                    values: values.collect(),
                    ..list
                })
            }
            (Self::Term(term), own) => Self::Term(Term {
                kind: own.number(),
                ..term
            }),
            (Self::Family(family), own) => Self::Family(Family {
                kind: own.number(),
                ..family
            }),
            (truth, _) => truth,
        }
    }

    /// Whether no number of it has the type of floating-point numbers.
    pub(crate) fn is_without_floats(&self) -> bool {
        match self {
            Self::Term(term) => term.kind != Kind::Float,
            Self::List(list) => list.values.iter().all(Self::is_without_floats),
            _ => true,
        }
    }

    /// Whether all its numbers have the type of integers.
    pub(crate) fn is_whole(&self) -> bool {
        match self {
            Self::Term(term) => term.kind.is_integer(),
            Self::List(list) => list.values.iter().all(Self::is_whole),
            _ => false,
        }
    }
}

impl List {
    /// Whether it has entries that are lists or points.
    pub(crate) fn is_nested(&self) -> bool {
        let mut values = self.values.iter();
        values.any(|value| match value {
            Value::Term(term) => term.is_point,
            _ => true,
        })
    }

    /// Whether it is a matrix of several rows and columns.
    pub(crate) fn has_rows(&self) -> bool {
        self.shape == Shape::Matrix && self.is_nested()
    }
}
