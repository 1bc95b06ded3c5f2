//! Which roots, logarithms and arcs a part of a statement asks for.
//!
//! In `q and fails(p)` the terms of p do not count for where q is defined, nor those of q for where p is. So the claim about q
//! leaves out the symbols of the roots and logarithms that p alone contains.

use crate::{Claim, Hypothesis, Source, Statement};
use std::collections::BTreeSet;
use std::sync::Arc;

impl Claim {
    /// The claim without those symbols of roots and logarithms that none of these statements needs, nor a hypothesis of the
    /// text. Its own statement stays as it is.
    #[must_use]
    pub fn needed_by<'s>(&self, statements: impl IntoIterator<Item = &'s Statement>) -> Self {
        let mut names: BTreeSet<Arc<str>> = BTreeSet::new();
        let mut note = |name: &Arc<str>| {
            names.insert(Arc::clone(name));
        };
        for statement in statements {
            statement.declared_names(&mut note);
        }
        for hypothesis in self.hypotheses.iter().filter(|own| !is_made(own)) {
            hypothesis.statement.declared_names(&mut note);
        }
        // The argument of one may contain those before it.
        let (mut left, mut is_needed) = (vec![], true);
        let mut symbols = self.symbols.clone();
        for hypothesis in self.hypotheses.iter().rev() {
            if let Some((name, _)) = hypothesis.implicit() {
                is_needed = names.contains(name);
                if !is_needed {
                    symbols.remove(name);
                }
            }
            // That the argument of a logarithm is positive comes right before its equation.
            if is_made(hypothesis) {
                if !is_needed {
                    continue;
                }
                hypothesis.statement.declared_names(&mut |name| {
                    names.insert(Arc::clone(name));
                });
            }
            left.push(hypothesis.clone());
        }
        left.reverse();
        Self {
            symbols,
            hypotheses: left,
            unknowns: self.unknowns.clone(),
            statement: self.statement.clone(),
        }
    }
}

/// Whether a hypothesis defines the symbol of a root or a logarithm.
fn is_made(hypothesis: &Hypothesis) -> bool {
    matches!(
        hypothesis.source,
        Source::Root | Source::Logarithm | Source::Arc
    )
}
