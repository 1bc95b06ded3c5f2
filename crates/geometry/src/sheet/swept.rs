//! Cylinders and cones over any curve: developable by the way they are made.
//!
//! Points of a cylinder are `c(x) + h d`, those of a cone `o + s (c(x) - o)`, and an edge says which `h(x)` or `s(x)` it
//! has: a constant, or where a plane cuts. A plane `n . X = e` gives `h = (e - n . c)/(n . d)`, which is affine in `c`, and
//! `1/s = n . (c - o)/(e - n . o)`: since the functions of a basis sum to one, both are curves in the basis of `c`, with the
//! weights of `c`, and their control values are those of its control points. They are computed on f64 and are the
//! definition from then on: what is kept exactly is that all rulings run along `d`, or through `o`. Of an arc of an ellipse
//! or a helix, which have no control points, `h(x)` is the same combination of sine, cosine and angle.

use super::{Point, Rail, RailCurve};
use crate::basis::Shape;
use crate::coordinate::Coordinate;
use crate::curve::{Affine, Curve, EllipticHelix, RationalCurve, SpaceCurve};
use crate::error::{GeometryError, Place, Result};
use crate::over::Over;
use crate::planes::Plane;
use crate::surface::{EndKinds, RailKind, Rails};
use crate::vector::{add, dot, scale, sub};
use torse_algebra::{Jet, Scalar};

/// Where the rulings of a cylinder or cone end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SweptEdge {
    /// At this multiple of the direction from the curve; at this ratio of the distance from the apex, 1 on the curve.
    Share(f64),
    /// On this plane.
    Cut(Plane<f64>),
}

/// What an edge multiplies by.
#[derive(Debug, Clone, PartialEq)]
enum Factor<S> {
    /// The same for all rulings.
    Constant(S),
    /// A function in the basis of the curve.
    Varying(Curve<Shape<S>, S, 1>),
    /// The same with the weights of the curve.
    Weighted(RationalCurve<Shape<S>, S, 1>),
    /// The first coordinate of an arc with the angles of the curve.
    Elliptic(EllipticHelix<S>),
}

impl<S: Coordinate> Factor<S> {
    fn jet(&self, x: &S, order: usize) -> Result<Jet<S>> {
        match self {
            Self::Constant(value) => Ok(Jet::of_constant(value.clone(), order)),
            Self::Varying(curve) => curve.jet(x, order).map(|[jet]| jet),
            Self::Weighted(curve) => curve.jet(x, order).map(|[jet]| jet),
            Self::Elliptic(curve) => curve.space_jet(x, order).map(|[jet, _, _]| jet),
        }
    }
}

impl<S: Coordinate> Factor<S> {
    fn value_and_slope(&self, x: &S) -> Result<[S; 2]> {
        let both = match self {
            Self::Constant(value) => return Ok([value.clone(), value.zero()]),
            Self::Varying(curve) => curve.point_and_slope(x)?,
            Self::Weighted(curve) => curve.point_and_slope(x)?,
            Self::Elliptic(curve) => {
                return Ok(curve.point_and_slope(x)?.map(|[value, _, _]| value));
            }
        };
        Ok(both.map(|[value]| value))
    }
}

impl<S: Coordinate, T: Coordinate> Over<S, T> for Factor<S> {
    type Object = Factor<T>;

    fn over(&self, convert: &impl Fn(&S) -> T) -> Result<Factor<T>> {
        Ok(match self {
            Self::Constant(value) => Factor::Constant(convert(value)),
            Self::Varying(curve) => Factor::Varying(curve.over(convert)?),
            Self::Weighted(curve) => Factor::Weighted(curve.over(convert)?),
            Self::Elliptic(curve) => Factor::Elliptic(curve.over(convert)?),
        })
    }
}

impl Factor<f64> {
    /// The function with these values at the control points.
    fn of(rail: &Rail, values: Vec<f64>) -> Result<Self> {
        match (values.first(), rail.curve()) {
            (Some(first), _) if values.iter().all(|value| value == first) => {
                Ok(Self::Constant(*first))
            }
            (_, RailCurve::Plain(curve)) => {
                let points = values.into_iter().map(|value| [value]).collect();
                Curve::new(*curve.basis(), points).map(Self::Varying)
            }
            (_, RailCurve::Weighted(curve)) => {
                let weights: Vec<f64> = curve.homogeneous().map(|(_, w)| *w).collect();
                let points: Vec<[f64; 1]> = values.into_iter().map(|value| [value]).collect();
                RationalCurve::new(*curve.basis(), &points, weights).map(Self::Weighted)
            }
            (_, RailCurve::Elliptic(_)) => Err(GeometryError::NoValue {
                what: "control points of an arc of an ellipse",
                at: Place::Whole,
            }),
        }
    }

