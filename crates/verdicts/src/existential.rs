//! Existential claims: "there are numbers such that ...".
//!
//! With a witness in place of each such number, the claim is decided like any other. That a witness fails refutes
//! nothing, since another one may do. An existential claim is `false` only if there is a point of its domain at which
//! the statement is false for every number of the declared intervals; that is a claim about this point, and it is
//! proved.

use crate::conclusion::{Conclusion, conclude};
use crate::elaborated_claim::ElaboratedClaim;
use crate::finding::Finding;
use crate::judged::Judged;
use crate::statement::{
    EmptyDomain, NoNumber, ProvedStatement, RefutedStatement, UndecidedStatement,
};
use crate::{condition, net, provenance, words};
use std::sync::Arc;
use torse_algebra::work::{self, Spent};
use torse_certificate::Proof;
use torse_certificate::proof::Emptiness;
use torse_prove::decide::Decision;
use torse_prove::{decide_statement, existential};
use torse_syntax::derivation::{Claim, DerivationError, Hypothesis, Provenance, Written};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Expr, Node};
use torse_syntax::notation::{self, Formula};

/// Decides an existential claim, and cross-checks the result.
///
/// # Errors
/// A [`DerivationError`] if a formula of the claim makes no sense.
pub(crate) fn decided(
    claim: &Claim,
    statement: &Written,
    budget: u64,
) -> Result<Finding, Box<DerivationError>> {
    let found = work::within(budget / 5, || existential::find_witnesses(claim, statement));
    let found = match unless_limited(statement, found)? {
        Ok(found) => found,
        Err(limit) => return Ok(Finding::undecided(limit)),
    };
    let (own, witnesses) = match &found {
        Some(found) => (&found.claim, found.witnesses.clone()),
        None => (claim, vec![]),
    };
    let decision = work::within(budget, || decide_statement(own, statement));
    let decision = match unless_limited(statement, decision)? {
        Ok(decision) => decision,
        Err(limit) => return Ok(Finding::undecided(limit)),
    };
    if let Decision::Proven(proof) = &decision
        && says_nothing_somewhere(proof)
    {
        let why = "the witness has no value at some of the integers";
        return Ok(Finding::undecided(why));
    }
    let Some(elaborated) = ElaboratedClaim::new(own, statement) else {
        let why = "the statement with its witness cannot be read back for the cross-check";
        return Ok(Finding::undecided(why));
    };
    let minimized = provenance::minimize_hypotheses(own, statement, decision, budget / 5);
    Ok(match conclude(own, statement, minimized) {
        Conclusion::Proved(proved) => {
            // Beyond the ranges another witness may do where this one fails.
            let proved = ProvedStatement {
                ranges: vec![],
                witnesses,
                ..proved
            };
            match net::proved(proved, &elaborated) {
                Finding::Proved(judged) => Finding::Proved(Box::new(Judged {
                    net: judged.net.with_own_witness(),
                    ..*judged
                })),
                finding => finding,
            }
        }
        Conclusion::Refuted(refuted) => {
            match without_witness(*refuted, claim, statement, budget / 5) {
                Ok(refuted) => net::refuted(refuted, &elaborated, budget / 5),
                Err(why) => Finding::undecided(why),
            }
        }
        Conclusion::Vacuous(empty) => net::vacuous(EmptyDomain { witnesses, ..empty }, &elaborated),
        Conclusion::Undecided(open) => Finding::Undecided(UndecidedStatement {
            reasons: witnesses
                .iter()
                .map(words::found_witness)
                .chain(open.reasons)
                .collect(),
            ..open
        }),
    })
}

/// The result, or the limit that ended the work.
fn unless_limited<T>(
    statement: &Written,
    found: Result<Result<T, Fault>, Spent>,
) -> Result<Result<T, String>, Box<DerivationError>> {
    match found {
        Ok(Ok(found)) => Ok(Ok(found)),
        Ok(Err(fault)) if fault.is_limit() => Ok(Err(fault.problem.to_string())),
        Ok(Err(fault)) => Err(Box::new(fault.into_error(&statement.origin))),
        Err(spent) => Ok(Err(spent.to_string())),
    }
}

