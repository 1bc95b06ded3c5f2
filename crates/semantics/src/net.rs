//! The net under verdicts: statements are judged at points of their domain.
//!
//! A proof that a point of the domain contradicts is wrong, and so is a refutation whose witness lies outside of the
//! domain or satisfies the statement. Neither needs to know how the verdict was found.

use crate::domain::point::{Outside, Point, check_hypotheses, check_sets};
use crate::gap::{Unknown, Work};
use crate::judge::Judge;
use crate::judgement::Judgement;
use crate::name::Name;
use crate::real::Real;
use crate::residue::judge::has_equation;
use crate::survey::{COSTLY, Ground, HOPELESS, Seen, Survey};
use crate::tree::Reading;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core::{Claim, Hypothesis, Source, Statement};
use torse_syntax::derivation::{Origin, Source as Text};

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
    /// Those of them at which the work of one point was not enough.
    pub costly: u64,
    /// The reason at the first open point.
    pub why_open: Option<String>,
    /// Points of the domain at which a condition is not true: they are not judged further.
    pub excepted: u64,
    /// Whether the only point of the domain was judged: linear equations leave no choice of any of its numbers, or it has
    /// none. No further points are drawn then.
    pub single: bool,
    /// Whether the budget was spent.
    pub exhausted: bool,
    /// Where the trees say something else than the core terms: both cannot be what the text says.
    pub objection: Option<String>,
}

impl Tally {
    /// Whether no point was found at which every term of the statement has a value, as far as is known: points were drawn, and
    /// it is undefined at each of them.
    #[must_use]
    pub fn is_undefined(&self) -> bool {
        self.found > 0 && self.undefined == self.found
    }

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
    check_hypotheses(&judge, |_| false)?;
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
    let survey = Survey::new(claim, seed, wanted, budget);
    counted(survey, None, statement, conditions, wanted)
}

/// The same, where every point is judged by the trees of the claim and the statement as well: see [`Tally::objection`].
#[must_use]
pub fn tally_twice(
    reading: &Reading<'_>,
    claim: &Claim,
    conditions: &[Statement],
    seed: &str,
    wanted: u64,
    budget: u64,
) -> Tally {
    let survey = Survey::new(claim, seed, wanted, budget);
    counted(survey, Some(reading), &claim.statement, conditions, wanted)
}

fn counted<'a>(
    survey: Survey<'a>,
    reading: Option<&'a Reading<'a>>,
    statement: &Statement,
    conditions: &[Statement],
    wanted: u64,
) -> Tally {
    let denied = survey.settled(statement);
    let survey = survey.read_by(reading);
    if has_equation(statement) {
        // What they find false, and what they cannot tell, is for exact numbers, but where those would cost too much too.
        let tally = walked(
            &survey.by_residues(),
            statement,
            conditions,
            &denied,
            wanted,
        );
        let enough = tally.holding >= wanted || (tally.single && tally.holding > 0);
        let costly = tally.exhausted || tally.costly >= COSTLY;
        if tally.objection.is_some() {
            return tally;
        }
        if tally.failing.is_none() && tally.open == tally.costly && (enough || costly) {
            return tally;
        }
    }
    walked(&survey, statement, conditions, &denied, wanted)
}

/// Walks until the statement is decided at `wanted` points, or false at one.
fn walked(
    survey: &Survey<'_>,
    statement: &Statement,
    conditions: &[Statement],
    denied: &BTreeMap<usize, ()>,
    wanted: u64,
) -> Tally {
    let mut tally = Tally::default();
    tally.attempts = survey.walk(statement, conditions, denied, &mut |seen| {
        tally.count(seen);
        let hopeless = tally.holding == 0 && tally.found >= HOPELESS;
        let unseen = matches!(survey.ground, Ground::Residues) && tally.open > tally.costly;
        let enough = tally.single || tally.decided() >= wanted;
        let contradicted = tally.failing.is_some() || tally.objection.is_some();
        !(enough || hopeless || unseen || contradicted)
    });
    tally.exhausted = survey.work.left() == 0;
    tally
}

