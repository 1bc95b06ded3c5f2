//! Following one branch of solutions, and proving what was followed.
//!
//! What f64 follows may leave one branch for another where two come close. So nothing is believed of it but
//! where to look: each link of two nodes is proved by itself, and the branch is cut where a link is not.
//!
//! A rising branch crosses each antidiagonal `s + t = u` of the square once, and there `F` changes its sign at
//! a simple zero, for along the antidiagonal its derivative is `(F_t - F_s)/2` with `F_s`, `F_t` of opposite
//! signs. So `u` is a parameter for steep and flat branches alike, and Newton's method on `w = t - s` finds
//! them.

use super::equation::Equation;
use super::survey::{ParameterBox, corners, rises};
use crate::curve::SpaceCurve;
use std::cmp::Ordering;
use torse_algebra::Ball;

/// How a branch ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BranchEnd {
    /// At an end of one of the curves.
    Border,
    /// Inside: there it turns back, or crosses another branch (as at an inflection of both curves), or comes so
    /// close to one of these that it was followed no further.
    Turns,
}

/// One branch: the developable patches that touch both curves along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    pub(super) nodes: Vec<[f64; 2]>,
    pub(super) ends: [BranchEnd; 2],
}

impl Branch {
    /// Pairs `[s, t]` on the branch, rising in both. It is proved (with balls) that there is one branch through all of
    /// them, which rises, or which is flatter than [`NODE_RADIUS`] at the end of a curve: it crosses the antidiagonal
    /// of each within [`NODE_RADIUS`], and between two of them it runs in their bounding box, widened by that much,
    /// which holds no other solution.
    #[must_use]
    pub fn nodes(&self) -> &[[f64; 2]] {
        &self.nodes
    }

    /// How it begins and how it ends.
    #[must_use]
    pub fn ends(&self) -> [BranchEnd; 2] {
        self.ends
    }

    /// First and last parameter on the first curve and on the second.
    #[must_use]
    pub fn ranges(&self) -> [[f64; 2]; 2] {
        let at = |node: Option<&[f64; 2]>, i: usize| node.map_or(0.0, |n| n[i]);
        [0, 1].map(|i| [at(self.nodes.first(), i), at(self.nodes.last(), i)])
    }

    /// How much of both curves it uses: 1 for all of both, 0 for nothing.
    #[must_use]
    pub fn coverage(&self) -> f64 {
        let [[a, b], [c, d]] = self.ranges();
        0.5 * (b - a + d - c)
    }

    /// Whether a solution that is known within half of [`NODE_RADIUS`] is on it: it is when it is in the box of
    /// a link, which holds no other.
    pub(super) fn passes(&self, solution: [f64; 2]) -> bool {
        let within = |link: &[[f64; 2]]| match link {
            [from, to] => (0..2).all(|i| {
                let (a, b) = (from[i].min(to[i]), from[i].max(to[i]));
                a - 0.5 * NODE_RADIUS <= solution[i] && solution[i] <= b + 0.5 * NODE_RADIUS
            }),
            _ => false,
        };
        self.nodes.windows(2).any(within)
    }

    /// Whether it ends in this cell, and not because a curve ends there.
    pub(super) fn stops_in(&self, cell: &ParameterBox) -> bool {
        let near = |[a, b]: [f64; 2], x: f64| a - NODE_RADIUS <= x && x <= b + NODE_RADIUS;
        let ends = [self.nodes.first(), self.nodes.last()];
        ends.into_iter().zip(self.ends).any(|(node, end)| {
            let inside = node.is_some_and(|[s, t]| near(cell.s, *s) && near(cell.t, *t));
            end == BranchEnd::Turns && inside
        })
    }
}

/// Half the width in `s` and `t` within which a node of a [`Branch`] is proved.
pub const NODE_RADIUS: f64 = 1e-9;

/// How near the border a branch that ends there may have been left.
const NEAR_BORDER: f64 = 1e-3;
/// Halvings of an interval on which a branch is proved to be a graph.
const GRAPH_DEPTH: u32 = 24;

/// Steps in `u`, which runs from 0 to 2.
const STEP: f64 = 1.0 / 64.0;
/// The smallest step.
const LEAST_STEP: f64 = 1.0 / 65536.0;
/// Newton steps to a solution.
const NEWTON: usize = 30;

