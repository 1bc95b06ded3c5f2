//! The patch along a branch, as rails with a common parameter.

use super::equation::{Equation, Expansion};
use super::trace::{Branch, NODE_RADIUS, solution};
use crate::coordinate::Coordinate;
use crate::curve::SpaceCurve;
use crate::error::{GeometryError, Place, Result};
use crate::scalars::{Over, exact_ball};
use crate::surface::{Partials, Rails, Surface, partials_between};
use torse_algebra::{Ball, Jet, Rational, Scalar};

/// The developable patch that touches two curves along a [`Branch`]: its rails are parts of the curves, and
/// the tangent planes of both agree along each ruling.
///
/// The common parameter `x` in [0, 1] is proportional to the sum `s + t` of the parameters of the curves.
/// On f64 each ruling is a solution up to rounding, on balls an enclosure of the true one.
#[derive(Debug, Clone, PartialEq)]
pub struct ConnectingPatch<P, Q> {
    first: P,
    second: Q,
    branch: Branch,
}

impl<P, Q> ConnectingPatch<P, Q> {
    pub(super) fn new(first: P, second: Q, branch: Branch) -> Self {
        Self {
            first,
            second,
            branch,
        }
    }

    /// The curves.
    #[must_use]
    pub fn curves(&self) -> (&P, &Q) {
        (&self.first, &self.second)
    }

    /// The branch.
    #[must_use]
    pub fn branch(&self) -> &Branch {
        &self.branch
    }

    /// First and last `u = s + t`.
    fn span(&self) -> [f64; 2] {
        let [[s0, s1], [t0, t1]] = self.branch.ranges();
        [s0 + t0, s1 + t1]
    }

    /// The rails as series, given `w = t - s` at the parameter; the coefficients of `w` follow one by one
    /// from those of `F = 0`, in which the newest enters times `(F_t - F_s)/2`.
    fn series<S: Coordinate>(&self, u: &S, w: S, order: usize) -> Result<[[Jet<S>; 3]; 2]>
    where
        P: SpaceCurve<S>,
        Q: SpaceCurve<S>,
    {
        let half = |jet: Jet<S>| -> Jet<S> { jet.times_two_to(-1) };
        let [from, to] = self.span();
        let mut u_series = Jet::of_constant(u.clone(), order);
        if order > 0 {
            // The difference of the exact ends, which f64 might round.
            let end = |x: f64| u.constant(&crate::exact(x));
            let slope = Jet::of_constant(end(to) - end(from), order);
            let x = Jet::variable(u.zero(), order);
            u_series = u_series + slope * x;
        }
        let s0 = (u.clone() - w.clone()).times_two_to(-1);
        let t0 = (u.clone() + w.clone()).times_two_to(-1);
        let one = Expansion::of(&self.first, &s0, order)?;
        let two = Expansion::of(&self.second, &t0, order)?;
        let mut w_series = Jet::of_constant(w, order);
        let at = |w: &Jet<S>| {
            (
                half(u_series.clone() - w.clone()),
                half(u_series.clone() + w.clone()),
            )
        };
        if order > 0 {
            let equation = Equation::at((&self.first, &self.second), &s0, &t0)?;
            let by_w = (equation.by_t - equation.by_s).times_two_to(-1);
            for n in 1..=order {
                let (s, t) = at(&w_series);
                let ruling = crate::vector::sub(&two.points(&t), &one.points(&s));
                let f = crate::vector::det(&one.slopes(&s), &two.slopes(&t), &ruling);
                let rest = f.coefficients().get(n).ok_or_else(|| turns(u))?;
                let next = (-rest.clone()).divided_by(&by_w).map_err(|_| turns(u))?;
                let mut list: Vec<S> = w_series.coefficients().to_vec();
                if let Some(slot) = list.get_mut(n) {
                    *slot = next;
                }
                let mut list = list.into_iter();
                let value = list.next().ok_or_else(|| turns(u))?;
                w_series = Jet::from_coefficients(value, list);
            }
        }
        let (s, t) = at(&w_series);
        Ok([one.points(&s), two.points(&t)])
    }

    /// The two nodes of the branch about `u`, as `[u, w]`.
    fn around(&self, u: f64) -> [[f64; 2]; 2] {
        let turned = |node: &[f64; 2]| [node[0] + node[1], node[1] - node[0]];
        let nodes = self.branch.nodes();
        let after = nodes.partition_point(|node| turned(node)[0] <= u);
        let after = after.clamp(1, nodes.len().saturating_sub(1).max(1));
        let at = |i: usize| nodes.get(i).map_or([u, 0.0], turned);
        [at(after - 1), at(after)]
    }
}

