//! Surfaces of revolution in the rational parametrization of gbt-surfaces Theorem 6.
//!
//! ```text
//! T(u, z) = ( C(z) X(u), +-W(z) X(u), Z(u) ),  C = (1-2z)/(2z^2-2z+1),  W = (2z-2z^2)/(2z^2-2z+1)
//! ```
//!
//! `C^2 + W^2 = 1`, so every section is a circle, and `z` in [0, 1] sweeps half a turn. The angle is
//! *not* proportional to `z`: with `t = tan(angle/2)`, `C = (1-t^2)/(1+t^2)` gives `z = t/(1+t)`
//! ([`rotation_parameter`]). Proposition 3.8 of the paper uses the linear range, which sweeps a
//! different angle (at 90 degrees both agree, at 60 degrees the linear range stops at 53.13).

use super::{Partials, Surface};
use crate::basis::Basis;
use crate::coordinate::{Coordinate, check_shape};
use crate::curve::{Curve, derivatives_of};
use crate::error::{GeometryError, Result};
use torse_algebra::{Jet, Scalar};

/// Which half turn: `Upper` has `Y >= 0` (for positive radii), `Lower` its mirror image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HalfTurn {
    /// Angles 0 to pi.
    Upper,
    /// Angles 0 to -pi.
    Lower,
}

/// The profile `(X(u), Z(u))` turned about the Z axis, over a range of the paper's parameter `z`.
#[derive(Debug, Clone, PartialEq)]
pub struct RotationSurface<B, S> {
    profile: Curve<B, S, 2>,
    half: HalfTurn,
    /// The bounds of `z`; the whole half turn when absent.
    range: Option<[S; 2]>,
}

impl<S: Coordinate, B: Basis<S>> RotationSurface<B, S> {
    /// A full half turn.
    ///
    /// ```
    /// use torse_algebra::rational::{integer, ratio};
    /// use torse_geometry::{Bernstein, Curve, HalfTurn, RotationSurface, Surface};
    /// let profile = Curve::new(Bernstein, vec![[integer(2), integer(0)], [integer(2), integer(5)]])?;
    /// let half = RotationSurface::half_turn(profile, HalfTurn::Upper);
    /// // Exactly on the circle of radius 2:
    /// let [x, y, _] = half.point(&ratio(1, 3).unwrap(), &ratio(1, 4).unwrap())?;
    /// assert_eq!(&x * &x + &y * &y, integer(4));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    #[must_use]
    pub fn half_turn(profile: Curve<B, S, 2>, half: HalfTurn) -> Self {
        Self {
            profile,
            half,
            range: None,
        }
    }

    /// The part of a half turn with the paper's parameter from `range[0]` to `range[1]`.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] when a bound is known to lie outside [0, 1].
    pub fn sector(profile: Curve<B, S, 2>, half: HalfTurn, range: [S; 2]) -> Result<Self> {
        for bound in &range {
            // 2z - 1 lies in [-1, 1] exactly when z lies in [0, 1].
            let centred = bound.clone() + bound.clone() - bound.one();
            check_shape("2z - 1 of the rotation parameter", &centred)?;
        }
        Ok(Self {
            profile,
            half,
            range: Some(range),
        })
    }

    /// The profile curve `(X, Z)`.
    #[must_use]
    pub fn profile(&self) -> &Curve<B, S, 2> {
        &self.profile
    }

    /// Which half turn it belongs to.
    #[must_use]
    pub fn half(&self) -> HalfTurn {
        self.half
    }

    /// The bounds of the paper's parameter; `None` for the whole half turn.
    #[must_use]
    pub fn range(&self) -> Option<&[S; 2]> {
        self.range.as_ref()
    }
}

