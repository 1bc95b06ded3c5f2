//! Finite patches of the developable that a plane family envelops.

use crate::basis::Basis;
use crate::coordinate::{Coordinate, check_finite, is_zero};
use crate::curve::first_two;
use crate::dual::Dual;
use crate::error::{GeometryError, Place, Result};
use crate::planes::{Plane, PlaneFamily, Ruling, exponent_of, finite, normal_of};
use crate::surface::{Partials, Rails, Surface, partials_between};
use crate::vector::dot;
use torse_algebra::{Jet, Scalar};

/// What part of each ruling belongs to a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PatchBounds<S> {
    /// A fixed range of the ruling parameter `x1` in `x1 phi + psi` (gbt-developable eq. (3.7)). The
    /// direction `phi = a x a'` is not normalised, so the width varies with its length.
    Range([S; 2]),
    /// The part between two planes.
    Planes([Plane<S>; 2]),
}

/// The patch of an enveloping developable within bounds (gbt-developable Sect. 3.2). It is developable
/// by construction: the plane `H(x)` touches it along the whole ruling of `x`.
///
/// ```
/// use torse_geometry::{PatchBounds, EnvelopingPatch, Gbt, PlaneFamily, Surface};
/// // gbt-developable Example 4.2, corrected: as printed Q2 = Q1 and Q3 = Q0, so that all planes pass
/// // through one line. Four different sign patterns give a surface.
/// let h = 5.0 * 2_f64.sqrt();
/// let planes = vec![[h, -h, 5.0, 125.0], [-h, -h, 5.0, 125.0], [-h, h, 5.0, 125.0], [h, h, 5.0, 125.0]];
/// let family = PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?;
/// let patch = EnvelopingPatch::new(family, PatchBounds::Planes([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 5.0]]))?;
/// let (bottom, top) = (patch.point(&0.3, &0.0)?, patch.point(&0.3, &1.0)?);
/// assert!(bottom[2].abs() < 1e-12 && (top[2] - 5.0).abs() < 1e-12);
/// // The plane of the family touches along the ruling.
/// let plane = patch.family().plane(&0.3)?;
/// let normal = patch.partials(&0.3, &0.7, 1)?.normal();
/// assert!((plane[0] * normal[1] - plane[1] * normal[0]).abs() < 1e-9 * plane[0].abs() * normal[0].abs());
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EnvelopingPatch<B, S> {
    family: PlaneFamily<B, S>,
    bounds: PatchBounds<S>,
}

impl<S: Coordinate, B: Basis<S>> EnvelopingPatch<B, S> {
    /// The patch of the developable enveloped by `family` within `bounds`.
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`], [`GeometryError::Degenerate`] for an empty range or a cutting
    /// plane without normal. A ruling parallel to a cutting plane shows when it is evaluated, as
    /// [`GeometryError::RulingParallelToPlane`] with its parameter.
    ///
    /// ```
    /// use torse_geometry::{PatchBounds, EnvelopingPatch, Gbt, GeometryError, PlaneFamily, Surface};
    /// let planes = vec![[0.0, -20.0, 10.0, 400.0], [0.0, -10.0, 20.0, 400.0], [0.0, 10.0, 20.0, 400.0]];
    /// let family = PlaneFamily::new(Gbt::new(0.0, 0.0)?, planes)?;
    /// // All rulings run along x and never meet z = 0.
    /// let flat = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 1.0, 9.0]];
    /// let patch = EnvelopingPatch::new(family, PatchBounds::Planes(flat))?;
    /// assert_eq!(
    ///     patch.point(&0.5, &0.0).unwrap_err(),
    ///     GeometryError::RulingParallelToPlane { parameter: 0.5 },
    /// );
    /// # Ok::<(), GeometryError>(())
    /// ```
    pub fn new(family: PlaneFamily<B, S>, bounds: PatchBounds<S>) -> Result<Self> {
        match &bounds {
            PatchBounds::Range([from, to]) => {
                check_finite("ruling range", [from, to])?;
                if is_zero(&(to.clone() - from.clone())) {
                    return Err(GeometryError::Degenerate {
                        what: "ruling range",
                        at: Place::Parameter(from.approximate()),
                    });
                }
            }
            PatchBounds::Planes(planes) => {
                check_finite("cutting plane", planes.iter().flatten())?;
                for (index, plane) in planes.iter().enumerate() {
                    if normal_of(plane).iter().all(is_zero) {
                        let what = "normal of a cutting plane";
                        return Err(GeometryError::Degenerate {
                            what,
                            at: Place::Index(index),
                        });
                    }
                }
            }
        }
        Ok(Self { family, bounds })
    }

