//! One-parameter families of planes and the developable surfaces that they envelop.
//!
//! By duality a curve in the space of planes is a developable surface: its points are planes
//! `a0 X + a1 Y + a2 Z = a3`, and neighbouring planes meet in a *ruling* (generator). With
//! `a = (a0, a1, a2)` and the prime for d/dx,
//!
//! ```text
//! direction  phi = a x a'
//! moment     theta = a3' a - a3 a'
//! foot       psi = (phi x theta) / (phi . phi)       the point of the ruling nearest to the origin
//! regression S = (a3 (a' x a'') + a3' (a'' x a) + a3'' (a x a')) / det(a, a', a'')
//! ```
//!
//! (gbt-developable eqs. (3.5) to (3.9); the signs in `psi` and `S` are derived here, the print of the
//! Z component of `psi` has a slip). `S` runs on the edge of regression, the *spine curve*; the surface
//! is regular away from it.

mod pencil;

use crate::basis::Basis;
use crate::coordinate::{Coordinate, check_finite, is_zero};
use crate::curve::Curve;
use crate::dual::Dual;
use crate::error::{GeometryError, Place, Result};
use crate::vector::{add, blended, cross, dot, scale, sub, times_two_to};
use std::cmp::Ordering;
use torse_algebra::{ExactError, Jet, Scalar};

/// A plane `[p, q, r, s]`: the points with `p X + q Y + r Z = s`.
pub type Plane<S> = [S; 4];

/// A family of planes `H(x) = sum_i g[i,k](x) Q[i]` with control planes `Q[i] = [p, q, r, s]`
/// (gbt-developable eqs. (3.1) to (3.4)).
///
/// Multiples of a plane are the same plane, and a common factor of all control planes changes nothing: the
/// surface is computed from planes whose normals a power of two brought to the size of one, so that
/// products neither overflow nor vanish. Factors of *single* planes do change the family (they act as
/// weights): with the opposite sign a plane is the same, but the family turns the other way round; see
/// [`PlaneFamily::opposing_normals`].
///
/// ```
/// use torse_geometry::{Gbt, PlaneFamily};
/// // gbt-developable Example 4.1: all planes are parallel to the x axis.
/// let planes = vec![
///     [0.0, -20.0, 10.0, 400.0], [0.0, -10.0, 20.0, 400.0],
///     [0.0, 10.0, 20.0, 400.0], [0.0, 20.0, 10.0, 400.0],
/// ];
/// let family = PlaneFamily::new(Gbt::new(0.3, 0.3)?, planes)?;
/// let ruling = family.ruling(&0.25)?;
/// // So the surface is a cylinder: every ruling runs along x.
/// assert!(ruling.direction[0].abs() > 1.0);
/// assert_eq!([ruling.direction[1], ruling.direction[2]], [0.0, 0.0]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneFamily<B, S> {
    /// As given.
    planes: Curve<B, S, 4>,
    /// `planes / 2^exponent`: the longest normal has its largest coordinate in [1, 2).
    unit: Curve<B, S, 4>,
    exponent: i32,
}

/// The line in which a plane of a family meets its neighbour.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ruling<S> {
    /// The direction `phi = a x a'`; its length is not normalised.
    pub direction: [S; 3],
    /// The moment `theta = a3' a - a3 a'`; with `phi` the Pluecker coordinates of the line.
    pub moment: [S; 3],
    /// The point of the line nearest to the origin, `psi`.
    pub foot: [S; 3],
}

impl<S: Coordinate> Ruling<S> {
    /// The point `x1 phi + psi` (gbt-developable eq. (3.7)).
    #[must_use]
    pub fn point(&self, x1: &S) -> [S; 3] {
        add(&scale(x1, &self.direction), &self.foot)
    }

    /// The ruling of the planes times a power of two: the same line, with `a x a'` quadratic in the planes.
    #[inline(always)]
    pub(crate) fn of_planes_times_two_to(self, power: i32) -> Self {
        Self {
            direction: times_two_to(&self.direction, 2 * power),
            moment: times_two_to(&self.moment, 2 * power),
            foot: self.foot,
        }
    }

