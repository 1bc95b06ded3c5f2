//! Cross-checks of verdicts: statements are judged at points of their domain.
//!
//! A proof is wrong if the statement is false at a point of the domain. A refutation is wrong if its witness lies
//! outside of the domain or satisfies the statement. Neither check depends on how the verdict was found.

use crate::branches::{Branch, branches};
use crate::divisors::divisors;
use crate::domain::Domain;
use crate::domain::point::Point;
use crate::judgement::Judgement;
use crate::no_value::{Undefined, Unknown};
use crate::survey::{
    Judged, MAX_COSTLY_POINTS, MAX_POINTS_WITHOUT_VALUE, NumberField, Seen, Survey,
};
use crate::tree::Reading;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::{Expr, Node, Relation};

/// The largest depth to which definitions of statements are opened.
const MAX_OPENED: u32 = 16;
/// The operations for each wanted point beyond which fewer points are enough, and the number that always has to be judged.
const POINT_WORK: u64 = 100;
const MIN_POINTS: u64 = 8;
/// The number of points that are judged on one thin part of a domain, and the work allowed to find them.
const POINTS_PER_BRANCH: u64 = 4;
const BRANCH_WORK: u64 = 10_000;

/// Statistics of a statement at points of the domain of its claim.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SampleStatistics {
    /// The number of points drawn, including those outside of the domain.
    pub attempts: u64,
    /// The number of points of the domain at which the statement was judged.
    pub found: u64,
    /// The number of points at which it is true.
    pub holding: u64,
    /// The first point at which it is false; no further points are drawn after it.
    pub failing: Option<Point>,
    /// The number of points at which it is undefined, so that the claim makes no assertion there.
    pub undefined: u64,
    /// The first of these points at which a divisor is zero, so that the claim lacks a condition.
    pub divided: Option<Point>,
    /// The number of points at which it was not decided.
    pub open: u64,
    /// The number of these points at which the budget of one point was spent.
    pub costly: u64,
    /// The reason at the first undecided point.
    pub why_open: Option<String>,
    /// The number of points of the domain at which a condition is not true; they are not judged further.
    pub excepted: u64,
    /// Whether the only point of the domain was judged: linear equations determine all of its numbers, or it has no
    /// numbers. No further points are drawn then.
    pub single: bool,
    /// Whether the statement was decided at as many points as were wanted: at fewer where each costs much, and at the only
    /// one of a domain of one point.
    pub enough: bool,
    /// Whether the budget was spent.
    pub exhausted: bool,
    /// The parts p of `fails(p)` for which no point was found at which p is false.
    pub unshown: Vec<Expr>,
    /// The number of thin parts of the domain.
    pub branches: u64,
    /// The assumptions of those thin parts on which the statement was decided at no point.
    pub unvisited: Vec<Expr>,
}

impl SampleStatistics {
    /// Whether, as far as is known, the statement is defined nowhere: points of the domain were found, and it is
    /// undefined at each of them.
    #[must_use]
    pub fn is_undefined(&self) -> bool {
        self.found > 0 && self.undefined == self.found
    }

    /// The number of points at which the statement was decided.
    #[must_use]
    pub fn decided(&self) -> u64 {
        self.holding + u64::from(self.failing.is_some())
    }
}

/// Judges the statement of a claim at points of its domain until it is decided at `wanted` of them, is false at one,
/// or the budget (in operations on numbers) is spent. Only points at which all `conditions` are true count.
///
/// The points depend only on the claim and the seed.
#[must_use]
pub fn judge_samples(
    reading: &Reading<'_>,
    conditions: &[&Expr],
    seed: &str,
    wanted: u64,
    budget: u64,
) -> SampleStatistics {
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
        divide(&mut tally, &domain, &judged, seed);
    }
    tally
}

/// Judges the statement at points of the whole domain, modulo a prime first if that may decide something.
fn generic<'a>(survey: &Survey<'a>, judged: &Judged<'a>, wanted: u64) -> SampleStatistics {
    let reading = survey.reading();
    if has_equation(reading.declarations(), reading.tree(), MAX_OPENED) {
        // Exact numbers re-examine what residues find false or cannot decide, unless exact numbers would cost too
        // much as well.
        let tally = walked(&survey.by_residues(), judged, wanted);
        let costly = tally.exhausted || tally.costly >= MAX_COSTLY_POINTS;
        if tally.failing.is_none() && tally.open == tally.costly && (tally.enough || costly) {
            return tally;
        }
    }
    walked(survey, judged, wanted)
}

