//! The generalized blended trigonometric Bernstein-like (GBTB) basis.

use super::Basis;
use crate::coordinate::{Coordinate, check_shape};
use crate::error::Result;
use torse_algebra::{ExactError, Jet};

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

    /// The seeds from sine and cosine.
    #[inline(always)]
    fn seeds_of_turn(&self, s: S, c: S) -> [S; 3] {
        let one = s.one();
        let outer = |t: S, shape: &S| (one.clone() - t.clone()) * (one.clone() - shape.clone() * t);
        let g0 = outer(s, &self.mu);
        let g2 = outer(c, &self.nu);
        let g1 = one - g0.clone() - g2.clone();
        [g0, g1, g2]
    }

    /// The derivatives of the seeds from sine and cosine.
    #[inline(always)]
    fn slopes_of_turn(&self, s: S, c: S, half_pi: &S) -> [S; 3] {
        // d/dt (1 - t)(1 - m t) = 2 m t - 1 - m
        let outer = |t: &S, m: &S| m.clone() * (t.clone() + t.clone() - t.one()) - t.one();
        let d0 = half_pi.clone() * c.clone() * outer(&s, &self.mu);
        let d2 = -(half_pi.clone() * s * outer(&c, &self.nu));
        [d0.clone(), -(d0 + d2.clone()), d2]
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
    #[inline(always)]
    fn seeds(&self, x: &S) -> Result<[S; 3], ExactError> {
        let (s, c) = x.turn()?;
        Ok(self.seeds_of_turn(s, c))
    }

    #[inline(always)]
    fn seed_columns(&self, xs: &[S], columns: [&mut [S]; 3]) -> Result<(), ExactError> {
        let [first, second, third] = columns;
        // Sine and cosine wait where their seeds will be.
        S::turns(xs, first, third)?;
        for (((g0, g1), g2), _) in first.iter_mut().zip(second).zip(third).zip(xs) {
            [*g0, *g1, *g2] = self.seeds_of_turn(g0.clone(), g2.clone());
        }
        Ok(())
    }

    #[inline(always)]
    fn seed_slopes(&self, x: &S) -> Result<[S; 3]> {
        let (s, c) = x.turn()?;
        Ok(self.slopes_of_turn(s, c, &x.half_pi()?))
    }

    #[inline(always)]
    fn seed_and_slope_columns(
        &self,
        xs: &[S],
        columns: [&mut [S]; 3],
        slopes: [&mut [S]; 3],
    ) -> Result<()> {
        let ([first, second, third], [d0, d1, d2]) = (columns, slopes);
        S::turns(xs, first, third)?;
        let Some(half_pi) = xs.first().map(S::half_pi).transpose()? else {
            return Ok(());
        };
        let turns = xs.iter().zip(first.iter()).zip(third.iter());
        for ((((_, s), c), d0), (d1, d2)) in turns.zip(d0).zip(d1.iter_mut().zip(d2)) {
            [*d0, *d1, *d2] = self.slopes_of_turn(s.clone(), c.clone(), &half_pi);
        }
        for (((g0, g1), g2), _) in first.iter_mut().zip(second).zip(third).zip(xs) {
            [*g0, *g1, *g2] = self.seeds_of_turn(g0.clone(), g2.clone());
        }
        Ok(())
    }

    fn seed_jets(&self, x: &S, order: usize) -> Result<[Jet<S>; 3], ExactError> {
        let (s, c) = turn_jets(x, order)?;
        let one = s.constant_like(x.one());
        let outer = |t: Jet<S>, shape: &S| {
            (one.clone() - t.clone()) * (one.clone() - t.constant_like(shape.clone()) * t)
        };
        let g0 = outer(s, &self.mu);
        let g2 = outer(c, &self.nu);
        Ok([g0.clone(), one.clone() - g0 - g2.clone(), g2])
    }

    fn reversed(&self) -> Self {
        Self {
            mu: self.nu.clone(),
            nu: self.mu.clone(),
        }
    }
}

/// The series of `sin(pi t/2)` and `cos(pi t/2)` at `t = x`, from [`Coordinate::turn`]: coefficient `n`
/// is `(pi/2)^n / n!` times `s, c, -s, -c` in turn (and `c, -s, -c, s`).
fn turn_jets<S: Coordinate>(x: &S, order: usize) -> Result<(Jet<S>, Jet<S>), ExactError> {
    let (s, c) = x.turn()?;
    let (mut sine, mut cosine) = (Vec::with_capacity(order), Vec::with_capacity(order));
    let (mut ds, mut dc) = (s.clone(), c.clone());
    let half_pi = if order > 0 { x.half_pi()? } else { x.one() };
    for n in 1..=order {
        let step = half_pi.divided_by(&x.natural(n))?;
        // d/dt (sin, cos) = pi/2 (cos, -sin)
        (ds, dc) = (dc * step.clone(), -(ds * step));
        sine.push(ds.clone());
        cosine.push(dc.clone());
    }
    Ok((
        Jet::from_coefficients(s, sine),
        Jet::from_coefficients(c, cosine),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::Scalar;

    #[test]
    fn the_series_of_the_turn_is_the_turn_of_the_series() {
        let (s, c) = turn_jets(&0.3_f64, 6).unwrap();
        let (s1, c1) = Jet::variable(0.3_f64, 6).quarter_turn().unwrap();
        for (a, b) in s.coefficients().iter().zip(s1.coefficients()) {
            assert!((a - b).abs() < 1e-14);
        }
        for (a, b) in c.coefficients().iter().zip(c1.coefficients()) {
            assert!((a - b).abs() < 1e-14);
        }
    }
}