    #[inline(always)]
    pub(crate) fn coordinates(&self) -> impl Iterator<Item = &S> {
        self.direction.iter().chain(&self.moment).chain(&self.foot)
    }

    /// The parameter `x1` of the intersection with a plane.
    ///
    /// # Errors
    /// [`GeometryError::RulingParallelToPlane`], naming `parameter`, when they do not meet in one point.
    pub fn meets(&self, plane: &Plane<S>, parameter: &S) -> Result<S> {
        let [p, q, r, s] = plane.clone();
        let normal = [p, q, r];
        let distance = s - dot(&normal, &self.foot);
        distance
            .divided_by(&dot(&normal, &self.direction))
            .map_err(|_| GeometryError::RulingParallelToPlane {
                parameter: parameter.approximate(),
            })
    }
}

impl<S: Coordinate, B: Basis<S>> PlaneFamily<B, S> {
    /// The family with these control planes.
    ///
    /// # Errors
    /// [`GeometryError::TooFew`] for fewer than three planes (two span a pencil, whose planes share one
    /// line), [`GeometryError::NotFinite`], [`GeometryError::Degenerate`] for a control plane without
    /// normal, [`GeometryError::ParallelPlanes`] when all control planes are parallel,
    /// [`GeometryError::Pencil`] when all pass through one line.
    ///
    /// ```
    /// use torse_geometry::{Bernstein, GeometryError, PlaneFamily};
    /// let two = vec![[0.0, 0.0, 1.0, 1.0], [0.0, 1.0, 0.0, 1.0]];
    /// let error = PlaneFamily::new(Bernstein, two).unwrap_err();
    /// assert_eq!(error.to_string(), "control planes: 2 given, at least 3 needed");
    /// let infinite = vec![[0.0, 0.0, 1.0, f64::INFINITY]; 3];
    /// let error = PlaneFamily::new(Bernstein, infinite).unwrap_err();
    /// assert_eq!(error.to_string(), "control plane, entry 3: inf is not a finite number");
    /// let flat = vec![[0.0, 0.0, 1.0, 1.0], [0.0, 0.0, 2.0, 5.0], [0.0, 0.0, 1.0, 3.0]];
    /// assert_eq!(
    ///     PlaneFamily::new(Bernstein, flat).unwrap_err(),
    ///     GeometryError::ParallelPlanes { first: 0, second: 2 },
    /// );
    /// let no_normal = vec![[1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0, 5.0], [0.0, 0.0, 1.0, 3.0]];
    /// assert!(matches!(
    ///     PlaneFamily::new(Bernstein, no_normal),
    ///     Err(GeometryError::Degenerate { what: "normal of a control plane", .. }),
    /// ));
    /// // gbt-developable Example 4.2 as printed: Q2 = Q1 and Q3 = Q0, so all planes share one line.
    /// let h = 5.0 * 2_f64.sqrt();
    /// let (even, odd) = ([h, -h, 5.0, 125.0], [-h, -h, 5.0, 125.0]);
    /// assert_eq!(
    ///     PlaneFamily::new(Bernstein, vec![even, odd, odd, even]).unwrap_err(),
    ///     GeometryError::Pencil { first: 0, second: 1 },
    /// );
    /// ```
    pub fn new(basis: B, planes: Vec<Plane<S>>) -> Result<Self> {
        if planes.len() < 3 {
            return Err(GeometryError::TooFew {
                what: "control planes",
                needed: 3,
                given: planes.len(),
            });
        }
        check_finite("control plane", planes.iter().flatten())?;
        let curve = Curve::new(basis, planes)?;
        let exponent = curve.points().iter().filter_map(exponent_of).max();
        let exponent = exponent.unwrap_or(0);
        let unit = curve.mapped(|plane| plane.each_ref().map(|c| c.times_two_to(-exponent)));
        Self::of_parts(curve, unit, exponent)
    }

