//! Deciding the statement of a claim.
//!
//! A claim says that its statement is true at every point of its domain at which it is defined. So a conjunction is
//! decided part by part, and `not p` is proved by one point at which p fails. Every other statement is decided
//! symbolically, or, where a symbolic degree cannot be carried, at small values of the integers.

use crate::case_split;
use crate::connectives::DisjunctiveDomain;
use crate::decide::{self, Decision};
use crate::evaluate::Evaluator;
use crate::evidence::Witness;
use crate::term_divisors::{has_root_in_empty_sum, has_too_many_divisors};
use std::collections::BTreeMap;
use std::rc::Rc;
use torse_core::{self as core, stack};
use torse_elaborate::Elaborator;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::derivation::{Claim, Origin, Written};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Expr, Node, Place};

/// Decides a statement on the domain of a claim: the claim's own, or another one in its place.
///
/// # Errors
/// [`Fault`] when a formula makes no sense.
pub fn decide_statement(claim: &Claim, statement: &Written) -> Result<Decision, Fault> {
    with_prepared(claim, statement, |prepared| prepared.decide(&mut |_| {}))
}

/// The most sides of comparisons in one statement: each part of a chain is decided with all the others in view.
const MAX_SIDES: usize = 2000;

/// A point of the domain of a claim at which the sides of a comparison of the statement have values, if one is found.
///
/// # Errors
/// [`Fault`] when a formula makes no sense.
pub fn a_point_of(claim: &Claim, statement: &Written) -> Result<Option<Witness>, Fault> {
    with_prepared(claim, statement, |prepared| {
        Ok(prepared.parts.anywhere(&prepared.statement))
    })
}

