//! The roots of a claim in its domain: those with values in other symbols are eliminated, the others are symbols with equations.

use super::given::{equations, no_unknown};
use super::{ProofContext, RootMode, plain};
use crate::decide::domain::Constraint;
use crate::decide::domain::branch::{Equation, written};
use crate::decide::root::Root;
use crate::decide::value::plain_symbol;
use crate::roots::{self, Resolved};
use crate::unknown::Unknown;
use torse_algebra::{Fraction, Polynomial, Symbol};
use torse_certificate::proof::assumptions::{Determining, RootAlong, Signed};
use torse_core::Hypothesis;
use torse_syntax::fault::Fault;
use torse_syntax::formula::Relation;

impl ProofContext<'_> {
    /// Takes the roots of which a value is found; those that are left.
    pub(super) fn resolve<'h>(
        &mut self,
        hypotheses: Vec<&'h Hypothesis>,
    ) -> Result<Vec<&'h Hypothesis>, Fault> {
        self.branch.domain.roots.clear();
        for hypothesis in &hypotheses {
            let Some((name, radicand)) = hypothesis.root() else {
                continue;
            };
            let symbol = Symbol::named(name);
            let value = self.branch.evaluator.term(radicand);
            let (false, Some(radicand)) = (
                self.branch.is_solved(&symbol),
                value.ok().as_ref().and_then(plain),
            ) else {
                continue;
            };
            match roots::resolved(&radicand, &self.branch.domain) {
                Some(found) => self.take_root(&symbol, &radicand, found)?,
                None => self.branch.domain.roots.push(Root { symbol, radicand }),
            }
        }
        while let Some((root, found)) = roots::resolved_by_others(&self.branch.domain) {
            self.take_root(&root.symbol, &root.radicand, found)?;
        }
        self.see_positive_roots();
        // Of one that an equation eliminated the radicand is still to be known.
        let open = |h: &&Hypothesis| {
            let root = h.root().map(|(name, _)| Symbol::named(name));
            root.is_some_and(|root| !self.has_root_value(&root))
        };
        Ok(hypotheses.into_iter().filter(open).collect())
    }

    /// Whether a root was given a value as such.
    pub(super) fn has_root_value(&self, root: &Symbol) -> bool {
        let root = plain_symbol(root);
        self.branch.eliminated().iter().any(|elimination| {
            let mut values = elimination.values.iter();
            let is_root = matches!(
                elimination.by,
                Determining::Root(_) | Determining::RootAlong(_)
            );
            is_root && values.any(|v| v.symbol == root)
        })
    }

    /// Gives a root this value where its radicand has a value.
    pub(super) fn take_root(
        &mut self,
        symbol: &Symbol,
        radicand: &Fraction,
        found: Resolved,
    ) -> Result<(), Fault> {
        let rooted = Signed {
            sign: found.sign,
            constraints: written(&self.branch.domain.constraints),
        };
        let value = found.value.under(radicand.conditions());
        let unknown = Unknown::new(symbol.clone()).ok_or_else(no_unknown)?;
        let by = match found.multiples.is_empty() {
            true => Equation::Root(Box::new(rooted)),
            false => Equation::RootAlong(Box::new(RootAlong {
                root: rooted,
                multiples: found.multiples,
            })),
        };
        let _ = self.branch.solve(&[(unknown, value)], by)?;
        Ok(())
    }

    /// Roots are positive where their radicands do not vanish, and a radicand does not where a hypothesis says that of its root.
    pub(super) fn see_positive_roots(&mut self) {
        for root in self.branch.domain.roots.clone() {
            let own = Polynomial::symbol(root.symbol.clone());
            let radicand = root.radicand.numerator();
            let mut found = self.branch.domain.positive_roots.iter();
            if found.any(|(symbol, _)| *symbol == root.symbol) {
                continue;
            }
            let is_stated = self.branch.domain.assumes_nonzero(&own);
            if is_stated {
                self.branch.differ_from_zero(std::slice::from_ref(radicand));
            } else if self.branch.never_zero(radicand) {
                let positive = (root.symbol.clone(), radicand.clone());
                self.branch.domain.positive_roots.push(positive);
                self.branch.domain.constraints.push(Constraint {
                    value: own.into(),
                    relation: Relation::Greater,
                });
            }
        }
    }

    /// The equations of the roots that are left. A root has a value where its radicand has one.
    pub(super) fn constrain_roots(&mut self, roots: &[&Hypothesis]) -> Result<(), Fault> {
        for hypothesis in roots {
            let within = |f: Fault| f.within(&hypothesis.origin);
            let Some((name, _)) = hypothesis.root() else {
                continue;
            };
            let statement = self.branch.evaluator.truth(&hypothesis.statement);
            let mut forms = vec![];
            statement
                .and_then(|statement| equations(&statement, &mut forms))
                .map_err(within)?;
            for form in forms {
                let value = self.branch.resolved(&form)?;
                let symbol = Symbol::named(name);
                if !self.branch.is_solved(&symbol) {
                    let own = Fraction::symbol(symbol).under(value.conditions());
                    self.branch.evaluator.fix(name.to_string(), own);
                }
                let relation = Relation::Equal;
                match self.roots_solved {
                    RootMode::Symbols => self
                        .branch
                        .domain
                        .constraints
                        .push(Constraint { value, relation }),
                    RootMode::Solved => self.vanishes(&value)?,
                }
            }
        }
        if self.roots_solved == RootMode::Solved {
            // What they are the roots of is written by them now: they are symbols like all others.
            self.branch.domain.roots.clear();
        }
        Ok(())
    }
}
