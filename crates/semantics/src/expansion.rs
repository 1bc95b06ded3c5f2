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
}

impl<N> Expanded<N> {
    /// Whether every number that occurs does so linearly.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        self.gaps.iter().all(|gap| gap.curved.is_empty())
    }
}
