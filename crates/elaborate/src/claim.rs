//! Claims of derivation files to core claims.

use crate::elaborator::{Elaborator, is_about_domain, misplaced};
use crate::existential;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_core::{Claim, Hypothesis, Set, Source, Visited, stack};
use torse_syntax::derivation::{self, Written};
use torse_syntax::fault::Fault;

/// The core of a claim of a derivation file, with `statement` as its statement (the claim's own, or another one
/// about the same domain, such as a correction).
///
/// # Errors
/// [`Fault`], pointing into the text that caused it: unknown names, wrong kinds, wrong numbers of arguments.
pub fn elaborate(claim: &derivation::Claim, statement: &Written) -> Result<Claim, Fault> {
    Elaborator::new(&claim.declarations).claim(claim, statement)
}

impl Elaborator<'_> {
    /// The same as [`elaborate`], with the definitions that were opened before.
    ///
    /// # Errors
    /// As [`elaborate`].
    pub fn claim(&self, claim: &derivation::Claim, statement: &Written) -> Result<Claim, Fault> {
        stack::deep(|| self.opened_claim(claim, statement))
    }

    fn opened_claim(&self, claim: &derivation::Claim, statement: &Written) -> Result<Claim, Fault> {
        let within = |w: &Written| self.statement(&w.expr).map_err(|f| f.within(&w.origin));
        let mut hypotheses = vec![];
        for (source, texts) in [
            (Source::Assume, &claim.assumptions),
            (Source::Given, &claim.given),
        ] {
            for text in texts {
                let statement = within(&text.formula)?;
                if is_about_domain(&statement) {
                    let fault = misplaced(text.formula.expr.place);
                    return Err(fault.within(&text.formula.origin));
                }
                hypotheses.push(Hypothesis {
                    statement,
                    source,
                    origin: text.formula.origin.clone(),
                });
            }
        }
        let unknowns = claim
            .unknowns
            .iter()
            .map(|w| self.term(&w.expr).map_err(|f| f.within(&w.origin)))
            .collect::<Result<Vec<_>, _>>()?;
        let statement = match claim.existentials.as_slice() {
            [] => within(statement)?,
            sought => {
                for hypothesis in &hypotheses {
                    let refused = existential::refuse(sought, &hypothesis.statement.terms());
                    refused.map_err(|f| f.within(&hypothesis.origin))?;
                }
                existential::instantiate(self, claim, statement)?
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
        let mut symbols = self.symbols_of(names.clone());
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
                let refused = existential::refuse(&claim.existentials, &statement.terms());
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
            symbols = self.symbols_of(names.clone());
        }
        Ok(Claim {
            symbols,
            hypotheses,
            unknowns,
            statement,
        })
    }
}
