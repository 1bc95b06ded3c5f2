//! The required value of an edited side: the other side of the equation at the sample point.

use super::subject::Subject;
use std::cell::Cell;
use std::collections::BTreeMap;
use torse_algebra::{Fraction, Rational};
use torse_prove::context::PreparedClaim;
use torse_prove::decide::domain::Constraint;
use torse_prove::decide::order::truth;
use torse_prove::evaluate::Evaluator;
use torse_prove::evaluate::quantity::Quantity;
use torse_prove::evaluate::value::{Statement, Value};
use torse_prove::probabilistic_refuter;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::Expr;

/// Maximum work of one search, in units of a visited node of a formula or a term of its value: if sines and cosines
/// stay symbols, a value has hundreds of terms.
const MAX_WORK: u64 = 800_000;

/// The side that is not edited, at a few instances of the integers, at the sample point.
pub struct Target<'a> {
    instances: Vec<(Evaluator<'a>, Vec<Fraction>)>,
    /// The terms of all values so far.
    terms: Cell<u64>,
    /// The remaining work.
    budget: Cell<u64>,
}

/// How far a candidate agrees with the other side.
#[derive(Debug, Clone, Copy)]
pub struct Agreement {
    /// The number of entries that agree at the first instance.
    pub entries: usize,
    /// Whether all entries agree at every instance.
    pub everywhere: bool,
}

impl<'a> Target<'a> {
    /// Returns the other side of the comparison that is corrected; none if it is no plain formula.
    #[must_use]
    pub fn new(claim: &'a Claim, statement: &Written, subject: &Subject) -> Option<Self> {
        let core = torse_elaborate::elaborate(claim, statement).ok()?;
        let integers: Vec<String> = core
            .symbols
            .iter()
            .filter(|(_, set)| matches!(set, SymbolKind::Integer { .. }))
            .map(|(name, _)| name.to_string())
            .collect();
        let mut instances = vec![];
        for shift in 0..2_i64 {
            // Different symbols get different integers, above the special small degrees.
            let fixed: BTreeMap<String, Fraction> = integers
                .iter()
                .enumerate()
                .map(|(position, name)| {
                    let spread = i64::try_from(position).unwrap_or(0);
                    let form = torse_algebra::Affine::symbol(name);
                    let top = claim.declarations.greatest(&form).unwrap_or(i64::MAX);
                    let least = claim.declarations.least(&form).unwrap_or(2);
                    (
                        name.clone(),
                        Fraction::integer((least + 2 + spread + shift).min(top)),
                    )
                })
                .collect();
            // An assumption may fix an integer: then there is one instance.
            let spread = PreparedClaim::new(claim, statement, fixed)
                .ok()
                .filter(|case| case.domain.constraints.iter().all(Self::possible));
            let alone = integers.is_empty() || spread.is_none();
            let case =
                spread.or_else(|| PreparedClaim::new(claim, statement, BTreeMap::new()).ok())?;
            let left = other_side(&case.statement, &subject.path)?;
            let values = left
                .entries()
                .into_iter()
                .map(|q| q.as_fraction().and_then(probabilistic_refuter::at_sample))
                .collect::<Option<Vec<_>>>()?;
            // Candidates differ from the printed formula in few places.
            let evaluator = case.evaluator.sampling();
            evaluator.elaborator().keep_parts_of(&subject.formula);
            instances.push((evaluator, values));
            if alone {
                break;
            }
        }
        Some(Self {
            instances,
            terms: Cell::new(0),
            budget: Cell::new(MAX_WORK),
        })
    }

    /// Returns how far a candidate agrees with the other side; not at all once the work is used up.
    #[must_use]
    pub fn agreement(&self, candidate: &Expr) -> Agreement {
        let entries = |(evaluator, other): &(Evaluator<'a>, Vec<Fraction>)| {
            let agreeing = self.agreeing(evaluator, other, candidate);
            (agreeing.unwrap_or(0), agreeing == Some(other.len()))
        };
        let mut instances = self.instances.iter();
        let first = instances.next().filter(|_| self.within_budget());
        let (agreeing, all) = first.map_or((0, false), entries);
        Agreement {
            entries: agreeing,
            everywhere: all && instances.all(|instance| entries(instance).1),
        }
    }

