//! Cylinders.

use super::factor::{Factor, SweptEdge, control, image};
use crate::coordinate::Coordinate;
use crate::curve::{EllipticHelix, SpaceCurve};
use crate::error::{GeometryError, Place, Result};
use crate::over::Over;
use crate::sheet::{Point, Rail, RailCurve};
use crate::surface::{EndKinds, Rails};
use crate::vector::{add, dot, scale};
use torse_algebra::Jet;

/// A part of a cylinder: straight lines in one direction through a curve.
///
/// ```
/// use torse_geometry::prelude::*;
/// let rim = Rail::ellipse_arc([0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0])?;
/// let edges = [SweptEdge::Share(0.0), SweptEdge::Cut([0.5, 0.0, 1.0, 3.0])];
/// let sheet = Sheet::cylinder(&rim, [0.0, 0.0, 1.0], edges)?;
/// let [bottom, top] = sheet.ruling(0.0)?;
/// assert_eq!((bottom, top), ([2.0, 0.0, 0.0], [2.0, 0.0, 2.0]));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CylinderPatch<S> {
    curve: Rail<S>,
    direction: [S; 3],
    heights: [Factor<S>; 2],
}

impl CylinderPatch<f64> {
    /// Returns the part between two edges.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] for a direction of no length and for a plane along it,
    /// [`GeometryError::NotFinite`].
    pub fn new(curve: &Rail, direction: Point, edges: [SweptEdge; 2]) -> Result<Self> {
        crate::coordinate::check_finite("direction of a cylinder", &direction)?;
        let length = crate::vector::norm(&direction);
        if length == 0.0 {
            return Err(GeometryError::Degenerate {
                what: "a cylinder whose direction has no length",
                at: Place::Whole,
            });
        }
        let points = control(curve);
        let steepness = |normal: &Point| {
            let slope = dot(normal, &direction);
            let along = GeometryError::Degenerate {
                what: "a cylinder cut by a plane along its rulings",
                at: Place::Whole,
            };
            if slope == 0.0 { Err(along) } else { Ok(slope) }
        };
        if let RailCurve::Elliptic(arc) = curve.curve() {
            let height = |edge: &SweptEdge| match edge {
                SweptEdge::Share(share) => {
                    crate::coordinate::check_finite("edge of a cylinder", [share])?;
                    Ok(Factor::Constant(*share))
                }
                SweptEdge::Cut([p, q, r, e]) => {
                    let normal = [*p, *q, *r];
                    Factor::from_arc(arc, &normal, [*e, steepness(&normal)?])
                }
            };
            let [first, second] = edges.each_ref().map(height);
            return Ok(Self {
                curve: curve.clone(),
                direction,
                heights: [first?, second?],
            });
        }
        let values = |edge: &SweptEdge| -> Result<Vec<f64>> {
            match edge {
                SweptEdge::Share(share) => Ok(vec![*share; points.len()]),
                SweptEdge::Cut([p, q, r, e]) => {
                    let normal = [*p, *q, *r];
                    let slope = steepness(&normal)?;
                    Ok(points
                        .iter()
                        .map(|b| (e - dot(&normal, b)) / slope)
                        .collect())
                }
            }
        };
        let [first, second] = edges.each_ref().map(values);
        let [first, second] = meeting(curve, [first?, second?], length);
        Ok(Self {
            curve: curve.clone(),
            direction,
            heights: [
                Factor::from_values(curve, first)?,
                Factor::from_values(curve, second)?,
            ],
        })
    }

    /// Returns the direction of the rulings, of any length.
    #[must_use]
    pub fn direction(&self) -> Point {
        self.direction
    }

    /// Returns both edges as curves of their own, with rounded control points.
    ///
    /// # Errors
    /// As [`Rail::new`].
    pub fn rails(&self) -> Result<[Rail; 2]> {
        let points = control(&self.curve);
        let rail = |heights: &Factor<f64>| {
            if let RailCurve::Elliptic(arc) = self.curve.curve() {
                return risen(arc, heights, &self.direction);
            }
            let values = heights.values(points.len());
            let pairs = points.iter().zip(&values);
            let moved: Vec<Point> = pairs
                .map(|(p, h)| add(p, &scale(h, &self.direction)))
                .collect();
            image(&self.curve, &moved, None)
        };
        let [first, second] = &self.heights;
        Ok([rail(first)?, rail(second)?])
    }

