//! Curves in any dimension over any basis family and scalar.

mod affine;
mod bezier;
mod conic;
mod differences;
mod elliptic;
mod least;
mod measure;
#[cfg(feature = "nalgebra")]
mod nalgebra;
mod rational;
mod space;
mod spline;
mod split;
mod through;

pub use affine::AffineMap;
pub use bezier::Bezier;
pub use conic::{ellipse_arc, parabola_arc};
pub use elliptic::EllipticHelix;
pub(crate) use least::least;
pub(crate) use measure::integrate;
pub use measure::{arc_length, curvature, torsion};
pub use rational::RationalCurve;
pub use space::SpaceCurve;
pub(crate) use space::{first_two, too_short};
pub use spline::{MAX_SPLINE_DEGREE, MAX_SPLINE_POINTS, MAX_SPLINE_WORK, Spline};
pub use through::{EndCondition, Interpolation, Spacing, interpolate, interpolate_closed};

use crate::basis::{Basis, Gbt};
use crate::coordinate::{Coordinate, check_finite};
use crate::error::{GeometryError, Result};
use crate::vector::{add, blended, combine, scale, sub};
use torse_algebra::Jet;

/// A curve `G(x) = sum_i g[i,k](x) R[i]`, `x` in [0, 1] (gbt-developable eq. (2.2), gbt-surfaces eq. (3)).
///
/// The degree is the number of control points minus one, and at least one. The curve starts in its
/// first control point, ends in its last and, for shape parameters in [-1, 1], lies in the convex
/// hull of all.
///
/// ```
/// use torse_geometry::{Curve, Gbt};
/// let curve = Curve::new(Gbt::new(1.0, 1.0)?, vec![[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]])?;
/// assert_eq!(curve.degree(), 3);
/// assert_eq!(curve.point(&0.0)?, [0.0, 0.0]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Curve<B, S, const D: usize> {
    basis: B,
    points: Vec<[S; D]>,
}

/// Terms of the expansion about the centre of a wide enclosure: what is left falls with this power of its
/// width.
const DEPTH: usize = 3;

impl<S: Coordinate, B: Basis<S>, const D: usize> Curve<B, S, D> {
    /// The curve with these control points.
    ///
    /// # Errors
    /// [`GeometryError::TooFew`] for fewer than two points, [`GeometryError::OutOfRange`] beyond
    /// [`MAX_DEGREE`](crate::basis::MAX_DEGREE), [`GeometryError::NotFinite`] for NaN and infinite coordinates.
    ///
    /// ```
    /// use torse_geometry::{Bernstein, Curve};
    /// let error = Curve::new(Bernstein, vec![[0.0, 0.0], [f64::NAN, 1.0]]).unwrap_err();
    /// assert_eq!(error.to_string(), "control point, entry 2: NaN is not a finite number");
    /// let error = Curve::new(Bernstein, vec![[0.0, 0.0]]).unwrap_err();
    /// assert_eq!(error.to_string(), "control points: 1 given, at least 2 needed");
    /// ```
    pub fn new(basis: B, points: Vec<[S; D]>) -> Result<Self> {
        if points.len() < 2 {
            return Err(GeometryError::TooFew {
                what: "control points",
                needed: 2,
                given: points.len(),
            });
        }
        crate::basis::check_degree(points.len() - 1)?;
        check_finite("control point", points.iter().flatten())?;
        Ok(Self { basis, points })
    }