    /// The family with these planes, also over another scalar than that for which the exponent was found.
    pub(crate) fn of_parts(
        planes: Curve<B, S, 4>,
        unit: Curve<B, S, 4>,
        exponent: i32,
    ) -> Result<Self> {
        // Planes beyond the range of f64 as seen from the origin.
        check_finite("control plane", unit.points().iter().flatten())?;
        let vanishes = |plane: &Plane<S>| normal_of(plane).iter().all(is_zero);
        if let Some(index) = unit.points().iter().position(vanishes) {
            return Err(GeometryError::Degenerate {
                what: "normal of a control plane",
                at: Place::Index(index),
            });
        }
        pencil::check(unit.points())?;
        Ok(Self {
            planes,
            unit,
            exponent,
        })
    }

    /// The curve that everything is computed from, and `e`: it is [`PlaneFamily::curve`] over `2^e`.
    pub(crate) fn unit_curve(&self) -> (&Curve<B, S, 4>, i32) {
        (&self.unit, self.exponent)
    }

    /// The first control plane whose normal is known to make an obtuse angle with that of the next: then
    /// the family turns by more than a right angle between two control planes, most often because the sign
    /// of one plane was lost (`[p, q, r, s]` and `[-p, -q, -r, -s]` are one plane, but two families), and
    /// the surface may run through infinity.
    ///
    /// ```
    /// use torse_geometry::{Bernstein, PlaneFamily};
    /// let planes = |sign: f64| vec![[1., 0., 0.2, 3.], [0.5 * sign, sign, 0.1 * sign, 2. * sign], [0., 1., 0.5, 4.]];
    /// assert_eq!(PlaneFamily::new(Bernstein, planes(1.0))?.opposing_normals(), None);
    /// assert_eq!(PlaneFamily::new(Bernstein, planes(-1.0))?.opposing_normals(), Some(0));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    #[must_use]
    pub fn opposing_normals(&self) -> Option<usize> {
        let planes = self.unit.points();
        let obtuse = |(a, b): (&Plane<S>, &Plane<S>)| {
            dot(&normal_of(a), &normal_of(b)).sign() == Some(Ordering::Less)
        };
        planes.iter().zip(planes.iter().skip(1)).position(obtuse)
    }

    /// The family as a curve in the space of planes.
    #[must_use]
    pub fn curve(&self) -> &Curve<B, S, 4> {
        &self.planes
    }