/// Judges the statement on the thin parts of its domain, each until it is decided at one point.
fn visit(tally: &mut SampleStatistics, domain: &Domain<'_>, judged: &Judged<'_>, seed: &str) {
    let reading = domain.reading;
    for branch in branches(reading) {
        let (mut seen, mut decided) = (0, None);
        walk_part(reading, &branch, judged, seed, &mut |found| {
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
            decided.is_none() && seen < POINTS_PER_BRANCH
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

/// Visits points of a thin part of a domain.
fn walk_part(
    reading: &Reading<'_>,
    part: &Branch,
    judged: &Judged<'_>,
    seed: &str,
    each: &mut dyn FnMut(Seen<'_, '_>) -> bool,
) {
    let (inside, alone) = (
        Domain::where_true(reading, &part.inside),
        Domain::alone(reading, &part.first),
    );
    let survey = Survey::new(&inside, seed, POINTS_PER_BRANCH, BRANCH_WORK).beyond(&alone);
    survey.walk(&judged.copied(), each);
}

/// Looks for a point of the domain at which a divisor in the statement is zero, and all conditions are true.
fn divide(tally: &mut SampleStatistics, domain: &Domain<'_>, judged: &Judged<'_>, seed: &str) {
    let reading = domain.reading;
    for zero in divisors(reading) {
        if tally.divided.is_some() || tally.failing.is_some() {
            return;
        }
        let mut there = SampleStatistics::default();
        walk_part(reading, &zero, judged, seed, &mut |seen| {
            there.count(seen);
            there.divided.is_none() && there.found < POINTS_PER_BRANCH
        });
        tally.divided = there.divided;
    }
}

/// Whether a part of the statement is an equation or a property of values; residues decide nothing about other
/// statements.
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

/// Draws points until the statement is decided at `wanted` of them, or false at one. Where their values cost
/// much, two fifths of them are enough.
fn walked<'a>(survey: &Survey<'a>, judged: &Judged<'a>, wanted: u64) -> SampleStatistics {
    let mut tally = SampleStatistics::default();
    tally.attempts = survey.walk(judged, &mut |seen| {
        tally.count(seen);
        let hopeless = tally.holding == 0 && tally.found >= MAX_POINTS_WITHOUT_VALUE;
        let unseen = matches!(survey.numbers, NumberField::Residues) && tally.open > tally.costly;
        let costly = survey.statement_work.get() > POINT_WORK * wanted;
        let few = costly && tally.holding >= MIN_POINTS.max(wanted * 2 / 5);
        tally.enough = tally.holding >= wanted || few || (tally.single && tally.holding > 0);
        !(tally.single || tally.enough || hopeless || unseen || tally.failing.is_some())
    });
    tally.exhausted = survey.work.left() == 0;
    if matches!(survey.numbers, NumberField::Residues) {
        // A residue may be zero although the number is not.
        tally.divided = None;
    }
    tally
}

/// Statistics of a statement at points at which a condition fails.
///
/// A condition is needed if there is a point at which it fails and the statement is false or undefined, or a
/// hypothesis is undefined: a claim presupposes that its formulas have values.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ViolationStatistics {
    /// The number of points drawn.
    pub attempts: u64,
    /// The number of points of the domain at which the condition fails, but the statement is true.
    pub holding: u64,
    /// The number of points at which the statement is false.
    pub failing: u64,
    /// The number of points at which the statement, or a hypothesis, is undefined.
    pub undefined: u64,
    /// The number of points at which it was not decided.
    pub open: u64,
    /// The first point at which the statement is false, or else the first at which it is undefined.
    pub needed_at: Option<Point>,
}

impl ViolationStatistics {
    /// The number of points at which the condition fails and the statement was judged.
    #[must_use]
    pub fn judged(&self) -> u64 {
        self.holding + self.failing + self.undefined
    }
}

/// Judges the statement at points of the claim's domain at which `condition` fails, until it is false at one, judged
/// at `wanted` of them, or the budget is spent. `None` if the condition is not a comparison.
///
/// Points at which the condition fails only approximately do not count, since they may satisfy it.
#[must_use]
pub fn judge_violations(
    reading: &Reading<'_>,
    condition: &Expr,
    seed: &str,
    wanted: u64,
    budget: u64,
) -> Option<ViolationStatistics> {
    let denial = negation(condition)?;
    let changed = Domain::where_true(reading, &denial);
    // Points at which the condition fails are rare, so its negation is solved before everything else.
    let alone = Domain::alone(reading, &denial);
    let survey = Survey::new(&changed, seed, wanted, budget).beyond(&alone);
    // Whether `fails(..)` is true depends on the whole domain.
    let domain = Domain::new(reading);
    let judged = Judged {
        statement: None,
        conditions: vec![],
        failing: Survey::new(&domain, seed, wanted, budget).settled(reading.tree()),
    };
    let mut beyond = ViolationStatistics::default();
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
        // A single point at which the statement is false shows that the condition is needed; whether the statement is true
        // elsewhere without it takes more.
        beyond.judged() < wanted
    });
    beyond.needed_at = beyond.needed_at.or(undefined_at);
    Some(beyond)
}

impl SampleStatistics {
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
            Judgement::Undefined(why) => {
                self.undefined += 1;
                if why == Undefined::ZeroDivisor && !near {
                    let values = draft.values();
                    self.divided.get_or_insert(Point { values, near });
                }
            }
            open @ (Judgement::Undecided | Judgement::Unknown(_)) => {
                self.open += 1;
                self.costly += u64::from(open == Judgement::Unknown(Unknown::Work));
                self.why_open.get_or_insert_with(|| open.to_string());
            }
        }
    }
}

/// The negation of a comparison; `None` for other statements.
fn negation(condition: &Expr) -> Option<Expr> {
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
