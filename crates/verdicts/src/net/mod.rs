//! The cross-check of every verdict, called the net.
//!
//! Before a verdict is shown, `torse_semantics` evaluates the claim from the trees of its text, by other means than the
//! prover: a proof at points of the domain, a refutation at its witness, which is inserted into every declared set,
//! every hypothesis and the statement. If the result contradicts the verdict, the contradiction is shown and no verdict
//! is given.
//!
//! **Conditions.** A verdict with conditions is tried on both sides of each. Where they hold, the statement must be
//! true: a point at which it is false is a contradiction. Where one of them fails, the statement should be false or
//! undefined somewhere; otherwise the condition says more than is needed. If it was true at every such point, that is
//! no contradiction, since the prover proved the weaker statement and claims nothing false about any point; but it must
//! not become an accusation of the paper either. Such a condition is reported as not seen to be needed
//! ([`ConditionCheck::seen_needed`]), the steps of the verdict say so, and the verdict is not netted.
//!
//! **Thin parts.** The text shows where a statement may fail though it holds elsewhere
//! ([`SampleStatistics::branches`]). Where the statement was decided at no point of such a part, and the checker
//! accepts no proof that the part is empty, the net names the part.
//!
//! **What is shown.** A refutation is shown only with a point that was inserted into the text. If its witness cannot be read
//! or judged, and no other point is found, the claim is undecided. A claim is undecided too if no point is found at which
//! all its terms have values: a proof says nothing about it.
//!
//! **Corrections** are proofs with conditions of their own, and are checked like proofs.

mod refutation;

use crate::agreement::{Agreement, agreement};
use crate::certificate::DecisionCertificate;
use crate::elaborated_claim::ElaboratedClaim;
use crate::finding::Finding;
use crate::judged::{ConditionCheck, Judged, MIN_VIOLATING_POINTS, Net, Replay};
use crate::outcome::Outcome;
use crate::statement::{Contradiction, EmptyDomain, ProvedStatement, RefutedStatement};
use crate::{condition, provenance, replay};
use std::sync::Arc;

use torse_algebra::work::{self, Allowance};
use torse_core as core;
use torse_prove::{self as prove, a_point_of};
use torse_semantics::tree::Reading;
use torse_semantics::{
    Identity, Judgement, SampleStatistics, Witness, Work, check_witness, identity, instances,
    judge_samples, judge_violations,
};
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Connective, Expr, Node};
use torse_syntax::notation::{self, Formula};
use torse_syntax::taxonomy::Verdict;

/// How much is tried before a verdict is believed. All limits count work, so the answer is the same on every machine.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// The required number of points for a proof.
    pub points: u64,
    /// Maximum number of operations on numbers for one statement.
    pub budget: u64,
    /// Maximum number of operations for the points at which one condition fails.
    pub condition_budget: u64,
    /// Maximum number of operations on polynomials for all small instances of one statement; 0 tries none.
    pub instance_budget: u64,
    /// Seed of the stream of points, besides the id of the claim.
    pub seed: &'static str,
}

/// The work that one proof that a thin part of a domain is empty may take, and all of one statement.
const EMPTINESS_WORK: u64 = 3_000_000;
const ALL_EMPTINESS_WORK: u64 = 15_000_000;

/// What every verdict has to pass before it is shown.
pub const DEFAULT_EFFORT: Effort = Effort {
    points: 20,
    budget: 800_000,
    condition_budget: 100_000,
    instance_budget: 0,
    seed: "",
};

/// Evaluates a proof at points, and has the checker go through it.
pub(crate) fn proved(statement: ProvedStatement, elaborated: &ElaboratedClaim<'_>) -> Finding {
    let Some(own) = elaborated.without_unneeded(&statement.needed) else {
        return Finding::undecided(
            "the statement makes no sense without the hypotheses that the proof does not need",
        );
    };
    let verdict = statement.verdict(elaborated.claim.entry.kind);
    let net = JudgedStatement::new(&own, &DEFAULT_EFFORT)
        .with_points_of(&statement.certificate)
        .proof(&statement.conditions);
    let replay = |statement: &ProvedStatement| replay::proof(statement, &own).map(Some);
    finding(verdict, statement, net, replay, |judged| {
        Finding::Proved(Box::new(judged))
    })
}

