//! What the edges of cylinders and cones multiply by: constants, or functions in the basis of the curve.

use crate::basis::BasisShape;
use crate::coordinate::Coordinate;
use crate::curve::{Curve, EllipticHelix, RationalCurve, SpaceCurve};
use crate::error::{GeometryError, Place, Result};
use crate::over::Over;
use crate::planes::Plane;
use crate::sheet::{Point, Rail, RailCurve};
use crate::vector::dot;
use torse_algebra::Jet;

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
pub(super) enum Factor<S> {
    /// The same for all rulings.
    Constant(S),
    /// A function in the basis of the curve.
    Varying(Curve<BasisShape<S>, S, 1>),
    /// The same with the weights of the curve.
    Weighted(RationalCurve<BasisShape<S>, S, 1>),
    /// The first coordinate of an arc with the angles of the curve.
    Elliptic(EllipticHelix<S>),
}

impl<S: Coordinate> Factor<S> {
    pub(super) fn jet(&self, x: &S, order: usize) -> Result<Jet<S>> {
        match self {
            Self::Constant(value) => Ok(Jet::of_constant(value.clone(), order)),
            Self::Varying(curve) => curve.jet(x, order).map(|[jet]| jet),
            Self::Weighted(curve) => curve.jet(x, order).map(|[jet]| jet),
            Self::Elliptic(curve) => curve.space_jet(x, order).map(|[jet, _, _]| jet),
        }
    }

    pub(super) fn value_and_slope(&self, x: &S) -> Result<[S; 2]> {
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
    /// Returns the function with these values at the control points.
    pub(super) fn from_values(rail: &Rail, values: Vec<f64>) -> Result<Self> {
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

    /// Returns the function `(level - normal . c)/slope` of an arc.
    pub(super) fn from_arc(
        arc: &EllipticHelix<f64>,
        normal: &Point,
        [level, slope]: [f64; 2],
    ) -> Result<Self> {
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

    /// Returns the values at the first and the last control point, which are those at the ends; not a number of an arc,
    /// whose ends are computed and equal nothing.
    pub(super) fn ends(&self) -> [f64; 2] {
        let both = |values: Vec<f64>| {
            [values.first(), values.last()].map(|value| value.copied().unwrap_or(f64::NAN))
        };
        both(self.values(1))
    }

    /// Returns the values at the control points, of which there are so many.
    pub(super) fn values(&self, count: usize) -> Vec<f64> {
        match self {
            Self::Constant(value) => vec![*value; count],
            Self::Varying(curve) => curve.points().iter().map(|[value]| *value).collect(),
            Self::Weighted(curve) => curve.homogeneous().map(|([p], w)| p / w).collect(),
            Self::Elliptic(_) => vec![f64::NAN; count],
        }
    }
}

/// Returns the control points of a rail; an arc of an ellipse has none.
pub(super) fn control(rail: &Rail) -> Vec<Point> {
    match rail.curve() {
        RailCurve::Elliptic(_) => Vec::new(),
        RailCurve::Plain(curve) => curve.points().to_vec(),
        RailCurve::Weighted(curve) => {
            let parts = curve.homogeneous();
            parts.map(|(p, w)| p.map(|c| c / w)).collect()
        }
    }
}

/// Returns the rail with other control points and with factors of its weights.
pub(super) fn image(rail: &Rail, points: &[Point], factors: Option<&[f64]>) -> Result<Rail> {
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