    /// The degree `k`.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.points.len().saturating_sub(1)
    }

    /// The basis family.
    #[must_use]
    pub fn basis(&self) -> &B {
        &self.basis
    }

    /// The control points `R[0], .., R[k]`.
    #[must_use]
    pub fn points(&self) -> &[[S; D]] {
        &self.points
    }

    /// The point `G(x)`.
    ///
    /// # Errors
    /// [`GeometryError::Exact`] where the basis is not a number of this kind at `x`.
    pub fn point(&self, x: &S) -> Result<[S; D]> {
        blended(&self.basis.row(self.degree(), x)?, &self.points)
    }

    /// The derivatives `[G(x), G'(x), .., G^(order)(x)]`.
    ///
    /// # Errors
    /// As [`Curve::point`].
    pub fn derivatives(&self, x: &S, order: usize) -> Result<Vec<[S; D]>> {
        let rows = self.basis.derivative_rows(self.degree(), x, order)?;
        self.blended_all(&rows, order)
    }

    /// The derivatives `[G(0), G'(0), .., G^(order)(0)]` at the start.
    ///
    /// # Errors
    /// As [`Curve::point`].
    pub fn start_jet(&self, order: usize) -> Result<Vec<[S; D]>> {
        match self.points.iter().flatten().next() {
            Some(like) => self.derivatives(&like.zero(), order),
            None => Ok(Vec::new()),
        }
    }

    /// The derivatives `[G(1), G'(1), .., G^(order)(1)]` at the end.
    ///
    /// # Errors
    /// As [`Curve::point`].
    ///
    /// ```
    /// use torse_algebra::rational::integer;
    /// use torse_geometry::{Bernstein, Curve};
    /// let curve = Curve::new(Bernstein, [1, 4, 2, 7].map(|n| [integer(n)]).to_vec())?;
    /// assert_eq!(curve.end_jet(1)?, [[integer(7)], [integer(15)]]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn end_jet(&self, order: usize) -> Result<Vec<[S; D]>> {
        match self.points.iter().flatten().next() {
            Some(like) => self.derivatives(&like.one(), order),
            None => Ok(Vec::new()),
        }
    }

    /// The Taylor series of each coordinate at `x`; of a wide ball, enclosures of the coefficients at all
    /// its points.
    ///
    /// # Errors
    /// As [`Curve::point`].
    ///
    /// ```
    /// use torse_algebra::{Ball, rational::{integer, ratio}};
    /// use torse_geometry::{Bernstein, Curve, exact_ball};
    /// // x^2 - x + 1 from the Bernstein coefficients 1, 1/2, 1: between 3/4 and 1 on the interval.
    /// let ball = |x: f64| exact_ball(x, 64);
    /// let curve = Curve::new(Bernstein, vec![[ball(1.0)], [ball(0.5)], [ball(1.0)]])?;
    /// let [series] = curve.jet(&Ball::from_bounds(&integer(0), &integer(1), 64), 0)?;
    /// assert!(series.value().contains(&ratio(3, 4).unwrap()) && series.value().contains(&integer(1)));
    /// let (low, high) = series.value().to_f64_bounds();
    /// assert_eq!((low, high), (0.5, 1.0));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn jet(&self, x: &S, order: usize) -> Result<[Jet<S>; D]> {
        let points = match x.centred() {
            None => self.series(x, order)?,
            Some((centre, rest)) => self.series_about(&centre, &rest, x, order)?,
        };
        let (value, rest) = points.split_first().ok_or(GeometryError::TooFew {
            what: "Taylor coefficients",
            needed: 1,
            given: 0,
        })?;
        Ok(std::array::from_fn(|axis| {
            let rest = rest.iter().map(|point| point[axis].clone());
            Jet::from_coefficients(value[axis].clone(), rest)
        }))
    }

    /// The Taylor coefficients at `x`.
    fn series(&self, x: &S, order: usize) -> Result<Vec<[S; D]>> {
        if self.basis.is_bernstein() && differences::DEGREES.contains(&self.degree()) {
            return differences::series(&self.points, x, order);
        }
        let rows = self.basis.series_rows(self.degree(), x, order)?;
        self.blended_all(&rows, order)
    }

    /// The Taylor coefficients at the points `x = centre + rest` from those at the centre: with `n = DEPTH`,
    ///
    /// ```text
    /// c[k](x) = sum_(i < n) C(k+i, k) c[k+i](centre) rest^i + C(k+n, k) c[k+n](some point) rest^n.
    /// ```
    fn series_about(&self, centre: &S, rest: &S, x: &S, order: usize) -> Result<Vec<[S; D]>> {
        let deepest = order.saturating_add(DEPTH);
        let (at, over) = (self.series(centre, deepest)?, self.series(x, deepest)?);
        let binomial = |k: usize, i: usize| (1..=i).fold(1, |c: usize, n| c * (k + n) / n);
        // The coefficients k .. k + DEPTH of both, each with its binomial.
        let coefficients = at.windows(DEPTH).zip(over.iter().skip(DEPTH)).enumerate();
        let coefficient = |(k, (near, last)): (usize, (&[[S; D]], &[S; D]))| {
            let weighted = |i, point| scale(&x.natural(binomial(k, i)), point);
            let terms = near.iter().enumerate().rev();
            terms.fold(weighted(DEPTH, last), |sum, (i, point)| {
                add(&weighted(i, point), &scale(rest, &sum))
            })
        };
        Ok(coefficients.map(coefficient).collect())
    }

    /// The first derivative, from the differences of neighbouring control points: with `D` the row of these,
    ///
    /// ```text
    /// G' = (k - 2) g[., k-1] . D + B[., k-2] . (g2' E - g0') D,
    /// ```
    ///
    /// as `g0' + g1' + g2' = 0`. Where control points coincide nothing is left of them, however far from the origin.
    ///
    /// # Errors
    /// As [`Curve::point`].
    pub(crate) fn slope(&self, x: &S) -> Result<[S; D]> {
        let steps = self.points.iter().zip(self.points.iter().skip(1));
        let steps: Vec<[S; D]> = steps.map(|(a, b)| sub(b, a)).collect();
        let degree = self.degree();
        if degree < 2 {
            return blended(&[x.one()], &steps);
        }
        let [down, _, up] = self.basis.seed_slopes(x)?;
        let blend = crate::basis::blend_row(degree - 2, x);
        let mut weights = if degree > 2 {
            let factor = x.natural(degree - 2);
            let row = self.basis.row(degree - 1, x)?;
            row.into_iter().map(|g| factor.clone() * g).collect()
        } else {
            vec![x.zero(); 2]
        };
        for (slot, b) in weights.iter_mut().zip(&blend) {
            *slot = slot.clone() - down.clone() * b.clone();
        }
        for (slot, b) in weights.iter_mut().skip(1).zip(&blend) {
            *slot = slot.clone() + up.clone() * b.clone();
        }
        blended(&weights, &steps)
    }

    /// The same curve traversed backwards: `x -> G(1 - x)`.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            basis: self.basis.reversed(),
            points: self.points.iter().rev().cloned().collect(),
        }
    }

    /// The curve whose control points are the images of these under `map`.
    ///
    /// For affine maps this is the image of the curve (affine invariance, from the partition of unity).
    #[must_use]
    pub fn mapped<const E: usize>(&self, map: impl Fn(&[S; D]) -> [S; E]) -> Curve<B, S, E> {
        Curve {
            basis: self.basis.clone(),
            points: self.points.iter().map(map).collect(),
        }
    }

    /// The same control points under another name of the basis.
    pub(crate) fn with_basis<C>(self, rename: impl FnOnce(B) -> C) -> Curve<C, S, D> {
        Curve {
            basis: rename(self.basis),
            points: self.points,
        }
    }

    /// One point for each order of derivatives; refuses to have fewer.
    fn blended_all(&self, rows: &[Vec<S>], order: usize) -> Result<Vec<[S; D]>> {
        if rows.len() <= order {
            return Err(GeometryError::TooFew {
                what: "rows of basis functions",
                needed: order.saturating_add(1),
                given: rows.len(),
            });
        }
        rows.iter().map(|row| blended(row, &self.points)).collect()
    }
}

