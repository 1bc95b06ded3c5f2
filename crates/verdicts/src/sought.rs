//! Claims that say that there are numbers.
//!
//! With a witness in the place of each number that it seeks a claim is one like all others, and is decided as such. That a witness
//! fails refutes nothing, for another one may do: `false` is such a claim only if there is a point of its domain at which the statement
//! is false of every number of the declared intervals, which is a claim of its own, about that point, and proved.

use crate::concluded::{conclude, rest_on};
use crate::meant::Meant;
use crate::outcome::{Outcome, Replay};
use crate::{condition, net, provenance};
use std::sync::Arc;
use torse_algebra::work::{self, Spent};
use torse_certificate::Proof;
use torse_certificate::proof::Emptiness;
use torse_prove::decide::Decision;
use torse_prove::{decide_statement, sought};
use torse_syntax::derivation::{Claim, DerivationError, Hypothesis, Provenance, Written};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Expr, Node};
use torse_syntax::notation::{self, Formula};
use torse_syntax::words::Verdict;

/// Decides a claim that seeks numbers, nets and replays its verdict.
///
/// # Errors
/// A [`DerivationError`] when a formula of the claim does not make sense.
pub(crate) fn decided(
    outcome: &mut Outcome,
    claim: &Claim,
    statement: &Written,
    budget: u64,
) -> Result<(), Box<DerivationError>> {
    let found = work::within(budget / 5, || sought::witnessed(claim, statement));
    let Some(found) = known(outcome, statement, found)? else {
        return Ok(());
    };
    let (own, steps) = match &found {
        Some(found) => (&found.claim, found.steps.clone()),
        None => (claim, vec![]),
    };
    let decision = work::within(budget, || decide_statement(own, statement));
    let Some(decision) = known(outcome, statement, decision)? else {
        return Ok(());
    };
    if let Decision::Proven(proof) = &decision
        && says_nothing_somewhere(proof)
    {
        outcome.steps = vec!["the witness has no value at some of the integers".to_owned()];
        return Ok(());
    }
    let weighed = provenance::weigh(own, statement, decision, budget / 5);
    conclude(outcome, weighed.decision, statement);
    provenance::record(outcome, own, &weighed.needed);
    rest_on(outcome, provenance::conditions(own, &weighed.needed));
    if outcome.verdict == Verdict::False {
        without_witness(outcome, claim, statement, budget / 5);
        if outcome.verdict != Verdict::False {
            return Ok(());
        }
    } else {
        outcome.steps.splice(0..0, steps);
    }
    if let Some(meant) = Meant::new(own, statement) {
        net::secure(outcome, &meant, budget / 5);
    }
    Ok(())
}

/// What was found; where a limit ended the work that is told, and nothing is known.
fn known<T>(
    outcome: &mut Outcome,
    statement: &Written,
    found: Result<Result<T, Fault>, Spent>,
) -> Result<Option<T>, Box<DerivationError>> {
    let limit = match found {
        Ok(Ok(found)) => return Ok(Some(found)),
        Ok(Err(fault)) if fault.is_limit() => fault.problem.to_string(),
        Ok(Err(fault)) => return Err(Box::new(fault.into_error(&statement.origin))),
        Err(spent) => spent.to_string(),
    };
    outcome.steps = vec![limit];
    Ok(None)
}

/// The claim with witnesses for all that it seeks, as its verdict was found with; the claim itself if it gives them all.
pub(crate) fn witnessed(claim: &Claim, statement: &Written, budget: u64) -> Claim {
    let found = work::within(budget, || sought::witnessed(claim, statement));
    match found {
        Ok(Ok(Some(found))) => found.claim,
        _ => claim.clone(),
    }
}

/// Whether a proof leaves out values of integers at which a term has no value: where the witness has none, nothing is shown.
fn says_nothing_somewhere<P>(proof: &Proof<P>) -> bool {
    match proof {
        Proof::Nowhere(Emptiness::Undefined(_)) => true,
        Proof::Instances(all) => all.iter().any(|one| says_nothing_somewhere(&one.proof)),
        Proof::On(ground) => says_nothing_somewhere(&ground.proof),
        Proof::Both(a, b) => says_nothing_somewhere(a) || says_nothing_somewhere(b),
        Proof::Parts(all) | Proof::Clauses(all) => all.iter().any(says_nothing_somewhere),
        Proof::Alternative { proof, .. } | Proof::Conclusion(proof) => {
            says_nothing_somewhere(proof)
        }
        // Conditions that only say where terms are defined may be those of the witness.
        Proof::Defined(_) => true,
        _ => false,
    }
}

/// A witness fails at a point: the claim is false if nothing else will do there, and not decided otherwise.
fn without_witness(outcome: &mut Outcome, claim: &Claim, statement: &Written, budget: u64) {
    let at = outcome.witness.iter().flat_map(|witness| &witness.at);
    let at: Vec<(String, String)> = at.cloned().collect();
    let point: Vec<String> = at
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    let point = match point.is_empty() {
        true => "everywhere".to_owned(),
        false => format!("at {}", point.join(", ")),
    };
    let denied = negated(&statement.expr).map(|expr| Written {
        expr,
        origin: statement.origin.clone(),
    });
    let mut there = claim.clone();
    there.sought.clear();
    for (name, value) in &at {
        let formula = Formula {
            text: format!("{name} == {value}"),
            ..Formula::default()
        };
        let Some(formula) = condition::written(&formula, &outcome.id) else {
            return unknown(outcome, &point);
        };
        there.assumptions.push(Hypothesis {
            formula,
            provenance: Provenance::Stated,
        });
    }
    let decision = denied.as_ref().map(|denied| {
        let decided = work::within(budget, || decide_statement(&there, denied));
        (denied, decided)
    });
    match decision {
        Some((denied, Ok(Ok(Decision::Proven(proof))))) if proof.conditions().is_empty() => {
            let names: Vec<&str> = claim.sought.iter().map(|s| s.name.as_str()).collect();
            let denied = notation::text(&denied.expr);
            outcome.steps.push(format!(
                "there is no {} {point}: `{denied}` holds there for all",
                names.join(", ")
            ));
            // What is kept is about the witness alone.
            outcome.grounds = None;
            outcome.difference = None;
            outcome.derived = None;
            outcome.replay = Some(Replay::beyond("that there is no other number"));
        }
        _ => unknown(outcome, &point),
    }
}

/// Nothing is decided: one witness fails.
fn unknown(outcome: &mut Outcome, point: &str) {
    outcome.verdict = Verdict::Undecided;
    outcome.evidence = None;
    outcome.witness = None;
    outcome.grounds = None;
    outcome.difference = None;
    outcome.derived = None;
    outcome.conditions.clear();
    outcome.steps = vec![format!(
        "the witness fails {point}; that no other one will do there is not shown"
    )];
}

/// The denial of a statement at a point, as far as it is made of comparisons of numbers.
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