    /// Whether a candidate agrees with the other side at every instance; never once the work is used up.
    #[must_use]
    pub fn agrees(&self, candidate: &Expr) -> bool {
        self.agreement(candidate).everywhere
    }

    /// The values of a candidate at the first instance, where they are numbers.
    #[must_use]
    pub fn values(&self, candidate: &Expr) -> Option<Vec<Rational>> {
        let (evaluator, other) = self.instances.first().filter(|_| self.within_budget())?;
        let value = evaluator.evaluate(candidate).ok()?;
        let entries = value.entries().into_iter();
        let at_sample = |q: &Quantity| {
            let own = q.as_fraction().and_then(probabilistic_refuter::at_sample)?;
            own.as_rational()
        };
        let values: Vec<Rational> = entries.map(at_sample).collect::<Option<_>>()?;
        (values.len() == other.len()).then_some(values)
    }

    /// The values that are wanted of it.
    #[must_use]
    pub fn wanted(&self) -> Option<Vec<Rational>> {
        let (_, other) = self.instances.first()?;
        other.iter().map(Fraction::as_rational).collect()
    }

    /// Starts a search of its own with so much work, without reducing the rest.
    pub fn apart<T>(&self, work: u64, search: impl FnOnce() -> T) -> T {
        let before = self.spent();
        let budget = self.budget.replace(before.saturating_add(work));
        let found = search();
        let own = self.spent().saturating_sub(before);
        self.budget.set(budget.saturating_add(own));
        found
    }

    fn spent(&self) -> u64 {
        let work = self.instances.iter().map(|(e, _)| e.work());
        work.sum::<u64>().saturating_add(self.terms.get())
    }

    /// Whether more than so much work was done in all searches.
    #[must_use]
    pub fn spent_more_than(&self, work: u64) -> bool {
        self.spent() > work
    }

    /// Whether there is work left; without it nothing agrees any more.
    #[must_use]
    pub fn within_budget(&self) -> bool {
        self.spent() <= self.budget.get()
    }

    /// Whether a constraint may hold.
    fn possible(constraint: &Constraint) -> bool {
        truth(&constraint.value, constraint.relation) != Some(false)
    }

    /// Returns how many entries agree; none for a candidate that makes no sense or has another shape.
    fn agreeing(
        &self,
        evaluator: &Evaluator<'_>,
        other: &[Fraction],
        candidate: &Expr,
    ) -> Option<usize> {
        let value = evaluator.evaluate(candidate).ok()?;
        let entries = value.entries();
        let plain = entries.iter().filter_map(|q| q.as_fraction());
        let terms: usize = plain.map(|value| value.numerator().len()).sum();
        self.terms
            .set(self.terms.get().saturating_add(terms as u64));
        let agree = |(q, wanted): &(&Quantity, &Fraction)| {
            let at_sample = q.as_fraction().and_then(probabilistic_refuter::at_sample);
            at_sample.is_some_and(|found| found == **wanted)
        };
        (entries.len() == other.len()).then(|| entries.into_iter().zip(other).filter(agree).count())
    }
}

/// Returns the side of the comparison that the path does not lead into.
pub(super) fn other_side<'s>(statement: &'s Statement, path: &[usize]) -> Option<&'s Value> {
    match (statement, path) {
        (Statement::Join(_, a, b), [first, rest @ ..]) => {
            other_side(if *first == 0 { a } else { b }, rest)
        }
        (Statement::Compare { left, .. }, [1]) => Some(left),
        (Statement::Compare { right, .. }, [0]) => Some(right),
        _ => None,
    }
}