    /// The plane family.
    #[must_use]
    pub fn family(&self) -> &PlaneFamily<B, S> {
        &self.family
    }

    /// The bounds of the rulings.
    #[must_use]
    pub fn bounds(&self) -> &PatchBounds<S> {
        &self.bounds
    }

    /// The range in units of the direction that the scaled family gives.
    fn unit_range(&self, range: &[S; 2]) -> [S; 2] {
        let (_, exponent) = self.family.unit_curve();
        range.each_ref().map(|x1| x1.times_two_to(2 * exponent))
    }
}

/// The same plane with a normal of the size of one.
pub(crate) fn unit_plane<S: Coordinate>(plane: &Plane<S>) -> Plane<S> {
    let exponent = exponent_of(plane).unwrap_or(0);
    plane.each_ref().map(|c| c.times_two_to(-exponent))
}

impl<S: Coordinate, B: Basis<S>> EnvelopingPatch<B, S> {
    /// The ends of a ruling of the scaled family: points, or their series.
    fn ends_of<T: Coordinate>(
        &self,
        ruling: &Ruling<T>,
        x: &S,
        lift: impl Fn(&S) -> T,
    ) -> Result<[[T; 3]; 2]> {
        let bounds = match &self.bounds {
            PatchBounds::Range(range) => self.unit_range(range).each_ref().map(lift),
            PatchBounds::Planes([first, second]) => {
                let at = |plane| ruling.meets(&unit_plane(plane).each_ref().map(&lift), &lift(x));
                [at(first)?, at(second)?]
            }
        };
        let ends = bounds.map(|x1| ruling.point(&x1));
        finite("end of a ruling", ends.iter().flatten(), x)?;
        Ok(ends)
    }
}

impl<S: Coordinate, B: Basis<S>> Rails<S> for EnvelopingPatch<B, S> {
    fn rail_jets(&self, x: &S, order: usize) -> Result<[[Jet<S>; 3]; 2]> {
        let ruling = self.family.unit_ruling_jet(x, order)?;
        self.ends_of(&ruling, x, |value| {
            ruling.foot[0].constant_like(value.clone())
        })
    }

    fn ruling_ends(&self, x: &S) -> Result<[[S; 3]; 2]> {
        self.ends_of(&self.family.unit_ruling(x)?, x, S::clone)
    }

    fn ends_and_slopes(&self, x: &S) -> Result<[[[S; 3]; 2]; 2]> {
        if x.centred().is_some() {
            let [p, q] = self.rail_jets(x, 1)?;
            return Ok([first_two(&p)?, first_two(&q)?]);
        }
        let ruling = self.family.unit_ruling_and_slope(x)?;
        let ends = self.ends_of(&ruling, x, |value| Dual::constant_of(value.clone()))?;
        Ok(ends.map(Dual::split))
    }

    /// The plane `H(x)` touches along the ruling of `x`.
    fn is_developable_by_construction(&self) -> bool {
        true
    }
}

impl<S: Coordinate, B: Basis<S>> Surface<S> for EnvelopingPatch<B, S> {
    fn partials(&self, u: &S, v: &S, order: usize) -> Result<Partials<S>> {
        partials_between(self, u, v, order)
    }
}

