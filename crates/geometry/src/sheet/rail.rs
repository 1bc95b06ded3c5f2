//! Space curves.

use super::{Joint, Point};
use crate::basis::{Basis, BasisShape, Bernstein, hermite};
use crate::coordinate::Coordinate;
use crate::curve::SpaceCurve;
use crate::curve::{
    AffineMap, Curve, EllipticHelix, RationalCurve, arc_length, curvature, ellipse_arc,
};
use crate::error::{GeometryError, Place, Result};
use crate::join::{JointMeasure, measure_curves, next_curve};
use crate::over::Over;
use crate::surface::RailKind;
use std::sync::Arc;
use torse_algebra::{Jet, Rational};

/// A curve in space over [0, 1] with any basis, weighted or not.
///
/// ```
/// use torse_geometry::prelude::*;
/// let rail = Rail::gbt(0.5, -0.25, &[[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 2.0, 1.0], [4.0, 0.0, 1.0]])?;
/// assert_eq!(rail.point(1.0)?, [4.0, 0.0, 1.0]);
/// let [dx, _, _] = rail.derivative(0.3)?;
/// assert!(dx > 0.0 && rail.curvature(0.3)? > 0.0 && rail.length(1e-9)? > 17.0_f64.sqrt());
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Rail<S = f64> {
    pub(super) curve: RailCurve<S>,
    /// What the curve is rounded from, where f64 does not hold it.
    pub(super) given: Option<Arc<Homogeneous>>,
}

/// Control points `w p` with their weights `w`, exactly.
pub(super) type Homogeneous = Vec<[Rational; 4]>;

/// The curve of the generic layer that a rail is.
#[derive(Debug, Clone, PartialEq)]
pub enum RailCurve<S = f64> {
    /// A curve without weights.
    Plain(Curve<BasisShape<S>, S, 3>),
    /// A curve with weights.
    Weighted(RationalCurve<BasisShape<S>, S, 3>),
    /// An arc of an ellipse of any angle, or a helix.
    Elliptic(EllipticHelix<S>),
}

impl<S> Rail<S> {
    /// Returns the curve that the rail is.
    #[must_use]
    pub fn curve(&self) -> &RailCurve<S> {
        &self.curve
    }
}

