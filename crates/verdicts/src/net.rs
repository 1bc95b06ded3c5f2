//! The net under every verdict.
//!
//! Before a verdict is shown, `torse_semantics` judges the claim from its core terms, by other means than the prover: a
//! proof at points of the domain, a refutation at its witness, which is put into every declared set, every hypothesis
//! and the statement, a correction like a proof. What contradicts the verdict is shown in its place: it is no verdict.

use crate::outcome::{Net, Outcome};
use torse_language::core;
use torse_language::derivation::{Claim, Written};
use torse_language::syntax::parse;
use torse_language::words::Verdict;
use torse_prove::evidence::Evidence;
use torse_semantics::{Judgement, Outside, Witness, check_witness, tally};

/// The points at which a proof is to be decided.
pub const WANTED: u64 = 20;
/// The operations on numbers that one tally may take.
const BUDGET: u64 = 300_000;

/// Judges the verdict of a claim that has a statement. A contradiction makes it undecided.
pub fn cast(outcome: &mut Outcome, claim: &Claim, statement: &Written) {
    let Ok(core) = core::Claim::new(claim, statement) else {
        return;
    };
    let found = match outcome.verdict {
        Verdict::Holds | Verdict::Conditional | Verdict::Definition => {
            proof(outcome, claim, &core, &conditions(outcome))
        }
        Verdict::False | Verdict::Misprint => refutation(outcome, claim, &core),
        Verdict::Vacuous => nowhere(outcome, &core),
        _ => return,
    };
    match found {
        Ok(net) => outcome.net = Some(net),
        Err(found) => contradicted(outcome, found),
    }
}

/// What the prover calls settled and the semantics does not.
fn contradicted(outcome: &mut Outcome, found: String) {
    let verdict = outcome.verdict;
    outcome.verdict = Verdict::Undecided;
    outcome.evidence = None;
    outcome.correction = None;
    outcome.data = None;
    outcome.witness = None;
    outcome.conditions.clear();
    outcome.steps = vec![
        format!("internal contradiction: the proof says {verdict:?}, but {found}"),
        "please report this claim".to_owned(),
    ];
    outcome.contradiction = Some(found);
}

/// A proof, with its conditions, at points of the domain.
fn proof(
    outcome: &Outcome,
    claim: &Claim,
    core: &core::Claim,
    conditions: &[Option<Written>],
) -> Result<Net, String> {
    if reads_solutions(core) {
        return Ok(Net::uncovered(
            "coefficients of what the given equations determine",
        ));
    }
    let stated: Option<Vec<core::Statement>> = conditions
        .iter()
        .map(|condition| {
            let core = core::Claim::new(claim, condition.as_ref()?).ok()?;
            Some(core.statement)
        })
        .collect();
    let Some(stated) = stated else {
        return Ok(Net::uncovered("a condition that cannot be read back"));
    };
    let tally = tally(core, &core.statement, &stated, &outcome.id, WANTED, BUDGET);
    match tally.failing {
        Some(point) => Err(format!("it is false at {point}")),
        None => {
            Ok(Net {
                tried: tally.attempts,
                decided: tally.holding,
                why: match tally.holding >= WANTED {
                    true => None,
                    false => Some(tally.why_open.unwrap_or_else(|| {
                        match (tally.exhausted, tally.found) {
                            (true, _) => "the budget is spent".to_owned(),
                            (false, 0) => "no point of the domain was drawn".to_owned(),
                            (false, _) => "it is undefined at most points".to_owned(),
                        }
                    })),
                },
            })
        }
    }
}

