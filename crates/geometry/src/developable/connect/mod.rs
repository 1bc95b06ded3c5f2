//! The developables that connect two space curves.
//!
//! The ruling from `c1(s)` to `c2(t)` belongs to a developable through both curves when one plane touches both
//! along it, that is when
//!
//! ```text
//! F(s, t) = det(c1'(s), c2'(t), c2(t) - c1(s)) = 0
//! ```
//!
//! (the torse of two directrices of classical descriptive geometry; "developable loft" of CAD). Its solutions
//! are curves in the square of parameters; each part that rises in both, a *branch*, gives one patch. There
//! may be several, or none, and they need not reach the ends of the curves. [`connect`] finds them all, in
//! two steps that check each other: bisection with balls shows where solutions can be ([`ParameterBox`]), and
//! what is followed from there on f64 is proved afterwards, box by box. Each cell with rising solutions is then
//! accounted for: a branch runs through it from end to end, or it is among the
//! [undecided](Connections::undecided).
//!
//! Two coplanar curves satisfy the equation everywhere; then every ruled surface between them is flat, and no
//! branch is singled out.

mod equation;
mod patch;
mod survey;
mod trace;
mod ways;

pub use patch::ConnectingPatch;
pub use survey::ParameterBox;
pub use trace::{Branch, BranchEnd, NODE_RADIUS};
pub(crate) use ways::{Landscape, Node, Step, StepKind, Way, may_exist, ways};

use super::certificate::certify;
use crate::coordinate::Coordinate;
use crate::curve::SpaceCurve;
use crate::error::{GeometryError, Place, Result, count};
use crate::over::Over;
use crate::scalars::exact_ball;
use crate::vector::{cross, dot, norm, sub};
use equation::{Contact, Equation};
use std::cmp::Ordering;
use torse_algebra::Ball;

/// Why a branch was preferred.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BranchReason {
    /// There is no other.
    Only,
    /// No other gives a regular patch.
    OnlyRegular,
    /// It uses most of the curves: as much of them as the first number says (1 for all of both), the next best
    /// the second.
    CoversMost(f64, f64),
    /// Of those that use as much of the curves, its longest ruling (the first number) is the shortest.
    ShorterRulings(f64, f64),
}

/// The ruling with the least twist through a point of one curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BestRuling {
    /// The parameter on the first curve.
    pub s: f64,
    /// The parameter on the second curve.
    pub t: f64,
    /// The angle between the tangent planes at its ends, in radians.
    pub twist: f64,
}

/// A part of a curve that no ruling of the chosen branch meets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RailGap {
    /// Whether it is on the first curve (0) or on the second (1).
    pub curve: usize,
    /// Its parameters.
    pub range: [f64; 2],
    /// The place where even the best ruling twists most: an estimate from samples.
    pub worst: BestRuling,
}

/// What [`connect`] found.
#[derive(Debug, Clone, PartialEq)]
pub struct Connections<P, Q> {
    curves: (P, Q),
    branches: Vec<Branch>,
    choice: Option<(usize, BranchReason)>,
    gaps: Vec<RailGap>,
    falling: Vec<ParameterBox>,
    open: Vec<ParameterBox>,
}

impl<P: Clone, Q: Clone> Connections<P, Q> {
    /// The branches, in the order of their first parameters.
    #[must_use]
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// The branch that was chosen, and why; `None` when there is none.
    #[must_use]
    pub fn choice(&self) -> Option<(usize, BranchReason)> {
        self.choice
    }

    /// What the chosen branch leaves of the curves; all of both when there is none.
    #[must_use]
    pub fn gaps(&self) -> &[RailGap] {
        &self.gaps
    }

    /// Cells in which solutions may fall: they give no patch, as its rulings would run against a curve.
    #[must_use]
    pub fn falling(&self) -> &[ParameterBox] {
        &self.falling
    }

    /// Cells about which nothing was decided (a crossing or a turn of branches lies there, or nothing at all):
    /// every rising solution is in one of these or [on a branch](Branch::nodes).
    #[must_use]
    pub fn undecided(&self) -> &[ParameterBox] {
        &self.open
    }

    /// The patch of a branch; `None` when there are fewer.
    #[must_use]
    pub fn patch(&self, branch: usize) -> Option<ConnectingPatch<P, Q>> {
        let branch = self.branches.get(branch)?.clone();
        Some(ConnectingPatch::new(
            self.curves.0.clone(),
            self.curves.1.clone(),
            branch,
        ))
    }