impl Rail {
    /// Returns the curve with these exact control points and weights, of which each product `w p` is rounded once where
    /// it is evaluated on f64; what is proved is proved of the exact numbers.
    ///
    /// # Errors
    /// As [`Curve::new`] and [`RationalCurve::new`].
    ///
    /// ```
    /// use torse_algebra::rational::ratio;
    /// use torse_geometry::Rails;
    /// use torse_geometry::basis::BasisShape;
    /// use torse_geometry::prelude::*;
    /// // Two arches of which one is a third of the other: neither is one of doubles.
    /// let arch = |n: i64| {
    ///     let q = |a: i64| ratio(a * n, 3).unwrap();
    ///     let points = [[q(0), q(0), q(3)], [q(1), q(2), q(3)], [q(4), q(0), q(3)]];
    ///     let weights = [ratio(1, 1), ratio(7, 10), ratio(1, 1)].map(Option::unwrap);
    ///     Rail::exact(BasisShape::Bernstein, &points, Some(&weights))
    /// };
    /// let cone = Sheet::ruled(arch(3)?, arch(1)?);
    /// assert!(Rails::<f64>::is_developable_by_construction(&cone));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn exact(
        shape: BasisShape<f64>,
        points: &[[Rational; 3]],
        weights: Option<&[Rational]>,
    ) -> Result<Self> {
        let one = Rational::from_integer(1.into());
        if let Some(weights) = weights
            && weights.len() != points.len()
        {
            return Err(GeometryError::LengthMismatch {
                what: "weights",
                index: 0,
                expected: points.len(),
                given: weights.len(),
            });
        }
        let weight = |k: usize| weights.and_then(|all| all.get(k)).unwrap_or(&one).clone();
        let control = points.iter().enumerate().map(|(k, point)| {
            let w = weight(k);
            let [x, y, z] = point.each_ref().map(|c| c.clone() * w.clone());
            [x, y, z, w]
        });
        Self::rounded(shape, control.collect(), weights.is_some())
    }

    /// Returns the curve with these homogeneous control points, rounded once.
    pub(super) fn rounded(
        shape: BasisShape<f64>,
        control: Homogeneous,
        weighted: bool,
    ) -> Result<Self> {
        let near = control
            .iter()
            .map(|p| p.each_ref().map(Coordinate::approximate));
        let near: Vec<[f64; 4]> = near.collect();
        let is_held = |(exact, near): (&[Rational; 4], &[f64; 4])| {
            let mut both = exact.iter().zip(near);
            both.all(|(q, c)| c.is_finite() && crate::exact(*c) == *q)
        };
        let held = control.iter().zip(&near).all(is_held);
        let (points, weights): (Vec<Point>, Vec<f64>) =
            near.into_iter().map(|[x, y, z, w]| ([x, y, z], w)).unzip();
        let curve = if weighted {
            RailCurve::Weighted(RationalCurve::from_homogeneous(shape, points, weights)?)
        } else {
            RailCurve::Plain(Curve::new(shape, points)?)
        };
        Ok(Self {
            curve,
            given: (!held).then(|| Arc::new(control)),
        })
    }

    /// Returns the exact homogeneous control points; an arc of an ellipse has none.
    pub(super) fn homogeneous(&self) -> Option<Homogeneous> {
        if let Some(given) = &self.given {
            return Some(given.as_ref().clone());
        }
        let lifted = |p: &Point, w: f64| {
            let [x, y, z] = p.map(crate::exact);
            [x, y, z, crate::exact(w)]
        };
        Some(match &self.curve {
            RailCurve::Plain(curve) => curve.points().iter().map(|p| lifted(p, 1.0)).collect(),
            RailCurve::Weighted(curve) => curve.homogeneous().map(|(p, w)| lifted(p, *w)).collect(),
            RailCurve::Elliptic(_) => return None,
        })
    }

    /// Returns the curve whose exact homogeneous control points are the images of these, where f64 does not hold these
    /// or their products with weights; `None` of a curve that is changed on f64.
    fn changed_exactly(&self, image: impl Fn(&[Rational; 4]) -> [Rational; 4]) -> Option<Self> {
        let (shape, weighted) = match &self.curve {
            RailCurve::Plain(curve) => (*curve.basis(), false),
            RailCurve::Weighted(curve) => (*curve.basis(), true),
            RailCurve::Elliptic(_) => return None,
        };
        if self.given.is_none() && !weighted {
            return None;
        }
        let control = self.homogeneous()?.iter().map(image).collect();
        Self::rounded(shape, control, weighted).ok()
    }

    /// Returns the curve with these control points and any basis.
    ///
    /// # Errors
    /// As [`Curve::new`].
    pub fn new(shape: BasisShape<f64>, points: &[Point]) -> Result<Self> {
        Curve::new(shape, points.to_vec()).map(Self::from)
    }

    /// Returns the Bezier curve with these control points.
    ///
    /// # Errors
    /// As [`Curve::new`].
    pub fn bezier(points: &[Point]) -> Result<Self> {
        Self::new(BasisShape::Bernstein, points)
    }

    /// Returns the GBT curve with these shape parameters and control points.
    ///
    /// # Errors
    /// As [`Curve::new`] and [`Gbt::new`](crate::Gbt::new).
    pub fn gbt(mu: f64, nu: f64, points: &[Point]) -> Result<Self> {
        Self::new(BasisShape::gbt(mu, nu)?, points)
    }

    /// Returns the polynomial curve with these Hermite data: points first, then tangents (see
    /// [`hermite`](crate::hermite)).
    ///
    /// # Errors
    /// As [`hermite::curve`](crate::hermite::curve).
    pub fn hermite(data: &[Point]) -> Result<Self> {
        hermite::curve(data).map(Self::from)
    }

    /// Returns the weighted curve with these control points and positive weights.
    ///
    /// # Errors
    /// As [`RationalCurve::new`].
    pub fn weighted(shape: BasisShape<f64>, points: &[Point], weights: &[f64]) -> Result<Self> {
        // Refuses what is no weight before it is multiplied.
        RationalCurve::new(shape, points, weights.to_vec())?;
        let points: Vec<[Rational; 3]> = points.iter().map(|p| p.map(crate::exact)).collect();
        let weights: Vec<Rational> = weights.iter().map(|w| crate::exact(*w)).collect();
        Self::exact(shape, &points, Some(&weights))
    }

    /// Returns a quarter of an ellipse about `centre`, exactly.
    ///
    /// # Errors
    /// As [`ellipse_arc`].
    pub fn ellipse_arc(centre: Point, from: Point, to: Point) -> Result<Self> {
        let arc = ellipse_arc(&centre, &from, &to)?;
        Self::new(BasisShape::Gbt(*arc.basis()), arc.points())
    }

    /// Returns the point at `x`.
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`] for NaN and infinities, and what a weighted curve refuses.
    pub fn point(&self, x: f64) -> Result<Point> {
        match &self.curve {
            RailCurve::Plain(curve) => curve.point(&x),
            RailCurve::Weighted(curve) => curve.point(&x),
            RailCurve::Elliptic(_) => {
                crate::coordinate::check_finite("parameter", [&x])?;
                self.space_point(&x)
            }
        }
    }

    /// Returns the first derivative at `x`.
    ///
    /// # Errors
    /// As [`Rail::point`].
    pub fn derivative(&self, x: f64) -> Result<Point> {
        let all = self.derivatives(x, 1)?;
        all.last().copied().ok_or(GeometryError::NoValue {
            what: "derivative of a rail",
            at: Place::Parameter(x),
        })
    }

    /// Returns point and derivatives up to `order` at `x`.
    ///
    /// # Errors
    /// As [`Rail::point`].
    pub fn derivatives(&self, x: f64, order: usize) -> Result<Vec<Point>> {
        match &self.curve {
            RailCurve::Plain(curve) => curve.derivatives(&x, order),
            RailCurve::Weighted(curve) => curve.derivatives(&x, order),
            RailCurve::Elliptic(curve) => {
                crate::curve::derivatives_of(&curve.space_jet(&x, order)?, order)
            }
        }
    }

    /// Returns the curvature at `x`.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] where the curve stands still.
    pub fn curvature(&self, x: f64) -> Result<f64> {
        curvature(self, x)
    }

    /// Returns the length, with an error estimated to be at most `accuracy`.
    ///
    /// # Errors
    /// As [`arc_length`].
    pub fn length(&self, accuracy: f64) -> Result<f64> {
        arc_length(self, [0.0, 1.0], accuracy)
    }

    /// Returns the curve as seen from `origin`; `None` for a weighted curve and an arc of an ellipse.
    pub(super) fn moved_to(&self, origin: Point) -> Option<Self> {
        match &self.curve {
            RailCurve::Plain(_) if self.given.is_some() => {
                let from = origin.map(crate::exact);
                self.changed_exactly(|[x, y, z, w]| {
                    let [x, y, z] = crate::vector::sub(&[x.clone(), y.clone(), z.clone()], &from);
                    [x, y, z, w.clone()]
                })
            }
            RailCurve::Plain(curve) => Some(Self {
                curve: RailCurve::Plain(curve.mapped(|p| crate::vector::sub(p, &origin))),
                given: None,
            }),
            RailCurve::Weighted(_) | RailCurve::Elliptic(_) => None,
        }
    }

    /// Returns the same curve traversed backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let curve = match &self.curve {
            RailCurve::Plain(curve) => RailCurve::Plain(curve.reversed()),
            RailCurve::Weighted(curve) => RailCurve::Weighted(curve.reversed()),
            RailCurve::Elliptic(curve) => RailCurve::Elliptic(curve.reversed()),
        };
        let given = self.given.as_ref();
        Self {
            curve,
            given: given.map(|all| Arc::new(all.iter().rev().cloned().collect())),
        }
    }

    /// Returns the image under an affine map.
    ///
    /// ```
    /// use torse_geometry::AffineMap;
    /// use torse_geometry::prelude::*;
    /// let mirror = AffineMap { linear: [[-1., 0., 0.], [0., 1., 0.], [0., 0., 1.]], shift: [0.; 3] };
    /// let arc = Rail::ellipse_arc([1., 0., 0.], [4., 0., 0.], [1., 2., 0.])?;
    /// assert_eq!(arc.mapped(&mirror).point(0.0)?, [-4.0, 0.0, 0.0]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    #[must_use]
    pub fn mapped(&self, map: &AffineMap<f64>) -> Self {
        let exactly = self.changed_exactly(|[x, y, z, w]| {
            let point = [x.clone(), y.clone(), z.clone()];
            let image = |row: usize| {
                let linear = map.linear[row].map(crate::exact);
                crate::vector::dot(&linear, &point) + crate::exact(map.shift[row]) * w.clone()
            };
            [image(0), image(1), image(2), w.clone()]
        });
        if let Some(exactly) = exactly {
            return exactly;
        }
        let curve = match &self.curve {
            RailCurve::Plain(curve) => RailCurve::Plain(curve.mapped(|p| map.apply(p))),
            RailCurve::Weighted(curve) => RailCurve::Weighted(curve.mapped(map)),
            RailCurve::Elliptic(curve) => RailCurve::Elliptic(curve.mapped(map)),
        };
        Self { curve, given: None }
    }

    /// Returns the curve that continues this one: its first control points from the joint, then the free ones.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] for a weighted curve, and as [`next_curve`].
    pub fn next(&self, shape: BasisShape<f64>, joint: &Joint, free: &[Point]) -> Result<Self> {
        next_curve(self.plain()?, shape, joint.condition(), free).map(Self::from)
    }

    /// Measures the joint of the end of this curve with the start of the next, up to `order`.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] for weighted curves, and as [`measure_curves`].
    pub fn joint_with(&self, next: &Self, order: usize) -> Result<JointMeasure<f64, 3>> {
        measure_curves(self.plain()?, next.plain()?, order)
    }

    fn plain(&self) -> Result<&Curve<BasisShape<f64>, f64, 3>> {
        match &self.curve {
            RailCurve::Plain(curve) => Ok(curve),
            RailCurve::Weighted(_) => Err(GeometryError::Degenerate {
                what: "joint of a weighted curve",
                at: Place::Whole,
            }),
            RailCurve::Elliptic(_) => Err(GeometryError::Degenerate {
                what: "joint of an arc of an ellipse: it has no control points",
                at: Place::Whole,
            }),
        }
    }
}