    /// Returns the kinds of its ends.
    #[must_use]
    pub fn end_kinds(&self) -> EndKinds {
        let kinds = self.curve.end_kinds();
        let [first, second] = self.heights.each_ref().map(Factor::ends);
        let tips = [first[0] == second[0], first[1] == second[1]];
        EndKinds::new([kinds, kinds], tips)
    }

    /// Returns the same cylinder over a moved curve.
    pub(in crate::sheet) fn moved(&self, rail: Rail) -> Self {
        Self {
            curve: rail,
            ..self.clone()
        }
    }

    pub(in crate::sheet) fn curve(&self) -> &Rail {
        &self.curve
    }
}

impl<S: Coordinate> Rails<S> for CylinderPatch<S> {
    fn rail_jets(&self, x: &S, order: usize) -> Result<[[Jet<S>; 3]; 2]> {
        let curve = self.curve.space_jet(x, order)?;
        let rail = |height: &Factor<S>| -> Result<[Jet<S>; 3]> {
            let height = height.jet(x, order)?;
            Ok(std::array::from_fn(|axis| {
                let direction = height.constant_like(self.direction[axis].clone());
                curve[axis].clone() + height.clone() * direction
            }))
        };
        let [first, second] = &self.heights;
        Ok([rail(first)?, rail(second)?])
    }

    fn ends_and_slopes(&self, x: &S) -> Result<[[[S; 3]; 2]; 2]> {
        let [point, slope] = self.curve.point_and_slope(x)?;
        let rail = |height: &Factor<S>| -> Result<[[S; 3]; 2]> {
            let [value, rate] = height.value_and_slope(x)?;
            Ok([
                add(&point, &scale(&value, &self.direction)),
                add(&slope, &scale(&rate, &self.direction)),
            ])
        };
        let [first, second] = &self.heights;
        Ok([rail(first)?, rail(second)?])
    }

    fn is_developable_by_construction(&self) -> bool {
        true
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for CylinderPatch<S> {
    type Object = CylinderPatch<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<CylinderPatch<T>> {
        let [first, second] = &self.heights;
        Ok(CylinderPatch {
            curve: self.curve.over(convert)?,
            direction: self.direction.each_ref().map(convert),
            heights: [first.over(convert)?, second.over(convert)?],
        })
    }
}

/// Ends of rulings that are nearer to one another than this share of the patch are one point, up to the rounding of the
/// planes that cut them.
const MEET: f64 = 1e-13;

/// Edges whose planes meet the same point of the curve but for rounding are made to meet there.
fn meeting(rail: &Rail, mut values: [Vec<f64>; 2], unit: f64) -> [Vec<f64>; 2] {
    let points = control(rail);
    let reach = |list: &[f64]| list.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let far = points.iter().flatten().fold(0.0_f64, |m, c| m.max(c.abs()));
    let size = far + unit * reach(&values[0]).max(reach(&values[1]));
    let [first, second] = &mut values;
    let last = first.len().saturating_sub(1);
    for k in [0, last] {
        if let (Some(a), Some(b)) = (first.get(k), second.get_mut(k))
            && (*a - *b).abs() * unit <= MEET * size
        {
            *b = *a;
        }
    }
    values
}

/// Returns the image of an arc on a cylinder.
fn risen(arc: &EllipticHelix<f64>, heights: &Factor<f64>, direction: &Point) -> Result<Rail> {
    let [h, c, s, r] = match heights {
        Factor::Elliptic(heights) => {
            let [cosine, sine] = heights.axes();
            [heights.centre()[0], cosine[0], sine[0], heights.rise()[0]]
        }
        Factor::Constant(height) => [*height, 0.0, 0.0, 0.0],
        Factor::Varying(_) | Factor::Weighted(_) => [f64::NAN; 4],
    };
    let moved = |v: &Point, by: f64| add(v, &scale(&by, direction));
    let [cosine, sine] = arc.axes();
    let (centre, rise) = (moved(arc.centre(), h), moved(arc.rise(), r));
    EllipticHelix::new(centre, moved(cosine, c), moved(sine, s), rise, *arc.range()).map(Rail::from)
}
