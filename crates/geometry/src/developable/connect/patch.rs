//! The patch along a branch, as rails with a common parameter.

use super::equation::{Equation, Expansion};
use super::trace::{Branch, NODE_RADIUS, solution_on_link};
use crate::chebyshev::{NODES, nodes};
use crate::coordinate::Coordinate;
use crate::curve::SpaceCurve;
use crate::error::{GeometryError, Place, Result};
use crate::model::ChebyshevModel;
use crate::over::Over;
use crate::scalars::exact_ball;
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

    /// The same branch of curves that have been moved together.
    pub(crate) fn over_curves(&self, first: P, second: Q) -> Self {
        Self::new(first, second, self.branch.clone())
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
        let one = Expansion::about(&self.first, &s0, order)?;
        let two = Expansion::about(&self.second, &t0, order)?;
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

    /// Bounds of `w` over these `u`, from the boxes of the links that lie over them: on a link `s` and `t` stay between
    /// those of its nodes, up to [`NODE_RADIUS`], so `w = t - s = u - 2 s = 2 t - u` does.
    fn linked(&self, low: f64, high: f64) -> Option<[f64; 2]> {
        let mut found: Option<[f64; 2]> = None;
        for link in self.branch.nodes().windows(2) {
            let [[s0, t0], [s1, t1]] = link else { continue };
            let (from, to) = (s0 + t0 - 4.0 * NODE_RADIUS, s1 + t1 + 4.0 * NODE_RADIUS);
            if to < low || high < from {
                continue;
            }
            let (from, to) = (from.max(low), to.min(high));
            let slack = 4.0 * NODE_RADIUS;
            let least = (from - 2.0 * s1).max(2.0 * t0 - to) - slack;
            let most = (to - 2.0 * s0).min(2.0 * t1 - from) + slack;
            let [a, b] = found.unwrap_or([least, most]);
            found = Some([a.min(least), b.max(most)]);
        }
        found
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

impl<P: SpaceCurve<f64>, Q: SpaceCurve<f64>> ConnectingPatch<P, Q> {
    /// `u` and `w` at the parameter of the patch.
    fn solved(&self, x: f64) -> (f64, Option<f64>) {
        let [from, to] = self.span();
        let u = from + (to - from) * x;
        let [[u0, w0], [u1, w1]] = self.around(u);
        let guess = w0 + (w1 - w0) * (u - u0) / (u1 - u0);
        let rails = (&self.first, &self.second);
        (u, solution_on_link(rails, u, guess, 2.0 * (u1 - u0) + 1e-6))
    }

    /// The parameters of both curves for a ruling.
    pub(crate) fn parameters_at(&self, x: f64) -> Option<[f64; 2]> {
        let (u, w) = self.solved(x);
        w.map(|w| [0.5 * (u - w), 0.5 * (u + w)])
    }
}

impl<P: SpaceCurve<f64>, Q: SpaceCurve<f64>> Rails<f64> for ConnectingPatch<P, Q> {
    fn rail_jets(&self, x: &f64, order: usize) -> Result<[[Jet<f64>; 3]; 2]> {
        let (u, w) = self.solved(*x);
        self.series(&u, w.ok_or_else(|| turns(&u))?, order)
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
        // Nor does it leave the boxes of the links over these parameters, which hold no other solution.
        if let Some([low, high]) = self.linked(low, high) {
            let (from, to) = (crate::exact(low), crate::exact(high));
            let (from, to) = (from.max(w.lower()), to.min(w.upper()));
            if from <= to {
                w = Ball::from_bounds(&from, &to, bits);
            }
        }
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

impl<P: SpaceCurve<ChebyshevModel>, Q: SpaceCurve<ChebyshevModel>> Rails<ChebyshevModel>
    for ConnectingPatch<P, Q>
{
    fn rail_jets(&self, x: &ChebyshevModel, order: usize) -> Result<[[Jet<ChebyshevModel>; 3]; 2]> {
        let [from, to] = self.span().map(ChebyshevModel::exact);
        let u = from + (to - from) * *x;
        let w = self.modelled(&u).ok_or_else(|| turns(&u))?;
        self.series(&u, w, order)
    }

    fn is_developable_by_construction(&self) -> bool {
        true
    }
}

/// How often Newton's method is tried at a node.
const STEPS: usize = 12;

impl<P: SpaceCurve<ChebyshevModel>, Q: SpaceCurve<ChebyshevModel>> ConnectingPatch<P, Q> {
    /// The equation at the parameters `s = (u - w)/2` and `t = (u + w)/2`.
    fn equation(&self, u: &ChebyshevModel, w: &ChebyshevModel) -> Option<Equation<ChebyshevModel>> {
        let s = (*u - *w).times_two_to(-1);
        let t = (*u + *w).times_two_to(-1);
        Equation::at((&self.first, &self.second), &s, &t).ok()
    }

    /// `w` on the branch over an interval of `u`: the polynomial through Newton's solutions, and by how much it may be
    /// off, `|F(w)| / min |F_w|`, where `F_w` is bounded over a tube about the polynomial. In the tube there is one
    /// solution for each `u`, and it is the one of the branch, since in the middle of the interval the tube lies in the
    /// box of a proved link.
    fn modelled(&self, u: &ChebyshevModel) -> Option<ChebyshevModel> {
        let [low, high] = u.range();
        let [first, last] = self.span();
        let [low, high] = [low.max(first), high.min(last)];
        let mut values = [0.0; NODES];
        for (value, at) in values.iter_mut().zip(nodes(low, high)) {
            let [[u0, w0], [u1, w1]] = self.around(at);
            let mut w = if u1 > u0 {
                w0 + (w1 - w0) * (at - u0) / (u1 - u0)
            } else {
                w0
            };
            for _ in 0..STEPS {
                let equation =
                    self.equation(&ChebyshevModel::exact(at), &ChebyshevModel::exact(w))?;
                let by_w = 0.5 * (equation.by_t.approximate() - equation.by_s.approximate());
                let step = equation.value.approximate() / by_w;
                if !step.is_finite() {
                    return None;
                }
                w -= step;
                if step.abs() <= 4.0 * f64::EPSILON {
                    break;
                }
            }
            *value = w;
        }
        let w = ChebyshevModel::through(&values);
        let residual = self.equation(u, &w)?.value.largest();
        let mut tube = 1e-12;
        // As narrow as it may be: a wide tube says less about the slope.
        while tube < 1e-3 {
            let over = self.equation(u, &w.widened(tube))?;
            let by_w = (over.by_t - over.by_s).times_two_to(-1);
            let least = by_w.least();
            if least <= 0.0 {
                return None;
            }
            let off = residual / least * (1.0 + 4.0 * f64::EPSILON);
            if off < 0.5 * tube {
                let middle = 0.5 * (low + high);
                let at = w.at(0.0);
                return self.holds(middle, at, tube).then(|| w.widened(off));
            }
            tube = 4.0 * off.max(tube);
        }
        None
    }

    /// The parameters of both curves for rulings of an interval.
    pub(crate) fn parameters(&self, x: &ChebyshevModel) -> Option<[ChebyshevModel; 2]> {
        let [from, to] = self.span().map(ChebyshevModel::exact);
        let u = from + (to - from) * *x;
        let w = self.modelled(&u)?;
        Some([u - w, u + w].map(|sum| sum.times_two_to(-1)))
    }

    /// Whether the points of this antidiagonal within `tube` of `w` lie in the box of the link there.
    fn holds(&self, u: f64, w: f64, tube: f64) -> bool {
        let [[u0, w0], [u1, w1]] = self.around(u);
        let parameters = |u: f64, w: f64| [0.5 * (u - w), 0.5 * (u + w)];
        let (from, to) = (parameters(u0, w0), parameters(u1, w1));
        [w - tube, w + tube].iter().all(|w| {
            let at = parameters(u, *w);
            (0..2).all(|i| from[i] - NODE_RADIUS <= at[i] && at[i] <= to[i] + NODE_RADIUS)
        })
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
