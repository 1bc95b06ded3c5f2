//! Following one branch of solutions, and proving what was followed.
//!
//! A rising branch crosses each antidiagonal `s + t = u` of the square once, and there `F` changes its sign at
//! a simple zero, for along the antidiagonal its derivative is `(F_t - F_s)/2` with `F_s`, `F_t` of opposite
//! signs. So `u` is a parameter for steep and flat branches alike, and Newton's method on `w = t - s` finds
//! them.

use super::equation::Equation;
use super::survey::{ParameterBox, corners, rises};
use crate::curve::SpaceCurve;
use torse_algebra::Ball;

/// How a branch ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BranchEnd {
    /// At an end of one of the curves.
    Border,
    /// Inside: there it turns back, or crosses another branch (as at an inflection of both curves).
    Turns,
}

/// One branch: the developable patches that touch both curves along it.
#[derive(Debug, Clone, PartialEq)]
pub struct Branch {
    pub(super) nodes: Vec<[f64; 2]>,
    pub(super) ends: [BranchEnd; 2],
    pub(super) proved: bool,
}

impl Branch {
    /// Pairs `[s, t]` on the branch, rising in both. When the branch [is proved](Branch::is_proved), the true
    /// branch crosses the antidiagonal of each within [`NODE_RADIUS`], and between two of them it runs in
    /// their bounding box, widened by that much.
    #[must_use]
    pub fn nodes(&self) -> &[[f64; 2]] {
        &self.nodes
    }

    /// How it begins and how it ends.
    #[must_use]
    pub fn ends(&self) -> [BranchEnd; 2] {
        self.ends
    }

    /// Whether it is proved (with balls) that there is one strictly rising branch through all nodes.
    #[must_use]
    pub fn is_proved(&self) -> bool {
        self.proved
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
}

/// Half the width in `s` and `t` within which a node of a [`Branch`] is proved.
pub const NODE_RADIUS: f64 = 1e-9;

/// Steps in `u`, which runs from 0 to 2.
const STEP: f64 = 1.0 / 64.0;
/// The smallest step.
const LEAST_STEP: f64 = 1.0 / 65536.0;
/// Newton steps to a solution.
const NEWTON: usize = 30;

/// `w` and `(F_t - F_s)/2` on the antidiagonal `u` near `guess`, if the branch rises there.
pub(super) fn solution<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    u: f64,
    guess: f64,
    room: f64,
) -> Option<f64> {
    let mut w = guess;
    let mut last = f64::INFINITY;
    for _ in 0..NEWTON {
        let equation = Equation::at(rails, &(0.5 * (u - w)), &(0.5 * (u + w))).ok()?;
        let (a, b) = (equation.by_s, equation.by_t);
        let rises = (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0);
        let step = equation.value / (0.5 * (b - a));
        if !rises || !step.is_finite() {
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

/// The solution in a rising cell, by bisection along the antidiagonal between its corners.
pub(super) fn seed<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    cell: &ParameterBox,
) -> Option<[f64; 2]> {
    let on = |k: f64| {
        let ([s0, s1], [t0, t1]) = (cell.s, cell.t);
        [s1 + k * (s0 - s1), t0 + k * (t1 - t0)]
    };
    let value = |k: f64| {
        let [s, t] = on(k);
        Equation::at(rails, &s, &t)
            .map(|equation| equation.value)
            .ok()
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
    Some(on(0.5 * (a + b)))
}

/// The branch through a solution, in both directions.
pub(super) fn trace<P: SpaceCurve<f64>, Q: SpaceCurve<f64>>(
    rails: (&P, &Q),
    from: [f64; 2],
) -> Option<Branch> {
    let u = from[0] + from[1];
    let w = solution(rails, u, from[1] - from[0], 0.1)?;
    let (mut nodes, start) = follow(rails, [u, w], -1.0);
    let (after, end) = follow(rails, [u, w], 1.0);
    nodes.reverse();
    nodes.push([u, w]);
    nodes.extend(after);
    let nodes: Vec<[f64; 2]> = nodes
        .into_iter()
        .map(|[u, w]| [0.5 * (u - w), 0.5 * (u + w)])
        .collect();
    let long = nodes.len() >= 2;
    long.then_some(Branch {
        nodes,
        ends: [start, end],
        proved: false,
    })
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
            if let Some(border) = border(rails, last, node) {
                // Not twice the same point, when the last node was on the border but for rounding.
                if (border[0] - last[0]).abs() > 1e-12 || nodes.is_empty() {
                    nodes.push(border);
                }
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

/// Proves the branch, adding nodes where boxes are too large for it.
pub(super) fn prove<P, Q, A, B>(
    branch: Branch,
    rails: (&P, &Q),
    balls: (&A, &B),
    bits: usize,
) -> Branch
where
    P: SpaceCurve<f64>,
    Q: SpaceCurve<f64>,
    A: SpaceCurve<Ball>,
    B: SpaceCurve<Ball>,
{
    let mut nodes: Vec<[f64; 2]> = Vec::with_capacity(branch.nodes.len());
    let mut open: Vec<[f64; 2]> = branch.nodes.into_iter().rev().collect();
    let mut proved = true;
    let around = |[s, t]: [f64; 2]| ParameterBox {
        s: [s - NODE_RADIUS, s + NODE_RADIUS],
        t: [t - NODE_RADIUS, t + NODE_RADIUS],
    };
    let crossed = |node| corners(balls.0, balls.1, &around(node), bits) == Some(true);
    while let Some(next) = open.pop() {
        let Some(&last) = nodes.last() else {
            proved &= crossed(next);
            nodes.push(next);
            continue;
        };
        let (lower, upper) = (around(last), around(next));
        let joined = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        let cell = ParameterBox {
            s: joined(lower.s, upper.s),
            t: joined(lower.t, upper.t),
        };
        if rises(balls.0, balls.1, &cell, bits) {
            proved &= crossed(next);
            nodes.push(next);
            continue;
        }
        let sum = |[s, t]: [f64; 2]| s + t;
        let u = 0.5 * (sum(last) + sum(next));
        let guess = 0.5 * (last[1] - last[0] + next[1] - next[0]);
        let between = solution(rails, u, guess, 0.1);
        match between.filter(|_| sum(next) - sum(last) > LEAST_STEP) {
            Some(w) => {
                open.push(next);
                open.push([0.5 * (u - w), 0.5 * (u + w)]);
            }
            None => {
                proved = false;
                nodes.push(next);
            }
        }
    }
    Branch {
        nodes,
        ends: branch.ends,
        proved,
    }
}
