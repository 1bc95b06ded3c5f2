//! B-splines, weighted or not, over the rationals.
//!
//! A spline of degree `p` keeps what was given: knots `u[0] <= u[1] <= ..`, control points, weights, all exact. What is
//! made of it are its Bezier pieces, one for each interval between different knots. Their control points are values of
//! the polar form (blossom) `f` of the polynomial on that interval. With the `2p` knots about the interval `[a, b]`,
//! `w[1..p] <= a < b <= w[p+1..2p]`, the spline has the control points `f(w[j+1], .., w[j+p])`, the piece has
//! `f(a, .., a, b, .., b)`. De Boor's algorithm at `a` gives, as the last entries of its levels,
//! `f(a, .., a, w[p+1], ..)`; the same at `b` on those gives, as the first entries, the control points of the piece.
//! Both are knot insertion, so over the rationals no digit is lost.

use super::{AffineMap, Bezier};
use crate::coordinate::Coordinate;
use crate::error::{GeometryError, Place, Result, count};
use crate::vector::{add, dot, scale};
use std::cmp::Ordering;
use torse_algebra::{Rational, Scalar};

/// The largest degree of a spline.
pub const MAX_SPLINE_DEGREE: usize = 64;
/// The most control points of a spline.
pub const MAX_SPLINE_POINTS: usize = 100_000;
/// The most work of one curve: the sum over its pieces of the third power of degree plus one.
pub const MAX_SPLINE_WORK: usize = 10_000_000;

/// A B-spline curve in space over exact numbers: polynomial, or rational where it has weights.
///
/// Invariants: the degree is between 1 and [`MAX_SPLINE_DEGREE`]; there are as many knots as control points plus degree
/// plus one; knots do not fall; no knot has more than degree plus one copies, and no inner one more than the degree;
/// the first and the last value of the parameter, `knots[degree]` and `knots[points]`, differ; weights are positive.
///
/// ```
/// use torse_algebra::rational::{integer, ratio};
/// use torse_geometry::curve::Spline;
/// let q = |x: i64, y: i64| [integer(x), integer(y), integer(0)];
/// let knots = [0, 0, 0, 1, 2, 2, 2].map(integer).to_vec();
/// let spline = Spline::new(2, knots, vec![q(0, 0), q(2, 4), q(6, 4), q(8, 0)], None)?;
/// let pieces = spline.pieces()?;
/// assert_eq!(pieces.len(), 2);
/// // The joint of the two parabolas is the middle of the inner control points.
/// assert_eq!(pieces[0].point(&integer(1))?, q(4, 4));
/// assert_eq!(pieces[1].point(&ratio(1, 2).unwrap())?, spline.point(&ratio(3, 2).unwrap())?);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    degree: usize,
    knots: Vec<Rational>,
    points: Vec<[Rational; 3]>,
    weights: Option<Vec<Rational>>,
    closed: bool,
}

