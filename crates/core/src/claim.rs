//! A claim in core terms: a statement, and the one domain on which it is meant.
//!
//! The claim says that its statement is true for **all** values in the declared sets that satisfy every hypothesis
//! and at which every term of the statement is defined. `given` equations are hypotheses like `assume` ones; their
//! unknowns range over all values that satisfy them. What a claim says there is (`exists`) has a witness in its place.

use crate::{Set, Statement, Term};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_syntax::derivation::Origin;

/// A claim in core terms.
#[derive(Debug, Clone)]
pub struct Claim {
    /// The declared symbols that occur in the statement, the hypotheses and the unknowns, and those in whose terms
    /// their sets and index ranges are declared.
    pub symbols: BTreeMap<Arc<str>, Set>,
    /// What is assumed, in the order of the file: `assume`, then `given`; then what the ends of declared intervals say
    /// that are formulas, of every symbol in the claim.
    pub hypotheses: Vec<Hypothesis>,
    /// The unknowns of the `given` equations: scalar symbols, coordinates or members.
    pub unknowns: Vec<Term>,
    /// The statement.
    pub statement: Statement,
}

/// One hypothesis.
#[derive(Debug, Clone)]
pub struct Hypothesis {
    /// What is assumed.
    pub statement: Statement,
    /// In which field it stands.
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
    /// No field: what the symbol of a root is, see [`Claim::rooted`].
    Root,
}
