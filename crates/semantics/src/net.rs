//! The net under verdicts: statements are judged at points of their domain.
//!
//! A proof that a point of the domain contradicts is wrong, and so is a refutation whose witness lies outside of the
//! domain or satisfies the statement. Neither needs to know how the verdict was found.

use crate::domain::draft::Draft;
use crate::domain::narrow::narrowed;
use crate::domain::point::{Outside, Point, check_hypotheses, check_sets, completed};
use crate::domain::solve::is_equations;
use crate::domain::stream::Stream;
use crate::gap::{Undefined, Unknown, Work};
use crate::judge::{Judge, address};
use crate::judgement::Judgement;
use crate::name::Name;
use crate::real::Real;
use crate::residue;
use crate::residue::domain::{Drawn, drawn};
use crate::residue::judge::has_equation;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_language::core::{Claim, Hypothesis, Source, Statement};
use torse_language::derivation::declarations::Interval;
use torse_language::derivation::{Origin, Source as Text};

/// Attempts for each wanted point, and at least.
const ATTEMPTS_PER_POINT: u64 = 12;
const LEAST_ATTEMPTS: u64 = 60;
/// No further points are drawn if the statement is decided at none of the first so many.
const HOPELESS: u64 = 40;
/// No further points are drawn if none of the first so many lies in the domain.
const NOWHERE: u64 = 150;
/// No further points are drawn if each of the first so many costs more than its share.
const COSTLY: u64 = 3;
/// Every how many-th point lies at the edges of the declared sets: where a statement holds, and where a condition fails.
const EDGES: u64 = 6;
const EDGES_BEYOND: u64 = 2;
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
    /// Whether the only point of the domain was judged, which has no numbers: neither the hypotheses nor the statement
    /// name a symbol. No further points are drawn then.
    pub single: bool,
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
    let denied = survey.settled(statement);
    if has_equation(statement) {
        // What they find false, and what they cannot tell, is for exact numbers, but where those would cost too much too.
        let tally = survey
            .by_residues()
            .tally(statement, conditions, &denied, wanted);
        let enough = tally.holding >= wanted || (tally.single && tally.holding > 0);
        let costly = tally.exhausted || tally.costly >= COSTLY;
        if tally.failing.is_none() && tally.open == tally.costly && (enough || costly) {
            return tally;
        }
    }
    survey.tally(statement, conditions, &denied, wanted)
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
    let survey = Survey {
        edges: EDGES_BEYOND,
        first: Some(&alone),
        ..Survey::new(&changed, seed, wanted, budget)
    };
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

/// What a drawn point turned out to be.
enum Seen<'s, 'a> {
    /// One condition is not true there.
    Excepted,
    /// A point of the domain, judged.
    Judged {
        judgement: Judgement,
        draft: &'s Draft<'a>,
        near: bool,
        /// Whether the hypotheses that are satisfied first are so exactly.
        exactly_first: bool,
    },
}

impl Tally {
    fn count(&mut self, seen: Seen<'_, '_>) {
        let Seen::Judged {
            judgement,
            draft,
            near,
            ..
        } = seen
        else {
            self.excepted += 1;
            return;
        };
        self.found += 1;
        self.single = draft.values().is_empty();
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

/// A walk through points of a domain, with bounded work.
struct Survey<'a> {
    claim: &'a Claim,
    narrowed: BTreeMap<Arc<str>, Interval>,
    seed: &'a str,
    attempts: u64,
    /// The work of one point.
    share: u64,
    work: Work,
    /// Every how many-th point lies at the edges of the declared sets.
    edges: u64,
    /// A claim with some of the hypotheses: they are satisfied first.
    first: Option<&'a Claim>,
    ground: Ground,
}

/// The numbers that points consist of.
#[derive(Debug, Clone, Copy)]
enum Ground {
    /// Exact ones, enclosed where they have to be.
    Reals,
    /// Residues modulo a prime.
    Residues,
}

impl<'a> Survey<'a> {
    fn new(claim: &'a Claim, seed: &'a str, wanted: u64, budget: u64) -> Self {
        Self {
            claim,
            narrowed: narrowed(claim),
            seed,
            attempts: LEAST_ATTEMPTS.max(ATTEMPTS_PER_POINT * wanted),
            share: (budget / wanted.max(1)).saturating_mul(2),
            work: Work::new(budget),
            edges: EDGES,
            first: None,
            ground: Ground::Reals,
        }
    }

    /// The same walk modulo a prime, with a budget of its own.
    fn by_residues(&self) -> Self {
        Self {
            narrowed: self.narrowed.clone(),
            work: Work::new(self.work.left()),
            ground: Ground::Residues,
            ..*self
        }
    }

    /// Judges the statement until it is decided at `wanted` points, or false at one.
    fn tally(
        &self,
        statement: &Statement,
        conditions: &[Statement],
        denied: &BTreeMap<usize, ()>,
        wanted: u64,
    ) -> Tally {
        let mut tally = Tally::default();
        tally.attempts = self.walk(statement, conditions, denied, &mut |seen| {
            tally.count(seen);
            let hopeless = tally.holding == 0 && tally.found >= HOPELESS;
            let unseen = matches!(self.ground, Ground::Residues) && tally.open > tally.costly;
            let enough = tally.single || tally.decided() >= wanted;
            !(enough || hopeless || unseen) && tally.failing.is_none()
        });
        tally.exhausted = self.work.left() == 0;
        tally
    }

