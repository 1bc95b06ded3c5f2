//! The net under verdicts: statements are judged at points of their domain.
//!
//! A proof that a point of the domain contradicts is wrong, and so is a refutation whose witness lies outside of the
//! domain or satisfies the statement. Neither needs to know how the verdict was found.

use crate::domain::point::{Outside, Point, check_hypotheses, check_sets, drawn};
use crate::gap::Work;
use crate::judge::{Judge, Judgement, address};
use crate::name::Name;
use crate::real::Real;
use std::collections::BTreeMap;
use torse_language::core::{Claim, Hypothesis, Source, Statement};
use torse_language::derivation::{Origin, Source as Text};
use torse_language::syntax::Relation;

/// Attempts for each wanted point, and at least.
const ATTEMPTS_PER_POINT: u64 = 12;
const LEAST_ATTEMPTS: u64 = 60;
/// The work of one judgement of a point that the caller names.
const POINT_WORK: u64 = 2_000_000;

/// What was found at points of the domain of a claim.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tally {
    /// Points that were drawn; those outside of the domain are not counted as found.
    pub attempts: u64,
    /// Points of the domain at which the statement was judged.
    pub found: u64,
    /// Points at which it is true.
    pub holding: u64,
    /// The first point at which it is false. No further points are drawn then.
    pub failing: Option<Point>,
    /// Points at which it is undefined: the claim says nothing there.
    pub undefined: u64,
    /// Points at which it was not decided, and why at the first of them.
    pub open: u64,
    /// The reason at the first open point.
    pub why_open: Option<String>,
    /// Points of the domain at which a condition is not true: they are not judged further.
    pub excepted: u64,
    /// Whether the budget was spent.
    pub exhausted: bool,
}

impl Tally {
    /// Points at which the statement was decided.
    #[must_use]
    pub fn decided(&self) -> u64 {
        self.holding + u64::from(self.failing.is_some())
    }
}

/// Judges a statement about the domain of a claim at a point.
///
/// The point is not asked whether it belongs to the domain: see [`check`].
#[must_use]
pub fn judge(claim: &Claim, statement: &Statement, point: &Point) -> Judgement {
    let work = Work::new(POINT_WORK);
    let denied = BTreeMap::new();
    let judge = Judge {
        claim,
        values: &|name: &Name| point.values.get(name).cloned(),
        near: point.near,
        denied: &denied,
        work: &work,
    };
    judge.judge(statement)
}

/// Whether a point belongs to the domain of a claim, and what the statement is there.
///
/// # Errors
/// [`Outside`]: a number is not in its declared set, or a hypothesis is not true.
pub fn check(claim: &Claim, statement: &Statement, point: &Point) -> Result<Judgement, Outside> {
    let work = Work::new(POINT_WORK);
    let denied = BTreeMap::new();
    let judge = Judge {
        claim,
        values: &|name: &Name| point.values.get(name).cloned(),
        near: point.near,
        denied: &denied,
        work: &work,
    };
    check_sets(claim, &point.values)?;
    check_hypotheses(&judge)?;
    Ok(judge.judge(statement))
}

/// Judges `statement` at points of the domain of the claim until it is decided at `wanted` of them, found to be false
/// at one, or the budget (in operations on numbers) is spent. Only points at which all `conditions` are true count.
///
/// The points are a function of the claim and the seed.
#[must_use]
pub fn tally(
    claim: &Claim,
    statement: &Statement,
    conditions: &[Statement],
    seed: &str,
    wanted: u64,
    budget: u64,
) -> Tally {
    let work = Work::new(budget);
    let mut denied = BTreeMap::new();
    settle(statement, claim, seed, wanted, &work, &mut denied);
    let mut tally = Tally::default();
    let share = (budget / wanted.max(1)).saturating_mul(2);
    while tally.attempts < LEAST_ATTEMPTS.max(ATTEMPTS_PER_POINT * wanted)
        && tally.decided() < wanted
        && tally.failing.is_none()
    {
        let attempt = tally.attempts;
        tally.attempts += 1;
        if work.left() == 0 {
            tally.exhausted = true;
            break;
        }
        let own = Work::new(share.min(work.left()));
        one(
            claim, statement, conditions, seed, attempt, &own, &denied, &mut tally,
        );
        let spent = share.min(work.left()) - own.left();
        let _ = work.spend(spent);
    }
    tally
}