/// What a statement is where a condition fails.
///
/// A condition is needed if the statement is false, or undefined, at a point at which it fails, or a hypothesis is undefined
/// there: what the claim says needs that its formulas have values.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Beyond {
    /// Points that were drawn.
    pub attempts: u64,
    /// Points of the domain at which the condition fails and the statement is true all the same.
    pub holding: u64,
    /// Those at which the statement is false.
    pub failing: u64,
    /// Those at which it, or a hypothesis, is undefined.
    pub undefined: u64,
    /// Those at which it was not decided.
    pub open: u64,
    /// The first point at which it is false, or else the first at which it is undefined.
    pub needed_at: Option<Point>,
}

impl Beyond {
    /// Points at which the condition fails and the statement was judged.
    #[must_use]
    pub fn judged(&self) -> u64 {
        self.holding + self.failing + self.undefined
    }
}

/// Judges `statement` at points of the domain of the claim at which `condition` fails, until it is false at one, judged
/// at `wanted` of them, or the budget is spent. `None` if the condition is no comparison.
///
/// Points that satisfy `condition`'s denial only nearly lie on the other side: they do not count.
#[must_use]
pub fn beyond(
    claim: &Claim,
    statement: &Statement,
    condition: &Statement,
    seed: &str,
    wanted: u64,
    budget: u64,
) -> Option<Beyond> {
    let denial = denied(condition)?;
    let mut changed = claim.clone();
    changed.hypotheses.push(denial.clone());
    // Points at which the condition fails are rare, so it is made to fail before anything else is solved.
    let alone = Claim {
        hypotheses: vec![denial],
        unknowns: vec![],
        ..claim.clone()
    };
    let survey = Survey::new(&changed, seed, wanted, budget).beyond(&alone);
    // Whether something is denied is a matter of the whole domain.
    let settled = Survey::new(claim, seed, wanted, budget).settled(statement);
    let mut beyond = Beyond::default();
    let mut undefined_at = None;
    beyond.attempts = survey.walk(statement, &[], &settled, &mut |seen| {
        let Seen::Judged {
            judgement,
            draft,
            near,
            exactly_first: true,
            ..
        } = seen
        else {
            return true;
        };
        let point = || Point {
            values: draft.values(),
            near,
        };
        match judgement {
            Judgement::True => beyond.holding += 1,
            Judgement::False => {
                beyond.failing += 1;
                beyond.needed_at.get_or_insert_with(point);
            }
            Judgement::Undefined(_) => {
                beyond.undefined += 1;
                undefined_at.get_or_insert_with(point);
            }
            Judgement::Undecided | Judgement::Unknown(_) => beyond.open += 1,
        }
        // One point at which it is false says all.
        beyond.failing == 0 && beyond.judged() < wanted
    });
    beyond.needed_at = beyond.needed_at.or(undefined_at);
    Some(beyond)
}

impl Tally {
    fn count(&mut self, seen: Seen<'_, '_>) {
        let Seen::Judged {
            judgement,
            draft,
            near,
            objection,
            ..
        } = seen
        else {
            self.excepted += 1;
            return;
        };
        self.objection = objection;
        self.found += 1;
        self.single = draft.is_determined();
        match judgement {
            Judgement::True => self.holding += 1,
            Judgement::False => {
                self.failing = Some(Point {
                    values: draft.values(),
                    near,
                });
            }
            Judgement::Undefined(_) => self.undefined += 1,
            open @ (Judgement::Undecided | Judgement::Unknown(_)) => {
                self.open += 1;
                self.costly += u64::from(open == Judgement::Unknown(Unknown::Work));
                self.why_open.get_or_insert_with(|| open.to_string());
            }
        }
    }
}

/// The denial of a comparison as a hypothesis: where a condition fails. `None` for other statements.
fn denied(condition: &Statement) -> Option<Hypothesis> {
    let Statement::Compare {
        relation,
        left,
        right,
    } = condition
    else {
        return None;
    };
    let nowhere = Arc::new(Text {
        name: "condition".to_owned(),
        text: String::new(),
    });
    Some(Hypothesis {
        statement: Statement::Compare {
            relation: relation.opposite(),
            left: left.clone(),
            right: right.clone(),
        },
        source: Source::Assume,
        origin: Origin::range(&nowhere, 0, 0),
    })
}

/// A number of a point, from its name.
pub(crate) type Numbers = BTreeMap<Name, Real>;
