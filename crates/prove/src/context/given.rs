//! The given equations of a claim, and their solution for the unknowns.

use super::ProofContext;
use crate::decide::domain::branch::Equation;
use crate::evaluate::Evaluator;
use crate::evaluate::linear::solve_for;
use crate::evaluate::value::{Statement, UNPLACED};
use crate::unknown::Unknown;
use std::collections::BTreeMap;
use torse_algebra::{Fraction, Symbol};
use torse_core::{self as core, Source};
use torse_syntax::derivation::Written;
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Relation};

impl ProofContext<'_> {
    /// The differences of the sides of the given equations.
    ///
    /// # Errors
    /// [`Fault`], pointing into the equation that caused it.
    pub fn given(&self, claim: &core::Claim) -> Result<Vec<Fraction>, Fault> {
        let hypotheses = claim.hypotheses.iter();
        let mut forms = vec![];
        for hypothesis in hypotheses.filter(|h| h.source == Source::Given) {
            let statement = self.branch.evaluator.truth(&hypothesis.statement);
            let taken = statement.and_then(|statement| equations(&statement, &mut forms));
            taken.map_err(|f| f.within(&hypothesis.origin))?;
        }
        Ok(forms)
    }

    /// The symbols that the unknowns of the given equations consist of.
    ///
    /// # Errors
    /// [`Fault`] for what is no symbol.
    pub fn unknowns(&self, claim: &core::Claim) -> Result<Vec<Unknown>, Fault> {
        unknowns(&self.branch.evaluator, &claim.unknowns)
    }

    /// Solves the given equations for their unknowns; what is left of them is assumed.
    pub(super) fn solve(&mut self, forms: &[Fraction], claim: &core::Claim) -> Result<(), Fault> {
        let mut given = claim.hypotheses.iter();
        let Some(first) = given.find(|h| h.source == Source::Given) else {
            return Ok(());
        };
        let symbols = self.unknowns(claim)?;
        let within = |f: Fault| f.within(&first.origin);
        let solution = solve_for(forms, &symbols, UNPLACED).map_err(within)?;
        // Where a divisor vanishes, an unknown may be what its value does not say.
        let divisors = solution.values.values().flat_map(Fraction::conditions);
        let divisors = self.branch.divisors(&divisors.cloned().collect::<Vec<_>>());
        let values = solution.values.iter().map(|(symbol, value)| {
            let unknown = Unknown::new(symbol.clone()).ok_or_else(no_unknown)?;
            Ok((unknown, value.clone()))
        });
        let values = values.collect::<Result<Vec<_>, Fault>>()?;
        let places = solution.used.clone();
        let equation = Equation::Given { places, divisors };
        let _ = self.branch.solve(&values, equation).map_err(within)?;
        solution
            .rest
            .iter()
            .try_for_each(|form| self.vanishes(form).map_err(within))
    }
}

pub(super) fn no_unknown() -> Fault {
    Fault::limit(UNPLACED, "a function of unknowns in the place of one")
}

/// The unknowns that terms stand for.
pub(super) fn unknowns(
    evaluator: &Evaluator<'_>,
    written: &[core::Term],
) -> Result<Vec<Unknown>, Fault> {
    let mut symbols = vec![];
    for unknown in written {
        for entry in evaluator.term(unknown)?.entries() {
            let symbol = entry.as_fraction().and_then(Unknown::from_fraction);
            symbols.push(symbol.ok_or_else(|| {
                crate::evaluate::wrong_type(unknown.place, "a formula", "an unknown such as Q[1]")
            })?);
        }
    }
    Ok(symbols)
}

/// The solution of given equations for their unknowns, for an evaluator without a domain.
///
/// # Errors
/// [`Fault`], pointing into the text that caused it; equations that contradict each other.
pub fn solve_given(
    given: &[Written],
    sought: &[Written],
    evaluator: &Evaluator<'_>,
) -> Result<BTreeMap<Symbol, Fraction>, Fault> {
    let Some(first) = given.first() else {
        return Ok(BTreeMap::new());
    };
    let mut symbols = vec![];
    for unknown in sought {
        let within = |f: Fault| f.within(&unknown.origin);
        let term = evaluator.elaborator().term(&unknown.expr).map_err(within)?;
        symbols.extend(unknowns(evaluator, &[term]).map_err(within)?);
    }
    let mut forms = vec![];
    for equation in given {
        let statement = evaluator
            .statement(&equation.expr)
            .map_err(|f| f.within(&equation.origin))?;
        equations(&statement, &mut forms).map_err(|f| f.within(&equation.origin))?;
    }
    let solution = solve_for(&forms, &symbols, UNPLACED).map_err(|f| f.within(&first.origin))?;
    if !solution.rest.is_empty() {
        let what = "the given equations contradict each other for some values";
        return Err(Fault::limit(UNPLACED, what).within(&first.origin));
    }
    Ok(solution.values)
}

pub(super) fn equations(statement: &Statement, forms: &mut Vec<Fraction>) -> Result<(), Fault> {
    match statement {
        Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
            ..
        } => {
            for (x, y) in left.entries().into_iter().zip(right.entries()) {
                let difference = x.minus(y);
                let form = difference.as_fraction().cloned();
                forms.push(form.ok_or_else(|| {
                    Fault::limit(UNPLACED, "a given equation of symbolic degree")
                })?);
            }
            Ok(())
        }
        Statement::Join(Connective::And, a, b) => {
            equations(a, forms)?;
            equations(b, forms)
        }
        _ => Err(Fault::limit(
            UNPLACED,
            "a given condition that is no equation",
        )),
    }
}
