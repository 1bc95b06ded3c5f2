//! Visits points of a domain with bounded work, as exact numbers or as residues modulo a prime.

use crate::domain::Domain;
use crate::domain::constraints::is_equations;
use crate::domain::draft::Draft;
use crate::domain::point::{check_sets, completed};
use crate::domain::stream::Stream;
use crate::judge::Judge;
use crate::judgement::Judgement;
use crate::name::Name;
use crate::no_value::{Undefined, Work};
use crate::residue::Residues;
use crate::residue::domain::{Drawn, drawn};
use crate::tree::Reading;
use std::cell::Cell;
use std::collections::BTreeSet;
use torse_syntax::formula::{Connective, Expr, Node};

/// The number of attempts for each wanted point, and the smallest total number.
const ATTEMPTS_PER_POINT: u64 = 12;
const MIN_ATTEMPTS: u64 = 60;
/// The search ends if none of the first this many attempts yields a point of the domain.
const MAX_OUTSIDE_ATTEMPTS: u64 = 150;
/// The search ends if the statement has no value at any of the first this many points of the domain.
pub(crate) const MAX_POINTS_WITHOUT_VALUE: u64 = 40;
/// The search ends if each of the first this many points costs more than its share.
pub(crate) const MAX_COSTLY_POINTS: u64 = 3;
/// One in this many points lies at the edges of the declared sets: in general, and where a condition fails.
const EDGES: u64 = 6;
const EDGES_BEYOND: u64 = 2;
/// The budget of the statement and its conditions at one point, in addition to the work of finding the point.
const STATEMENT_WORK: u64 = 1_000_000;
/// The largest depth to which definitions of statements are opened.
const MAX_OPENED: u32 = 16;

/// The result for a point that was drawn.
pub(crate) enum Seen<'s, 'a> {
    /// A condition is not true at the point.
    Excepted,
    /// A point of the domain, with the judgement on the statement.
    Judged {
        judgement: Judgement,
        draft: &'s Draft<'a>,
        near: bool,
        /// Whether the hypotheses that are satisfied first hold exactly.
        exactly_first: bool,
    },
}

/// What is judged at the points.
pub(crate) struct Judged<'a> {
    /// A statement; `None` for the statement of the claim.
    pub statement: Option<&'a Expr>,
    /// Conditions that must be true as well.
    pub conditions: Vec<&'a Expr>,
    /// The parts p of `fails(p)` for which a point is known at which p fails, by address.
    pub failing: BTreeSet<usize>,
}

impl<'a> Judged<'a> {
    fn new(statement: &'a Expr, failing: &BTreeSet<usize>) -> Self {
        Self {
            statement: Some(statement),
            conditions: vec![],
            failing: failing.clone(),
        }
    }

    /// A copy, to be judged on another domain of the same claim.
    pub fn copied(&self) -> Self {
        Self {
            statement: self.statement,
            conditions: self.conditions.clone(),
            failing: self.failing.clone(),
        }
    }

    /// Whether a point is known at which this part of the statement is false.
    pub fn fails(&self, tree: &Expr) -> bool {
        self.failing.contains(&std::ptr::from_ref(tree).addr())
    }
}

/// Visits points of a domain with bounded work.
pub(crate) struct Survey<'a> {
    domain: &'a Domain<'a>,
    seed: &'a str,
    attempts: u64,
    /// The budget of one point.
    share: u64,
    /// The budget.
    pub work: Work,
    /// The operations that the statement and its conditions took so far, beside the budget.
    pub statement_work: Cell<u64>,
    /// One in this many points lies at the edges of the declared sets.
    edges: u64,
    /// Hypotheses that are satisfied before all others.
    first: Option<&'a Domain<'a>>,
    /// The kind of numbers that points consist of.
    pub numbers: NumberField,
}

/// The kind of numbers that points consist of.
#[derive(Debug, Clone, Copy)]
pub(crate) enum NumberField {
    /// Exact numbers, enclosed where necessary.
    Reals,
    /// Residues modulo a prime.
    Residues,
}

impl<'a> Survey<'a> {
    /// Visits the whole domain with this seed, until the budget is spent.
    pub fn new(domain: &'a Domain<'a>, seed: &'a str, wanted: u64, budget: u64) -> Self {
        Self {
            domain,
            seed,
            attempts: MIN_ATTEMPTS.max(ATTEMPTS_PER_POINT * wanted),
            share: (budget / wanted.max(1)).saturating_mul(2),
            work: Work::new(budget),
            statement_work: Cell::new(0),
            edges: EDGES,
            first: None,
            numbers: NumberField::Reals,
        }
    }