/// Evaluates a refutation at its counterexample and its correction like a proof, and has the checker go through both;
/// `budget` bounds the work to prove the correction again.
pub(crate) fn refuted(
    statement: RefutedStatement,
    elaborated: &ElaboratedClaim<'_>,
    budget: u64,
) -> Finding {
    let verdict = statement.verdict();
    let net = JudgedStatement::new(elaborated, &DEFAULT_EFFORT).refutation(&statement);
    let replay =
        |statement: &RefutedStatement| replay::refutation(statement, elaborated, budget).map(Some);
    finding(verdict, statement, net, replay, |judged| {
        Finding::Refuted(Box::new(judged))
    })
}

/// Checks that a domain has no points.
pub(crate) fn vacuous(statement: EmptyDomain, elaborated: &ElaboratedClaim<'_>) -> Finding {
    let net = JudgedStatement::new(elaborated, &DEFAULT_EFFORT).no_points();
    finding(
        Verdict::Vacuous,
        statement,
        net,
        |_| Ok(None),
        |judged| Finding::Vacuous(Box::new(judged)),
    )
}

/// Makes a finding of the prover's answer if neither check contradicts it; the checker is not asked if the net did.
fn finding<T>(
    claimed: Verdict,
    statement: T,
    net: Result<Net, Objection>,
    replay: impl FnOnce(&T) -> Result<Option<Replay>, String>,
    wrap: impl FnOnce(Judged<T>) -> Finding,
) -> Finding {
    let contradicted = |found| Finding::Contradicted(Contradiction { claimed, found });
    match net {
        Err(Objection::Contradiction(found)) => contradicted(found),
        Err(Objection::Unconfirmed(why)) => Finding::undecided(why),
        Ok(net) => match replay(&statement) {
            Err(found) => contradicted(found),
            Ok(replay) => wrap(Judged {
                statement,
                net,
                replay,
            }),
        },
    }
}

/// Why a verdict is not shown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Objection {
    /// The semantics finds the opposite of the prover's answer.
    Contradiction(String),
    /// Nothing contradicts it, but nothing outside the prover confirms it, which is required.
    Unconfirmed(String),
}

impl Objection {
    /// The same reason for a part of the statement.
    fn about(self, part: &str) -> Self {
        match self {
            Self::Contradiction(found) => Self::Contradiction(format!("{part}: {found}")),
            Self::Unconfirmed(why) => Self::Unconfirmed(format!("{part}: {why}")),
        }
    }
}

impl From<String> for Objection {
    fn from(found: String) -> Self {
        Self::Contradiction(found)
    }
}

/// Checks a verdict with this effort: returns the result, or why the verdict must not be shown. `None` if nothing was
/// decided.
pub fn judged(
    outcome: &Outcome,
    claim: &Claim,
    statement: &Written,
    effort: &Effort,
) -> Option<Result<Net, Objection>> {
    let elaborated = ElaboratedClaim::new(claim, statement)?;
    match &outcome.finding {
        Finding::Proved(judged) => {
            let proved = &judged.statement;
            let own = elaborated.without_unneeded(&proved.needed)?;
            let case = JudgedStatement::new(&own, effort);
            let case = case.with_points_of(&proved.certificate);
            Some(case.proof(&proved.conditions))
        }
        Finding::Refuted(judged) => {
            Some(JudgedStatement::new(&elaborated, effort).refutation(&judged.statement))
        }
        Finding::Vacuous(_) => Some(JudgedStatement::new(&elaborated, effort).no_points()),
        _ => None,
    }
}

