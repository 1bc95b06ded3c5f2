//! Arcs of ellipses of any angle, and helices: what a spline cannot hold with numbers that are known.
//!
//! `C(q) = centre + cos(pi/2 q) cosine + sin(pi/2 q) sine + q rise` with the angle `q` in quarter turns, from `from` to
//! `to` as the parameter runs from 0 to 1. Its Taylor series is in closed form: a derivative turns the pair `(cosine,
//! sine)` by a quarter and stretches it by `pi/2 (to - from)`.

use super::{AffineMap, SpaceCurve};
use crate::coordinate::{Coordinate, check_finite};
use crate::error::{GeometryError, Place, Result};
use crate::vector::{add, cross, dot, norm, scale, sub, unit};
use torse_algebra::Jet;

/// An arc of an ellipse, or of a helix about one, over [0, 1].
///
/// ```
/// use torse_geometry::SpaceCurve;
/// use torse_geometry::curve::EllipticHelix;
/// // A whole turn of radius 2 that climbs by 3, on f64.
/// let helix = EllipticHelix::new([0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.75], [0.0, 4.0])?;
/// assert_eq!(helix.space_point(&0.5)?, [-2.0, 0.0, 1.5]);
/// assert_eq!(helix.space_point(&1.0)?, [2.0, 0.0, 3.0]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EllipticHelix<S = f64> {
    centre: [S; 3],
    cosine: [S; 3],
    sine: [S; 3],
    rise: [S; 3],
    range: [S; 2],
}

impl<S> EllipticHelix<S> {
    /// The centre of the ellipse at the angle zero.
    #[must_use]
    pub fn centre(&self) -> &[S; 3] {
        &self.centre
    }

    /// The conjugate half axes: what the cosine and the sine go with.
    #[must_use]
    pub fn axes(&self) -> [&[S; 3]; 2] {
        [&self.cosine, &self.sine]
    }

    /// By how much a quarter turn climbs.
    #[must_use]
    pub fn rise(&self) -> &[S; 3] {
        &self.rise
    }

    /// The angles of start and end, in quarter turns.
    #[must_use]
    pub fn range(&self) -> &[S; 2] {
        &self.range
    }
}