impl Spline {
    /// The spline of this degree with these knots, control points and, if it is rational, weights.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] for the degree, for more points than [`MAX_SPLINE_POINTS`], for more work than
    /// [`MAX_SPLINE_WORK`], and for a knot that falls or has too many copies (its index is told);
    /// [`GeometryError::TooFew`] for fewer points than degree plus one; [`GeometryError::LengthMismatch`] for the
    /// number of knots or weights; [`GeometryError::BadWeight`]; [`GeometryError::Degenerate`] where the parameter has
    /// no range.
    pub fn new(
        degree: usize,
        knots: Vec<Rational>,
        points: Vec<[Rational; 3]>,
        weights: Option<Vec<Rational>>,
    ) -> Result<Self> {
        check(degree, degree + 1, &points, weights.as_deref())?;
        let expected = points.len() + degree + 1;
        if knots.len() != expected {
            return Err(GeometryError::LengthMismatch {
                what: "knots of a spline",
                index: 0,
                expected,
                given: knots.len(),
            });
        }
        if let Some(index) = knots.windows(2).position(|pair| pair[1] < pair[0]) {
            return Err(GeometryError::OutOfRange {
                name: "knot that falls: its index",
                value: count(index + 1),
                range: "knots that do not fall",
            });
        }
        let crowded = |window: &[Rational]| window.first() == window.last();
        if let Some(index) = knots.windows(degree + 2).position(crowded) {
            return Err(GeometryError::OutOfRange {
                name: "knot with too many copies: its index",
                value: count(index),
                range: "at most degree plus one copies",
            });
        }
        let spline = Self {
            degree,
            knots,
            points,
            weights,
            closed: false,
        };
        let [from, to] = spline.domain();
        if from == to {
            return Err(GeometryError::Degenerate {
                what: "a spline whose parameter has no range",
                at: Place::Whole,
            });
        }
        let torn = |window: &[Rational]| {
            window.first() == window.last() && window[0] > from && window[0] < to
        };
        if let Some(index) = spline.knots.windows(degree + 1).position(torn) {
            return Err(GeometryError::OutOfRange {
                name: "inner knot with more copies than the degree, where the curve tears: its index",
                value: count(index),
                range: "at most as many copies as the degree",
            });
        }
        let work = spline
            .spans()
            .count()
            .saturating_mul((degree + 1).saturating_pow(3));
        if work > MAX_SPLINE_WORK {
            return Err(GeometryError::OutOfRange {
                name: "pieces times the third power of degree plus one, the work for a spline",
                value: count(work),
                range: "[1, 10000000]",
            });
        }
        Ok(spline)
    }

