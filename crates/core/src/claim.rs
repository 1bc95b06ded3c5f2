//! A claim in core terms: a statement and the domain on which it is claimed.
//!
//! The claim says that its statement is true for **all** values in the declared sets that satisfy every hypothesis
//! and at which every term of the statement is defined. `given` equations are hypotheses like `assume` ones; their
//! unknowns range over all values that satisfy them. An existential symbol (`exists`) has been replaced by its
//! witness.

use crate::{Set, Statement, Term};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_syntax::derivation::Origin;

/// A claim in core terms.
#[derive(Debug, Clone)]
pub struct Claim {
    /// The declared symbols that occur in the statement, the hypotheses and the unknowns, and the symbols that occur
    /// in the declarations of their sets and index ranges.
    pub symbols: BTreeMap<Arc<str>, Set>,
    /// The hypotheses in the order of the file: `assume`, then `given`; then, for every symbol of the claim, the
    /// bounds of its declared interval that are formulas.
    pub hypotheses: Vec<Hypothesis>,
    /// The unknowns of the `given` equations: scalar symbols, coordinates or members.
    pub unknowns: Vec<Term>,
    /// The statement.
    pub statement: Statement,
}

/// One hypothesis.
#[derive(Debug, Clone)]
pub struct Hypothesis {
    /// The assumed statement.
    pub statement: Statement,
    /// The field of the claim that states it.
    pub source: Source,
    /// Where it was written.
    pub origin: Origin,
}

/// The field of a hypothesis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// `assume`, or the end of a declared interval that is a formula, see [`Interval::relations`].
    ///
    /// [`Interval::relations`]: torse_syntax::derivation::declarations::Interval::relations
    Assume,
    /// `given`
    Given,
    /// No field: the hypothesis defines the symbol of a root, see [`Claim::rooted`].
    Root,
    /// No field: the hypothesis defines the symbol of a logarithm, see [`Claim::rooted`].
    Logarithm,
    /// No field: the hypothesis defines the symbol of an arc tangent or an arc sine, see [`Claim::rooted`].
    Arc,
}