/// The part `S(x) + x2 S'(x)` of the tangent surface of the edge of regression with `x2` in a range
/// (gbt-developable eq. (3.10)): the same developable as the enveloping one, seen from its spine curve.
///
/// ```
/// use torse_geometry::{Gbt, PlaneFamily, Surface, TangentPatch};
/// // gbt-developable Sect. 4.2; Q2 is printed "(-10, -10, 10 sqrt 2400)" without its comma.
/// let r = 2_f64.sqrt();
/// let planes = vec![
///     [6.5, 6.5, 6.5 * r, 169.0], [-5.5, 7.5, 7.5 * r, 225.0],
///     [-10.0, -10.0, 10.0 * r, 400.0], [12.5, -12.5, 12.5 * r, 625.0],
/// ];
/// let family = PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?;
/// let patch = TangentPatch::new(family, [0.0, 1.0])?;
/// let spine = patch.point(&0.4, &0.0)?;
/// // The plane, its derivative and its second derivative all contain the spine point.
/// for [p, q, r, s] in patch.family().curve().derivatives(&0.4, 2)? {
///     let height = p * spine[0] + q * spine[1] + r * spine[2] - s;
///     assert!(height.abs() < 1e-9 * s.abs().max(1e3));
/// }
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct TangentPatch<B, S> {
    family: PlaneFamily<B, S>,
    range: [S; 2],
}

impl<S: Coordinate, B: Basis<S>> TangentPatch<B, S> {
    /// The patch with `x2` from `range[0]` (at `v = 0`) to `range[1]` (at `v = 1`). The surface is
    /// singular at `x2 = 0`, on the edge of regression itself.
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`], [`GeometryError::Degenerate`] for an empty range.
    pub fn new(family: PlaneFamily<B, S>, range: [S; 2]) -> Result<Self> {
        check_finite("ruling range", &range)?;
        let [from, to] = &range;
        if is_zero(&(to.clone() - from.clone())) {
            return Err(GeometryError::Degenerate {
                what: "ruling range",
                at: Place::Parameter(from.approximate()),
            });
        }
        Ok(Self { family, range })
    }

    /// The plane family.
    #[must_use]
    pub fn family(&self) -> &PlaneFamily<B, S> {
        &self.family
    }

    /// The range of `x2`.
    #[must_use]
    pub fn range(&self) -> &[S; 2] {
        &self.range
    }
}

impl<S: Coordinate, B: Basis<S>> Rails<S> for TangentPatch<B, S> {
    fn rail_jets(&self, x: &S, order: usize) -> Result<[[Jet<S>; 3]; 2]> {
        let no_point = || GeometryError::NoCharacteristicPoint {
            parameter: x.approximate(),
        };
        let spine = self.family.characteristic_jet(x, order.saturating_add(1))?;
        let [a, b, c] = spine.each_ref().map(Jet::differentiated);
        let (Some(a), Some(b), Some(c)) = (a, b, c) else {
            return Err(no_point());
        };
        let tangent = [a, b, c];
        let rails = self.range.each_ref().map(|x2| {
            let x2 = tangent[0].constant_like(x2.clone());
            std::array::from_fn(|axis| spine[axis].clone() + x2.clone() * tangent[axis].clone())
        });
        finite("rail", rails.iter().flatten(), x)?;
        Ok(rails)
    }

    /// The osculating plane of the spine curve touches along its tangent.
    fn is_developable_by_construction(&self) -> bool {
        true
    }
}

impl<S: Coordinate, B: Basis<S>> Surface<S> for TangentPatch<B, S> {
    fn partials(&self, u: &S, v: &S, order: usize) -> Result<Partials<S>> {
        partials_between(self, u, v, order)
    }
}

/// The signed distance function of a plane times the length of its normal, at a point.
#[must_use]
pub(crate) fn height<S: Scalar>(plane: &Plane<S>, point: &[S; 3]) -> S {
    dot(&normal_of(plane), point) - plane[3].clone()
}