/// A refutation at its witness, and its correction at points of the domain.
fn refutation(outcome: &Outcome, claim: &Claim, core: &core::Claim) -> Result<Net, String> {
    if reads_solutions(core) {
        return Ok(Net::uncovered(
            "coefficients of what the given equations determine",
        ));
    }
    let Some(witness) = &outcome.witness else {
        return Ok(Net::uncovered("a refutation without a point"));
    };
    let numbers = witness
        .at
        .iter()
        .map(|(name, value)| (name.as_str(), value.as_str()));
    let net = match check_witness(core, &core.statement, numbers) {
        Witness::Refutes => Net {
            tried: 1,
            decided: 1,
            why: None,
        },
        Witness::Outside(Outside::Hypothesis {
            judgement: judgement @ (Judgement::Undecided | Judgement::Unknown(_)),
            ..
        }) => elsewhere(outcome, core, &judgement.to_string()),
        Witness::Outside(why) => {
            return Err(format!("its witness is outside of the domain: {why}"));
        }
        Witness::Stands(judgement @ (Judgement::True | Judgement::Undefined(_))) => {
            return Err(format!("the statement is {judgement} at its witness"));
        }
        Witness::Stands(judgement) => elsewhere(outcome, core, &judgement.to_string()),
        Witness::Unreadable(why) => elsewhere(outcome, core, &why.to_string()),
    };
    let Some(correction) = &outcome.correction else {
        return Ok(net);
    };
    let corrected = claim.statement.as_ref().and_then(|printed| {
        let expr = parse(&correction.statement.text).ok()?;
        let origin = printed.origin.clone();
        core::Claim::new(claim, &Written { expr, origin }).ok()
    });
    match corrected {
        Some(corrected) if !reads_solutions(&corrected) => {
            proof(outcome, claim, &corrected, &[])
                .map_err(|found| format!("the correction is wrong: {found}"))?;
            Ok(net)
        }
        _ => Ok(net),
    }
}

/// A refutation whose witness cannot be put in, because it does not name every number or speaks of functions: another
/// point at which the statement is false.
fn elsewhere(outcome: &Outcome, core: &core::Claim, why: &str) -> Net {
    let tally = tally(core, &core.statement, &[], &outcome.id, WANTED, BUDGET);
    match tally.failing {
        Some(_) => Net {
            tried: tally.attempts,
            decided: 1,
            why: None,
        },
        None => Net {
            tried: tally.attempts,
            decided: 0,
            why: Some(why.to_owned()),
        },
    }
}

/// A domain that is said to be empty.
fn nowhere(outcome: &Outcome, core: &core::Claim) -> Result<Net, String> {
    let tally = tally(core, &core.statement, &[], &outcome.id, WANTED, BUDGET);
    match tally.found {
        0 => Ok(Net {
            tried: tally.attempts,
            decided: 0,
            why: Some("no point of the domain was drawn".to_owned()),
        }),
        _ => Err("its domain has points".to_owned()),
    }
}

/// The conditions of a verdict, read back.
fn conditions(outcome: &Outcome) -> Vec<Option<Written>> {
    let source = |text: &str| torse_language::derivation::Source {
        name: outcome.id.clone(),
        text: text.to_owned(),
    };
    outcome
        .conditions
        .iter()
        .map(|condition| {
            let expr = parse(&condition.text).ok()?;
            let length = condition.text.len();
            let origin = torse_language::derivation::Origin::range(
                &std::sync::Arc::new(source(&condition.text)),
                0,
                length,
            );
            Some(Written { expr, origin })
        })
        .collect()
}

/// Whether the statement asks for coefficients while `given` determines unknowns: then forms are read with the
/// solutions put in, which has no counterpart at a point.
fn reads_solutions(core: &core::Claim) -> bool {
    !core.unknowns.is_empty()
        && core
            .statement
            .terms()
            .into_iter()
            .any(|term| term.applies(core::BuiltIn::Coefficients))
}

/// Whether a verdict rests on more than its own evidence: the statement was decided at enough points, or its witness
/// was put in.
#[must_use]
pub fn is_netted(outcome: &Outcome) -> bool {
    outcome
        .net
        .as_ref()
        .is_some_and(|net| match outcome.evidence {
            Some(Evidence::Witness) => net.decided > 0,
            _ => net.decided >= WANTED,
        })
}