    /// The patch of the chosen branch.
    #[must_use]
    pub fn chosen(&self) -> Option<ConnectingPatch<P, Q>> {
        self.choice.and_then(|(branch, _)| self.patch(branch))
    }
}

impl<P: SpaceCurve<f64>, Q: SpaceCurve<f64>> Connections<P, Q> {
    /// The place on a branch where the parameter of this curve (0, 1) has a value between those of two nodes: by
    /// bisection, as `F` changes its sign once between the nodes.
    pub(crate) fn on_branch(&self, branch: usize, curve: usize, value: f64) -> Option<Node> {
        let nodes = self.branches.get(branch)?.nodes();
        let after = nodes.partition_point(|node| node[curve] < value);
        let after = after.clamp(1, nodes.len().checked_sub(1)?);
        let (low, high) = (nodes.get(after - 1)?, nodes.get(after)?);
        let other = 1 - curve;
        let place = |x: f64| if curve == 0 { [value, x] } else { [x, value] };
        let at = |x: f64| -> Option<f64> {
            let [s, t] = place(x);
            let equation = Equation::at((&self.curves.0, &self.curves.1), &s, &t);
            equation.map(|equation| equation.value).ok()
        };
        let (mut from, mut to) = (
            (low[other] - NODE_RADIUS).max(0.0),
            (high[other] + NODE_RADIUS).min(1.0),
        );
        let (start, end) = (at(from)?, at(to)?);
        if (start < 0.0) == (end < 0.0) {
            // At a node but for rounding.
            let node = if (value - low[curve]).abs() <= (value - high[curve]).abs() {
                low
            } else {
                high
            };
            let close = (node[curve] - value).abs() <= NODE_RADIUS;
            return close.then_some(*node);
        }
        for _ in 0..64 {
            let middle = 0.5 * (from + to);
            if (at(middle)? < 0.0) == (start < 0.0) {
                from = middle;
            } else {
                to = middle;
            }
        }
        Some(place(0.5 * (from + to)))
    }

    /// The solutions with this value of the parameter of this curve (0, 1), at which the tangent planes at both ends
    /// have the patch on the same side: as many as samples show, and of a run of samples that all are solutions both
    /// ends, as those between them are rulings of the fan over it.
    pub(crate) fn on_line(&self, curve: usize, value: f64) -> Vec<Node> {
        const SAMPLES: u32 = 128;
        let place = |x: f64| if curve == 0 { [value, x] } else { [x, value] };
        let at = |x: f64| -> Option<[f64; 2]> {
            let [s, t] = place(x);
            let (one, two) = (
                Contact::at(&self.curves.0, &s).ok()?,
                Contact::at(&self.curves.1, &t).ok()?,
            );
            let size = norm(&one.first) * norm(&two.first) * norm(&sub(&two.point, &one.point));
            Some([Equation::from_contacts(&one, &two).value, size])
        };
        let mut found = Vec::new();
        let mut run: Vec<Node> = Vec::new();
        let mut before: Option<(f64, f64)> = None;
        for k in 0..=SAMPLES {
            let x = f64::from(k) / f64::from(SAMPLES);
            let here = at(x);
            if let Some([value, size]) = here
                && value.abs() <= 1e-14 * size
            {
                run.extend(Some(place(x)).filter(|node| self.one_side(node)));
                before = None;
                continue;
            }
            found.extend(ends_of(&run));
            run.clear();
            let Some([value, _]) = here else {
                before = None;
                continue;
            };
            if let Some((from, last)) = before
                && (last < 0.0) != (value < 0.0)
            {
                let (mut a, mut b) = (from, x);
                for _ in 0..60 {
                    let middle = 0.5 * (a + b);
                    match at(middle) {
                        Some([value, _]) if (value < 0.0) == (last < 0.0) => a = middle,
                        _ => b = middle,
                    }
                }
                found.push(place(0.5 * (a + b)));
            }
            before = Some((x, value));
        }
        found.extend(ends_of(&run));
        found.retain(|node| self.one_side(node));
        found
    }

    /// Whether the tangent planes at both ends of each ruling of a branch have the patch on the same side, at its
    /// nodes.
    pub(crate) fn is_regular(&self, branch: usize) -> bool {
        let nodes = self.branches.get(branch).map(Branch::nodes);
        nodes.is_some_and(|nodes| nodes.iter().all(|node| self.one_side(node)))
    }

