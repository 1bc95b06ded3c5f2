//! The generalized blended trigonometric Bernstein-like (GBTB) basis.

use super::Basis;
use crate::coordinate::{Coordinate, check_shape};
use crate::error::Result;
use crate::series;
use torse_algebra::ExactError;

/// The GBTB family with shape parameters `mu, nu` in [-1, 1]: with `s = sin(pi x/2)` and
/// `c = cos(pi x/2)` the seeds are
///
/// ```text
/// g0 = (1 - s)(1 - mu s),   g2 = (1 - c)(1 - nu c),   g1 = 1 - g0 - g2
/// ```
///
/// (gbt-developable Definition 1, gbt-surfaces eq. (1)). At `mu = nu = 1` the quadratic is
/// `(1-s)^2, .., (1-c)^2`; at `mu = nu = 0` it is `1-s, s+c-1, 1-c`, whose curves are arcs of ellipses.
///
/// ```
/// use torse_geometry::{Basis, Gbt};
/// let quadratic = Gbt::new(0.0, 0.0)?.row(2, &0.5)?;
/// let half = 0.5_f64.sqrt();
/// assert!((quadratic[0] - (1.0 - half)).abs() < 1e-15);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Gbt<S> {
    mu: S,
    nu: S,
}

impl<S: Coordinate> Gbt<S> {
    /// The family with these shape parameters.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`](crate::GeometryError::OutOfRange) when a parameter is known to
    /// lie outside [-1, 1], [`GeometryError::NotFinite`](crate::GeometryError::NotFinite) for NaN and
    /// infinities.
    ///
    /// ```
    /// use torse_geometry::{Gbt, GeometryError};
    /// let error = Gbt::new(0.0, 1.5).unwrap_err();
    /// assert_eq!(error.to_string(), "nu = 1.5 is outside [-1, 1]");
    /// assert!(matches!(Gbt::new(f64::NAN, 0.0), Err(GeometryError::NotFinite { .. })));
    /// ```
    pub fn new(mu: S, nu: S) -> Result<Self> {
        check_shape("mu", &mu)?;
        check_shape("nu", &nu)?;
        Ok(Self { mu, nu })
    }

    /// The shape parameter at the start, `mu`.
    #[must_use]
    pub fn mu(&self) -> &S {
        &self.mu
    }

    /// The shape parameter at the end, `nu`.
    #[must_use]
    pub fn nu(&self) -> &S {
        &self.nu
    }

    /// The factors `s(1 - s)` and `c(1 - c)` that move the curve when `mu` and `nu` grow: the seeds
    /// are affine in both, `d g0/d mu = -s(1-s) = -d g1/d mu` and `d g2/d nu = -c(1-c) = -d g1/d nu`.
    ///
    /// # Errors
    /// [`ExactError::NoExactTurn`] where sine and cosine are not numbers of this kind.
    pub fn shape_factors(&self, x: &S) -> Result<[S; 2], ExactError> {
        let (s, c) = x.turn()?;
        Ok([s, c].map(|t| t.clone() * (t.one() - t)))
    }
}

impl<S: Coordinate> Basis<S> for Gbt<S> {
    fn seeds(&self, x: &S) -> Result<[S; 3], ExactError> {
        let (s, c) = x.turn()?;
        let one = x.one();
        let outer = |t: S, shape: &S| (one.clone() - t.clone()) * (one.clone() - shape.clone() * t);
        let g0 = outer(s, &self.mu);
        let g2 = outer(c, &self.nu);
        let g1 = one - g0.clone() - g2.clone();
        Ok([g0, g1, g2])
    }

    fn seed_series(&self, x: &S, order: usize) -> Result<[Vec<S>; 3], ExactError> {
        if order == 0 {
            return Ok(self.seeds(x)?.map(|g| vec![g]));
        }
        let (s, c) = series::quarter_turn(x, order)?;
        let outer = |t: &[S], shape: &S| {
            let one_minus_t = series::one_minus(t);
            let scaled: Vec<S> = t.iter().map(|v| shape.clone() * v.clone()).collect();
            series::product(&one_minus_t, &series::one_minus(&scaled))
        };
        let g0 = outer(&s, &self.mu);
        let g2 = outer(&c, &self.nu);
        let sum: Vec<S> = g0
            .iter()
            .zip(&g2)
            .map(|(a, b)| a.clone() + b.clone())
            .collect();
        let g1 = series::one_minus(&sum);
        Ok([g0, g1, g2])
    }

    fn reversed(&self) -> Self {
        Self {
            mu: self.nu.clone(),
            nu: self.mu.clone(),
        }
    }
}