/// A statement about the domain of a claim, to be judged.
struct JudgedStatement<'a> {
    claim: &'a Claim,
    statement: &'a Written,
    core: &'a core::Claim,
    seed: String,
    effort: &'a Effort,
    /// Conditions of the proof with points at which the statement fails because they do; these points are not trusted.
    excepted: Vec<(Formula, prove::Witness)>,
    /// Points at which the proof says that the parts p of `fails(p)` are false: nothing is believed of these.
    denials: Vec<prove::Witness>,
}

impl<'a> JudgedStatement<'a> {
    fn new(elaborated: &'a ElaboratedClaim<'_>, effort: &'a Effort) -> Self {
        Self {
            claim: &elaborated.claim,
            statement: elaborated.statement,
            core: &elaborated.core,
            seed: format!("{}{}", effort.seed, elaborated.claim.entry.id.get_ref()),
            effort,
            excepted: vec![],
            denials: vec![],
        }
    }

    /// The same with the points that a proof knows.
    fn with_points_of(self, certificate: &DecisionCertificate) -> Self {
        Self {
            excepted: certificate.excepted(),
            denials: certificate.denials(),
            ..self
        }
    }

    /// Fails if the core terms differ from the text; returns why they cannot be compared, if so.
    fn compare_core_terms(&self) -> Result<Option<String>, Objection> {
        match agreement(self.claim, self.statement, self.core) {
            Agreement::Differs(found) => Err(found.into()),
            Agreement::Same => Ok(None),
            Agreement::NotCompared(why) => Ok(Some(why)),
        }
    }

    /// Evaluates the statement at points of the domain; also returns whether these points say nothing.
    fn judge_samples(&self, conditions: &[Written]) -> (SampleStatistics, Option<String>) {
        let Effort { points, budget, .. } = *self.effort;
        let conditions: Vec<&Expr> = conditions.iter().map(|written| &written.expr).collect();
        let reading = self.reading();
        let tally = judge_samples(&reading, &conditions, &self.seed, points, budget);
        let blind = "its points would not reveal a slip in it".to_owned();
        (tally, reading.is_blind().then_some(blind))
    }