/// A control point times its weight, with the weight: it is equal to another one where the points are, whatever their weights.
struct WeightedPoint<'a, S> {
    point: &'a [S; 3],
    weight: &'a S,
}

/// Products with weights are rounded: points that differ by this share of their products are equal.
const PRODUCT: f64 = 4.0 * f64::EPSILON;

impl<S: Coordinate + PartialEq> PartialEq for WeightedPoint<'_, S> {
    fn eq(&self, other: &Self) -> bool {
        self.point.iter().zip(other.point).all(|(p, q)| {
            let products = [
                p.clone() * other.weight.clone(),
                q.clone() * self.weight.clone(),
            ];
            let [a, b] = products.each_ref().map(Coordinate::approximate);
            products[0] == products[1] || (a - b).abs() <= PRODUCT * a.abs()
        })
    }
}

impl<S: Coordinate + PartialEq> Rail<S> {
    /// Returns what kind of rail it is, by its control points: where the scalar knows that they are equal.
    #[must_use]
    pub fn end_kinds(&self) -> RailKind {
        match &self.curve {
            RailCurve::Plain(curve) => RailKind::from_points(curve.points()),
            RailCurve::Weighted(curve) => {
                let parts = curve
                    .homogeneous()
                    .map(|(point, weight)| WeightedPoint { point, weight });
                RailKind::from_points(&parts.collect::<Vec<_>>())
            }
            // An arc is a point or runs with a speed; whether it closes depends on what is computed.
            RailCurve::Elliptic(arc) => {
                let [from, to] = arc.range();
                let zero = from.zero();
                let still = |v: &[S; 3]| v.iter().all(|c| *c == zero);
                let moving = arc.axes().into_iter().chain([arc.rise()]);
                if from == to || moving.into_iter().all(still) {
                    RailKind::Point
                } else {
                    RailKind::default()
                }
            }
        }
    }