impl<S: Coordinate> EllipticHelix<S> {
    /// The helix about an ellipse with this centre and these conjugate half axes, which climbs by `rise` in each
    /// quarter turn, between two angles in quarter turns. Of a plane arc `rise` is zero.
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`].
    pub fn new(
        centre: [S; 3],
        cosine: [S; 3],
        sine: [S; 3],
        rise: [S; 3],
        range: [S; 2],
    ) -> Result<Self> {
        let vectors = [&centre, &cosine, &sine, &rise];
        check_finite("elliptic arc", vectors.into_iter().flatten())?;
        check_finite("angle of an elliptic arc", &range)?;
        Ok(Self {
            centre,
            cosine,
            sine,
            rise,
            range,
        })
    }

    /// The image under an affine map.
    #[must_use]
    pub fn mapped(&self, map: &AffineMap<S>) -> Self {
        Self {
            centre: map.apply(&self.centre),
            cosine: map.turn(&self.cosine),
            sine: map.turn(&self.sine),
            rise: map.turn(&self.rise),
            range: self.range.clone(),
        }
    }

    /// The same curve traversed backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [from, to] = self.range.clone();
        Self {
            range: [to, from],
            ..self.clone()
        }
    }

    /// The part from `from` to `to`, shares of the whole in [0, 1].
    #[must_use]
    pub fn part(&self, from: &S, to: &S) -> Self {
        let at = |x: &S| self.angle(x);
        Self {
            range: [at(from), at(to)],
            ..self.clone()
        }
    }

    /// The angle at `x` in quarter turns; exact at both ends.
    fn angle(&self, x: &S) -> S {
        let [from, to] = &self.range;
        (x.one() - x.clone()) * from.clone() + x.clone() * to.clone()
    }
}

/// `(sin, cos)` of an angle in quarter turns: whole quarters are exact, so f64 has the same bits on every machine.
fn turned<S: Coordinate>(angle: &S) -> Result<[S; 2]> {
    let near = angle.approximate().floor();
    let whole = if near.abs() < 1e15 { near } else { 0.0 };
    #[allow(clippy::cast_possible_truncation, reason = "an integer below 2^53")]
    let quarters = whole as i64;
    let shift = angle.constant(&torse_algebra::rational::integer(quarters));
    let (sine, cosine) = (angle.clone() - shift).turn()?;
    Ok(match quarters.rem_euclid(4) {
        0 => [sine, cosine],
        1 => [cosine, -sine],
        2 => [-sine, -cosine],
        _ => [-cosine, sine],
    })
}

impl<S: Coordinate> SpaceCurve<S> for EllipticHelix<S> {
    fn space_jet(&self, x: &S, order: usize) -> Result<[Jet<S>; 3]> {
        let angle = self.angle(x);
        let [mut sine, mut cosine] = turned(&angle)?;
        let blend =
            |sine: &S, cosine: &S| add(&scale(cosine, &self.cosine), &scale(sine, &self.sine));
        let value = add(
            &add(&self.centre, &blend(&sine, &cosine)),
            &scale(&angle, &self.rise),
        );
        let [from, to] = &self.range;
        let width = to.clone() - from.clone();
        let speed = width.clone() * x.half_pi()?;
        let mut terms: Vec<[S; 3]> = Vec::with_capacity(order);
        let mut factor = x.one();
        for k in 1..=order {
            // The derivative of (cos, sin) is (-sin, cos).
            (sine, cosine) = (cosine, -sine);
            factor = (factor * speed.clone()).divided_by(&x.natural(k))?;
            let mut term = scale(&factor, &blend(&sine, &cosine));
            if k == 1 {
                term = add(&term, &scale(&width, &self.rise));
            }
            terms.push(term);
        }
        Ok(std::array::from_fn(|axis| {
            let rest = terms.iter().map(|term| term[axis].clone());
            Jet::from_coefficients(value[axis].clone(), rest)
        }))
    }
}

impl EllipticHelix {
    /// The arc of a circle about an axis, from a point, by an angle in degrees (positive counter-clockwise seen from
    /// the tip of the axis), that climbs by `climb` along the axis on the whole of its way.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] for an axis without direction, a point on the axis, an angle of zero;
    /// [`GeometryError::NotFinite`].
    ///
    /// ```
    /// use torse_geometry::SpaceCurve;
    /// use torse_geometry::curve::EllipticHelix;
    /// let arc = EllipticHelix::about([0.0; 3], [0.0, 0.0, 2.0], [5.0, 0.0, 1.0], 180.0, 0.0)?;
    /// assert_eq!(arc.space_point(&1.0)?, [-5.0, 0.0, 1.0]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn about(
        centre: [f64; 3],
        axis: [f64; 3],
        from: [f64; 3],
        degrees: f64,
        climb: f64,
    ) -> Result<Self> {
        check_finite("arc", [centre, axis, from].iter().flatten())?;
        check_finite("angle of an arc", [&degrees, &climb])?;
        let degenerate = |what| GeometryError::Degenerate {
            what,
            at: Place::Whole,
        };
        let axis = unit(&axis).ok_or(degenerate("an axis without direction"))?;
        if degrees == 0.0 {
            return Err(degenerate("an arc without an angle"));
        }
        let reach = sub(&from, &centre);
        let along = dot(&reach, &axis);
        let foot = add(&centre, &scale(&along, &axis));
        let cosine = sub(&from, &foot);
        if norm(&cosine) == 0.0 {
            return Err(degenerate("an arc about an axis through its start"));
        }
        let quarters = degrees / 90.0;
        let rise = scale(&(climb / quarters), &axis);
        Self::new(foot, cosine, cross(&axis, &cosine), rise, [0.0, quarters])
    }
}