    /// The closed spline of this degree: `knots` are those of one period, the last is the first of the next; control
    /// points, as many as intervals between them, and weights go round.
    ///
    /// Control point `i` belongs to the intervals from `i - degree` to `i`, counted round.
    ///
    /// # Errors
    /// As [`Spline::new`], for three points at least.
    ///
    /// ```
    /// use torse_algebra::rational::integer;
    /// use torse_geometry::curve::Spline;
    /// let q = |x: i64, y: i64| [integer(x), integer(y), integer(0)];
    /// let corners = vec![q(1, 1), q(-1, 1), q(-1, -1), q(1, -1)];
    /// let ring = Spline::periodic(3, &[0, 1, 2, 3, 4].map(integer), corners, None)?;
    /// assert!(ring.is_closed());
    /// assert_eq!(ring.point(&integer(0))?, ring.point(&integer(4))?);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn periodic(
        degree: usize,
        knots: &[Rational],
        points: Vec<[Rational; 3]>,
        weights: Option<Vec<Rational>>,
    ) -> Result<Self> {
        check(degree, 3, &points, weights.as_deref())?;
        let n = points.len();
        let (Some(first), Some(last), true) = (knots.first(), knots.last(), knots.len() == n + 1)
        else {
            return Err(GeometryError::LengthMismatch {
                what: "knots of a period",
                index: 0,
                expected: n + 1,
                given: knots.len(),
            });
        };
        let period = last.clone() - first.clone();
        // Knot k of the endless sequence, for k from -degree on.
        let knot = |k: usize| {
            let shifted = k + n * degree - degree;
            let (round, index) = (shifted / n, shifted % n);
            let rounds = torse_algebra::rational::integer(i64::try_from(round).unwrap_or(i64::MAX))
                - torse_algebra::rational::integer(i64::try_from(degree).unwrap_or(i64::MAX));
            knots.get(index).cloned().unwrap_or_default() + rounds * period.clone()
        };
        let all: Vec<Rational> = (0..n + 2 * degree + 1).map(knot).collect();
        let round =
            |list: &[[Rational; 3]]| list.iter().cycle().take(n + degree).cloned().collect();
        let weights = weights.map(|w| w.iter().cycle().take(n + degree).cloned().collect());
        let mut spline = Self::new(degree, all, round(&points), weights)?;
        spline.closed = true;
        Ok(spline)
    }

    /// The polygon through these points, a spline of degree one, with the distances of the points as parameters.
    ///
    /// The distances are rounded to f64 and are the definition from then on.
    ///
    /// # Errors
    /// As [`Spline::new`], and [`GeometryError::Degenerate`] for neighbours at one place.
    pub fn polyline(points: Vec<[Rational; 3]>) -> Result<Self> {
        let mut knots = vec![Rational::default(); 2];
        let mut at = Rational::default();
        for (index, pair) in points.windows(2).enumerate() {
            let step: [f64; 3] =
                std::array::from_fn(|k| (pair[1][k].clone() - pair[0][k].clone()).approximate());
            let length = libm::hypot(libm::hypot(step[0], step[1]), step[2]);
            if !(length > 0.0 && length.is_finite()) {
                return Err(GeometryError::Degenerate {
                    what: "a polygon with two neighbours at one place",
                    at: Place::Index(index + 1),
                });
            }
            at += crate::exact(length);
            knots.push(at.clone());
        }
        knots.push(at);
        Self::new(1, knots, points, None)
    }

    /// The degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The knots; of a closed spline those of more than a period.
    #[must_use]
    pub fn knots(&self) -> &[Rational] {
        &self.knots
    }

    /// The control points; of a closed spline the first are repeated at the end.
    #[must_use]
    pub fn points(&self) -> &[[Rational; 3]] {
        &self.points
    }

    /// The weights, if the spline is rational.
    #[must_use]
    pub fn weights(&self) -> Option<&[Rational]> {
        self.weights.as_deref()
    }

    /// Whether the spline was made closed, by [`Spline::periodic`].
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The first and the last value of the parameter.
    #[must_use]
    pub fn domain(&self) -> [Rational; 2] {
        let at = |index: usize| self.knots.get(index).cloned().unwrap_or_default();
        [at(self.degree), at(self.points.len())]
    }

    /// The places between pieces, first and last included, as shares of the range of the parameter.
    #[must_use]
    pub fn breaks(&self) -> Vec<Rational> {
        let [from, to] = self.domain();
        let width = to - from.clone();
        let ends = self.spans().map(|span| self.knots[span + 1].clone());
        let shares = ends.map(|end| (end - from.clone()) / width.clone());
        std::iter::once(Rational::default()).chain(shares).collect()
    }

    /// The Bezier pieces, exact, in order; piece `i` runs from break `i` to break `i + 1`.
    ///
    /// # Errors
    /// What the arithmetic refuses: nothing, for what [`Spline::new`] accepted.
    pub fn pieces(&self) -> Result<Vec<Bezier>> {
        self.spans()
            .map(|span| Bezier::new(self.piece(span, |q| q.clone())?, self.weights.is_some()))
            .collect()
    }

    /// The homogeneous control points of the pieces on f64: for measuring and drawing long curves.
    ///
    /// # Errors
    /// As [`Spline::pieces`].
    pub fn approximate_pieces(&self) -> Result<Vec<Vec<[f64; 4]>>> {
        self.spans()
            .map(|span| self.piece(span, Coordinate::approximate))
            .collect()
    }

    /// The point at a value of the parameter, exactly.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] outside of the domain.
    pub fn point(&self, t: &Rational) -> Result<[Rational; 3]> {
        let [from, to] = self.domain();
        let found = self.spans().find(|span| *t <= self.knots[span + 1]);
        let Some(span) = found.filter(|_| *t >= from) else {
            return Err(GeometryError::OutOfRange {
                name: "parameter of a spline",
                value: t.approximate(),
                range: if *t > to {
                    "its knots (above)"
                } else {
                    "its knots (below)"
                },
            });
        };
        let (a, b) = (&self.knots[span], &self.knots[span + 1]);
        let share = (t.clone() - a.clone()) / (b.clone() - a.clone());
        Bezier::new(self.piece(span, |q| q.clone())?, self.weights.is_some())?.point(&share)
    }

    /// The same curve traversed backwards: the parameter `t` becomes `from + to - t`.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [from, to] = self.domain();
        let sum = from + to;
        Self {
            degree: self.degree,
            knots: self
                .knots
                .iter()
                .rev()
                .map(|u| sum.clone() - u.clone())
                .collect(),
            points: self.points.iter().rev().cloned().collect(),
            weights: self
                .weights
                .as_ref()
                .map(|w| w.iter().rev().cloned().collect()),
            closed: self.closed,
        }
    }

    /// The image under an affine map, exactly.
    #[must_use]
    pub fn mapped(&self, map: &AffineMap<Rational>) -> Self {
        let points = self.points.iter().map(|point| map.apply(point)).collect();
        Self {
            points,
            ..self.clone()
        }
    }

    /// The part between two values of the parameter, exactly; its knots have full multiplicity.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] unless `from < to` are in the domain.
    ///
    /// ```
    /// use torse_algebra::rational::{integer, ratio};
    /// use torse_geometry::curve::Spline;
    /// let q = |x: i64, y: i64| [integer(x), integer(y), integer(0)];
    /// let knots = [0, 0, 0, 1, 2, 2, 2].map(integer).to_vec();
    /// let spline = Spline::new(2, knots, vec![q(0, 0), q(2, 4), q(6, 4), q(8, 0)], None)?;
    /// let [from, to] = [ratio(1, 3).unwrap(), ratio(5, 4).unwrap()];
    /// let part = spline.part(&from, &to)?;
    /// assert_eq!(part.domain(), [from, to]);
    /// assert_eq!(part.point(&integer(1))?, spline.point(&integer(1))?);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn part(&self, from: &Rational, to: &Rational) -> Result<Self> {
        let [start, end] = self.domain();
        if *from < start || *to > end || from.cmp(to) != Ordering::Less {
            return Err(GeometryError::OutOfRange {
                name: "start of a part",
                value: from.approximate(),
                range: "first knot <= from < to <= last knot",
            });
        }
        let weighted = self.weights.is_some();
        let mut knots = vec![from.clone(); self.degree + 1];
        let mut control: Vec<[Rational; 4]> = Vec::new();
        for span in self.spans() {
            let (a, b) = (&self.knots[span], &self.knots[span + 1]);
            if b <= from || a >= to {
                continue;
            }
            let mut piece = Bezier::new(self.piece(span, |q| q.clone())?, weighted)?;
            let share = |x: &Rational, low: &Rational| {
                (x.clone() - low.clone()) / (b.clone() - low.clone())
            };
            if a < from {
                let [_, after] = piece.split(&share(from, a))?;
                piece = after;
            }
            let low = if a < from { from } else { a };
            if b > to {
                let [before, _] = piece.split(&share(to, low))?;
                piece = before;
            }
            let high = if b > to { to } else { b };
            // Neighbours share the control point between them.
            let shared = usize::from(!control.is_empty());
            control.extend(piece.homogeneous().into_iter().skip(shared));
            knots.extend(std::iter::repeat_n(high.clone(), self.degree));
        }
        knots.push(to.clone());
        let weights = weighted.then(|| control.iter().map(|p| p[3].clone()).collect());
        let points = control
            .into_iter()
            .map(|[x, y, z, w]| [x, y, z].map(|c| c / w.clone()))
            .collect();
        Self::new(self.degree, knots, points, weights)
    }

    /// The indices of knots that begin an interval.
    fn spans(&self) -> impl Iterator<Item = usize> + '_ {
        let inside = self.degree..self.points.len();
        inside.filter(|&k| self.knots[k] < self.knots[k + 1])
    }

    /// The homogeneous control points of the piece that begins at a knot.
    fn piece<S: Coordinate>(
        &self,
        span: usize,
        convert: impl Fn(&Rational) -> S,
    ) -> Result<Vec<[S; 4]>> {
        let p = self.degree;
        let one = Rational::from_integer(1.into());
        let weight = |j: usize| match &self.weights {
            Some(weights) => weights.get(j).unwrap_or(&one),
            None => &one,
        };
        let control = (span - p..=span).map(|j| {
            let w = weight(j);
            let [x, y, z] = &self.points[j];
            [x, y, z]
                .map(|c| convert(&(w.clone() * c.clone())))
                .into_iter()
                .chain([convert(w)])
                .collect::<Vec<S>>()
        });
        let control = control.filter_map(|list| <[S; 4]>::try_from(list).ok());
        let control: Vec<[S; 4]> = control.collect();
        let mut window: Vec<S> = (span + 1 - p..=span + p)
            .map(|k| convert(&self.knots[k]))
            .collect();
        let (a, b) = (convert(&self.knots[span]), convert(&self.knots[span + 1]));
        let mut first = inserted(&control, &window, &a, Edge::Last)?;
        first.reverse();
        for knot in window.iter_mut().take(p) {
            *knot = a.clone();
        }
        inserted(&first, &window, &b, Edge::First)
    }
}