    /// Judges the statement at one point after the other as long as `each` says so; returns how many were drawn.
    fn walk(
        &self,
        statement: &Statement,
        conditions: &[Statement],
        denied: &BTreeMap<usize, ()>,
        each: &mut dyn FnMut(Seen<'_, '_>) -> bool,
    ) -> u64 {
        let (mut costly, mut nowhere) = (0, true);
        for attempt in 0..self.attempts {
            let available = self.share.min(self.work.left());
            let hopeless =
                (attempt == COSTLY && costly == COSTLY) || (attempt == NOWHERE && nowhere);
            if available == 0 || hopeless {
                return attempt;
            }
            let own = Work::new(available);
            let go_on = self.one(statement, conditions, denied, attempt, &own, each);
            let _ = self.work.spend(available - own.left());
            costly += u64::from(own.left() == 0);
            nowhere &= go_on.is_none();
            if go_on == Some(false) {
                return attempt + 1;
            }
        }
        self.attempts
    }

    /// Judges the statement at the point of this attempt: whether to go on; `None` if it is no point of the domain.
    fn one(
        &self,
        statement: &Statement,
        conditions: &[Statement],
        denied: &BTreeMap<usize, ()>,
        attempt: u64,
        work: &Work,
        each: &mut dyn FnMut(Seen<'_, '_>) -> bool,
    ) -> Option<bool> {
        let stream = Stream::new(self.seed, attempt);
        let stream = match (attempt + 1) % self.edges {
            0 => stream.at_edges(),
            _ => stream,
        };
        let draft = Draft::new(self.claim, &self.narrowed, stream);
        if let Some(first) = self.first {
            let near = completed(first, &draft, work)?;
            if let Some(why) = undefined_hypothesis(self.claim, &draft, work) {
                return Some(each(Seen::Judged {
                    judgement: Judgement::Undefined(why),
                    draft: &draft,
                    near,
                    exactly_first: !near,
                }));
            }
        }
        let (judgement, near) = match self.ground {
            Ground::Reals => self.exactly(statement, conditions, denied, &draft, work)?,
            Ground::Residues => (
                self.modulo_prime(statement, conditions, denied, &draft, work)?,
                false,
            ),
        };
        let Some(judgement) = judgement else {
            return Some(each(Seen::Excepted));
        };
        // What was solved for since may have moved them.
        let exactly_first = match self.first {
            Some(first) => !completed(first, &draft, work)?,
            None => !near,
        };
        if draft.empty.get() {
            return None;
        }
        Some(each(Seen::Judged {
            judgement,
            draft: &draft,
            near,
            exactly_first,
        }))
    }

    /// What the statement is at the point that a draft is completed to, if the conditions are true there, and whether the
    /// point satisfies its equations only nearly; `None` if it is no point of the domain.
    fn exactly(
        &self,
        statement: &Statement,
        conditions: &[Statement],
        denied: &BTreeMap<usize, ()>,
        draft: &Draft<'_>,
        work: &Work,
    ) -> Option<(Option<Judgement>, bool)> {
        let near = completed(self.claim, draft, work)?;
        let judge = Judge {
            claim: self.claim,
            values: &|name| draft.value(name),
            near,
            denied,
            work,
        };
        let excepted = conditions.iter().any(|c| judge.judge(c) != Judgement::True);
        Some(((!excepted).then(|| judge.judge(statement)), near))
    }

    /// The same modulo a prime.
    fn modulo_prime(
        &self,
        statement: &Statement,
        conditions: &[Statement],
        denied: &BTreeMap<usize, ()>,
        draft: &Draft<'_>,
        work: &Work,
    ) -> Option<Option<Judgement>> {
        let point = match drawn(self.claim, draft, work) {
            Drawn::Inside(point) => point,
            Drawn::Outside => return None,
            Drawn::Unknown(why) => return Some(Some(Judgement::Unknown(why))),
        };
        let judge = residue::judge::Judge {
            claim: self.claim,
            point: &point,
            denied,
            work,
        };
        for condition in conditions {
            match judge.judge(condition) {
                Judgement::True => {}
                open @ (Judgement::Undecided | Judgement::Unknown(_)) => return Some(Some(open)),
                Judgement::False | Judgement::Undefined(_) => return Some(None),
            }
        }
        Some(Some(judge.judge(statement)))
    }

    /// Finds, for each `not p` of a statement, a point of the domain at which p is false: `not p` is true then.
    fn settled(&self, statement: &Statement) -> BTreeMap<usize, ()> {
        let mut denied = BTreeMap::new();
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
            let fails = |survey: &Self| {
                let mut found = false;
                survey.walk(p, &[], &denied, &mut |seen| {
                    found = matches!(
                        seen,
                        Seen::Judged {
                            judgement: Judgement::False,
                            ..
                        }
                    );
                    !found
                });
                found
            };
            if fails(&self.by_residues()) || fails(self) {
                denied.insert(address(p), ());
            }
        }
        denied
    }
}

/// Why a hypothesis is undefined at numbers that satisfy all others, but for equations that might be solved.
fn undefined_hypothesis(claim: &Claim, draft: &Draft<'_>, work: &Work) -> Option<Undefined> {
    let denied = BTreeMap::new();
    let judge = Judge {
        claim,
        values: &|name| draft.value(name),
        near: false,
        denied: &denied,
        work,
    };
    let mut undefined = None;
    for hypothesis in &claim.hypotheses {
        match judge.hypothesis(&hypothesis.statement) {
            Judgement::True => {}
            Judgement::Undefined(why) => undefined = Some(why),
            _ if is_equations(&hypothesis.statement) => {}
            _ => return None,
        }
    }
    check_sets(claim, &draft.values()).ok()?;
    undefined
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