impl<B: Basis<f64>> RotationSurface<B, f64> {
    /// The surface swept by turning the profile by `angle` in (0, 2 pi]: one sector up to pi, two beyond
    /// (gbt-surfaces Proposition 3.8 with the right parameter range).
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] for other angles, NaN included.
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt, RotationSurface, Surface};
    /// // gbt-surfaces Example 3.6, turned by 240 degrees.
    /// let points = vec![[4.0, 15.0], [0.0, 13.0], [0.0, 10.0], [10.0, 5.0], [4.0, 0.0]];
    /// let profile = Curve::new(Gbt::new(0.9, 0.25)?, points)?;
    /// let angle = 240_f64.to_radians();
    /// let sectors = RotationSurface::turned(&profile, angle)?;
    /// let end = sectors[1].point(&0.0, &1.0)?;
    /// assert!((end[0] - 4.0 * angle.cos()).abs() < 1e-14 && (end[1] - 4.0 * angle.sin()).abs() < 1e-14);
    /// assert!(RotationSurface::turned(&profile, 7.0).is_err());
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn turned(profile: &Curve<B, f64, 2>, angle: f64) -> Result<Vec<Self>> {
        use std::f64::consts::PI;
        if !(angle > 0.0 && angle <= 2.0 * PI) {
            let (name, range) = ("rotation angle", "(0, 2 pi]");
            return Err(GeometryError::OutOfRange {
                name,
                value: angle,
                range,
            });
        }
        let sector = |half, range| Self::sector(profile.clone(), half, range);
        if angle <= PI {
            return Ok(vec![sector(
                HalfTurn::Upper,
                [0.0, rotation_parameter(angle)],
            )?]);
        }
        // The second part runs from the angle pi = -pi to the angle -(2 pi - angle) on the mirror image.
        let rest = [1.0, rotation_parameter(2.0 * PI - angle)];
        Ok(vec![
            sector(HalfTurn::Upper, [0.0, 1.0])?,
            sector(HalfTurn::Lower, rest)?,
        ])
    }
}

/// The parameter `z` at which the half turn has reached `angle` in [0, pi]:
/// `z = t/(1 + t)` with `t = tan(angle/2)`, written without the pole at pi.
///
/// ```
/// use torse_geometry::surface::rotation_parameter;
/// let angle = 60_f64.to_radians();
/// let z = rotation_parameter(angle);
/// assert!(((1.0 - 2.0 * z) / (2.0 * z * z - 2.0 * z + 1.0) - angle.cos()).abs() < 1e-15);
/// // The linear range of the paper, z = 1/3, reaches 53.13 degrees only.
/// let printed = ((1.0 - 2.0 / 3.0) / (2.0 / 9.0 - 2.0 / 3.0 + 1.0_f64)).acos().to_degrees();
/// assert!((printed - 53.130_102).abs() < 1e-6);
/// ```
#[must_use]
pub fn rotation_parameter(angle: f64) -> f64 {
    let (sine, cosine) = libm::sincos(0.5 * angle);
    sine / (sine + cosine)
}

impl<S: Coordinate, B: Basis<S>> Surface<S> for RotationSurface<B, S> {
    fn partials(&self, u: &S, v: &S, order: usize) -> Result<Partials<S>> {
        let profile = derivatives_of(&self.profile.jet(u, order)?, order)?;
        let t = Jet::variable(v.clone(), order);
        let z = match &self.range {
            None => t,
            Some([from, to]) => {
                let [from, to] = [from, to].map(|bound| t.constant_like(bound.clone()));
                from.clone() + (to - from) * t
            }
        };
        let one = z.constant_like(u.one());
        // 2z - 2z^2; the denominator is one minus it.
        let sine = (z.clone() + z.clone()) * (one.clone() - z.clone());
        let bottom = one.clone() - sine.clone();
        let cosine = (one - z.clone() - z).divided_by(&bottom)?;
        let sine = sine.divided_by(&bottom)?;
        let sine = if self.half == HalfTurn::Lower {
            -sine
        } else {
            sine
        };
        let circle = derivatives_of(&[cosine, sine], order)?;
        let entry = |list: &[[S; 2]], n: usize| {
            list.get(n)
                .cloned()
                .unwrap_or_else(|| std::array::from_fn(|_| u.zero()))
        };
        Ok(Partials::from_fn(order, |i, j| {
            let ([radius, height], [cosine, sine]) = (entry(&profile, i), entry(&circle, j));
            let height = if j == 0 { height } else { u.zero() };
            [radius.clone() * cosine, radius * sine, height]
        }))
    }
}
