//! Composed statements.

use super::term::Part;
use std::fmt;
use std::sync::Arc;

/// A statement.
#[derive(Debug, Clone, PartialEq)]
pub enum Statement {
    /// `a == b` and so on.
    Compare(Part, &'static str, Part),
    /// `p and q`
    And(Arc<Statement>, Arc<Statement>),
    /// `p or q`
    Or(Arc<Statement>, Arc<Statement>),
    /// `p implies q`
    Implies(Arc<Statement>, Arc<Statement>),
    /// `nonnegative(B)`
    Nonnegative(String),
    /// `at(p, x, t)`
    At(Arc<Statement>, String, Part),
}

impl Statement {
    /// `a == b`
    #[must_use]
    pub fn equal(a: &Part, b: &Part) -> Self {
        Self::Compare(Arc::clone(a), "==", Arc::clone(b))
    }

    /// The same with every term changed; `change` is told the place of each.
    #[must_use]
    pub fn with_terms(&self, change: &mut dyn FnMut(&Part) -> Part) -> Self {
        let both = |p: &Self, q: &Self, change: &mut dyn FnMut(&Part) -> Part| {
            (
                Arc::new(p.with_terms(change)),
                Arc::new(q.with_terms(change)),
            )
        };
        match self {
            Self::Compare(a, relation, b) => Self::Compare(change(a), relation, change(b)),
            Self::And(p, q) => {
                let (p, q) = both(p, q, change);
                Self::And(p, q)
            }
            Self::Or(p, q) => {
                let (p, q) = both(p, q, change);
                Self::Or(p, q)
            }
            Self::Implies(p, q) => {
                let (p, q) = both(p, q, change);
                Self::Implies(p, q)
            }
            Self::Nonnegative(name) => Self::Nonnegative(name.clone()),
            Self::At(p, by, value) => {
                Self::At(Arc::new(p.with_terms(change)), by.clone(), change(value))
            }
        }
    }

    /// How many terms it compares or puts in.
    #[must_use]
    pub fn terms(&self) -> usize {
        match self {
            Self::Compare(..) => 2,
            Self::And(p, q) | Self::Or(p, q) | Self::Implies(p, q) => p.terms() + q.terms(),
            Self::Nonnegative(_) => 0,
            Self::At(p, ..) => p.terms() + 1,
        }
    }
}

impl fmt::Display for Statement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bracketed = |p: &Self| match p {
            Self::And(..) | Self::Or(..) | Self::Implies(..) => format!("({p})"),
            _ => p.to_string(),
        };
        match self {
            Self::Compare(a, relation, b) => write!(f, "{a} {relation} {b}"),
            Self::And(p, q) => write!(f, "{} and {}", bracketed(p), bracketed(q)),
            Self::Or(p, q) => write!(f, "{} or {}", bracketed(p), bracketed(q)),
            Self::Implies(p, q) => write!(f, "{} implies {}", bracketed(p), bracketed(q)),
            Self::Nonnegative(name) => write!(f, "nonnegative({name})"),
            Self::At(p, by, value) => write!(f, "at({p}, {by}, {value})"),
        }
    }
}