impl<S: Coordinate, const D: usize> Curve<Gbt<S>, S, D> {
    /// `[dG/d mu, dG/d nu]` at `x` (gbt-developable eqs. (2.3), (2.4), corrected).
    ///
    /// `G` is affine in both shape parameters:
    ///
    /// ```text
    /// dG/d mu = s(1-s) sum_j B[j,k-2](x) (R[j+1] - R[j])
    /// dG/d nu = c(1-c) sum_j B[j,k-2](x) (R[j+1] - R[j+2])
    /// ```
    ///
    /// with `B` the Bernstein polynomials; the print has powers of sine and cosine where the blend is
    /// polynomial. Zero for degree one, which has no shape.
    ///
    /// # Errors
    /// As [`Curve::point`].
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt};
    /// let at = |mu: f64| Curve::new(Gbt::new(mu, 0.5)?, vec![[0.0], [1.0], [4.0], [2.0], [0.0]]);
    /// let [by_mu, _] = at(0.0)?.shape_derivatives(&0.4)?;
    /// let step = at(0.75)?.point(&0.4)?[0] - at(-0.25)?.point(&0.4)?[0];
    /// assert!((step - by_mu[0]).abs() < 1e-15);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn shape_derivatives(&self, x: &S) -> Result<[[S; D]; 2]> {
        let zero = || std::array::from_fn(|_| x.zero());
        let differences: Vec<[S; D]> = self
            .points
            .iter()
            .zip(self.points.iter().skip(1))
            .map(|(a, b)| sub(b, a))
            .collect();
        if differences.len() < 2 {
            return Ok([zero(), zero()]);
        }
        let blend = crate::basis::blend_row(differences.len() - 2, x);
        let [by_mu, by_nu] = self.basis.shape_factors(x)?;
        let later: Vec<[S; D]> = differences.iter().skip(1).cloned().collect();
        let sum = |list: &[[S; D]]| combine(&blend, list).unwrap_or_else(zero);
        Ok([
            scale(&by_mu, &sum(&differences)),
            scale(&-by_nu, &sum(&later)),
        ])
    }
}

/// Derivatives `[f, f', .., f^(order)]` of a vector from the Taylor series of its coordinates; refuses series
/// that are shorter, as a curve of somebody else may give them.
pub(crate) fn derivatives_of<S: Coordinate, const D: usize>(
    jets: &[Jet<S>; D],
    order: usize,
) -> Result<Vec<[S; D]>> {
    if let Some((index, short)) = jets.iter().enumerate().find(|(_, jet)| jet.order() < order) {
        return Err(GeometryError::LengthMismatch {
            what: "Taylor coefficients",
            index,
            expected: order + 1,
            given: short.order() + 1,
        });
    }
    let derivative = |jet: &Jet<S>, n| jet.derivative(n).unwrap_or_else(|| jet.value().zero());
    Ok((0..=order)
        .map(|n| jets.each_ref().map(|jet| derivative(jet, n)))
        .collect())
}
