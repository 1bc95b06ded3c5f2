//! Points of the domain of a claim: numbers in the declared sets that satisfy all hypotheses.
//!
//! The points form a stream seeded by a text, the claim's id, so they are the same in every run. [`set`] draws a
//! number from a declared set, which [`narrow`] has narrowed by hypotheses; [`draft`] draws numbers one after the
//! other as they are needed; [`sort`] puts them into an assumed order; [`solve`] changes some of them until the
//! assumed and given equations hold, by steps of [`newton`]; [`point`] checks the result. [`constraints`] finds the
//! hypotheses that can be used in this way, as they stand in the text.

pub(crate) mod constraints;
pub(crate) mod draft;
pub(crate) mod narrow;
pub(crate) mod newton;
pub(crate) mod point;
pub(crate) mod set;
pub(crate) mod solve;
pub(crate) mod sort;
pub(crate) mod stream;

use crate::name::Name;
use crate::tree::Reading;
use constraints::{Constraint, constraints};
use narrow::Narrowed;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Expr, Relation};

/// The conditions on the points of a claim.
pub(crate) struct Domain<'a> {
    /// The syntax trees of the claim.
    pub reading: &'a Reading<'a>,
    /// All hypotheses.
    pub hypotheses: Vec<&'a Expr>,
    /// The unknowns of the claim, which are solved for first.
    pub unknowns: Vec<&'a Expr>,
    /// The comparisons that every point satisfies.
    pub constraints: Vec<Constraint<'a>>,
    /// The sets that symbols are drawn from.
    pub narrowed: Narrowed,
}

impl<'a> Domain<'a> {
    /// The domain of a claim.
    pub fn new(reading: &'a Reading<'a>) -> Self {
        Self::with(
            reading,
            reading.hypotheses().collect(),
            reading.unknowns().collect(),
        )
    }

    /// The part of the domain of a claim in which one more hypothesis is true.
    pub fn where_true(reading: &'a Reading<'a>, further: &'a Expr) -> Self {
        let all = reading.hypotheses().chain([further]);
        Self::with(reading, all.collect(), reading.unknowns().collect())
    }

    /// The set in which one hypothesis is true, ignoring all others.
    pub fn alone(reading: &'a Reading<'a>, hypothesis: &'a Expr) -> Self {
        Self::with(reading, vec![hypothesis], vec![])
    }

    fn with(reading: &'a Reading<'a>, hypotheses: Vec<&'a Expr>, unknowns: Vec<&'a Expr>) -> Self {
        let constraints = constraints(reading.declarations(), &hypotheses);
        let narrowed = Narrowed::new(reading, &constraints);
        Self {
            reading,
            hypotheses,
            unknowns,
            constraints,
            narrowed,
        }
    }

    /// The declared set of a number.
    pub fn set(&self, name: &Name) -> Option<&'a SymbolKind> {
        self.reading.declarations().symbol(name.declared())
    }

    /// The equations among the constraints.
    pub fn equations(&self) -> Vec<(&'a Expr, &'a Expr)> {
        let all = self.constraints.iter();
        let equations = all.filter(|(relation, ..)| *relation == Relation::Equal);
        equations.map(|(_, left, right)| (*left, *right)).collect()
    }
}
