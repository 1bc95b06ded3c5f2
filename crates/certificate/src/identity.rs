//! Equality: differences without terms, and differences that are combinations of equations.

use crate::evidence::Evidence;
use serde::Serialize;

/// The sides of an equation have the same normal form, entry by entry.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Identity<P> {
    /// How the difference was seen to vanish.
    pub by: Vanishing,
    /// Whether this shows a relation of order that includes equality.
    pub in_order: bool,
    /// What was divided by on the way: the proof says nothing where one of them vanishes.
    pub divisors: Vec<P>,
}

/// How a difference vanishes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Vanishing {
    /// Its numerator has no terms.
    NormalForm,
    /// Series of symbolic degree: the step of the recursion is an operator on the seeds, of which each power of the index
    /// shift has coefficients without terms. So the difference vanishes for every degree at once.
    Series,
}

/// Each difference is a sum of multiples of expressions that are zero by hypothesis.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Combination<P> {
    /// Which hypotheses.
    pub of: Equations,
    /// The numerators that are zero by hypothesis.
    pub equations: Vec<P>,
    /// For each entry of the statement the multipliers of the equations: the numerator of its difference is the sum of the
    /// products.
    pub multipliers: Vec<Vec<P>>,
    /// What was divided by on the way.
    pub divisors: Vec<P>,
    /// Whether symbolic degrees were met.
    pub by: Vanishing,
}

/// The equations of a combination.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Equations {
    /// Assumed, with eliminated symbols put in.
    Assumed,
    /// The same, where one of them alone is not enough.
    Together,
    /// The `given` ones as they stand: nothing is solved for.
    Given,
}

impl Vanishing {
    /// What it rests on.
    #[must_use]
    pub fn evidence(self) -> Evidence {
        match self {
            Self::NormalForm => Evidence::Identity,
            Self::Series => Evidence::Induction,
        }
    }
}

impl<P> Identity<P> {
    /// The same in other polynomials.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Identity<Q> {
        Identity {
            by: self.by,
            in_order: self.in_order,
            divisors: self.divisors.iter().map(change).collect(),
        }
    }

    /// The steps in words.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        let steps: &[&str] = match (self.in_order, self.by) {
            (true, _) => &["both sides are equal identically"],
            (false, Vanishing::NormalForm) => &["the normal form of the difference has 0 terms"],
            (false, Vanishing::Series) => &[
                "both sides are written with the step of the recursion as an operator on the seeds",
                "the difference has no terms, for every degree at once",
            ],
        };
        steps.iter().map(|step| (*step).to_owned()).collect()
    }
}

impl<P> Combination<P> {
    /// The same in other polynomials.
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

    /// The steps in words.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        let step = match self.of {
            Equations::Assumed => "each difference is a multiple of an equation that is assumed",
            Equations::Together => {
                "each difference is a sum of multiples of the equations that are assumed"
            }
            Equations::Given => "the difference is a combination of the given equations",
        };
        vec![step.to_owned()]
    }
}
