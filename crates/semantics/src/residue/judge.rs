//! What statements are at a point modulo the prime.
//!
//! Equations and their denials are judged on residues, all other statements on the numbers themselves, where none of
//! them was solved for.

use super::point::Point;
use super::{Residue, Residues};
use crate::arithmetic::Arithmetic;
use crate::evaluate::Evaluator;
use crate::gap::{Gap, Work};
use crate::judge::{self, are_integers, joined, with_printed};
use crate::judgement::Judgement;
use crate::name::Name;
use std::collections::BTreeMap;
use torse_core::{Claim, Printed, Statement, Term};
use torse_syntax::formula::Relation;

/// A point modulo the prime at which statements of a claim are judged.
pub(crate) struct Judge<'p> {
    pub claim: &'p Claim,
    pub point: &'p Point<'p, 'p>,
    /// The denials that are known to be true.
    pub denied: &'p BTreeMap<usize, ()>,
    pub work: &'p Work,
}

/// Whether some part of a statement is an equation, or says what integers are: other statements gain nothing by residues.
pub(crate) fn has_equation(statement: &Statement) -> bool {
    let mut pending = vec![statement];
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Join(_, a, b) => pending.extend([&**a, &**b]),
            Statement::Compare {
                relation: Relation::Equal,
                ..
            } => return true,
            Statement::Agrees { printed, .. } if are_integers(printed) => return true,
            _ => {}
        }
    }
    false
}

impl Judge<'_> {
    /// Judges a statement about the domain.
    pub fn judge(&self, statement: &Statement) -> Judgement {
        self.judged(statement, Some(self.claim))
    }

    /// Judges a hypothesis: what it says of coefficients is not read with the solutions of the hypotheses put in.
    pub fn hypothesis(&self, statement: &Statement) -> Judgement {
        self.judged(statement, None)
    }

    fn judged(&self, statement: &Statement, solved: Option<&Claim>) -> Judgement {
        let residues = Residues { work: self.work };
        let values = |name: &Name| self.point.residue(name);
        let at = Evaluator::new(&residues, &values).of(solved);
        joined(statement, &|part| match part {
            Statement::Compare {
                relation: relation @ (Relation::Equal | Relation::Different),
                left,
                right,
            } => equal(left, right, &at).map_or_else(Judgement::from, |equal| {
                Judgement::of(Some(equal == (*relation == Relation::Equal)))
            }),
            Statement::Agrees { value, printed, .. } if are_integers(printed) => {
                agrees(value, printed, &at)
                    .map_or_else(Judgement::from, |all| Judgement::of(Some(all)))
            }
            _ => self.exactly(part, solved),
        })
    }

    /// Judges a statement on the numbers themselves.
    fn exactly(&self, statement: &Statement, solved: Option<&Claim>) -> Judgement {
        let judge = judge::Judge {
            claim: self.claim,
            values: &|name| self.point.number(name),
            near: false,
            denied: self.denied,
            work: self.work,
        };
        match solved {
            Some(_) => judge.judge(statement),
            None => judge.hypothesis(statement),
        }
    }
}

/// Whether every entry is its printed integer.
fn agrees(
    value: &Term,
    printed: &[Printed],
    at: &Evaluator<'_, Residues<'_>>,
) -> Result<bool, Gap> {
    let mut all = true;
    for (number, printed) in with_printed(value, printed, at)? {
        all &= same(&number, &at.arithmetic.rational(&printed.value))?;
    }
    Ok(all)
}

/// Whether two residues are the same.
fn same(x: &Residue, y: &Residue) -> Result<bool, Gap> {
    match (x, y) {
        (Residue::Class(x), Residue::Class(y)) => Ok(x == y),
        _ => Err(super::missing()),
    }
}

fn equal(left: &Term, right: &Term, at: &Evaluator<'_, Residues<'_>>) -> Result<bool, Gap> {
    let pairs = at.value(left)?.pairs(&at.value(right)?, at.arithmetic)?;
    let mut all = true;
    for (x, y) in pairs {
        let (Some(x), Some(y)) = (x.as_number(), y.as_number()) else {
            return Err(Gap::shape("an infinitesimal to a comparison"));
        };
        all &= same(x, y)?;
    }
    Ok(all)
}
