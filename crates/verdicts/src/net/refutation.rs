//! Refutations: at their counterexample, at a point that the net finds itself, or, of `fails(p)`, at all points.

use super::{JudgedStatement, Objection};
use crate::condition;
use crate::judged::Net;
use crate::statement::RefutedStatement;
use std::sync::Arc;
use torse_core as core;
use torse_semantics::{Judgement, Outside, Witness};
use torse_syntax::derivation::Written;
use torse_syntax::formula::{Connective, Expr, Node};

impl JudgedStatement<'_> {
    /// Checks a refutation at its witness, and its correction at points of the domain.
    pub(super) fn refutation(&self, refuted: &RefutedStatement) -> Result<Net, Objection> {
        let uncompared = self.compare_core_terms()?;
        let mut net = self.witness(refuted)?.not_netted_because(uncompared);
        let Some(correction) = refuted.correction() else {
            return Ok(net);
        };
        let statement = condition::written(&correction.statement, &self.seed);
        let corrected = statement
            .as_ref()
            .and_then(|statement| torse_elaborate::elaborate(self.claim, statement).ok());
        let (Some(statement), Some(corrected)) = (&statement, &corrected) else {
            net.netted = false;
            net.why = Some("the correction cannot be read back".to_owned());
            return Ok(net);
        };
        let case = JudgedStatement {
            core: corrected,
            statement,
            seed: self.seed.clone(),
            excepted: vec![],
            denials: vec![],
            ..*self
        };
        let found = case
            .proof(&correction.conditions)
            .map_err(|found| found.about("the correction is wrong"))?;
        if !found.netted {
            net.netted = false;
            net.why = found
                .why
                .as_ref()
                .map(|why| format!("the correction: {why}"));
        }
        net.correction = Some(Box::new(found));
        Ok(net)
    }

    fn witness(&self, refuted: &RefutedStatement) -> Result<Net, Objection> {
        let (denied, others) = conjuncts(&self.statement.expr);
        if let (core::Statement::Not(_), []) = (&self.core.statement, denied.as_slice()) {
            let why = "the negated statement stands in a definition";
            return Ok(Net::without_points(why));
        }
        let denials = || {
            let shown = denied.iter().map(|denied| self.denial(denied));
            let first = |kept: Result<Net, Objection>, next| if kept.is_ok() { kept } else { next };
            shown.reduce(first)
        };
        if others.is_empty() {
            return denials().unwrap_or_else(|| Ok(Net::without_points("no statement is negated")));
        }
        self.at_witness(refuted).or_else(|objection| {
            if denied.is_empty() {
                return Err(objection);
            }
            self.require_value(&others)?;
            denials().and_then(Result::ok).ok_or(objection)
        })
    }

    fn at_witness(&self, refuted: &RefutedStatement) -> Result<Net, Objection> {
        let Some(witness) = &refuted.witness else {
            return self.elsewhere("it names no point");
        };
        match self.place(witness, &self.statement.expr) {
            Witness::Refutes => Ok(Net::with_refuting_point(1)),
            Witness::Outside(Outside::Hypothesis {
                judgement: judgement @ (Judgement::Undecided | Judgement::Unknown(_)),
                ..
            }) => self.elsewhere(&judgement.to_string()),
            Witness::Outside(why) => {
                Err(format!("its witness is outside of the domain: {why}").into())
            }
            Witness::Stands(judgement @ (Judgement::True | Judgement::Undefined(_))) => {
                Err(format!("the statement is {judgement} at its witness").into())
            }
            Witness::Stands(judgement) => self.elsewhere(&judgement.to_string()),
            Witness::Unreadable(why) => self.elsewhere(&why.to_string()),
        }
    }

    /// If `fails(p)` is false, p is true at every point: a proof.
    fn denial(&self, denied: &Expr) -> Result<Net, Objection> {
        let found = self.about(denied, |case| case.proof_at_points(&[]));
        found.map_err(|found| found.about("what it denies is not shown"))
    }

    /// Fails unless these statements, joined by `and`, have a value somewhere on the domain.
    fn require_value(&self, all: &[Expr]) -> Result<(), Objection> {
        let joined = all
            .iter()
            .cloned()
            .reduce(|a, b| Expr::made(Node::Join(Connective::And, Arc::new(a), Arc::new(b))));
        match joined {
            None => Ok(()),
            Some(joined) => self.about(&joined, |case| {
                let (tally, _) = case.judge_samples(&[]);
                match case.require_defined_point(&tally) {
                    // It is false at a point, and so it has a value there.
                    Err(Objection::Contradiction(_)) => Ok(()),
                    found => found,
                }
            }),
        }
    }

    /// Judges another statement about the same domain.
    fn about<T>(
        &self,
        statement: &Expr,
        judge: impl FnOnce(&JudgedStatement<'_>) -> Result<T, Objection>,
    ) -> Result<T, Objection> {
        let statement = Written {
            expr: statement.clone(),
            origin: self.statement.origin.clone(),
        };
        let core = torse_elaborate::elaborate(self.claim, &statement);
        let core = core.map_err(|fault| Objection::Unconfirmed(fault.problem.to_string()))?;
        judge(&JudgedStatement {
            core: &core,
            statement: &statement,
            seed: self.seed.clone(),
            excepted: vec![],
            denials: vec![],
            ..*self
        })
    }

    /// Handles a refutation whose witness cannot be inserted, because it does not name every number, or is undecided
    /// there: searches for another point at which the statement is false. Without one, only the prover says that it is.
    fn elsewhere(&self, why: &str) -> Result<Net, Objection> {
        let (tally, _) = self.judge_samples(&[]);
        match tally.failing {
            Some(_) => Ok(Net::with_refuting_point(tally.attempts)),
            None => Err(Objection::Unconfirmed(format!(
                "a point at which it fails was found, but could not be inserted into the text: {why}"
            ))),
        }
    }
}

/// The statements p of the parts `fails(p)` of a conjunction, and its other parts.
fn conjuncts(statement: &Expr) -> (Vec<Expr>, Vec<Expr>) {
    let (mut denied, mut others) = (vec![], vec![]);
    let mut pending = vec![statement];
    while let Some(part) = pending.pop() {
        match &part.node {
            Node::Join(Connective::And, a, b) => pending.extend([&**b, &**a]),
            Node::Call(head, arguments) if matches!(&head.node, Node::Name(name) if name == "fails") =>
            {
                denied.extend(arguments.first().cloned());
            }
            _ => others.push(part.clone()),
        }
    }
    (denied, others)
}
