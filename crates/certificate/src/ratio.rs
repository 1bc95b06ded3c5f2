//! Quotients of polynomials, and comparisons of them with zero.

use crate::polynomial::Polynomial;
use serde::{Serialize, Serializer};
use std::fmt;
use torse_syntax::formula::Relation;

/// A quotient whose denominator is not the zero polynomial.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct Ratio<P> {
    /// The numerator.
    pub above: P,
    /// The denominator.
    pub below: P,
}

impl<P> Ratio<P> {
    /// Converts both polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Ratio<Q> {
        Ratio {
            above: change(&self.above),
            below: change(&self.below),
        }
    }
}

impl From<Polynomial> for Ratio<Polynomial> {
    fn from(above: Polynomial) -> Self {
        Self {
            above,
            below: Polynomial::one(),
        }
    }
}

impl fmt::Display for Ratio<Polynomial> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |p: &Polynomial| match p.len() {
            0 | 1 => p.to_string(),
            _ => format!("({p})"),
        };
        match self.below.as_constant() {
            Some(number) if !self.below.is_zero() => {
                write!(f, "{}", self.above.scaled(&number.recip()))
            }
            _ => write!(f, "{}/({})", part(&self.above), self.below),
        }
    }
}

/// `value relation 0`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Constraint<P> {
    /// The quotient that is compared with zero.
    pub value: Ratio<P>,
    /// The relation to zero.
    #[serde(serialize_with = "sign")]
    pub relation: Relation,
}

/// Serializes a relation by its sign.
pub(crate) fn sign<S: Serializer>(relation: &Relation, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(relation.sign())
}

impl<P> Constraint<P> {
    /// Converts the polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Constraint<Q> {
        Constraint {
            value: self.value.map(change),
            relation: self.relation,
        }
    }
}

impl fmt::Display for Constraint<Polynomial> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} 0", self.value, self.relation.sign())
    }
}