/// `w` on the antidiagonal `u` near `guess`, if the branch rises there.
pub(super) fn solution<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    u: f64,
    guess: f64,
    room: f64,
) -> Option<f64> {
    newton(rails, u, guess, room, |Equation { by_s, by_t, .. }| {
        (*by_s > 0.0 && *by_t < 0.0) || (*by_s < 0.0 && *by_t > 0.0)
    })
}

/// [`solution`] near a proved link, where the branch may be as flat as rounding: whether it rises is not asked.
pub(super) fn solution_on_link<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    u: f64,
    guess: f64,
    room: f64,
) -> Option<f64> {
    newton(rails, u, guess, room, |_| true)
}

/// Newton's method for `w` on the antidiagonal `u`, as long as the derivatives are `admitted`, and `w` stays within
/// `room` of the guess.
fn newton<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    u: f64,
    guess: f64,
    room: f64,
    admitted: impl Fn(&Equation<f64>) -> bool,
) -> Option<f64> {
    let mut w = guess;
    let mut last = f64::INFINITY;
    for _ in 0..NEWTON {
        let equation = Equation::at(rails, &(0.5 * (u - w)), &(0.5 * (u + w))).ok()?;
        let step = equation.value / (0.5 * (equation.by_t - equation.by_s));
        if !admitted(&equation) || !step.is_finite() {
            return None;
        }
        // Rounding: the steps no longer shrink.
        if step.abs() <= 4.0 * f64::EPSILON || (step.abs() < 1e-12 && step.abs() >= last) {
            return Some(w);
        }
        w -= step;
        last = step.abs();
        if (w - guess).abs() > room {
            return None;
        }
    }
    (last < 1e-12).then_some(w)
}

/// The curves, for following and for proving what was followed.
pub(super) struct Tracer<'a, P, Q, A, B> {
    pub rails: (&'a P, &'a Q),
    /// The same curves over balls.
    pub balls: (&'a A, &'a B),
    /// The precision of the balls.
    pub bits: usize,
}