    fn one_side(&self, [s, t]: &Node) -> bool {
        let ends = (
            Contact::at(&self.curves.0, s),
            Contact::at(&self.curves.1, t),
        );
        let (Ok(one), Ok(two)) = ends else {
            return false;
        };
        let ruling = sub(&two.point, &one.point);
        dot(&cross(&one.first, &ruling), &cross(&two.first, &ruling)) > 0.0
    }
}

/// The first and the last of a run.
fn ends_of(run: &[Node]) -> impl Iterator<Item = Node> {
    let last = run.last().filter(|_| run.len() > 1);
    run.first().into_iter().chain(last).copied()
}

impl<P, Q> Connections<P, Q>
where
    P: SpaceCurve<f64> + Over<f64, Ball, Object: SpaceCurve<Ball>> + Clone,
    Q: SpaceCurve<f64> + Over<f64, Ball, Object: SpaceCurve<Ball>> + Clone,
{
    /// What is left of cells when those parts are taken away in which it is proved that there is no solution, or none
    /// at which the tangent planes at both ends have the patch on the same side: no panel passes there.
    ///
    /// # Errors
    /// As [`connect`].
    pub(crate) fn passable(&self, cells: Vec<ParameterBox>) -> Result<Vec<ParameterBox>> {
        let (first, second) = (&self.curves.0, &self.curves.1);
        let bits = precision((first, second))?;
        let ball = |x: &f64| exact_ball(*x, bits);
        let (one, two) = (first.over(&ball)?, second.over(&ball)?);
        let over =
            |[from, to]: [f64; 2]| Ball::from_bounds(&crate::exact(from), &crate::exact(to), bits);
        let mut kept = Vec::new();
        let mut work = 0;
        let mut open: Vec<(ParameterBox, u32)> =
            cells.into_iter().rev().map(|cell| (cell, 0)).collect();
        while let Some((cell, depth)) = open.pop() {
            work += 1;
            let contacts = (
                Contact::at(&one, &over(cell.s)),
                Contact::at(&two, &over(cell.t)),
            );
            let (Ok(a), Ok(b)) = contacts else {
                kept.push(cell);
                continue;
            };
            let ruling = sub(&b.point, &a.point);
            let side = dot(&cross(&a.first, &ruling), &cross(&b.first, &ruling)).sign();
            let value = Equation::from_contacts(&a, &b).value.sign();
            if side == Some(Ordering::Less) || value.is_some_and(Ordering::is_ne) {
                continue;
            }
            if side == Some(Ordering::Greater) || depth >= SIDE_DEPTH || work >= MAX_SIDE_CELLS {
                kept.push(cell);
                continue;
            }
            let halves = |[from, to]: [f64; 2]| {
                let middle = 0.5 * (from + to);
                [[from, middle], [middle, to]]
            };
            for s in halves(cell.s) {
                open.extend(halves(cell.t).map(|t| (ParameterBox { s, t }, depth + 1)));
            }
        }
        Ok(kept)
    }
}

/// How often a cell is halved to see on which side of it the patch lies.
const SIDE_DEPTH: u32 = 4;
/// Cells looked at for that, at most.
const MAX_SIDE_CELLS: usize = 20_000;

/// Bits after the point, for curves of the size of one.
const BITS: usize = 96;
/// Rulings on which the patches of competing branches are measured.
const RULINGS: usize = 33;

/// Finds all developable patches between two curves and chooses one: regular before singular, then the one
/// that uses most of the curves, then the one with the shorter rulings.
///
/// # Errors
/// [`GeometryError::Degenerate`] when the equation holds everywhere as far as f64 knows (coplanar curves, or a
/// curve that is a point), and what the curves refuse.
///
/// ```
/// use torse_geometry::developable::{certify, connect};
/// use torse_geometry::{Bernstein, Curve};
/// let rail = |points: [[f64; 3]; 3]| Curve::new(Bernstein, points.to_vec());
/// let lower = rail([[0.0, 0.0, 0.0], [2.0, 3.0, 0.0], [6.0, 0.0, 0.0]])?;
/// let upper = rail([[0.5, 0.0, 2.0], [3.0, 2.0, 3.0], [6.0, -1.0, 2.0]])?;
/// let found = connect(&lower, &upper)?;
/// let patch = found.chosen().expect("one developable");
/// assert!(patch.branch().coverage() > 0.8);
/// let certificate = certify(&patch, 32)?;
/// assert!(certificate.is_regular() && certificate.is_developable_within(1e-7));
/// // What is left of the curves cannot be reached without twist.
/// assert!(found.gaps().iter().all(|gap| gap.worst.twist > 0.0));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn connect<P, Q>(first: &P, second: &Q) -> Result<Connections<P, Q>>
where
    P: SpaceCurve<f64> + Over<f64, Ball, Object: SpaceCurve<Ball>> + Clone,
    Q: SpaceCurve<f64> + Over<f64, Ball, Object: SpaceCurve<Ball>> + Clone,
{
    let mut found = all_branches(first, second)?;
    found.choice = choose(&found);
    let ranges = found.chosen().map(|patch| patch.branch().ranges());
    found.gaps = gaps((first, second), ranges)?;
    Ok(found)
}

