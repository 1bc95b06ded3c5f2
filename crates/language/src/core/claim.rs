//! A claim in core terms: a statement, and the one domain on which it is meant.
//!
//! The claim says that its statement is true for **all** values in the declared sets that satisfy every hypothesis
//! and at which every term of the statement is defined. `given` equations are hypotheses like `assume` ones; their
//! unknowns range over all values that satisfy them. What a claim says there is (`exists`) has a witness in its place.

use super::elaborate::Elaborator;
use super::visited::Visited;
use super::{Set, Statement, Term, sought};
use crate::derivation::{self, Origin, Written};
use crate::fault::Fault;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

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
    /// [`Interval::relations`]: crate::derivation::declarations::Interval::relations
    Assume,
    /// `given`
    Given,
    /// No field: what the symbol of a root is, see [`Claim::rooted`].
    Root,
}

impl Claim {
    /// The core of a claim of a derivation file, with `statement` as its statement (the claim's own, or another one
    /// about the same domain, such as a correction).
    ///
    /// # Errors
    /// [`Fault`], pointing into the text that caused it: unknown names, wrong kinds, wrong numbers of arguments.
    pub fn new(claim: &derivation::Claim, statement: &Written) -> Result<Self, Fault> {
        let elaborator = Elaborator::new(&claim.declarations);
        Self::elaborated(&elaborator, claim, statement)
    }

    /// The same with an elaborator that has opened the definitions before.
    ///
    /// # Errors
    /// As [`Claim::new`].
    pub fn elaborated(
        elaborator: &Elaborator<'_>,
        claim: &derivation::Claim,
        statement: &Written,
    ) -> Result<Self, Fault> {
        let within = |w: &Written| {
            elaborator
                .statement(&w.expr)
                .map_err(|f| f.within(&w.origin))
        };
        let mut hypotheses = vec![];
        for (source, texts) in [
            (Source::Assume, &claim.assumptions),
            (Source::Given, &claim.given),
        ] {
            for text in texts {
                hypotheses.push(Hypothesis {
                    statement: within(&text.formula)?,
                    source,
                    origin: text.formula.origin.clone(),
                });
            }
        }
        let unknowns = claim
            .unknowns
            .iter()
            .map(|w| elaborator.term(&w.expr).map_err(|f| f.within(&w.origin)))
            .collect::<Result<Vec<_>, _>>()?;
        let statement = match claim.sought.as_slice() {
            [] => within(statement)?,
            sought => {
                for hypothesis in &hypotheses {
                    let refused = sought::refuse(sought, &hypothesis.statement.terms());
                    refused.map_err(|f| f.within(&hypothesis.origin))?;
                }
                sought::put_in(elaborator, claim, statement)?
            }
        };
        let mut names: Vec<Arc<str>> = vec![];
        let mut add = |name: &Arc<str>| names.push(Arc::clone(name));
        // Statements of one claim share the definitions that they use.
        let mut seen = Visited::default();
        for hypothesis in &hypotheses {
            hypothesis.statement.further_names(&mut seen, &mut add);
        }
        for unknown in &unknowns {
            unknown.further_names(&mut seen, &mut add);
        }
        statement.further_names(&mut seen, &mut add);
        let mut symbols = elaborator.symbols_of(names.clone());
        let mut bounded: BTreeSet<Arc<str>> = BTreeSet::new();
        // What the ends of a range say may name symbols whose ranges have such ends again.
        while let Some((name, relations)) = symbols.iter().find_map(|(name, set)| match set {
            Set::Real(interval) if interval.formulas().next().is_some() => {
                (!bounded.contains(name)).then(|| (Arc::clone(name), interval.relations(name)))
            }
            _ => None,
        }) {
            for relation in relations {
                let statement = within(&relation)?;
                let refused = sought::refuse(&claim.sought, &statement.terms());
                refused.map_err(|f| f.within(&relation.origin))?;
                statement.further_names(&mut seen, &mut |name: &Arc<str>| {
                    names.push(Arc::clone(name));
                });
                hypotheses.push(Hypothesis {
                    statement,
                    source: Source::Assume,
                    origin: relation.origin,
                });
            }
            bounded.insert(name);
            symbols = elaborator.symbols_of(names.clone());
        }
        Ok(Self {
            symbols,
            hypotheses,
            unknowns,
            statement,
        })
    }
}
