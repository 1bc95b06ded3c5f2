//! Elaborates claims of derivation files to core claims.

use crate::elaborator::{Elaborator, is_about_domain, misplaced};
use crate::existential;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_core::{Claim, Hypothesis, Set, Source, Visited, stack};
use torse_syntax::derivation::{self, Written};
use torse_syntax::fault::Fault;

/// Elaborates a claim of a derivation file. `statement` is the claim's own statement, or another one about the same
/// domain, such as a correction.
///
/// # Errors
/// [`Fault`], which points into the text, for unknown names, wrong kinds and wrong numbers of arguments.
pub fn elaborate(claim: &derivation::Claim, statement: &Written) -> Result<Claim, Fault> {
    Elaborator::new(&claim.declarations).claim(claim, statement)
}

impl Elaborator<'_> {
    /// As [`elaborate`], reusing definitions that this elaborator has opened before.
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
                let assumed = self.hypothesis(&text.formula.expr);
                let statement = assumed.map_err(|f| f.within(&text.formula.origin))?;
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
        self.lists_are_free(&statement.expr, hypotheses.iter().map(|h| &h.statement))
            .map_err(|f| f.within(&statement.origin))?;
        let statement = match claim.existentials.as_slice() {
            [] => within(statement)?,
            existentials => {
                for hypothesis in &hypotheses {
                    let refused = existential::refuse(existentials, &hypothesis.statement.terms());
                    refused.map_err(|f| f.within(&hypothesis.origin))?;
                }
                existential::instantiate(self, claim, &hypotheses, statement)?
            }
        };
        let mut names: Vec<Arc<str>> = vec![];
        let mut add = |name: &Arc<str>| names.push(Arc::clone(name));
        // Visit the definitions that several statements share only once.
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
        // The ends of a range may contain symbols whose own ranges have formulas as ends.
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
