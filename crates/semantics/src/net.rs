//! The net under verdicts: statements are judged at points of their domain.
//!
//! A proof that a point of the domain contradicts is wrong, and so is a refutation whose witness lies outside of the
//! domain or satisfies the statement. Neither needs to know how the verdict was found.

use crate::branches::branches;
use crate::domain::Domain;
use crate::domain::point::Point;
use crate::judgement::Judgement;
use crate::no_value::Unknown;
use crate::survey::{Ground, Judged, MAX_COSTLY_POINTS, MAX_POINTS_WITHOUT_VALUE, Seen, Survey};
use crate::tree::Reading;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::{Expr, Node, Relation};

/// How deep definitions of statements are opened.
const MAX_OPENED: u32 = 16;
/// The points that are judged on one thin part of a domain, and the work that finding them may take.
const STARTS: u64 = 4;
const BRANCH_WORK: u64 = 10_000;

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
    /// The parts p of `fails(p)` of which no point was found at which they are false.
    pub unshown: Vec<Expr>,
    /// How many thin parts of the domain the text shows.
    pub branches: u64,
    /// What is true on those of them on which the statement was decided at no point.
    pub unvisited: Vec<Expr>,
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

/// Judges the statement of a claim at points of its domain until it is decided at `wanted` of them, found to be false
/// at one, or the budget (in operations on numbers) is spent. Only points at which all `conditions` are true count.
///
/// The points are a function of the claim and the seed.
#[must_use]
pub fn tally(
    reading: &Reading<'_>,
    conditions: &[&Expr],
    seed: &str,
    wanted: u64,
    budget: u64,
) -> Tally {
    let domain = Domain::new(reading);
    let survey = Survey::new(&domain, seed, wanted, budget);
    let judged = Judged {
        statement: None,
        conditions: conditions.to_vec(),
        failing: survey.settled(reading.tree()),
    };
    let mut tally = generic(&survey, &judged, wanted);
    let denied = survey.denied(reading.tree()).into_iter();
    let unshown = denied.filter(|tree| !judged.fails(tree));
    tally.unshown = unshown.cloned().collect();
    if tally.failing.is_none() && tally.holding > 0 && !tally.single && tally.costly == 0 {
        visit(&mut tally, &domain, &judged, seed);
    }
    tally
}

/// The statement at points drawn from the whole domain: modulo a prime first, where that may tell something.
fn generic<'a>(survey: &Survey<'a>, judged: &Judged<'a>, wanted: u64) -> Tally {
    let reading = survey.reading();
    if has_equation(reading.declarations(), reading.tree(), MAX_OPENED) {
        // What they find false, and what they cannot tell, is for exact numbers, but where those would cost too much too.
        let tally = walked(&survey.by_residues(), judged, wanted);
        let enough = tally.holding >= wanted || (tally.single && tally.holding > 0);
        let costly = tally.exhausted || tally.costly >= MAX_COSTLY_POINTS;
        if tally.failing.is_none() && tally.open == tally.costly && (enough || costly) {
            return tally;
        }
    }
    walked(survey, judged, wanted)
}

/// Judges the statement on the thin parts of its domain, each until it is decided at one point.
fn visit(tally: &mut Tally, domain: &Domain<'_>, judged: &Judged<'_>, seed: &str) {
    let reading = domain.reading;
    for branch in branches(reading) {
        let (inside, alone) = (
            Domain::where_true(reading, &branch.inside),
            Domain::alone(reading, &branch.first),
        );
        let survey = Survey::new(&inside, seed, STARTS, BRANCH_WORK).beyond(&alone);
        let (mut seen, mut decided) = (0, None);
        survey.walk(&judged.anew(), &mut |found| {
            seen += 1;
            if let Seen::Judged {
                judgement,
                draft,
                near,
                ..
            } = found
            {
                decided = judgement.decided();
                if decided == Some(false) {
                    let values = draft.values();
                    tally.failing = Some(Point { values, near });
                }
            }
            decided.is_none() && seen < STARTS
        });
        tally.branches += 1;
        if decided.is_none() {
            tally.unvisited.push(branch.inside);
        }
        if tally.failing.is_some() {
            return;
        }
    }
}

/// Whether some part of a statement is an equation, or says what numbers are: other statements gain nothing by residues.
fn has_equation(declarations: &Declarations, tree: &Expr, depth: u32) -> bool {
    let within = |tree: &Expr| has_equation(declarations, tree, depth);
    match &tree.node {
        Node::Join(_, a, b) => within(a) || within(b),
        Node::Not(inner) => within(inner),
        Node::Compare(_, rest) => rest
            .iter()
            .any(|(relation, _)| *relation == Relation::Equal),
        Node::Name(name) => match (declarations.definition(name), depth.checked_sub(1)) {
            (Some(definition), Some(depth)) => {
                has_equation(declarations, &definition.body.expr, depth)
            }
            _ => false,
        },
        Node::Call(head, arguments) => match (&head.node, arguments.as_slice()) {
            (Node::Name(name), _) if name == "agrees" => true,
            (Node::Name(name), [inner, ..]) if name == "at" || name == "fails" => within(inner),
            _ => false,
        },
        _ => false,
    }
}

/// Walks until the statement is decided at `wanted` points, or false at one.
fn walked<'a>(survey: &Survey<'a>, judged: &Judged<'a>, wanted: u64) -> Tally {
    let mut tally = Tally::default();
    tally.attempts = survey.walk(judged, &mut |seen| {
        tally.count(seen);
        let hopeless = tally.holding == 0 && tally.found >= MAX_POINTS_WITHOUT_VALUE;
        let unseen = matches!(survey.ground, Ground::Residues) && tally.open > tally.costly;
        let enough = tally.single || tally.decided() >= wanted;
        !(enough || hopeless || unseen || tally.failing.is_some())
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

/// Judges the statement at points of the domain of the claim at which `condition` fails, until it is false at one, judged
/// at `wanted` of them, or the budget is spent. `None` if the condition is no comparison.
///
/// Points that satisfy `condition`'s denial only nearly lie on the other side: they do not count.
#[must_use]
pub fn beyond(
    reading: &Reading<'_>,
    condition: &Expr,
    seed: &str,
    wanted: u64,
    budget: u64,
) -> Option<Beyond> {
    let denial = denied(condition)?;
    let changed = Domain::where_true(reading, &denial);
    // Points at which the condition fails are rare, so it is made to fail before anything else is solved.
    let alone = Domain::alone(reading, &denial);
    let survey = Survey::new(&changed, seed, wanted, budget).beyond(&alone);
    // Whether something is denied is a matter of the whole domain.
    let whole = Domain::new(reading);
    let judged = Judged {
        statement: None,
        conditions: vec![],
        failing: Survey::new(&whole, seed, wanted, budget).settled(reading.tree()),
    };
    let mut beyond = Beyond::default();
    let mut undefined_at = None;
    beyond.attempts = survey.walk(&judged, &mut |seen| {
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
            ..
        } = seen
        else {
            self.excepted += 1;
            return;
        };
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

/// The denial of a comparison: where a condition fails. `None` for other statements.
fn denied(condition: &Expr) -> Option<Expr> {
    let Node::Compare(left, rest) = &condition.node else {
        return None;
    };
    let [(relation, right)] = rest.as_slice() else {
        return None;
    };
    Some(Expr {
        node: Node::Compare(left.clone(), vec![(relation.opposite(), right.clone())]),
        place: condition.place,
    })
}