impl<P, Q, A, B> Tracer<'_, P, Q, A, B>
where
    P: SpaceCurve<f64>,
    Q: SpaceCurve<f64>,
    A: SpaceCurve<Ball>,
    B: SpaceCurve<Ball>,
{
    /// The solution in a rising cell, by bisection along the antidiagonal between its corners; known within half of
    /// [`NODE_RADIUS`], or `None`.
    pub(super) fn seed(&self, cell: &ParameterBox) -> Option<[f64; 2]> {
        let on = |k: f64| {
            let ([s0, s1], [t0, t1]) = (cell.s, cell.t);
            [s1 + k * (s0 - s1), t0 + k * (t1 - t0)]
        };
        let value = |k: f64| {
            let [s, t] = on(k);
            let equation = Equation::at(self.rails, &s, &t);
            equation.map(|equation| equation.value).ok()
        };
        let (mut a, mut b) = (0.0, 1.0);
        let negative = value(a)? < 0.0;
        for _ in 0..60 {
            let middle = 0.5 * (a + b);
            if (value(middle)? < 0.0) == negative {
                a = middle;
            } else {
                b = middle;
            }
        }
        let seed = on(0.5 * (a + b));
        self.crosses(seed, 0.5 * NODE_RADIUS).then_some(seed)
    }

    /// The branch through a solution, in both directions; in pieces where it could not be proved.
    pub(super) fn trace(&self, from: [f64; 2]) -> Vec<Branch> {
        let u = from[0] + from[1];
        let Some(w) = solution(self.rails, u, from[1] - from[0], 0.1) else {
            return Vec::new();
        };
        let (mut nodes, mut start) = follow(self.rails, [u, w], -1.0);
        let (after, mut end) = follow(self.rails, [u, w], 1.0);
        nodes.reverse();
        nodes.push([u, w]);
        nodes.extend(after);
        // The border is met up to rounding.
        let nodes = nodes
            .into_iter()
            .map(|[u, w]| [0.5 * (u - w), 0.5 * (u + w)].map(|x| x.clamp(0.0, 1.0)));
        let mut nodes: Vec<[f64; 2]> = nodes.collect();
        if start == BranchEnd::Turns
            && let Some(node) = nodes.first().and_then(|last| self.on_border(*last, 0.0))
        {
            nodes.insert(0, node);
            start = BranchEnd::Border;
        }
        if end == BranchEnd::Turns
            && let Some(node) = nodes.last().and_then(|last| self.on_border(*last, 1.0))
        {
            nodes.push(node);
            end = BranchEnd::Border;
        }
        self.proved(nodes, [start, end])
    }

    /// The solution on the border beside a node where a branch was followed no farther, because it meets the border at
    /// a right angle: at the end of a curve without curvature, such as a natural spline.
    fn on_border(&self, node: [f64; 2], border: f64) -> Option<[f64; 2]> {
        let curve = if (node[0] - border).abs() <= (node[1] - border).abs() {
            0
        } else {
            1
        };
        if (node[curve] - border).abs() > NEAR_BORDER {
            return None;
        }
        let other = 1 - curve;
        let mut at = node;
        at[curve] = border;
        for _ in 0..NEWTON {
            let equation = Equation::at(self.rails, &at[0], &at[1]).ok()?;
            let slopes = [equation.by_s, equation.by_t];
            // The tangent of the branch runs along the other curve's parameter hardly at all.
            let step = equation.value / slopes[other];
            if !step.is_finite() || slopes[curve].abs() > 0.1 * slopes[other].abs() {
                return None;
            }
            at[other] -= step;
            if step.abs() <= 4.0 * f64::EPSILON {
                break;
            }
        }
        let ahead = if border == 0.0 {
            node[other] - at[other]
        } else {
            at[other] - node[other]
        };
        let inside = (0.0..=1.0).contains(&at[other]);
        (inside && (-NODE_RADIUS..NEAR_BORDER).contains(&ahead)).then_some(at)
    }

    /// The pieces of what was followed that are proved, with nodes added where boxes are too large for it.
    fn proved(&self, nodes: Vec<[f64; 2]>, [start, end]: [BranchEnd; 2]) -> Vec<Branch> {
        let crossed = |node: &[f64; 2]| self.crosses(*node, NODE_RADIUS);
        let sum = |[s, t]: [f64; 2]| s + t;
        let (first, last) = (nodes.first().copied(), nodes.last().copied());
        let mut open: Vec<[f64; 2]> = nodes.into_iter().rev().filter(crossed).collect();
        let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
        let mut piece: Vec<[f64; 2]> = Vec::new();
        while let Some(next) = open.pop() {
            let Some(&before) = piece.last() else {
                piece.push(next);
                continue;
            };
            if self.links(before, next) {
                piece.push(next);
                continue;
            }
            let guess = 0.5 * (before[1] - before[0] + next[1] - next[0]);
            let u = 0.5 * (sum(before) + sum(next));
            let between = (sum(next) - sum(before) > LEAST_STEP)
                .then(|| solution(self.rails, u, guess, 0.1))
                .flatten()
                .map(|w| [0.5 * (u - w), 0.5 * (u + w)])
                .filter(crossed);
            open.push(next);
            match between {
                Some(node) => open.push(node),
                None => pieces.push(std::mem::take(&mut piece)),
            }
        }
        pieces.push(piece);
        let at = |node: Option<&[f64; 2]>, end: Option<[f64; 2]>, kind: BranchEnd| {
            let reached = node.copied() == end;
            if reached { kind } else { BranchEnd::Turns }
        };
        let branch = |nodes: Vec<[f64; 2]>| Branch {
            ends: [at(nodes.first(), first, start), at(nodes.last(), last, end)],
            nodes,
        };
        let long = |nodes: &Vec<[f64; 2]>| nodes.len() >= 2;
        pieces.into_iter().filter(long).map(branch).collect()
    }

    /// Whether `F` is proved to change its sign on the antidiagonal within this distance of a point.
    fn crosses(&self, node: [f64; 2], radius: f64) -> bool {
        corners(self.balls.0, self.balls.1, &around(node, radius), self.bits) == Some(true)
    }

    /// Whether the solutions about two nodes and between them are proved to be one rising graph.
    fn links(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let (lower, upper) = (around(from, NODE_RADIUS), around(to, NODE_RADIUS));
        let joined = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        let cell = ParameterBox {
            s: joined(lower.s, upper.s),
            t: joined(lower.t, upper.t),
        };
        rises(self.balls.0, self.balls.1, &cell, self.bits) || self.is_graph(&cell)
    }

    /// Whether the solutions in a box are proved to be one graph over one of both parameters, that leaves it at the
    /// ends of that parameter only: the derivative by the other one has a sign, and so has `F` on both sides. Where the
    /// branch is as flat as rounding it need not rise.
    fn is_graph(&self, cell: &ParameterBox) -> bool {
        let curve = if cell.s[1] - cell.s[0] >= cell.t[1] - cell.t[0] {
            0
        } else {
            1
        };
        let over = |[from, to]: [f64; 2]| {
            Ball::from_bounds(&crate::exact(from), &crate::exact(to), self.bits)
        };
        let sides = [cell.s, cell.t];
        let place = |along: &Ball, across: &Ball| {
            if curve == 0 {
                Equation::at(self.balls, along, across).ok()
            } else {
                Equation::at(self.balls, across, along).ok()
            }
        };
        let Some(whole) = place(&over(sides[curve]), &over(sides[1 - curve])) else {
            return false;
        };
        let across = if curve == 0 { whole.by_t } else { whole.by_s };
        if across.sign().is_none_or(Ordering::is_eq) {
            return false;
        }
        let sign = |at: f64| -> Option<Ordering> {
            let at = crate::exact_ball(at, self.bits);
            let mut found: Option<Ordering> = None;
            let mut open = vec![(sides[curve], 0)];
            while let Some(([from, to], depth)) = open.pop() {
                let middle = 0.5 * (from + to);
                let range = over([from, to]);
                let (here, there) = (
                    place(&crate::exact_ball(middle, self.bits), &at)?,
                    place(&range, &at)?,
                );
                let slope = if curve == 0 { there.by_s } else { there.by_t };
                let value = here.value + slope * (range - crate::exact_ball(middle, self.bits));
                match value.sign().filter(|sign| sign.is_ne()) {
                    Some(sign) if found.is_none_or(|known| known == sign) => found = Some(sign),
                    Some(_) => return None,
                    None if depth >= GRAPH_DEPTH => return None,
                    None => open.extend([([from, middle], depth + 1), ([middle, to], depth + 1)]),
                }
            }
            found
        };
        let [low, high] = sides[1 - curve];
        matches!((sign(low), sign(high)), (Some(a), Some(b)) if a != b)
    }
}

