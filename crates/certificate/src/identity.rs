//! Proofs of equality: differences that vanish, and differences that are combinations of equations.

use crate::evidence::Evidence;
use serde::Serialize;

/// A proof that the two sides of an equation have the same normal form, entry by entry.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Identity<P> {
    /// How the difference is seen to vanish.
    pub by: Vanishing,
    /// Whether this proves an order relation that includes equality, such as `<=`.
    pub in_order: bool,
    /// The divisors of the computation: nothing is proved where one of them vanishes.
    pub divisors: Vec<P>,
}

/// How a difference is seen to vanish.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Vanishing {
    /// Its numerator has no terms.
    NormalForm,
    /// As a series of symbolic degree: the step of the recursion is an operator on the seeds, and the coefficient of
    /// each power of the index shift has no terms. So the difference vanishes for every degree at once.
    Series,
}

/// A proof that each difference is a combination of expressions that are zero by hypothesis.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Combination<P> {
    /// The kind of equations.
    pub of: Equations,
    /// The numerators that are zero by hypothesis.
    pub equations: Vec<P>,
    /// For each entry of the statement, the multipliers of the equations: the numerator of the difference is the sum
    /// of the products.
    pub multipliers: Vec<Vec<P>>,
    /// The divisors of the computation.
    pub divisors: Vec<P>,
    /// Whether the differences are normal forms or series of symbolic degree.
    pub by: Vanishing,
}

/// The kind of equations in a combination.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Equations {
    /// One assumed equation, with the values of eliminated symbols substituted.
    Assumed,
    /// Several assumed equations, with the values of eliminated symbols substituted.
    Together,
    /// The `given` equations as they stand, without solving them.
    Given,
}

impl Vanishing {
    /// The evidence.
    #[must_use]
    pub fn evidence(self) -> Evidence {
        match self {
            Self::NormalForm => Evidence::Identity,
            Self::Series => Evidence::Induction,
        }
    }
}

impl<P> Identity<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Identity<Q> {
        Identity {
            by: self.by,
            in_order: self.in_order,
            divisors: self.divisors.iter().map(change).collect(),
        }
    }
}

impl<P> Combination<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Combination<Q> {
        let all = |list: &[P]| list.iter().map(change).collect();
        Combination {
            of: self.of,
            equations: all(&self.equations),
            multipliers: self.multipliers.iter().map(|row| all(row)).collect(),
            divisors: all(&self.divisors),
            by: self.by,
        }
    }
}