/// What [`connect`] finds before it chooses.
pub(crate) fn all_branches<P, Q>(first: &P, second: &Q) -> Result<Connections<P, Q>>
where
    P: SpaceCurve<f64> + Over<f64, Ball, Object: SpaceCurve<Ball>> + Clone,
    Q: SpaceCurve<f64> + Over<f64, Ball, Object: SpaceCurve<Ball>> + Clone,
{
    let rails = (first, second);
    let bits = precision(rails)?;
    let ball = |x: &f64| exact_ball(*x, bits);
    let (one, two) = (first.over(&ball)?, second.over(&ball)?);
    let tracer = trace::Tracer {
        rails,
        balls: (&one, &two),
        bits,
    };
    let survey::Survey {
        rising,
        falling,
        mut open,
    } = survey::survey(&one, &two, bits);
    let mut branches: Vec<Branch> = Vec::new();
    let mut seeds: Vec<(ParameterBox, [f64; 2])> = Vec::new();
    for cell in rising {
        let Some(seed) = tracer.seed(&cell) else {
            open.push(cell);
            continue;
        };
        seeds.push((cell, seed));
        if branches.iter().any(|branch| branch.passes(seed)) {
            continue;
        }
        for piece in tracer.trace(seed) {
            let known = |node: &[f64; 2]| branches.iter().any(|branch| branch.passes(*node));
            if !piece.nodes.iter().any(known) {
                branches.push(piece);
            }
        }
    }
    // The one rising graph in a cell is all on a branch that meets it and does not end there.
    open.extend(seeds.into_iter().filter_map(|(cell, seed)| {
        let whole = |branch: &Branch| branch.passes(seed) && !branch.stops_in(&cell);
        (!branches.iter().any(whole)).then_some(cell)
    }));
    branches.sort_by(|a, b| {
        a.nodes
            .partial_cmp(&b.nodes)
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    Ok(Connections {
        curves: (first.clone(), second.clone()),
        branches,
        choice: None,
        gaps: Vec::new(),
        falling,
        open,
    })
}

/// Bits for balls of the size of these curves; refuses curves for which the equation says nothing.
fn precision<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(rails: (&P, &Q)) -> Result<usize> {
    const GRID: u32 = 7;
    let contacts = |k: u32| -> Result<_> {
        let x = (f64::from(k) + 0.5) / f64::from(GRID);
        Ok((Contact::at(rails.0, &x)?, Contact::at(rails.1, &x)?))
    };
    let contacts = (0..GRID).map(contacts).collect::<Result<Vec<_>>>()?;
    let (mut scale, mut nonzero) = (0.0_f64, false);
    for (one, _) in &contacts {
        for (_, two) in &contacts {
            let size = norm(&one.first) * norm(&two.first);
            let reach = norm(&sub(&two.point, &one.point));
            let away = norm(&one.point) + norm(&two.point);
            let value = Equation::from_contacts(one, two).value.abs();
            if !(size.is_finite() && away.is_finite() && value.is_finite()) {
                return Err(GeometryError::NoValue {
                    what: "size of the curves",
                    at: Place::Whole,
                });
            }
            nonzero |= value > 1e-13 * size * (reach + 1e-3 * away);
            scale = scale.max(norm(&one.first)).max(norm(&two.first)).max(reach);
        }
    }
    if !nonzero {
        return Err(GeometryError::Degenerate {
            what: "curves of which two pieces lie in one plane, as parallel straight ones do, or one is a point: every ruling there is torsal",
            at: Place::Whole,
        });
    }
    let small = scale.exponent().unwrap_or(0).min(0).unsigned_abs();
    // The equation is a product of three lengths.
    Ok(BITS + 3 * usize::try_from(small).unwrap_or(0))
}

/// The branch to take, and why.
fn choose<P: SpaceCurve<f64> + Clone, Q: SpaceCurve<f64> + Clone>(
    found: &Connections<P, Q>,
) -> Option<(usize, BranchReason)> {
    struct Candidate {
        index: usize,
        regular: bool,
        coverage: f64,
        longest: f64,
    }
    let candidate = |index: usize| {
        let patch = found.patch(index)?;
        let rails = found.curves.clone();
        let length = |[s, t]: &[f64; 2]| {
            let ends = (Contact::at(&rails.0, s), Contact::at(&rails.1, t));
            match ends {
                (Ok(one), Ok(two)) => norm(&sub(&two.point, &one.point)),
                _ => f64::INFINITY,
            }
        };
        Some(Candidate {
            index,
            regular: certify(&patch, RULINGS).is_ok_and(|c| c.is_regular()),
            coverage: patch.branch().coverage(),
            longest: patch.branch().nodes.iter().map(length).fold(0.0, f64::max),
        })
    };
    let mut all: Vec<Candidate> = (0..found.branches.len()).filter_map(candidate).collect();
    // To a thousandth, so that rounding does not decide between mirror images.
    let share = |c: &Candidate| (c.coverage * 1e3).round();
    all.sort_by(|a, b| {
        (b.regular.cmp(&a.regular))
            .then(share(b).total_cmp(&share(a)))
            .then(a.longest.total_cmp(&b.longest))
    });
    let reason = match all.as_slice() {
        [] => return None,
        [_] => BranchReason::Only,
        [a, b, ..] if a.regular && !b.regular => BranchReason::OnlyRegular,
        [a, b, ..] if share(a) > share(b) => BranchReason::CoversMost(a.coverage, b.coverage),
        [a, b, ..] => BranchReason::ShorterRulings(a.longest, b.longest),
    };
    all.first().map(|best| (best.index, reason))
}

/// Samples of a gap, and of the other curve for each.
const GAP_SAMPLES: usize = 17;
const OTHER_SAMPLES: usize = 65;

fn gaps<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    ranges: Option<[[f64; 2]; 2]>,
) -> Result<Vec<RailGap>> {
    let mut gaps = Vec::new();
    for curve in [0, 1] {
        let parts = match ranges.map(|ranges| ranges[curve]) {
            None => vec![[0.0, 1.0]],
            Some([from, to]) => vec![[0.0, from], [to, 1.0]],
        };
        for range in parts.into_iter().filter(|[a, b]| b - a > NODE_RADIUS) {
            let mut worst: Option<BestRuling> = None;
            for k in 0..GAP_SAMPLES {
                let part = count(k) / count(GAP_SAMPLES - 1);
                let at = range[0] + (range[1] - range[0]) * part;
                let best = best_ruling(rails, curve, at)?;
                if worst.is_none_or(|worst| best.twist > worst.twist) {
                    worst = Some(best);
                }
            }
            gaps.extend(worst.map(|worst| RailGap {
                curve,
                range,
                worst,
            }));
        }
    }
    Ok(gaps)
}

/// The ruling of least twist through the point at this parameter of a curve: the best of samples of the other
/// curve, refined between its neighbours by golden section.
fn best_ruling<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    curve: usize,
    at: f64,
) -> Result<BestRuling> {
    let ruling = |other: f64| -> Result<BestRuling> {
        let (s, t) = if curve == 0 { (at, other) } else { (other, at) };
        let (one, two) = (Contact::at(rails.0, &s)?, Contact::at(rails.1, &t)?);
        let r = sub(&two.point, &one.point);
        let (n0, n1) = (cross(&one.first, &r), cross(&two.first, &r));
        let twist = libm::atan2(norm(&cross(&n0, &n1)), dot(&n0, &n1).abs());
        Ok(BestRuling { s, t, twist })
    };
    let sample = |k: usize| count(k.min(OTHER_SAMPLES - 1)) / count(OTHER_SAMPLES - 1);
    let mut best = ruling(0.0)?;
    let mut index = 0;
    for k in 1..OTHER_SAMPLES {
        let next = ruling(sample(k))?;
        if next.twist < best.twist {
            (best, index) = (next, k);
        }
    }
    let (mut a, mut b) = (sample(index.saturating_sub(1)), sample(index + 1));
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..40 {
        let (left, right) = (ruling(b - golden * (b - a))?, ruling(a + golden * (b - a))?);
        for found in [left, right] {
            if found.twist < best.twist {
                best = found;
            }
        }
        if left.twist <= right.twist {
            b = a + golden * (b - a);
        } else {
            a = b - golden * (b - a);
        }
    }
    Ok(best)
}
