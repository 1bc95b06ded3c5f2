//! Curves of STEP.

use super::part21::{Instance, Value};
use super::values::{Axes, Resolver, exact, knots, list, number, positive, truth, whole};
use crate::read::CurveShape;
use crate::read::error::{ReadError, ReadResult, at, refused};
use crate::read::open_conic::OpenConic;
use crate::read::trim::{Base, Trim, between, whole_conic};
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_geometry::curve::{MAX_SPLINE_POINTS, Spline};

/// How deep curves refer to other curves.
const MAX_DEPTH: usize = 24;

/// Reads curves of one representation.
pub(super) struct Curves<'t, 'd, 'r> {
    pub resolver: &'r Resolver<'t, 'd>,
    /// Radians of its unit of angles.
    pub angle: f64,
}

impl<'t, 'd> Curves<'t, 'd, '_> {
    /// The curve as a whole; nothing for a kind that is not read, and for a hyperbola or a parabola without ends.
    ///
    /// A line without ends is that of its vector.
    pub(super) fn whole(&self, instance: &'d Instance<'t>) -> ReadResult<Option<CurveShape>> {
        let Some(base) = self.base(instance, 0)? else {
            return Ok(None);
        };
        self.bounded(instance, base)
    }

    fn bounded(&self, instance: &Instance<'t>, base: Base) -> ReadResult<Option<CurveShape>> {
        let made = match base {
            Base::Curve(shape) => return Ok(Some(shape)),
            Base::Open { .. } => return Ok(None),
            Base::Conic { axes, radii } => whole_conic(&axes, radii),
            Base::Line { point, direction } => {
                let to =
                    std::array::from_fn(|k| point[k].clone() + torse_geometry::exact(direction[k]));
                CurveShape::line(point, to)
            }
        };
        made.map(Some).map_err(refused(&instance.place()))
    }

    /// The curve of an edge, from its first vertex to its second.
    pub(super) fn edge(&self, edge: &'d Instance<'t>) -> ReadResult<Option<CurveShape>> {
        let values = self.resolver.part(edge, "EDGE_CURVE")?;
        let geometry = self.resolver.instance(edge, values.get(3))?;
        let Some(base) = self.base(geometry, 0)? else {
            return Ok(None);
        };
        let vertex = |value: Option<&Value<'t>>| {
            let vertex = self.resolver.instance(edge, value)?;
            self.resolver
                .point(vertex, self.resolver.part(vertex, "VERTEX_POINT")?.get(1))
        };
        let ends = [vertex(values.get(1))?, vertex(values.get(2))?].map(Trim::Point);
        let made = between(base, ends, truth(values.get(4)));
        made.map(Some).map_err(refused(&edge.place()))
    }

    pub(super) fn base(
        &self,
        instance: &'d Instance<'t>,
        depth: usize,
    ) -> ReadResult<Option<Base>> {
        if depth > MAX_DEPTH {
            return Err(ReadError::TooMuch {
                place: instance.place(),
                what: "curves that refer to each other: a circle of references?",
                most: MAX_DEPTH,
            });
        }
        if let Some(spline) = self.spline(instance)? {
            return Ok(Some(Base::Curve(CurveShape::Spline(spline))));
        }
        let resolver = self.resolver;
        let follow = |value: Option<&Value<'t>>| -> ReadResult<Option<Base>> {
            self.base(resolver.instance(instance, value)?, depth + 1)
        };
        let keyword = instance.keyword();
        let values = match instance.parts.as_slice() {
            [(_, values)] => values.as_slice(),
            _ => return Ok(None),
        };
        Ok(Some(match keyword {
            "LINE" => Base::Line {
                point: resolver.point(instance, values.get(1))?,
                direction: resolver.vector(instance, values.get(2))?,
            },
            "CIRCLE" => {
                let radius = positive(instance, values.get(2), "a radius")?;
                Base::Conic {
                    axes: resolver.axes(instance, values.get(1))?.triple(),
                    radii: [radius; 2],
                }
            }
            "ELLIPSE" => Base::Conic {
                axes: resolver.axes(instance, values.get(1))?.triple(),
                radii: [
                    positive(instance, values.get(2), "a radius")?,
                    positive(instance, values.get(3), "a radius")?,
                ],
            },
            "HYPERBOLA" => Base::Open {
                axes: resolver.axes(instance, values.get(1))?.triple(),
                conic: OpenConic::Hyperbola([
                    positive(instance, values.get(2), "a half axis")?,
                    positive(instance, values.get(3), "a half axis")?,
                ]),
            },
            "PARABOLA" => Base::Open {
                axes: resolver.axes(instance, values.get(1))?.triple(),
                conic: OpenConic::Parabola(positive(
                    instance,
                    values.get(2),
                    "a distance of the focus",
                )?),
            },
            "POLYLINE" => {
                let mut points = resolver.points(instance, values.get(1))?;
                points.dedup();
                let made = Spline::polyline(points).map(CurveShape::Spline);
                Base::Curve(made.map_err(refused(&instance.place()))?)
            }
            "SURFACE_CURVE" | "SEAM_CURVE" | "INTERSECTION_CURVE" => return follow(values.get(1)),
            "TRIMMED_CURVE" => {
                let Some(base) = follow(values.get(1))? else {
                    return Ok(None);
                };
                let trims = [
                    self.trim(instance, values.get(2), &base)?,
                    self.trim(instance, values.get(3), &base)?,
                ];
                let made = between(base, trims, truth(values.get(4)));
                Base::Curve(made.map_err(refused(&instance.place()))?)
            }
            "COMPOSITE_CURVE" => {
                let mut row = Vec::new();
                for segment in resolver.instances(instance, values.get(1))? {
                    let values = resolver.part(segment, "COMPOSITE_CURVE_SEGMENT")?;
                    let parent = resolver.instance(segment, values.get(2))?;
                    let Some(base) = self.base(parent, depth + 1)? else {
                        return Ok(None);
                    };
                    let Some(shape) = self.bounded(parent, base)? else {
                        return Ok(None);
                    };
                    row.push(if truth(values.get(1)) {
                        shape
                    } else {
                        shape.reversed()
                    });
                }
                if row.is_empty() {
                    return Err(at(&instance.place(), "a composite curve without segments"));
                }
                Base::Curve(CurveShape::Row(row))
            }
            _ => return Ok(None),
        }))
    }

    /// A trim: a list of a point, a parameter, or both.
    fn trim(
        &self,
        instance: &Instance<'t>,
        value: Option<&Value<'t>>,
        base: &Base,
    ) -> ReadResult<Trim> {
        let choices = list(instance, value)?;
        let parameter = choices
            .iter()
            .find(|choice| matches!(choice, Value::Typed(..) | Value::Number(_)));
        let point = choices
            .iter()
            .find(|choice| matches!(choice, Value::Reference(_)));
        match (parameter, point, base) {
            (_, Some(point), Base::Line { .. }) | (None, Some(point), _) => {
                self.resolver.point(instance, Some(point)).map(Trim::Point)
            }
            // That of a hyperbola or a parabola is no angle.
            (Some(parameter), _, Base::Conic { .. }) => {
                let angle = number(instance, Some(parameter))? * self.angle;
                Ok(Trim::Parameter(torse_geometry::exact(angle)))
            }
            (Some(parameter), _, _) => exact(instance, Some(parameter)).map(Trim::Parameter),
            (None, None, _) => Err(at(&instance.place(), "a trim without point and parameter")),
        }
    }

    /// The B-spline that an instance is, in any of the ways of the standard.
    fn spline(&self, instance: &Instance<'t>) -> ReadResult<Option<Spline>> {
        let simple = instance.parts.len() == 1;
        let keyword = instance.keyword();
        // Of a simple instance the values of all entities stand in a row, the label first.
        let with_knots = instance.part("B_SPLINE_CURVE_WITH_KNOTS");
        let kind = ["BEZIER_CURVE", "UNIFORM_CURVE", "QUASI_UNIFORM_CURVE"]
            .into_iter()
            .find(|k| instance.part(k).is_some());
        if with_knots.is_none() && kind.is_none() {
            return Ok(None);
        }
        let base = match instance.part("B_SPLINE_CURVE") {
            Some(values) if !simple => values,
            _ if simple => instance
                .part(keyword)
                .and_then(|v| v.get(1..))
                .unwrap_or_default(),
            _ => return Err(at(&instance.place(), "B_SPLINE_CURVE is wanted here")),
        };
        let degree = whole(instance, base.first())?;
        let points = self.resolver.points(instance, base.get(1))?;
        if points.len() > MAX_SPLINE_POINTS || degree > points.len() {
            return Err(at(
                &instance.place(),
                format!("degree {degree} with {} control points", points.len()),
            ));
        }
        let count = points.len() + degree + 1;
        let knots = match (with_knots, kind) {
            (Some(values), _) => {
                let own = if simple {
                    values.get(6..).unwrap_or_default()
                } else {
                    values
                };
                knots(instance, own.first(), own.get(1), count)?
            }
            (None, Some(kind)) => implied_knots(kind, degree, points.len()),
            (None, None) => return Ok(None),
        };
        let weights = match instance.part("RATIONAL_B_SPLINE_CURVE") {
            Some(values) => {
                let list = list(instance, values.first())?;
                let weights: ReadResult<Vec<Rational>> =
                    list.iter().map(|w| exact(instance, Some(w))).collect();
                Some(weights?)
            }
            None => None,
        };
        Spline::new(degree, knots, points, weights)
            .map(Some)
            .map_err(refused(&instance.place()))
    }
}

/// The knots that a kind of spline has without saying so.
pub(super) fn implied_knots(kind: &str, degree: usize, points: usize) -> Vec<Rational> {
    let number = |k: usize| integer(i64::try_from(k).unwrap_or(i64::MAX));
    let count = points + degree + 1;
    match kind {
        "UNIFORM_CURVE" | "UNIFORM_SURFACE" => {
            (0..count).map(|k| number(k) - number(degree)).collect()
        }
        // Bezier pieces in a row: each inner knot as often as the degree says.
        "BEZIER_CURVE" | "BEZIER_SURFACE" => (0..count)
            .map(|k| number(k.saturating_sub(1).min(points.saturating_sub(1)) / degree.max(1)))
            .collect(),
        _ => (0..count)
            .map(|k| number(k.clamp(degree, points.max(degree)) - degree))
            .collect(),
    }
}

impl Axes {
    /// The frame as the reader of trims sees it.
    pub(super) fn triple(&self) -> [[f64; 3]; 3] {
        [self.place(), self.x, self.y]
    }
}