    /// The function `(level - normal . c)/slope` of an arc.
    fn of_arc(arc: &EllipticHelix<f64>, normal: &Point, [level, slope]: [f64; 2]) -> Result<Self> {
        let part = |v: &Point| [-dot(normal, v) / slope, 0.0, 0.0];
        let [cosine, sine] = arc.axes();
        let start = [(level - dot(normal, arc.centre())) / slope, 0.0, 0.0];
        let moving = [cosine, sine, arc.rise()].map(part);
        if moving.iter().flatten().all(|c| *c == 0.0) {
            crate::coordinate::check_finite("edge of a cylinder", &start)?;
            return Ok(Self::Constant(start[0]));
        }
        let [cosine, sine, rise] = moving;
        EllipticHelix::new(start, cosine, sine, rise, *arc.range()).map(Self::Elliptic)
    }

    /// The values at the first and the last control point, which are those at the ends; not a number of an arc, whose ends
    /// are computed and equal nothing.
    fn ends(&self) -> [f64; 2] {
        let both = |values: Vec<f64>| {
            [values.first(), values.last()].map(|value| value.copied().unwrap_or(f64::NAN))
        };
        both(self.values(1))
    }

    /// The values at the control points, of which there are so many.
    fn values(&self, count: usize) -> Vec<f64> {
        match self {
            Self::Constant(value) => vec![*value; count],
            Self::Varying(curve) => curve.points().iter().map(|[value]| *value).collect(),
            Self::Weighted(curve) => curve.homogeneous().map(|([p], w)| p / w).collect(),
            Self::Elliptic(_) => vec![f64::NAN; count],
        }
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

/// The control points of a rail; an arc of an ellipse has none.
fn control(rail: &Rail) -> Vec<Point> {
    match rail.curve() {
        RailCurve::Elliptic(_) => Vec::new(),
        RailCurve::Plain(curve) => curve.points().to_vec(),
        RailCurve::Weighted(curve) => {
            let parts = curve.homogeneous();
            parts.map(|(p, w)| p.map(|c| c / w)).collect()
        }
    }
}

/// The rail with other control points and with factors of its weights.
fn image(rail: &Rail, points: &[Point], factors: Option<&[f64]>) -> Result<Rail> {
    let (shape, own): (_, Vec<f64>) = match rail.curve() {
        RailCurve::Plain(curve) => (*curve.basis(), vec![1.0; points.len()]),
        RailCurve::Weighted(curve) => (
            *curve.basis(),
            curve.homogeneous().map(|(_, w)| *w).collect(),
        ),
        RailCurve::Elliptic(_) => {
            return Err(GeometryError::NoValue {
                what: "control points of an arc of an ellipse",
                at: Place::Whole,
            });
        }
    };
    let weights: Vec<f64> = match factors {
        None => own,
        Some(factors) => own.iter().zip(factors).map(|(w, f)| w * f).collect(),
    };
    // Equal weights are none.
    match weights.first() {
        Some(first) if weights.iter().any(|w| w != first) => {
            Rail::weighted(shape, points, &weights)
        }
        _ => Rail::new(shape, points),
    }
}

/// An arc whose numbers are finite, as a rail.
fn finite(arc: EllipticHelix<f64>) -> Result<Rail> {
    let [cosine, sine] = arc.axes();
    let [centre, rise] = [arc.centre(), arc.rise()];
    EllipticHelix::new(*centre, *cosine, *sine, *rise, *arc.range()).map(Rail::from)
}

/// The image of an arc on a cylinder.
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
    /// The part between two edges.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] for a direction of no length and for a plane along it, [`GeometryError::NotFinite`].
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
                    Factor::of_arc(arc, &normal, [*e, steepness(&normal)?])
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
            heights: [Factor::of(curve, first)?, Factor::of(curve, second)?],
        })
    }

    /// Both edges as curves of their own, with rounded control points.
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

    /// The kinds of its ends.
    #[must_use]
    pub fn end_kinds(&self) -> EndKinds {
        let kinds = self.curve.end_kinds();
        let [first, second] = self.heights.each_ref().map(Factor::ends);
        let tips = [first[0] == second[0], first[1] == second[1]];
        EndKinds::of([kinds, kinds], tips)
    }

    /// The same cylinder moved by the vector from `origin` to zero.
    pub(super) fn moved(&self, rail: Rail) -> Self {
        Self {
            curve: rail,
            ..self.clone()
        }
    }

    pub(super) fn curve(&self) -> &Rail {
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

/// A part of a cone: straight lines through its apex and a curve.
///
/// ```
/// use torse_geometry::prelude::*;
/// let rim = Rail::ellipse_arc([0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0])?;
/// let sheet = Sheet::swept_cone(&rim, [0.0, 0.0, 4.0], [SweptEdge::Share(1.0), SweptEdge::Share(0.0)])?;
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
    /// The part between two edges.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] for a plane through the apex, [`GeometryError::BehindApex`] where a plane cuts on the
    /// other side of it, [`GeometryError::NotFinite`].
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
            match Factor::of(curve, values)? {
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

    /// Both edges as curves of their own, with rounded control points.
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
                return finite(arc.mapped(&Affine { linear, shift }));
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

    /// The kinds of its ends.
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
        EndKinds::of(kinds, tips)
    }

    /// The half that is farther from the apex, of a cone that reaches it.
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

    /// The same cone over a moved curve, about a moved apex.
    pub(super) fn moved(&self, rail: Rail, apex: Point) -> Self {
        Self {
            curve: rail,
            apex,
            ratios: self.ratios.clone(),
        }
    }

    pub(super) fn curve(&self) -> &Rail {
        &self.curve
    }

    /// The apex.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::prelude::Sheet;
    use crate::vector::cross;

    fn helix() -> Rail {
        let (a, b, rise) = ([3.0, 0.0, 0.0], [0.0, 2.0, 0.5], [0.0, 0.0, 0.25]);
        Rail::from(EllipticHelix::new([1.0, 0.0, 0.0], a, b, rise, [0.0, 2.5]).unwrap())
    }

    #[test]
    fn a_cylinder_over_a_helix_ends_on_its_plane_and_runs_along_its_direction() {
        let (direction, plane) = ([0.0, 1.0, 2.0], [0.3, 0.0, 1.0, 40.0]);
        let edges = [SweptEdge::Share(0.0), SweptEdge::Cut(plane)];
        let patch = CylinderPatch::new(&helix(), direction, edges).unwrap();
        let [first, second] = patch.rails().unwrap();
        for k in 0..=8 {
            let x = f64::from(k) / 8.0;
            let [[p, dp], [q, dq]] = patch.ends_and_slopes(&x).unwrap();
            assert_eq!(p, helix().point(x).unwrap());
            assert!((0.3 * q[0] + q[2] - 40.0).abs() < 1e-13);
            assert!((0.3 * dq[0] + dq[2]).abs() < 1e-13);
            let off = cross(&sub(&q, &p), &direction);
            assert!(off.iter().all(|c| c.abs() < 1e-12), "{off:?}");
            let jets = patch.rail_jets(&x, 1).unwrap();
            for (jets, slope) in jets.iter().zip([dp, dq]) {
                for (jet, slope) in jets.iter().zip(slope) {
                    assert!((jet.derivative(1).unwrap() - slope).abs() < 1e-12);
                }
            }
            for (rail, point) in [(&first, p), (&second, q)] {
                let off = sub(&rail.point(x).unwrap(), &point);
                assert!(off.iter().all(|c| c.abs() < 1e-13), "{off:?}");
            }
        }
        let models = patch.over(&|x| Model::exact(*x)).unwrap();
        assert!(models.ends_and_slopes(&Model::identity(0.25, 0.5)).is_ok());
        assert!(patch.is_developable_by_construction());
    }

    #[test]
    fn arcs_have_cones_but_no_oblique_cuts_of_them() {
        let apex = [0.0, 0.0, 30.0];
        let whole = [SweptEdge::Share(1.0), SweptEdge::Share(0.25)];
        let [near, far] = ConePatch::new(&helix(), apex, whole)
            .unwrap()
            .rails()
            .unwrap();
        for x in [0.0, 0.3, 1.0] {
            let (p, q) = (near.point(x).unwrap(), far.point(x).unwrap());
            let off = sub(&sub(&q, &apex), &scale(&0.25, &sub(&p, &apex)));
            assert!(off.iter().all(|c| c.abs() < 1e-13), "{off:?}");
        }
        let cut = [SweptEdge::Share(1.0), SweptEdge::Cut([0.0, 0.1, 1.0, 20.0])];
        assert!(ConePatch::new(&helix(), apex, cut).is_err());
        let along = [SweptEdge::Share(0.0), SweptEdge::Cut([0.0, 0.0, 1.0, 20.0])];
        assert!(CylinderPatch::new(&helix(), [1.0, 0.0, 0.0], along).is_err());
    }

    #[test]
    fn a_ruled_patch_between_arcs_is_exact_where_one_moves_as_a_multiple_of_the_other() {
        use crate::surface::Rails;
        let arc = |centre: Point, size: f64, turns: f64| {
            let (a, b) = ([size, 0.0, 0.0], [0.0, 2.0 * size, 0.0]);
            Rail::from(EllipticHelix::new(centre, a, b, [0.0; 3], [0.0, turns]).unwrap())
        };
        let exact = |first: Rail, second: Rail| {
            Rails::<f64>::is_developable_by_construction(&Sheet::ruled(first, second))
        };
        let low = || arc([0.0; 3], 2.0, 3.0);
        assert!(exact(low(), arc([1.0, 0.0, 5.0], 1.0, 3.0)));
        assert!(!exact(low(), arc([1.0, 0.0, 5.0], 1.0, 2.0)));
        let other = EllipticHelix::new(
            [0.0, 0.0, 5.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0; 3],
            [0.0, 3.0],
        );
        assert!(!exact(low(), Rail::from(other.unwrap())));
    }
}