/// Makes a statement ready on the domain of a claim, and does something with it.
///
/// # Errors
/// [`Fault`] when a formula makes no sense, and that of what is done.
pub fn with_prepared<T>(
    claim: &Claim,
    statement: &Written,
    then: impl FnOnce(&Prepared<'_>) -> Result<T, Fault>,
) -> Result<T, Fault> {
    stack::deep(|| prepared(claim, statement, then))
}

fn prepared<T>(
    claim: &Claim,
    statement: &Written,
    then: impl FnOnce(&Prepared<'_>) -> Result<T, Fault>,
) -> Result<T, Fault> {
    let elaborator = Rc::new(Elaborator::new(&claim.declarations));
    let core = elaborator.claim(claim, statement)?;
    let evaluator = Evaluator::with(Rc::clone(&elaborator));
    let asks = |own: &core::Statement| has_root_in_empty_sum(own, &evaluator);
    if asks(&core.statement) || core.hypotheses.iter().any(|own| asks(&own.statement)) {
        let what = "a root, a logarithm or an arc in a sum that may be empty";
        return Err(Fault::limit(Place::default(), what).within(&statement.origin));
    }
    // With a witness in place a divisor that is not looked at would be a condition that is not stated.
    if !claim.existentials.is_empty() && has_too_many_divisors(&core.statement, &evaluator) {
        let what =
            "a statement that divides more often, or within more binders, than can be looked at";
        return Err(Fault::limit(Place::default(), what).within(&statement.origin));
    }
    let rooted = core
        .rooted(&statement.origin)
        .map_err(|fault| fault.within(&statement.origin))?;
    let mut declarations = None;
    for (name, _) in rooted.implicit() {
        let set = rooted.symbols.get(name).cloned();
        let known = declarations.take();
        let known = known.unwrap_or_else(|| Declarations::clone(&claim.declarations));
        declarations = Some(match set {
            Some(set) => known.with_symbol(name, set),
            None => known,
        });
    }
    let (core, elaborator) = match &declarations {
        None => (rooted, elaborator),
        Some(more) => {
            let elaborator = Rc::new(Elaborator::new(more));
            let core = elaborator.claim(claim, statement)?;
            let rooted = core.rooted(&statement.origin);
            let rooted = rooted.map_err(|fault| fault.within(&statement.origin))?;
            (rooted, elaborator)
        }
    };
    if core.statement.terms().len() > MAX_SIDES {
        let what = format!("a statement that compares more than {MAX_SIDES} formulas");
        return Err(Fault::limit(Place::default(), what).within(&statement.origin));
    }
    case_split::spend_on_domain(core.hypotheses.len())
        .map_err(|limit| Fault::limit(Place::default(), limit.to_string()))?;
    let domain = |claim: &core::Claim| {
        DisjunctiveDomain::new(case_split::parts(claim), &elaborator, &statement.origin)
    };
    let (mut all, mut denials) = (vec![], BTreeMap::new());
    conjuncts(&statement.expr, &core.statement, &mut all);
    let is_denial = |part: &core::Statement| matches!(part, core::Statement::Not(_));
    let others = all.iter().copied().filter(|part| !is_denial(part));
    let own = core.needed_by(others);
    if declarations.is_some() && all.len() > 1 {
        for (number, part) in all.iter().enumerate().filter(|(_, part)| is_denial(part)) {
            denials.insert(number, domain(&core.needed_by([*part])));
        }
    }
    let parts = domain(if denials.is_empty() { &core } else { &own });
    then(&Prepared {
        parts,
        denials,
        statement: core.statement.clone(),
        written: &statement.expr,
        origin: &statement.origin,
        has_roots: declarations.is_some(),
    })
}

/// A statement that is ready to be decided: its domain is made once for all of its parts.
pub struct Prepared<'a> {
    parts: DisjunctiveDomain<'a>,
    /// The domains of the denials among several conjuncts with roots or logarithms, by their numbers: where these have
    /// values is asked for each denial alone.
    denials: BTreeMap<usize, DisjunctiveDomain<'a>>,
    statement: core::Statement,
    written: &'a Expr,
    origin: &'a Origin,
    /// Whether it has roots of formulas: symbols stand for them.
    has_roots: bool,
}

impl<'a> Prepared<'a> {
    /// Decides the statement. Calls `tell` with the decision on each conjunct, in the order of the text, up to the first that
    /// is refuted.
    ///
    /// # Errors
    /// [`Fault`] when a formula makes no sense.
    pub fn decide(&self, tell: &mut dyn FnMut(&Decision)) -> Result<Decision, Fault> {
        self.joined(self.written, &self.statement, &mut 0, tell)
            .map(|decision| self.seen(decision))
            .map_err(|fault| fault.within(self.origin))
    }

    /// Decides the statement of this number, from 0, of those that a written conjunction joins; nothing if there are not so
    /// many.
    ///
    /// # Errors
    /// [`Fault`] when a formula makes no sense.
    pub fn decide_part(&self, number: usize) -> Result<Option<Decision>, Fault> {
        let mut all = vec![];
        conjuncts(self.written, &self.statement, &mut all);
        let part = all.get(number);
        let domain = self.domain(number);
        let decision = part.map(|part| domain.decide(part)).transpose();
        decision
            .map(|decision| decision.map(|decision| self.seen(decision)))
            .map_err(|fault| fault.within(self.origin))
    }

    /// The domain of the conjunct of this number.
    fn domain(&self, number: usize) -> &DisjunctiveDomain<'a> {
        self.denials.get(&number).unwrap_or(&self.parts)
    }

    /// Decides a statement, the first conjunct of which has this number; counts its conjuncts.
    fn joined(
        &self,
        written: &Expr,
        statement: &core::Statement,
        number: &mut usize,
        tell: &mut dyn FnMut(&Decision),
    ) -> Result<Decision, Fault> {
        if let Some(((first, a), (second, b))) = halves(written, statement) {
            let decision = self.joined(first, a, number, tell)?;
            if decision.is_refuted() {
                return Ok(decision);
            }
            let other = self.joined(second, b, number, tell)?;
            return Ok(decide::both(decision, other));
        }
        let decision = self.domain(*number).decide(statement)?;
        *number += 1;
        match &decision {
            Decision::Vacuous(emptiness) => {
                tell(&self.seen(Decision::Vacuous(emptiness.clone())));
            }
            other => tell(other),
        }
        Ok(decision)
    }

    /// Turns "no points" into open where symbols stand for roots: the hypotheses may then have points, with the statement
    /// undefined at all of them.
    fn seen(&self, decision: Decision) -> Decision {
        match decision {
            Decision::Vacuous(_) if self.has_roots => Decision::open(
                "there is no point of the domain at which all roots are defined",
                &[],
            ),
            decision => decision,
        }
    }
}

/// A statement, and how it is written.
type Both<'s> = (&'s Expr, &'s core::Statement);

/// The two statements that a written conjunction joins.
fn halves<'s>(written: &'s Expr, statement: &'s core::Statement) -> Option<(Both<'s>, Both<'s>)> {
    match (&written.node, statement) {
        (
            Node::Join(Connective::And, first, second),
            core::Statement::Join(Connective::And, a, b),
        ) => Some(((first, a), (second, b))),
        _ => None,
    }
}

/// The statements that a written conjunction joins, in order.
fn conjuncts<'s>(
    written: &'s Expr,
    statement: &'s core::Statement,
    all: &mut Vec<&'s core::Statement>,
) {
    match halves(written, statement) {
        Some(((first, a), (second, b))) => {
            conjuncts(first, a, all);
            conjuncts(second, b, all);
        }
        None => all.push(statement),
    }
}
