//! Values of terms to first order, computed by an [`Arithmetic`](crate::Arithmetic) with derivatives.

use crate::name::Name;
use std::collections::{BTreeMap, BTreeSet};

/// An entry of a term, or the difference of the sides of an equation, to first order.
#[derive(Debug, Clone)]
pub struct Slope<N> {
    /// The value.
    pub value: N,
    /// The derivatives that are not zero, by variable.
    pub rates: BTreeMap<Name, N>,
    /// The variables that occur nonlinearly.
    pub curved: BTreeSet<Name>,
}

/// The expansions of all entries of all terms.
#[derive(Debug, Clone)]
pub struct Expanded<N> {
    /// The entries.
    pub gaps: Vec<Slope<N>>,
    /// Numbers that must not be moved by small amounts, because they are integers.
    pub discrete: BTreeSet<Name>,
    /// Whether two variables, or formulas in them, are multiplied anywhere.
    pub multiplied: bool,
}

impl<N> Expanded<N> {
    /// Whether the entries are jointly linear in all variables, so that one Newton step finds their zero.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        !self.multiplied && self.gaps.iter().all(|gap| gap.curved.is_empty())
    }
}
