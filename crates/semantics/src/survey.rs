//! A walk through points of a domain, with bounded work: exact numbers, or residues modulo a prime.

use crate::domain::constraints::is_equations;
use crate::domain::draft::Draft;
use crate::domain::narrow::Narrowed;
use crate::domain::point::{check_sets, completed};
use crate::domain::stream::Stream;
use crate::gap::{Undefined, Work};
use crate::judge::{Judge, address};
use crate::judgement::Judgement;
use crate::name::Name;
use crate::residue;
use crate::residue::domain::{Drawn, drawn};
use crate::tree::Reading;
use crate::tree::second::{self, Second};
use std::collections::BTreeMap;
use torse_core::{Claim, Statement};

/// Attempts for each wanted point, and at least.
const ATTEMPTS_PER_POINT: u64 = 12;
const LEAST_ATTEMPTS: u64 = 60;
/// No further points are drawn if none of the first so many lies in the domain.
const NOWHERE: u64 = 150;
/// No further points are drawn if what is looked for is seen at none of the first so many of the domain.
pub(crate) const HOPELESS: u64 = 40;
/// No further points are drawn if each of the first so many costs more than its share.
pub(crate) const COSTLY: u64 = 3;
/// Every how many-th point lies at the edges of the declared sets: where a statement holds, and where a condition fails.
const EDGES: u64 = 6;
const EDGES_BEYOND: u64 = 2;

/// What a drawn point turned out to be.
pub(crate) enum Seen<'s, 'a> {
    /// One condition is not true there.
    Excepted,
    /// A point of the domain, judged.
    Judged {
        judgement: Judgement,
        draft: &'s Draft<'a>,
        near: bool,
        /// Whether the hypotheses that are satisfied first are so exactly.
        exactly_first: bool,
        /// What the trees say otherwise.
        objection: Option<String>,
    },
}

/// What a statement is at a point, and what the trees say otherwise.
type Judged = (Judgement, Option<String>);

/// What both readings make of a point together.
fn weighed(judgement: Judgement, second: Option<Second>) -> Judged {
    match second {
        None => (judgement, None),
        Some(Second::Objection(objection)) => (judgement, Some(objection)),
        Some(Second::Fails) => (Judgement::False, None),
        Some(Second::Open) => (Judgement::Undecided, None),
    }
}

/// A walk through points of a domain, with bounded work.
pub(crate) struct Survey<'a> {
    claim: &'a Claim,
    narrowed: Narrowed,
    seed: &'a str,
    attempts: u64,
    /// The work of one point.
    share: u64,
    /// The budget.
    pub work: Work,
    /// Every how many-th point lies at the edges of the declared sets.
    edges: u64,
    /// A claim with some of the hypotheses: they are satisfied first.
    first: Option<&'a Claim>,
    /// What points consist of.
    pub ground: Ground,
    /// The trees of the claim and the statement, if every point is judged by them as well.
    reading: Option<&'a Reading<'a>>,
}

/// The numbers that points consist of.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Ground {
    /// Exact ones, enclosed where they have to be.
    Reals,
    /// Residues modulo a prime.
    Residues,
}

impl<'a> Survey<'a> {
    /// The walk through the whole domain that this text seeds, until this budget is spent.
    pub fn new(claim: &'a Claim, seed: &'a str, wanted: u64, budget: u64) -> Self {
        Self {
            claim,
            narrowed: Narrowed::new(claim),
            seed,
            attempts: LEAST_ATTEMPTS.max(ATTEMPTS_PER_POINT * wanted),
            share: (budget / wanted.max(1)).saturating_mul(2),
            work: Work::new(budget),
            edges: EDGES,
            first: None,
            ground: Ground::Reals,
            reading: None,
        }
    }

    /// The same walk where the trees judge every point as well.
    pub fn read_by(self, reading: Option<&'a Reading<'a>>) -> Self {
        Self { reading, ..self }
    }

    /// The same walk where the hypotheses of `first` are satisfied before all others, often at the edges of the declared sets.
    pub fn beyond(self, first: &'a Claim) -> Self {
        Self {
            edges: EDGES_BEYOND,
            first: Some(first),
            ..self
        }
    }

    /// The same walk modulo a prime, with a budget of its own.
    pub fn by_residues(&self) -> Self {
        Self {
            narrowed: self.narrowed.clone(),
            work: self.work.apart(self.work.left()),
            ground: Ground::Residues,
            ..*self
        }
    }

    /// Judges the statement at one point after the other as long as `each` says so; returns how many were drawn.
    pub fn walk(
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
            let own = self.work.apart(available);
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
            // The corners of the declared sets, every other time.
            0 if (attempt + 1).is_multiple_of(2 * self.edges) => stream.at_corner(),
            0 => stream.at_edges(),
            n if n == self.edges / 2 && self.edges > EDGES_BEYOND => stream.with_coincidences(),
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
                    objection: None,
                }));
            }
        }
        let (judged, near) = match self.ground {
            Ground::Reals => self.exactly(statement, conditions, denied, &draft, work)?,
            Ground::Residues => (
                self.modulo_prime(statement, conditions, denied, &draft, work)?,
                false,
            ),
        };
        let Some((judgement, objection)) = judged else {
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
            objection,
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
    ) -> Option<(Option<Judged>, bool)> {
        let near = completed(self.claim, draft, work)?;
        let judge = Judge {
            claim: self.claim,
            values: &|name| draft.value(name),
            near,
            denied,
            work,
        };
        let excepted = conditions.iter().any(|c| judge.judge(c) != Judgement::True);
        let judged = || {
            let judgement = judge.judge(statement);
            let number = |name: &Name| draft.value(name);
            let objection = self
                .reading
                .and_then(|reading| second::objection(reading, &judgement, &number, near, work));
            weighed(judgement, objection)
        };
        Some(((!excepted).then(judged), near))
    }

    /// The same modulo a prime.
    fn modulo_prime(
        &self,
        statement: &Statement,
        conditions: &[Statement],
        denied: &BTreeMap<usize, ()>,
        draft: &Draft<'_>,
        work: &Work,
    ) -> Option<Option<Judged>> {
        let unknown = |why| Some(Some((Judgement::Unknown(why), None)));
        let point = match drawn(self.claim, draft, work) {
            Drawn::Inside(point) => point,
            Drawn::Outside => return None,
            Drawn::Unknown(why) => return unknown(why),
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
                open @ (Judgement::Undecided | Judgement::Unknown(_)) => {
                    return Some(Some((open, None)));
                }
                Judgement::False | Judgement::Undefined(_) => return Some(None),
            }
        }
        let judgement = judge.judge(statement);
        let objection = self
            .reading
            .and_then(|reading| second::objection_modulo_prime(reading, &judgement, &point, work));
        Some(Some(weighed(judgement, objection)))
    }

    /// Finds, for each `not p` of a statement, a point of the domain at which p is false: `not p` is true then.
    pub fn settled(&self, statement: &Statement) -> BTreeMap<usize, ()> {
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
                let (mut found, mut judged) = (false, 0);
                survey.walk(p, &[], &denied, &mut |seen| {
                    if let Seen::Judged { judgement, .. } = seen {
                        found = judgement == Judgement::False;
                        judged += 1;
                    }
                    !found && judged < HOPELESS
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
    draft.look(|values| check_sets(claim, values)).ok()?;
    undefined
}