fn turns<S: Coordinate>(u: &S) -> GeometryError {
    GeometryError::Degenerate {
        what: "no ruling of the connecting developable at s + t",
        at: Place::Parameter(u.approximate()),
    }
}

impl<P: SpaceCurve<f64>, Q: SpaceCurve<f64>> Rails<f64> for ConnectingPatch<P, Q> {
    fn rail_jets(&self, x: &f64, order: usize) -> Result<[[Jet<f64>; 3]; 2]> {
        let [from, to] = self.span();
        let u = from + (to - from) * x;
        let [[u0, w0], [u1, w1]] = self.around(u);
        let guess = w0 + (w1 - w0) * (u - u0) / (u1 - u0);
        let rails = (&self.first, &self.second);
        let w = solution(rails, u, guess, 2.0 * (u1 - u0) + 1e-6).ok_or_else(|| turns(&u))?;
        self.series(&u, w, order)
    }

    /// The equation of the branch says just that.
    fn is_developable_by_construction(&self) -> bool {
        true
    }
}

/// How often an enclosure of a ruling is narrowed.
const NARROWED: usize = 24;

impl<P: SpaceCurve<Ball>, Q: SpaceCurve<Ball>> Rails<Ball> for ConnectingPatch<P, Q> {
    fn rail_jets(&self, x: &Ball, order: usize) -> Result<[[Jet<Ball>; 3]; 2]> {
        let [from, to] = self.span().map(|end| exact_ball(end, x.bits()));
        let u = from.clone() + (to - from) * x.clone();
        let w = self.enclosed(&u);
        self.series(&u, w, order)
    }

    fn is_developable_by_construction(&self) -> bool {
        true
    }
}

impl<P: SpaceCurve<Ball>, Q: SpaceCurve<Ball>> ConnectingPatch<P, Q> {
    /// All `w` on the branch over `u`: from the boxes of the nodes, narrowed by interval Newton steps
    /// `W -> W n (m - (G(u_m, m) + G_u (U - u_m)) / G_w)`.
    fn enclosed(&self, u: &Ball) -> Ball {
        let bits = u.bits();
        let ball = |value: &Rational| Ball::from_rational(value, bits);
        let (low, high) = u.to_f64_bounds();
        let ([before, _], [_, after]) = (self.around(low), self.around(high));
        // |dw/du| < 1 on a rising branch.
        let reach = after[0].max(high) - before[0].min(low) + 4.0 * NODE_RADIUS;
        let bound = |w: f64| exact_ball(w, bits);
        let mut w = bound((before[1] - reach).max(after[1] - reach).next_down())
            .hull(&bound((before[1] + reach).min(after[1] + reach).next_up()));
        let middle_u = ball(&u.midpoint());
        let rest = u.clone() - middle_u.clone();
        let at = |u: &Ball, w: &Ball| {
            let s = (u.clone() - w.clone()).times_two_to(-1);
            let t = (u.clone() + w.clone()).times_two_to(-1);
            Equation::at((&self.first, &self.second), &s, &t).ok()
        };
        for _ in 0..NARROWED {
            let middle = ball(&w.midpoint());
            let (Some(over), Some(here)) = (at(u, &w), at(&middle_u, &middle)) else {
                break;
            };
            let by_u = (over.by_s.clone() + over.by_t.clone()).times_two_to(-1);
            let by_w = (over.by_t - over.by_s).times_two_to(-1);
            let value = here.value + by_u * rest.clone();
            let Ok(step) = value.divided_by(&by_w) else {
                break;
            };
            let newton = middle - step;
            if !newton.overlaps(&w) {
                break;
            }
            let (a, b) = (newton.lower(), w.lower());
            let (c, d) = (newton.upper(), w.upper());
            let next = Ball::from_bounds(&a.max(b), &c.min(d), bits);
            let shrunk = next.width() + next.width();
            let enough = shrunk > w.width();
            w = next;
            if enough {
                break;
            }
        }
        w
    }
}

impl<P: SpaceCurve<f64>, Q: SpaceCurve<f64>> Surface<f64> for ConnectingPatch<P, Q> {
    fn partials(&self, u: &f64, v: &f64, order: usize) -> Result<Partials<f64>> {
        partials_between(self, u, v, order)
    }
}

impl<S, T, P: Over<S, T>, Q: Over<S, T>> Over<S, T> for ConnectingPatch<P, Q> {
    type Object = ConnectingPatch<P::Object, Q::Object>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Self::Object> {
        Ok(ConnectingPatch {
            first: self.first.over(convert)?,
            second: self.second.over(convert)?,
            branch: self.branch.clone(),
        })
    }
}
