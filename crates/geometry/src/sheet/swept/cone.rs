//! Cones.

use super::factor::{Factor, SweptEdge, control, image};
use crate::coordinate::Coordinate;
use crate::curve::{AffineMap, EllipticHelix, RationalCurve, SpaceCurve};
use crate::error::{GeometryError, Place, Result};
use crate::over::Over;
use crate::sheet::{Point, Rail, RailCurve};
use crate::surface::{EndKinds, RailKind, Rails};
use crate::vector::{add, dot, scale, sub};
use torse_algebra::{Jet, Scalar};

/// A part of a cone: straight lines through its apex and a curve.
///
/// ```
/// use torse_geometry::prelude::*;
/// let rim = Rail::ellipse_arc([0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0])?;
/// let sheet = Sheet::cone(&rim, [0.0, 0.0, 4.0], [SweptEdge::Share(1.0), SweptEdge::Share(0.0)])?;
/// // Up to its apex, which is one point and does not move.
/// let [_, [apex, speed]] = torse_geometry::Rails::<f64>::ends_and_slopes(&sheet, &0.3)?;
/// assert_eq!((apex, speed), ([0.0, 0.0, 4.0], [0.0; 3]));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ConePatch<S> {
    curve: Rail<S>,
    apex: [S; 3],
    /// Of the distance from the apex: a constant, or the reciprocal of a function.
    ratios: [Factor<S>; 2],
}

impl ConePatch<f64> {
    /// Returns the part between two edges.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] for a plane through the apex, [`GeometryError::BehindApex`] where a plane cuts on
    /// the other side of it, [`GeometryError::NotFinite`].
    pub fn new(curve: &Rail, apex: Point, edges: [SweptEdge; 2]) -> Result<Self> {
        crate::coordinate::check_finite("apex of a cone", &apex)?;
        let points = control(curve);
        let ratio = |edge: &SweptEdge| -> Result<Factor<f64>> {
            let [p, q, r, e] = match edge {
                SweptEdge::Share(share) => {
                    crate::coordinate::check_finite("edge of a cone", [share])?;
                    return Ok(Factor::Constant(*share));
                }
                SweptEdge::Cut(plane) => *plane,
            };
            if let RailCurve::Elliptic(_) = curve.curve() {
                return Err(GeometryError::Degenerate {
                    what: "a plane that cuts a cone over an arc of any angle: quarters of an ellipse (`arc` with `to`) are cut",
                    at: Place::Whole,
                });
            }
            let normal = [p, q, r];
            let reach = e - dot(&normal, &apex);
            if reach == 0.0 {
                return Err(GeometryError::Degenerate {
                    what: "a cone cut by a plane through its apex",
                    at: Place::Whole,
                });
            }
            let values = points.iter().map(|b| dot(&normal, &sub(b, &apex)) / reach);
            let values: Vec<f64> = values.collect();
            if let Some(index) = values.iter().position(|v| v.is_nan() || *v <= 0.0) {
                let what = "control point";
                return Err(GeometryError::BehindApex { what, index });
            }
            match Factor::from_values(curve, values)? {
                Factor::Constant(value) => Ok(Factor::Constant(1.0 / value)),
                varying => Ok(varying),
            }
        };
        let [first, second] = edges.each_ref().map(ratio);
        Ok(Self {
            curve: curve.clone(),
            apex,
            ratios: [first?, second?],
        })
    }

    /// Returns both edges as curves of their own, with rounded control points.
    ///
    /// # Errors
    /// As [`Rail::new`].
    pub fn rails(&self) -> Result<[Rail; 2]> {
        let points = control(&self.curve);
        let rail = |ratio: &Factor<f64>| {
            if let (RailCurve::Elliptic(arc), Factor::Constant(share)) = (self.curve.curve(), ratio)
            {
                let [x, y, z] = [0, 1, 2].map(|axis| {
                    std::array::from_fn(|other| if axis == other { *share } else { 0.0 })
                });
                let shift = scale(&(1.0 - share), &self.apex);
                let linear = [x, y, z];
                return finite(arc.mapped(&AffineMap { linear, shift }));
            }
            let values = ratio.values(points.len());
            let constant = matches!(ratio, Factor::Constant(_));
            let pairs = points.iter().zip(&values);
            let moved: Vec<Point> = pairs
                .map(|(p, value)| {
                    let share = if constant { *value } else { 1.0 / value };
                    add(&self.apex, &scale(&share, &sub(p, &self.apex)))
                })
                .collect();
            image(
                &self.curve,
                &moved,
                (!constant).then_some(values.as_slice()),
            )
        };
        let [first, second] = &self.ratios;
        Ok([rail(first)?, rail(second)?])
    }