/// Which entries of the levels of de Boor's algorithm are wanted.
#[derive(Clone, Copy)]
enum Edge {
    First,
    Last,
}

/// De Boor's algorithm at `x` on the control points of a window of `2p` knots: the first or last entries of its levels.
fn inserted<S: Coordinate>(
    control: &[[S; 4]],
    window: &[S],
    x: &S,
    edge: Edge,
) -> Result<Vec<[S; 4]>> {
    let p = control.len().saturating_sub(1);
    let mut level = control.to_vec();
    let mut kept = Vec::with_capacity(p + 1);
    for round in 1..=p + 1 {
        kept.extend(match edge {
            Edge::First => level.first().cloned(),
            Edge::Last => level.last().cloned(),
        });
        if round > p {
            break;
        }
        let mut next = Vec::with_capacity(level.len() - 1);
        for (j, pair) in level.windows(2).enumerate() {
            // Knots are counted from one in the text, from zero here.
            let (low, high) = (&window[j + round - 1], &window[j + p]);
            let width = high.clone() - low.clone();
            let left = (high.clone() - x.clone()).divided_by(&width)?;
            let right = (x.clone() - low.clone()).divided_by(&width)?;
            next.push(add(&scale(&left, &pair[0]), &scale(&right, &pair[1])));
        }
        level = next;
    }
    Ok(kept)
}