    /// Returns the first and the last control point, where they have no weight or the weight one; of an arc none.
    pub(super) fn end_points(&self) -> [Option<[S; 3]>; 2] {
        match &self.curve {
            RailCurve::Plain(curve) => {
                [curve.points().first(), curve.points().last()].map(|p| p.cloned())
            }
            RailCurve::Weighted(curve) => {
                let mut parts = curve.homogeneous();
                let first = parts.next();
                let last = parts.last();
                [first, last].map(|part| {
                    let (point, weight) = part?;
                    (*weight == weight.one()).then(|| point.clone())
                })
            }
            RailCurve::Elliptic(_) => [None, None],
        }
    }
}

impl<B: Into<BasisShape<S>> + Basis<S>, S: Coordinate> From<Curve<B, S, 3>> for Rail<S> {
    fn from(curve: Curve<B, S, 3>) -> Self {
        Self {
            curve: RailCurve::Plain(curve.with_basis(Into::into)),
            given: None,
        }
    }
}

impl From<RationalCurve<Bernstein, f64, 3>> for Rail {
    fn from(curve: RationalCurve<Bernstein, f64, 3>) -> Self {
        Self {
            curve: RailCurve::Weighted(curve.with_basis(Into::into)),
            given: None,
        }
    }
}

impl<S: Coordinate> From<EllipticHelix<S>> for Rail<S> {
    fn from(curve: EllipticHelix<S>) -> Self {
        Self {
            curve: RailCurve::Elliptic(curve),
            given: None,
        }
    }
}