    /// Returns the kinds of its ends.
    #[must_use]
    pub fn end_kinds(&self) -> EndKinds {
        let kinds = self.ratios.each_ref().map(|ratio| match ratio {
            Factor::Constant(0.0) => RailKind::Point,
            _ => self.curve.end_kinds(),
        });
        let share = |ratio: &Factor<f64>, end: usize| match ratio {
            Factor::Constant(value) => *value,
            varying => 1.0 / varying.ends()[end],
        };
        let [first, second] = &self.ratios;
        let tips = [0, 1].map(|end| share(first, end) == share(second, end));
        EndKinds::new(kinds, tips)
    }

    /// Returns the half that is farther from the apex, of a cone that reaches it.
    #[must_use]
    pub fn away_from_apex(&self) -> Self {
        let half = |ratio: &Factor<f64>, other: &Factor<f64>| match (ratio, other) {
            (Factor::Constant(0.0), Factor::Constant(value)) => Factor::Constant(0.5 * value),
            // Of reciprocals the double.
            (Factor::Constant(0.0), Factor::Varying(curve)) => {
                Factor::Varying(curve.mapped(|[g]| [2.0 * g]))
            }
            (Factor::Constant(0.0), Factor::Weighted(curve)) => {
                let weights: Vec<f64> = curve.homogeneous().map(|(_, w)| *w).collect();
                let points: Vec<[f64; 1]> =
                    curve.homogeneous().map(|([g], w)| [2.0 * g / w]).collect();
                let doubled = RationalCurve::new(*curve.basis(), &points, weights);
                doubled.map_or_else(|_| ratio.clone(), Factor::Weighted)
            }
            _ => ratio.clone(),
        };
        let [first, second] = &self.ratios;
        Self {
            ratios: [half(first, second), half(second, first)],
            ..self.clone()
        }
    }

    /// Returns the same cone over a moved curve, about a moved apex.
    pub(in crate::sheet) fn moved(&self, rail: Rail, apex: Point) -> Self {
        Self {
            curve: rail,
            apex,
            ratios: self.ratios.clone(),
        }
    }

    pub(in crate::sheet) fn curve(&self) -> &Rail {
        &self.curve
    }

    /// Returns the apex.
    #[must_use]
    pub fn apex(&self) -> Point {
        self.apex
    }
}

impl<S: Coordinate> Rails<S> for ConePatch<S> {
    fn rail_jets(&self, x: &S, order: usize) -> Result<[[Jet<S>; 3]; 2]> {
        let curve = self.curve.space_jet(x, order)?;
        let rail = |ratio: &Factor<S>| -> Result<[Jet<S>; 3]> {
            let factor = ratio.jet(x, order)?;
            let share = match ratio {
                Factor::Constant(_) => factor,
                _ => factor.constant_like(x.one()).divided_by(&factor)?,
            };
            Ok(std::array::from_fn(|axis| {
                let apex = share.constant_like(self.apex[axis].clone());
                let arm: Jet<S> = curve[axis].clone() - apex.clone();
                apex + share.clone() * arm
            }))
        };
        let [first, second] = &self.ratios;
        Ok([rail(first)?, rail(second)?])
    }

    fn ends_and_slopes(&self, x: &S) -> Result<[[[S; 3]; 2]; 2]> {
        let [point, slope] = self.curve.point_and_slope(x)?;
        let arm = sub(&point, &self.apex);
        let rail = |ratio: &Factor<S>| -> Result<[[S; 3]; 2]> {
            let [value, rate] = ratio.value_and_slope(x)?;
            let [share, change] = match ratio {
                Factor::Constant(_) => [value, rate],
                _ => {
                    let share = x.one().divided_by(&value)?;
                    let change = -(rate * share.clone() * share.clone());
                    [share, change]
                }
            };
            Ok([
                add(&self.apex, &scale(&share, &arm)),
                add(&scale(&share, &slope), &scale(&change, &arm)),
            ])
        };
        let [first, second] = &self.ratios;
        Ok([rail(first)?, rail(second)?])
    }

    fn is_developable_by_construction(&self) -> bool {
        true
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for ConePatch<S> {
    type Object = ConePatch<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<ConePatch<T>> {
        let [first, second] = &self.ratios;
        Ok(ConePatch {
            curve: self.curve.over(convert)?,
            apex: self.apex.each_ref().map(convert),
            ratios: [first.over(convert)?, second.over(convert)?],
        })
    }
}

/// Returns an arc whose numbers are finite, as a rail.
fn finite(arc: EllipticHelix<f64>) -> Result<Rail> {
    let [cosine, sine] = arc.axes();
    let [centre, rise] = [arc.centre(), arc.rise()];
    EllipticHelix::new(*centre, *cosine, *sine, *rise, *arc.range()).map(Rail::from)
}