/// The square of this half width about a point.
fn around([s, t]: [f64; 2], radius: f64) -> ParameterBox {
    ParameterBox {
        s: [s - radius, s + radius],
        t: [t - radius, t + radius],
    }
}

/// `min(s, t, 1 - s, 1 - t)`: negative outside of the square.
fn inside([u, w]: [f64; 2]) -> f64 {
    let (s, t) = (0.5 * (u - w), 0.5 * (u + w));
    s.min(t).min(1.0 - s).min(1.0 - t)
}

/// The nodes `[u, w]` after one that is inside, up to the border or to where the branch turns.
fn follow<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    from: [f64; 2],
    direction: f64,
) -> (Vec<[f64; 2]>, BranchEnd) {
    let mut nodes: Vec<[f64; 2]> = Vec::new();
    let mut last = from;
    let mut slope = 0.0;
    let mut step = STEP;
    if inside(last) <= 0.0 {
        return (nodes, BranchEnd::Border);
    }
    loop {
        let h = direction * step;
        let next = solution(rails, last[0] + h, last[1] + slope * h, 2.0 * step);
        // Rising: w changes by less than u.
        let next = next.filter(|w| (w - last[1]).abs() < step);
        let Some(w) = next else {
            step *= 0.5;
            if step < LEAST_STEP {
                return (nodes, BranchEnd::Turns);
            }
            continue;
        };
        let node = [last[0] + h, w];
        if inside(node) < 0.0 {
            let Some(border) = border(rails, last, node) else {
                return (nodes, BranchEnd::Turns);
            };
            // Not twice the same point, when the last node was on the border but for rounding.
            if (border[0] - last[0]).abs() > 1e-12 {
                nodes.push(border);
            }
            return (nodes, BranchEnd::Border);
        }
        slope = (w - last[1]) / h;
        nodes.push(node);
        last = node;
        step = (2.0 * step).min(STEP);
    }
}

/// Where the branch between a node inside and one outside crosses the border: the last point inside.
fn border<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    within: [f64; 2],
    beyond: [f64; 2],
) -> Option<[f64; 2]> {
    let (mut a, mut b) = (within, beyond);
    for _ in 0..60 {
        let u = 0.5 * (a[0] + b[0]);
        let guess = 0.5 * (a[1] + b[1]);
        let node = [
            u,
            solution(rails, u, guess, 2.0 * (b[0] - a[0]).abs() + 1e-9)?,
        ];
        if inside(node) < 0.0 {
            b = node
        } else {
            a = node
        }
    }
    // A corner is hit up to rounding only: the nearer of both.
    Some(if inside(b) > -1e-12 { b } else { a })
}