/// Returns the claim with the same witnesses for its existential numbers as its verdict used; the claim itself if it
/// provides them all.
pub(crate) fn witnessed(claim: &Claim, statement: &Written, budget: u64) -> Claim {
    let found = work::within(budget, || existential::find_witnesses(claim, statement));
    match found {
        Ok(Ok(Some(found))) => found.claim,
        _ => claim.clone(),
    }
}

/// Whether the proof skips instances where a term (possibly the witness) is undefined: there nothing is shown.
fn says_nothing_somewhere<P>(proof: &Proof<P>) -> bool {
    match proof {
        Proof::Nowhere(Emptiness::Undefined(_)) => true,
        Proof::Instances(all) => all.iter().any(|one| says_nothing_somewhere(&one.proof)),
        Proof::On(ground) => says_nothing_somewhere(&ground.proof),
        Proof::Both(a, b) => says_nothing_somewhere(a) || says_nothing_somewhere(b),
        Proof::Parts(all) | Proof::Clauses(all) => all.iter().any(says_nothing_somewhere),
        Proof::Sides(sides) => {
            says_nothing_somewhere(&sides.above) || says_nothing_somewhere(&sides.below)
        }
        Proof::Alternative { proof, .. } | Proof::Conclusion(proof) => {
            says_nothing_somewhere(proof)
        }
        // Conditions that only make terms defined may come from the witness.
        Proof::Defined(_) | Proof::Within { .. } => true,
        _ => false,
    }
}

/// Handles a witness that fails at a point: refutes the claim if no other number will do there.
///
/// # Errors
/// Another number might do, in words.
fn without_witness(
    refuted: RefutedStatement,
    claim: &Claim,
    statement: &Written,
    budget: u64,
) -> Result<RefutedStatement, String> {
    let at = refuted.witness.iter().flat_map(|witness| &witness.at);
    let at: Vec<(String, String)> = at.cloned().collect();
    let unknown = || {
        let place = words::place(&at);
        format!("the witness fails {place}; it is not shown that no other number works there")
    };
    let mut there = claim.clone();
    there.existentials.clear();
    for (name, value) in &at {
        let formula = Formula {
            text: format!("{name} == {value}"),
        };
        let id = claim.entry.id.get_ref();
        let formula = condition::written(&formula, id).ok_or_else(unknown)?;
        there.assumptions.push(Hypothesis {
            formula,
            provenance: Provenance::Stated,
        });
    }
    let denied = Written {
        expr: negated(&statement.expr).ok_or_else(unknown)?,
        origin: statement.origin.clone(),
    };
    let decided = work::within(budget, || decide_statement(&there, &denied));
    let is_proved = |decision: &Decision| match decision {
        Decision::Proven(proof) => proof.conditions().is_empty(),
        _ => false,
    };
    if !decided
        .ok()
        .and_then(Result::ok)
        .as_ref()
        .is_some_and(is_proved)
    {
        return Err(unknown());
    }
    let names = claim.existentials.iter().map(|s| s.name.clone()).collect();
    let no_number = NoNumber {
        names,
        opposite: notation::formula(&denied.expr),
        at,
    };
    // The sides and the refutation as data belong to the one witness that was tried.
    Ok(RefutedStatement {
        no_number: Some(no_number),
        difference: None,
        derived: None,
        certificate: None,
        ..refuted
    })
}

/// Returns the negation of a statement at a point, as far as it consists of comparisons of numbers.
fn negated(expr: &Expr) -> Option<Expr> {
    let both =
        |connective, a: Expr, b: Expr| Expr::made(Node::Join(connective, Arc::new(a), Arc::new(b)));
    match &expr.node {
        Node::Compare(first, rest) => {
            let mut left = &**first;
            let mut denied: Option<Expr> = None;
            for (relation, right) in rest {
                let pair = vec![(relation.opposite(), right.clone())];
                let link = Expr::made(Node::Compare(Arc::new(left.clone()), pair));
                denied = Some(match denied {
                    None => link,
                    Some(before) => both(Connective::Or, before, link),
                });
                left = right;
            }
            denied
        }
        Node::Join(Connective::And, a, b) => Some(both(Connective::Or, negated(a)?, negated(b)?)),
        Node::Join(Connective::Or, a, b) => Some(both(Connective::And, negated(a)?, negated(b)?)),
        Node::Join(Connective::Implies, a, b) => {
            Some(both(Connective::And, (**a).clone(), negated(b)?))
        }
        _ => None,
    }
}