    /// The degree `k`.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.planes.degree()
    }

    /// The plane `H(x)`, tangent to the surface along the ruling of `x`.
    ///
    /// # Errors
    /// [`GeometryError::Exact`] where the basis is not a number of this kind at `x`.
    pub fn plane(&self, x: &S) -> Result<Plane<S>> {
        self.planes.point(x)
    }

    /// The ruling `H(x), H'(x)` meet in.
    ///
    /// # Errors
    /// [`GeometryError::NoRuling`] where the two planes are parallel or coincide.
    ///
    /// ```
    /// use torse_geometry::{Bernstein, GeometryError, PlaneFamily};
    /// // A family that stands still at its start has no ruling there.
    /// let q = [0.0, 1.0, 0.0, 1.0];
    /// let planes = vec![q, q, [1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]];
    /// let family = PlaneFamily::new(Bernstein, planes)?;
    /// assert_eq!(
    ///     family.ruling(&0.0).unwrap_err(),
    ///     GeometryError::NoRuling { parameter: 0.0 },
    /// );
    /// # Ok::<(), GeometryError>(())
    /// ```
    pub fn ruling(&self, x: &S) -> Result<Ruling<S>> {
        let ruling = self.unit_ruling(x)?.of_planes_times_two_to(self.exponent);
        finite("ruling", ruling.coordinates(), x)?;
        Ok(ruling)
    }

    /// The ruling of the planes over `2^exponent`: the same line, with another length of its direction.
    pub(crate) fn unit_ruling(&self, x: &S) -> Result<Ruling<S>> {
        let mut row = vec![x.zero(); self.degree() + 1];
        let mut slope = row.clone();
        let basis = self.planes.basis();
        basis.row_and_slope_into(x, &mut row, &mut slope)?;
        let points = self.unit.points();
        let (plane, slope) = (blended(&row, points)?, blended(&slope, points)?);
        let ruling = ruling_of(&plane, &slope).map_err(|_| no_ruling(x))?;
        finite("ruling", ruling.coordinates(), x)?;
        Ok(ruling)
    }

    /// The point `S(x)` of the edge of regression (spine curve), gbt-developable eq. (3.9).
    ///
    /// # Errors
    /// [`GeometryError::NoCharacteristicPoint`] where `det(a, a', a'')` vanishes: at every `x` for
    /// cylinders.
    ///
    /// ```
    /// use torse_geometry::{Bernstein, PlaneFamily};
    /// // Osculating planes of the twisted cubic (t, t^2, t^3): 3t^2 X - 3t Y + Z = t^3.
    /// let planes = vec![[0., 0., 1., 0.], [0., -1., 1., 0.], [1., -2., 1., 0.], [3., -3., 1., 1.]];
    /// let family = PlaneFamily::new(Bernstein, planes)?;
    /// let t = 0.6;
    /// let s = family.characteristic_point(&t)?;
    /// assert!((s[0] - t).abs() < 1e-14 && (s[1] - t * t).abs() < 1e-14 && (s[2] - t * t * t).abs() < 1e-14);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn characteristic_point(&self, x: &S) -> Result<[S; 3]> {
        let jet = self.unit.derivatives(x, 2)?;
        let [h0, h1, h2] = jet.as_slice() else {
            return Err(no_point(x));
        };
        let point = characteristic_point_of([h0, h1, h2]).map_err(|_| no_point(x))?;
        finite("point of the edge of regression", &point, x)?;
        Ok(point)
    }

    /// The ruling parameter `x1` at which the ruling of `x` meets the edge of regression,
    /// `S(x) = x1 phi(x) + psi(x)`: a patch is regular where its bounds leave this value out.
    ///
    /// # Errors
    /// As [`PlaneFamily::ruling`] and [`PlaneFamily::characteristic_point`].
    ///
    /// ```
    /// use torse_geometry::{Gbt, PlaneFamily};
    /// let planes = vec![[1., 0., 0.2, 3.], [0.5, 1., 0.1, 2.], [0., 1., 0.5, 4.], [-1., 0.3, 0.1, 5.]];
    /// let family = PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?;
    /// let edge = family.ruling(&0.4)?.point(&family.edge_parameter(&0.4)?);
    /// let spine = family.characteristic_point(&0.4)?;
    /// assert!((0..3).all(|k| (edge[k] - spine[k]).abs() < 1e-12 * spine[k].abs()));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn edge_parameter(&self, x: &S) -> Result<S> {
        let (ruling, spine) = (self.unit_ruling(x)?, self.characteristic_point(x)?);
        let phi = &ruling.direction;
        // The foot is perpendicular to phi, so it drops out.
        let edge = dot(&spine, phi)
            .divided_by(&dot(phi, phi))
            .map_err(|_| no_ruling(x))?
            .times_two_to(-2 * self.exponent);
        finite("parameter of the edge of regression", [&edge], x)?;
        Ok(edge)
    }

    /// The ruling at `x` as Taylor series to this order, of the planes over `2^exponent`.
    pub(crate) fn unit_ruling_jet(&self, x: &S, order: usize) -> Result<Ruling<Jet<S>>> {
        let plane = self.unit.jet(x, order.saturating_add(1))?;
        let slope = slope_of(&plane).ok_or_else(|| no_ruling(x))?;
        ruling_of(&plane, &slope).map_err(|_| no_ruling(x))
    }

    /// [`PlaneFamily::unit_ruling`] with its first derivative.
    pub(crate) fn unit_ruling_and_slope(&self, x: &S) -> Result<Ruling<Dual<S>>> {
        let rows = self.unit.derivatives(x, 2)?;
        let [h0, h1, h2] = rows.as_slice() else {
            return Err(no_ruling(x));
        };
        let along = |value: &Plane<S>, slope: &Plane<S>| -> Plane<Dual<S>> {
            std::array::from_fn(|i| Dual {
                value: value[i].clone(),
                slope: slope[i].clone(),
            })
        };
        ruling_of(&along(h0, h1), &along(h1, h2)).map_err(|_| no_ruling(x))
    }

    /// The edge of regression at `x` as a Taylor series to this order.
    ///
    /// # Errors
    /// As [`PlaneFamily::characteristic_point`].
    pub fn characteristic_jet(&self, x: &S, order: usize) -> Result<[Jet<S>; 3]> {
        let h0 = self.unit.jet(x, order.saturating_add(2))?;
        let h1 = slope_of(&h0).ok_or_else(|| no_point(x))?;
        let h2 = slope_of(&h1).ok_or_else(|| no_point(x))?;
        characteristic_point_of([&h0, &h1, &h2]).map_err(|_| no_point(x))
    }
}