impl<S: Coordinate> SpaceCurve<S> for Rail<S> {
    fn space_jet(&self, x: &S, order: usize) -> Result<[Jet<S>; 3]> {
        match &self.curve {
            RailCurve::Plain(curve) => curve.jet(x, order),
            RailCurve::Weighted(curve) => curve.jet(x, order),
            RailCurve::Elliptic(curve) => curve.space_jet(x, order),
        }
    }

    fn space_point(&self, x: &S) -> Result<[S; 3]> {
        match &self.curve {
            RailCurve::Plain(curve) => curve.space_point(x),
            RailCurve::Weighted(curve) => curve.space_point(x),
            RailCurve::Elliptic(curve) => curve.space_point(x),
        }
    }

    fn point_and_slope(&self, x: &S) -> Result<[[S; 3]; 2]> {
        match &self.curve {
            RailCurve::Plain(curve) => curve.point_and_slope(x),
            RailCurve::Weighted(curve) => curve.point_and_slope(x),
            RailCurve::Elliptic(curve) => curve.point_and_slope(x),
        }
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for Rail<S> {
    type Object = Rail<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Rail<T>> {
        let curve = match &self.curve {
            RailCurve::Plain(curve) => RailCurve::Plain(curve.over(convert)?),
            RailCurve::Weighted(curve) => RailCurve::Weighted(curve.over(convert)?),
            RailCurve::Elliptic(curve) => RailCurve::Elliptic(curve.over(convert)?),
        };
        let Some(given) = &self.given else {
            return Ok(Rail { curve, given: None });
        };
        // Over another scalar the numbers as they were given.
        let number = |like: &T, q: &Rational| like.constant(q);
        let curve = match curve {
            RailCurve::Plain(curve) => {
                let pairs = curve.points().iter().zip(given.iter());
                let points =
                    pairs.map(|([like, ..], [x, y, z, _])| [x, y, z].map(|q| number(like, q)));
                RailCurve::Plain(Curve::new(curve.basis().clone(), points.collect())?)
            }
            RailCurve::Weighted(curve) => {
                let pairs = curve.homogeneous().zip(given.iter());
                let (points, weights) = pairs
                    .map(|((_, like), [x, y, z, w])| {
                        ([x, y, z].map(|q| number(like, q)), number(like, w))
                    })
                    .unzip();
                let basis = curve.basis().clone();
                RailCurve::Weighted(RationalCurve::from_homogeneous(basis, points, weights)?)
            }
            RailCurve::Elliptic(curve) => RailCurve::Elliptic(curve),
        };
        Ok(Rail { curve, given: None })
    }
}