#[expect(clippy::too_many_arguments, reason = "the body of one loop")]
fn one(
    claim: &Claim,
    statement: &Statement,
    conditions: &[Statement],
    seed: &str,
    attempt: u64,
    work: &Work,
    denied: &BTreeMap<usize, ()>,
    tally: &mut Tally,
) {
    let Some((draft, near)) = drawn(claim, seed, attempt, work) else {
        return;
    };
    let judge = Judge {
        claim,
        values: &|name| draft.value(name),
        near,
        denied,
        work,
    };
    if conditions.iter().any(|c| judge.judge(c) != Judgement::True) {
        tally.excepted += 1;
        return;
    }
    let judgement = judge.judge(statement);
    if draft.empty.get() {
        return;
    }
    tally.found += 1;
    match judgement {
        Judgement::True => tally.holding += 1,
        Judgement::False => {
            tally.failing = Some(Point {
                values: draft.values(),
                near,
            });
        }
        Judgement::Undefined(_) => tally.undefined += 1,
        open @ (Judgement::Undecided | Judgement::Unknown(_)) => {
            tally.open += 1;
            tally.why_open.get_or_insert_with(|| open.to_string());
        }
    }
}

/// Finds, for each `not p` of a statement, a point of the domain at which p is false: `not p` is true then.
fn settle(
    statement: &Statement,
    claim: &Claim,
    seed: &str,
    wanted: u64,
    work: &Work,
    denied: &mut BTreeMap<usize, ()>,
) {
    let mut pending = vec![statement];
    let mut inner = vec![];
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Join(_, a, b) => pending.extend([&**a, &**b]),
            Statement::Not(p) => {
                inner.push(&**p);
                pending.push(p);
            }
            _ => {}
        }
    }
    // The innermost denials first.
    for p in inner.into_iter().rev() {
        for attempt in 0..LEAST_ATTEMPTS.max(ATTEMPTS_PER_POINT * wanted) {
            let Some((draft, near)) = drawn(claim, seed, attempt, work) else {
                continue;
            };
            let judge = Judge {
                claim,
                values: &|name| draft.value(name),
                near,
                denied,
                work,
            };
            if judge.judge(p) == Judgement::False && !draft.empty.get() {
                denied.insert(address(p), ());
                break;
            }
        }
    }
}

/// The claim with the denial of a comparison among its hypotheses: where a condition fails. `None` for other statements.
///
/// A tally of the changed claim tells whether the condition is needed: it is if the statement is false or undefined
/// where the condition fails, and it is not if the changed domain has no points.
#[must_use]
pub fn excepting(claim: &Claim, condition: &Statement) -> Option<Claim> {
    let Statement::Compare {
        relation,
        left,
        right,
    } = condition
    else {
        return None;
    };
    let relation = match relation {
        Relation::Equal => Relation::Different,
        Relation::Different => Relation::Equal,
        Relation::Less => Relation::AtLeast,
        Relation::AtMost => Relation::Greater,
        Relation::Greater => Relation::AtMost,
        Relation::AtLeast => Relation::Less,
    };
    let nowhere = std::sync::Arc::new(Text {
        name: "condition".to_owned(),
        text: String::new(),
    });
    let mut changed = claim.clone();
    changed.hypotheses.push(Hypothesis {
        statement: Statement::Compare {
            relation,
            left: left.clone(),
            right: right.clone(),
        },
        source: Source::Assume,
        origin: Origin::range(&nowhere, 0, 0),
    });
    Some(changed)
}

/// A number of a point, from its name.
pub(crate) type Numbers = BTreeMap<Name, Real>;