fn slope_of<S: Coordinate>(plane: &Plane<Jet<S>>) -> Option<Plane<Jet<S>>> {
    let [p, q, r, s] = plane;
    Some([
        p.differentiated()?,
        q.differentiated()?,
        r.differentiated()?,
        s.differentiated()?,
    ])
}

/// The common point of a plane and the first two derivatives of its family.
///
/// # Errors
/// [`ExactError::DivisionByZero`] when they have none or many.
pub fn characteristic_point_of<S: Scalar>(
    [h0, h1, h2]: [&Plane<S>; 3],
) -> Result<[S; 3], ExactError> {
    let [a, b, c] = [h0, h1, h2].map(normal_of);
    let bc = cross(&b, &c);
    let first = add(&scale(&h0[3], &bc), &scale(&h1[3], &cross(&c, &a)));
    divide(&add(&first, &scale(&h2[3], &cross(&a, &b))), &dot(&a, &bc))
}

/// The ruling in which a plane and the derivative of its family meet.
///
/// # Errors
/// [`ExactError::DivisionByZero`] when the planes are parallel.
#[inline(always)]
pub fn ruling_of<S: Scalar>(plane: &Plane<S>, slope: &Plane<S>) -> Result<Ruling<S>, ExactError> {
    let (a, b) = (normal_of(plane), normal_of(slope));
    let direction = cross(&a, &b);
    let moment = sub(&scale(&slope[3], &a), &scale(&plane[3], &b));
    let foot = divide(&cross(&direction, &moment), &dot(&direction, &direction))?;
    Ok(Ruling {
        direction,
        moment,
        foot,
    })
}

/// The normal `(p, q, r)` of a plane.
#[must_use]
#[inline(always)]
pub fn normal_of<S: Clone>(plane: &Plane<S>) -> [S; 3] {
    [plane[0].clone(), plane[1].clone(), plane[2].clone()]
}

#[inline(always)]
fn divide<S: Scalar>(v: &[S; 3], by: &S) -> Result<[S; 3], ExactError> {
    Ok([
        v[0].divided_by(by)?,
        v[1].divided_by(by)?,
        v[2].divided_by(by)?,
    ])
}

/// Refuses a result that left the range of the scalar.
pub(crate) fn finite<'a, S: Coordinate + 'a>(
    what: &'static str,
    values: impl IntoIterator<Item = &'a S>,
    x: &impl Coordinate,
) -> Result<()> {
    let at = Place::Parameter(x.approximate());
    if values.into_iter().all(Coordinate::is_finite) {
        Ok(())
    } else {
        Err(GeometryError::NoValue { what, at })
    }
}

/// The largest exponent among the coordinates of the normal.
pub(crate) fn exponent_of<S: Coordinate>(plane: &Plane<S>) -> Option<i32> {
    let [p, q, r, _] = plane;
    [p, q, r].into_iter().filter_map(Coordinate::exponent).max()
}

fn no_ruling<S: Coordinate>(x: &S) -> GeometryError {
    GeometryError::NoRuling {
        parameter: x.approximate(),
    }
}

fn no_point<S: Coordinate>(x: &S) -> GeometryError {
    GeometryError::NoCharacteristicPoint {
        parameter: x.approximate(),
    }
}
