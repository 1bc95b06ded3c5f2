//! Values of a program that is run on symbols.

use crate::grammar::small;
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
    /// A list or a tuple.
    List(Vec<Value>),
    /// A list that is added and multiplied by numbers entry by entry.
    Vector(Vec<Value>),
    /// A family of the claim, with the indices that are given so far.
    Family(Family),
}

/// A formula with its size and height.
#[derive(Debug, Clone)]
pub(crate) struct Term {
    pub(crate) expr: Expr,
    pub(crate) size: usize,
    pub(crate) height: usize,
    /// Whether it has the type of integers.
    pub(crate) is_whole: bool,
    /// Its value, if it is a number that is written down.
    pub(crate) constant: Option<Rational>,
}

/// A family of points or numbers.
#[derive(Debug, Clone)]
pub(crate) struct Family {
    pub(crate) name: String,
    /// The range of each index, both ends included, if it is declared.
    pub(crate) ranges: Vec<(Affine, Affine)>,
    pub(crate) given: Vec<Expr>,
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
            is_whole,
            constant: Some(value),
        }
    }

    /// A formula that is no number.
    pub(crate) fn formula(expr: Expr, is_whole: bool) -> Self {
        Self {
            size: expr.size(),
            height: height(&expr),
            expr,
            is_whole,
            constant: None,
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
            is_whole: false,
            constant: None,
        }
    }

    /// `self operator other`, without looking at values.
    pub(crate) fn joined(self, operator: Operator, other: Self) -> Self {
        Self {
            size: self.size + other.size + 1,
            height: self.height.max(other.height) + 1,
            is_whole: self.is_whole && other.is_whole,
            constant: None,
            expr: self.expr.with(operator, other.expr),
        }
    }

    pub(crate) fn negative(self) -> Self {
        if let Some(value) = self.constant {
            return Self::number(-value, self.is_whole);
        }
        Self {
            size: self.size + 1,
            height: self.height + 1,
            is_whole: self.is_whole,
            constant: None,
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
            Self::List(items) | Self::Vector(items) => {
                let items: Vec<Term> = items
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
                    is_whole: false,
                    constant: None,
                })
            }
            Self::Truth(_) | Self::Family(_) => None,
        }
    }

    /// What it is, in words.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Term(_) => "a number",
            Self::Truth(_) => "true or false",
            Self::List(_) => "a list",
            Self::Vector(_) => "a vector",
            Self::Family(_) => "a family of points",
        }
    }

    /// Whether it is a list that can be changed.
    pub(crate) fn is_list(&self) -> bool {
        matches!(self, Self::List(_) | Self::Vector(_))
    }
}