    /// The trees of the claim.
    pub const fn reading(&self) -> &'a Reading<'a> {
        self.domain.reading
    }

    /// As before, but the hypotheses of `first` are satisfied before all others, and points are often at the edges of
    /// the declared sets.
    pub fn beyond(self, first: &'a Domain<'a>) -> Self {
        Self {
            edges: EDGES_BEYOND,
            first: Some(first),
            ..self
        }
    }

    /// As before, but modulo a prime, with a budget of its own.
    pub fn by_residues(&self) -> Self {
        Self {
            work: Work::new(self.work.left()),
            statement_work: Cell::new(0),
            numbers: NumberField::Residues,
            ..*self
        }
    }

    /// Judges a statement at points as long as `each` returns true; returns the number of points drawn.
    pub fn walk(&self, judged: &Judged<'a>, each: &mut dyn FnMut(Seen<'_, '_>) -> bool) -> u64 {
        let (mut costly, mut none_inside) = (0, true);
        for attempt in 0..self.attempts {
            let available = self.share.min(self.work.left());
            let hopeless = (attempt == MAX_COSTLY_POINTS && costly == MAX_COSTLY_POINTS)
                || (attempt == MAX_OUTSIDE_ATTEMPTS && none_inside);
            if available == 0 || hopeless {
                return attempt;
            }
            let own = Work::new(available);
            let go_on = self.attempt(judged, attempt, &own, each);
            let _ = self.work.spend(available - own.left());
            costly += u64::from(own.left() == 0);
            none_inside &= go_on.is_none();
            if go_on == Some(false) {
                return attempt + 1;
            }
        }
        self.attempts
    }

