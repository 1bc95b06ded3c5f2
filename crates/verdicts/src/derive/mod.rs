//! End point derivatives and join conditions of a basis family, for every degree at once.
//!
//! A curve of the family with symbolic degree is a [`Series`](torse_prove::evaluate::series::Series); at an end
//! of its interval the symbolic power collapses, so its derivatives there are finite combinations of
//! control points with coefficients polynomial in the degree ([`end`]). Two such ends joined under a
//! condition `F1^(j) = sum over i of t[j,i] F^(i)` give a triangular system for the next control points
//! ([`join`]).
//!
//! The results are [`Derivation`]s: titled lists of equations that [`print()`] writes as text, LaTeX,
//! Typst, Rust or SymPy.
//!
//! **Differences.** Every combination of points is written `w R_0 + sum over i of s_i (R_i - R_(i-1))`
//! with s_i the sum of the coefficients from i on, the shape in which join conditions are printed. For a
//! partition of unity w is 1 for the point itself and 0 for its derivatives.

mod code;
pub mod end;
pub mod join;
mod names;
mod print;

pub use end::{Shape, end_derivatives};
pub use join::{Geometric, continuity, geometric};
pub use print::{Language, print};

use std::sync::Arc;
use torse_algebra::ExactError;
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Expr, Node, Relation};

/// Maximum order of derivatives.
pub const MAX_ORDER: u8 = 8;

/// An equation of a derivation: a name or a point, with its formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// The meaning of the equation, in words.
    pub label: String,
    /// The left side: a name (an abbreviation), or a point or derivative (a result).
    pub left: Expr,
    /// The right side, in terms of the given symbols and of the lines before.
    pub right: Expr,
}

impl Line {
    /// `left == right`.
    #[must_use]
    pub fn formula(&self) -> Expr {
        Expr::made(Node::Compare(
            Arc::new(self.left.clone()),
            vec![(Relation::Equal, self.right.clone())],
        ))
    }

    /// Whether this only defines a name for the lines that follow.
    #[must_use]
    pub fn is_abbreviation(&self) -> bool {
        matches!(self.left.node, Node::Name(_))
    }
}

/// Equations with a title and conditions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Derivation {
    /// The title.
    pub title: String,
    /// The names of the symbolic degrees.
    pub degrees: Vec<String>,
    /// The names of shape parameters and other real symbols.
    pub parameters: Vec<String>,
    /// The control points that the right sides use, in order.
    pub points: Vec<Expr>,
    /// The equations, in an order in which they can be computed.
    pub lines: Vec<Line>,
    /// Conditions: bounds of the degrees, divisors that must not vanish.
    pub conditions: Vec<Expr>,
}

/// Why a derivation failed.
#[derive(Debug, Clone, thiserror::Error)]
pub enum DeriveError {
    /// There is no basis of this name.
    #[error("there is no basis `{name}`")]
    UnknownBasis {
        /// The name.
        name: String,
    },
    /// The order is zero or too high.
    #[error("order {order} is not between 1 and {most}")]
    Order {
        /// The order asked for.
        order: u8,
        /// The maximum order.
        most: u8,
    },
    /// The seeds or the step cannot be evaluated.
    #[error("the basis `{name}` cannot be evaluated: {}", .fault.problem)]
    Basis {
        /// The basis.
        name: String,
        /// What went wrong, and where.
        fault: Box<Fault>,
    },
    /// The degree is too low or too high.
    #[error("the degree is not between {least} and {most}")]
    Degree {
        /// The degree of the seeds.
        least: u8,
        /// The maximum degree.
        most: u8,
    },
    /// The basis is a list of functions of another degree.
    #[error("the functions are listed for degree {degree} alone")]
    OneDegree {
        /// This degree.
        degree: u8,
    },
    /// The step depends on the index, so there is no formula for every degree.
    #[error("the step of `{name}` depends on the index: name a degree with `--degree`")]
    NeedsDegree {
        /// The basis.
        name: String,
    },
    /// The conditions of a join do not determine the next points.
    #[error("the conditions do not determine the next points of this family: {reason}")]
    Open {
        /// The reason.
        reason: String,
    },
    /// A value at an end of the interval does not exist.
    #[error("the basis `{name}` has no value at the end of its interval: {source}")]
    End {
        /// The basis.
        name: String,
        /// What went wrong.
        source: ExactError,
    },
    /// The variable has no finite interval with numbers as ends.
    #[error("the variable `{variable}` is declared on no interval with two numbers as ends")]
    Interval {
        /// The variable.
        variable: String,
    },
    /// The step is neither 1 nor a shift at an end, so there is no finite combination of points there.
    #[error("the step of `{name}` does not collapse at `{variable}` = {value}")]
    NoCollapse {
        /// The basis.
        name: String,
        /// Its variable.
        variable: String,
        /// The end.
        value: String,
    },
    /// A derivative at the start involves later points than its order: the join is not triangular.
    #[error("the derivative of order {order} at the start involves the point of index {index}")]
    NotTriangular {
        /// The order.
        order: usize,
        /// The offending index.
        index: usize,
    },
    /// A derivative at the start does not involve the point that it should determine.
    #[error(
        "the derivative of order {order} at the start does not determine the point of index {order}"
    )]
    Undetermined {
        /// The order.
        order: usize,
    },
}