fn check(
    degree: usize,
    least: usize,
    points: &[[Rational; 3]],
    weights: Option<&[Rational]>,
) -> Result<()> {
    if !(1..=MAX_SPLINE_DEGREE).contains(&degree) {
        return Err(GeometryError::OutOfRange {
            name: "degree of a spline",
            value: count(degree),
            range: "[1, 64]",
        });
    }
    if points.len() < least {
        return Err(GeometryError::TooFew {
            what: "control points of a spline",
            needed: least,
            given: points.len(),
        });
    }
    if points.len() > MAX_SPLINE_POINTS {
        return Err(GeometryError::OutOfRange {
            name: "number of control points of a spline",
            value: count(points.len()),
            range: "[2, 100000]",
        });
    }
    let Some(weights) = weights else {
        return Ok(());
    };
    if weights.len() != points.len() {
        return Err(GeometryError::LengthMismatch {
            what: "weights",
            index: 0,
            expected: points.len(),
            given: weights.len(),
        });
    }
    let bad = |w: &Rational| w.sign() != Some(Ordering::Greater);
    match weights.iter().position(bad) {
        None => Ok(()),
        Some(index) => Err(GeometryError::BadWeight {
            index,
            value: weights[index].approximate(),
        }),
    }
}

impl AffineMap<Rational> {
    /// The map that only stretches, by one factor.
    ///
    /// ```
    /// use torse_algebra::rational::{integer, ratio};
    /// use torse_geometry::AffineMap;
    /// let inches = AffineMap::stretch(&ratio(127, 5).unwrap());
    /// assert_eq!(inches.apply(&[integer(5), integer(0), integer(-5)]), [integer(127), integer(0), integer(-127)]);
    /// ```
    #[must_use]
    pub fn stretch(factor: &Rational) -> Self {
        let entry = |i: usize, j: usize| {
            if i == j {
                factor.clone()
            } else {
                Rational::default()
            }
        };
        Self {
            linear: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
            shift: std::array::from_fn(|_| Rational::default()),
        }
    }
}

impl<S: Scalar> AffineMap<S> {
    /// The image of a direction: the shift does not act on it.
    #[must_use]
    pub fn turn(&self, direction: &[S; 3]) -> [S; 3] {
        self.linear.each_ref().map(|row| dot(row, direction))
    }

    /// This map after another one.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        let column = |j: usize| first.linear.each_ref().map(|row| row[j].clone());
        let columns: [[S; 3]; 3] = std::array::from_fn(|j| self.turn(&column(j)));
        Self {
            linear: std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i].clone())),
            shift: self.apply(&first.shift),
        }
    }
}