    /// Judges a statement at the point of this attempt. Returns whether to continue, and `None` if it is not a point
    /// of the domain.
    fn attempt(
        &self,
        judged: &Judged<'a>,
        attempt: u64,
        work: &Work,
        each: &mut dyn FnMut(Seen<'_, '_>) -> bool,
    ) -> Option<bool> {
        let stream = Stream::new(self.seed, attempt);
        let stream = match (attempt + 1) % self.edges {
            // Every other time at the corners of the declared sets.
            0 if (attempt + 1).is_multiple_of(2 * self.edges) => stream.at_corner(),
            0 => stream.at_edges(),
            n if n == self.edges / 2 && self.edges > EDGES_BEYOND => stream.with_coincidences(),
            _ => stream,
        };
        let draft = Draft::new(self.domain, stream);
        if let Some(first) = self.first {
            let near = completed(first, &draft, work)?;
            if has_undefined_hypothesis(self.domain, &draft, work) {
                return Some(each(Seen::Judged {
                    judgement: Judgement::Undefined(Undefined::Unasserted),
                    draft: &draft,
                    near,
                    exactly_first: !near,
                }));
            }
        }
        let own = Work::new(STATEMENT_WORK);
        let judgement = match self.numbers {
            NumberField::Reals => self.exactly(judged, &draft, work, &own),
            NumberField::Residues => {
                let judgement = self.modulo_prime(judged, &draft, work, &own);
                judgement.map(|judgement| (judgement, false))
            }
        };
        let before = self.statement_work.get();
        self.statement_work
            .set(before + (STATEMENT_WORK - own.left()));
        let (judgement, near) = judgement?;
        let Some(judgement) = judgement else {
            return Some(each(Seen::Excepted));
        };
        // Solving the other equations may have moved the numbers.
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

    /// Completes a draft to a point of the domain and judges the statement there if the conditions are true. Also
    /// returns whether the point satisfies its equations only approximately; `None` if it is not a point of the
    /// domain.
    fn exactly(
        &self,
        judged: &Judged<'a>,
        draft: &Draft<'_>,
        work: &Work,
        own: &Work,
    ) -> Option<(Option<Judgement>, bool)> {
        let near = completed(self.domain, draft, work)?;
        let reading = self.domain.reading;
        let judge = Judge {
            reading,
            values: &|name| draft.value(name),
            near,
            fails: &|tree| judged.fails(tree),
            work: own,
        };
        let grounds = judge.evaluators();
        let at = grounds.along(&judge, reading.given(), None);
        let mut conditions = judged.conditions.iter();
        if conditions.any(|condition| at.truth(condition) != Judgement::True) {
            return Some((None, near));
        }
        let judgement = match judged.statement {
            None => at.statement(),
            Some(tree) => at.truth(tree),
        };
        Some((Some(judgement), near))
    }

    /// As `exactly`, modulo a prime.
    fn modulo_prime(
        &self,
        judged: &Judged<'a>,
        draft: &Draft<'a>,
        work: &Work,
        own: &Work,
    ) -> Option<Option<Judgement>> {
        let point = match drawn(self.domain, draft, work) {
            Drawn::Inside(point) => point,
            Drawn::Outside => return None,
            Drawn::Unknown(why) => return Some(Some(Judgement::Unknown(why))),
        };
        let reading = self.domain.reading;
        let judge = Judge {
            reading,
            values: &|name| point.number(name),
            near: false,
            fails: &|tree| judged.fails(tree),
            work: own,
        };
        let (residues, residue) = (Residues { work: own }, |name: &Name| point.residue(name));
        let grounds = judge.evaluators();
        let at = grounds.along(&judge, reading.given(), Some((&residues, &residue)));
        for condition in &judged.conditions {
            match at.truth(condition) {
                Judgement::True => {}
                open @ (Judgement::Undecided | Judgement::Unknown(_)) => {
                    return Some(Some(open));
                }
                Judgement::False | Judgement::Undefined(_) => return Some(None),
            }
        }
        Some(Some(match judged.statement {
            None => at.statement(),
            Some(tree) => at.truth(tree),
        }))
    }

    /// Finds, for each `fails(p)` in a statement, a point of the domain at which p is false; `fails(p)` is then true.
    pub fn settled(&self, statement: &'a Expr) -> BTreeSet<usize> {
        let mut failing = BTreeSet::new();
        for p in self.denied(statement) {
            let fails = |survey: &Self| {
                let (mut found, mut judged) = (false, 0);
                survey.walk(&Judged::new(p, &failing), &mut |seen| {
                    if let Seen::Judged { judgement, .. } = seen {
                        found = judgement == Judgement::False;
                        judged += 1;
                    }
                    !found && judged < MAX_POINTS_WITHOUT_VALUE
                });
                found
            };
            if fails(&self.by_residues()) || fails(self) {
                failing.insert(std::ptr::from_ref(p).addr());
            }
        }
        failing
    }

    /// The parts p of `fails(p)` in a statement.
    pub fn denied(&self, statement: &'a Expr) -> Vec<&'a Expr> {
        let mut pending = vec![(statement, MAX_OPENED)];
        let mut denied = vec![];
        while let Some((tree, depth)) = pending.pop() {
            match &tree.node {
                Node::Join(Connective::And, a, b) => {
                    pending.extend([(&**b, depth), (&**a, depth)]);
                }
                Node::Name(name) => {
                    let definition = self.domain.reading.declarations().definition(name);
                    if let (Some(definition), Some(depth)) = (definition, depth.checked_sub(1)) {
                        pending.push((&definition.body.expr, depth));
                    }
                }
                Node::Call(head, arguments) => {
                    if let (Node::Name(name), [inner]) = (&head.node, arguments.as_slice())
                        && name == "fails"
                    {
                        denied.push(inner);
                    }
                }
                _ => {}
            }
        }
        denied
    }
}

/// Whether a hypothesis is undefined at numbers that satisfy all others, except possibly equations that could be solved.
fn has_undefined_hypothesis(domain: &Domain<'_>, draft: &Draft<'_>, work: &Work) -> bool {
    let judge = Judge {
        reading: domain.reading,
        values: &|name| draft.value(name),
        near: false,
        fails: &|_| false,
        work,
    };
    let declarations = domain.reading.declarations();
    let mut undefined = false;
    let grounds = judge.evaluators();
    let at = grounds.each(&judge);
    for tree in &domain.hypotheses {
        match at.truth(tree) {
            Judgement::True => {}
            Judgement::Undefined(_) => undefined = true,
            _ if is_equations(declarations, tree) => {}
            _ => return false,
        }
    }
    let sets = draft.look(|values| check_sets(declarations, values, false));
    undefined && sets.is_ok()
}