    /// The trees of the claim and the statement: the text, independent of the core terms.
    fn reading(&self) -> Reading<'_> {
        reading(self.claim, self.statement, self.core)
    }

    /// Puts a point that the prover names into the declared sets, the hypotheses and a statement, as they are written.
    fn place(&self, point: &prove::Witness, statement: &Expr) -> Witness {
        let numbers = point.at.iter();
        let numbers = numbers.map(|(name, value)| (name.as_str(), value.as_str()));
        check_witness(self.claim, statement, numbers)
    }

    /// Checks a proof under conditions, at points of the domain.
    fn proof(&self, conditions: &[Formula]) -> Result<Net, Objection> {
        let uncompared = self.compare_core_terms()?;
        Ok(self
            .proof_at_points(conditions)?
            .not_netted_because(uncompared))
    }

    /// The same, where the core terms were compared with the text before.
    fn proof_at_points(&self, conditions: &[Formula]) -> Result<Net, Objection> {
        let read: Option<Vec<Written>> = conditions.iter().map(|c| self.read(c)).collect();
        let Some(read) = read else {
            return Ok(Net::without_points("a condition that cannot be read back"));
        };
        let (tally, useless) = self.judge_samples(&read);
        if let Some(point) = tally.failing {
            return Err(format!("it is false at {point}").into());
        }
        if let Some(point) = tally.divided {
            return Err(Objection::Unconfirmed(format!(
                "a term of it divides by zero at {point}, which no condition excludes"
            )));
        }
        self.require_defined_point(&tally)?;
        self.fails_somewhere(&tally)?;
        self.require_reached_premise(&tally, conditions)?;
        let instances = self.instances(&read)?;
        let conditions: Vec<ConditionCheck> = conditions
            .iter()
            .zip(&read)
            .map(|(formula, condition)| self.sides(formula, condition))
            .collect();
        let unneeded = conditions.iter().find(|sides| !sides.seen_needed());
        let why = match (tally.enough, unneeded) {
            (false, _) => Some(why_few(&tally)),
            (true, _) if useless.is_some() => useless,
            (true, Some(sides)) => Some(format!(
                "no point was found at which the condition {} is needed",
                sides.condition
            )),
            (true, None) => None,
        };
        Ok(Net {
            netted: why.is_none(),
            tried: tally.attempts,
            decided: tally.holding,
            unvisited: self.unvisited(&tally),
            instances,
            why,
            conditions,
            correction: None,
        })
    }

    /// Fails unless each part p of `fails(p)` was seen to be false at a point of the domain: at one that was drawn, or
    /// at one that the prover knows, put into the text like the witness of an accusation.
    fn fails_somewhere(&self, tally: &SampleStatistics) -> Result<(), Objection> {
        for denied in &tally.unshown {
            let is_false_at = |known| self.place(known, denied) == Witness::Refutes;
            if !self.denials.iter().any(is_false_at) {
                return Err(Objection::Unconfirmed(format!(
                    "no point was seen at which {} is false",
                    notation::text(denied)
                )));
            }
        }
        Ok(())
    }

    /// Fails for an implication whose premise was true at no point at which the conditions of its proof are: it says nothing
    /// there, and the conditions may be the opposite of what it concludes.
    fn require_reached_premise(
        &self,
        tally: &SampleStatistics,
        conditions: &[Formula],
    ) -> Result<(), Objection> {
        let Node::Join(Connective::Implies, premise, _) = &self.statement.expr.node else {
            return Ok(());
        };
        let premise = notation::text(premise);
        let is_unvisited = || {
            tally
                .unvisited
                .iter()
                .any(|part| notation::text(part) == premise)
        };
        if conditions.is_empty() || !is_unvisited() {
            return Ok(());
        }
        let conditions: Vec<&str> = conditions.iter().map(|own| own.text.as_str()).collect();
        Err(Objection::Unconfirmed(format!(
            "it is proved under the condition {}, and no point was seen at which that and its premise are true",
            conditions.join(" and ")
        )))
    }

    /// What is true on the thin parts of the domain on which no point was decided; those that are proved to be empty are
    /// left out.
    fn unvisited(&self, tally: &SampleStatistics) -> Vec<String> {
        let mut allowance = Allowance::new(EMPTINESS_WORK, ALL_EMPTINESS_WORK);
        let mut is_empty = |inside: &Expr| {
            let denial = Expr::made(Node::Not(Arc::new(inside.clone())));
            allowance.within(|| self.is_replayed(&denial)) == Ok(Some(true))
        };
        let parts = tally.unvisited.iter();
        let open = parts.filter(|inside| !is_empty(inside));
        open.map(notation::text).collect()
    }

    /// Returns whether the checker accepts an unconditional proof of a statement about the same domain.
    fn is_replayed(&self, statement: &Expr) -> Option<bool> {
        let formula = notation::formula(statement);
        let (certificate, answer) = replay::decided(self.claim, &formula, EMPTINESS_WORK)?;
        Some(certificate.is_unconditional_proof() && answer.ok()?.is_whole())
    }

    /// Fails unless the statement has a value somewhere on the domain: if the drawn points leave that open, at the
    /// point that the prover found.
    fn require_defined_point(&self, tally: &SampleStatistics) -> Result<(), Objection> {
        if tally.found > 0 && !tally.is_undefined() {
            return Ok(());
        }
        let without_values = || {
            let what =
                "no point was found at which all of its terms have values, so it may say nothing";
            Objection::Unconfirmed(what.to_owned())
        };
        let known = work::within(self.effort.budget.saturating_mul(10), || {
            a_point_of(self.claim, self.statement)
        });
        let Ok(Ok(Some(known))) = known else {
            return Err(without_values());
        };
        match self.place(&known, &self.statement.expr) {
            Witness::Stands(Judgement::Undefined(_))
            | Witness::Outside(_)
            | Witness::Unreadable(_) => Err(without_values()),
            Witness::Stands(_) => Ok(()),
            Witness::Refutes => Err("it is false at a point that the prover found"
                .to_owned()
                .into()),
        }
    }

    /// The statement where a condition fails. A condition that is a hypothesis fails nowhere on the domain; it is looked
    /// at without it.
    fn sides(&self, formula: &Formula, condition: &Written) -> ConditionCheck {
        let slot = provenance::slot_of(self.claim, formula);
        let wider = slot.and_then(|slot| {
            let wider = provenance::without(self.claim, &[slot]);
            let core = torse_elaborate::elaborate(&wider, self.statement).ok()?;
            Some((wider, core))
        });
        let reading = match &wider {
            Some((claim, core)) => reading(claim, self.statement, core),
            None => self.reading(),
        };
        let budget = self.effort.condition_budget;
        let found = judge_violations(
            &reading,
            &condition.expr,
            &self.seed,
            MIN_VIOLATING_POINTS,
            budget,
        );
        let mut found = found.unwrap_or_default();
        let mut needed_at = found.needed_at.map(|point| point.to_string());
        let mut excepted = self.excepted.iter();
        if needed_at.is_none()
            && let Some((_, known)) = excepted.find(|(own, _)| own.text == formula.text)
            && self.place(known, &self.statement.expr) == Witness::Refutes
        {
            let point = known
                .at
                .iter()
                .map(|(name, value)| format!("{name} = {value}"));
            needed_at = Some(point.collect::<Vec<_>>().join(", "));
            found.failing += 1;
        }
        ConditionCheck {
            condition: formula.text.clone(),
            tried: found.attempts,
            holding: found.holding,
            failing: found.failing,
            undefined: found.undefined,
            needed_at,
        }
    }

    /// Counts the small instances that are identities.
    fn instances(&self, conditions: &[Written]) -> Result<u64, String> {
        let work = Work::new(self.effort.instance_budget);
        let mut confirmed = 0;
        if work.left() == 0 {
            return Ok(confirmed);
        }
        let reading = self.reading();
        for instance in instances(&reading) {
            match identity(&reading, &instance, &work) {
                Identity::Holds => confirmed += 1,
                // An identity may fail where a condition on integers fails.
                Identity::Differs { terms } if conditions.is_empty() => {
                    let place = match instance.to_string() {
                        none if none.is_empty() => String::new(),
                        some => format!(" at {some}"),
                    };
                    return Err(format!("its sides differ by {terms} terms{place}"));
                }
                Identity::Differs { .. } | Identity::Outside | Identity::Undefined(_) => {}
                Identity::Open(_) if work.left() == 0 => break,
                Identity::Open(_) => {}
            }
        }
        Ok(confirmed)
    }

    /// Checks a domain that is claimed to be empty.
    fn no_points(&self) -> Result<Net, Objection> {
        let _ = self.compare_core_terms()?;
        let (tally, _) = self.judge_samples(&[]);
        match tally.found {
            0 => Ok(Net {
                tried: tally.attempts,
                ..Net::without_points(
                    "no point of the domain was drawn, which does not prove that there is none",
                )
            }),
            _ => Err("its domain has points".to_owned().into()),
        }
    }

    /// Reads back a formula of the outcome, as a statement about the same domain.
    fn read(&self, formula: &Formula) -> Option<Written> {
        let written = condition::written(formula, &self.seed)?;
        torse_elaborate::elaborate(self.claim, &written).ok()?;
        Some(written)
    }
}

/// The trees of a claim and a statement about its domain, with the core claim made from them.
fn reading<'c>(claim: &'c Claim, statement: &'c Written, core: &core::Claim) -> Reading<'c> {
    let names = core.symbols.keys().map(|name| &**name);
    Reading::new(claim, &statement.expr, names)
}

/// Why a statement was not decided at more points.
fn why_few(tally: &SampleStatistics) -> String {
    let open = tally.why_open.clone();
    open.unwrap_or_else(|| {
        let why = match (tally.exhausted, tally.found) {
            (true, _) => "the budget is spent",
            (false, 0) => "no point of the domain was drawn",
            (false, _) if tally.undefined > tally.holding => "it is undefined at most points",
            (false, _) => "few points of the domain were drawn",
        };
        why.to_owned()
    })
}
