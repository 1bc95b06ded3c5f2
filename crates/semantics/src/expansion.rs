//! Values of terms to first order: what an [`Arithmetic`](crate::Arithmetic) with derivatives finds at a point.

use crate::name::Name;
use std::collections::{BTreeMap, BTreeSet};

/// An entry of a term, or left minus right of an entry of an equation, to first order.
#[derive(Debug, Clone)]
pub struct Slope<N> {
    /// The value.
    pub value: N,
    /// The rates that are not zero.
    pub rates: BTreeMap<Name, N>,
    /// The numbers that do not occur linearly.
    pub curved: BTreeSet<Name>,
}

/// All entries of all terms.
#[derive(Debug, Clone)]
pub struct Expanded<N> {
    /// The entries.
    pub gaps: Vec<Slope<N>>,
    /// Numbers that cannot be moved a little.
    pub discrete: BTreeSet<Name>,
    /// Whether two numbers that move, or formulas in them, are multiplied somewhere.
    pub multiplied: bool,
}

impl<N> Expanded<N> {
    /// Whether the entries are linear in all numbers that move, together: one step finds where they are zero.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        !self.multiplied && self.gaps.iter().all(|gap| gap.curved.is_empty())
    }
}
