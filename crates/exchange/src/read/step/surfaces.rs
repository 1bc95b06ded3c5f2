//! Surfaces of STEP.

use super::curves::{Curves, implied_knots};
use super::part21::{Instance, Value};

use super::values::{Axes, exact, knots, list, number, positive, whole};
use crate::read::error::{ReadError, ReadResult, at, refused};
use crate::read::turned::turned;
use crate::read::{SplineSurface, SurfaceFrame, SurfaceShape};
use torse_algebra::Rational;
use torse_geometry::curve::MAX_SPLINE_POINTS;

/// How deep surfaces refer to other surfaces.
const MAX_DEPTH: usize = 24;

impl<'t, 'd> Curves<'t, 'd, '_> {
    /// The surface that an instance is; nothing for a kind that is not read.
    pub(super) fn surface(&self, instance: &'d Instance<'t>) -> ReadResult<Option<SurfaceShape>> {
        self.surface_within(instance, 0)
    }

    fn surface_within(
        &self,
        instance: &'d Instance<'t>,
        depth: usize,
    ) -> ReadResult<Option<SurfaceShape>> {
        if depth > MAX_DEPTH {
            return Err(ReadError::TooMuch {
                place: instance.place(),
                what: "surfaces that refer to each other: a circle of references?",
                most: MAX_DEPTH,
            });
        }
        if let Some(surface) = self.spline_surface(instance)? {
            return Ok(Some(SurfaceShape::Spline(surface)));
        }
        let values = match instance.parts.as_slice() {
            [(_, values)] => values.as_slice(),
            _ => return Ok(None),
        };
        let frame = || {
            self.resolver
                .axes(instance, values.get(1))
                .map(|axes| frame_of(&axes))
        };
        let radius = |k: usize| positive(instance, values.get(k), "a radius");
        Ok(Some(match instance.keyword() {
            "PLANE" => SurfaceShape::Plane(frame()?),
            "CYLINDRICAL_SURFACE" => SurfaceShape::Cylinder(frame()?, radius(2)?),
            "CONICAL_SURFACE" => {
                let radius = number(instance, values.get(2))?;
                let angle = number(instance, values.get(3))? * self.angle;
                if radius < 0.0 || !(0.0..std::f64::consts::FRAC_PI_2).contains(&angle.abs()) {
                    return Err(at(
                        &instance.place(),
                        format!("a cone of radius {radius} and half angle {angle}"),
                    ));
                }
                SurfaceShape::Cone(frame()?, radius, angle)
            }
            "SPHERICAL_SURFACE" => SurfaceShape::Sphere(frame()?, radius(2)?),
            "TOROIDAL_SURFACE" | "DEGENERATE_TOROIDAL_SURFACE" => {
                SurfaceShape::Torus(frame()?, radius(2)?, radius(3)?)
            }
            "SURFACE_OF_LINEAR_EXTRUSION" => {
                let Some(curve) = self.whole(self.resolver.instance(instance, values.get(1))?)?
                else {
                    return Ok(None);
                };
                SurfaceShape::Extruded(
                    Box::new(curve),
                    self.resolver.vector(instance, values.get(2))?,
                )
            }
            "SURFACE_OF_REVOLUTION" => {
                let Some(curve) = self.whole(self.resolver.instance(instance, values.get(1))?)?
                else {
                    return Ok(None);
                };
                let axes = self.resolver.axes(instance, values.get(2))?;
                let direction = axes.z.map(torse_geometry::exact);
                turned(curve, &axes.origin, &direction, frame_of(&axes))
            }
            "RECTANGULAR_TRIMMED_SURFACE" | "CURVE_BOUNDED_SURFACE" => {
                return self
                    .surface_within(self.resolver.instance(instance, values.get(1))?, depth + 1);
            }
            _ => return Ok(None),
        }))
    }

    fn spline_surface(&self, instance: &Instance<'t>) -> ReadResult<Option<SplineSurface>> {
        let simple = instance.parts.len() == 1;
        let with_knots = instance.part("B_SPLINE_SURFACE_WITH_KNOTS");
        let kinds = ["BEZIER_SURFACE", "UNIFORM_SURFACE", "QUASI_UNIFORM_SURFACE"];
        let kind = kinds.into_iter().find(|k| instance.part(k).is_some());
        if with_knots.is_none() && kind.is_none() {
            return Ok(None);
        }
        let base = match instance.part("B_SPLINE_SURFACE") {
            Some(values) if !simple => values,
            _ if simple => instance
                .part(instance.keyword())
                .and_then(|v| v.get(1..))
                .unwrap_or_default(),
            _ => return Err(at(&instance.place(), "B_SPLINE_SURFACE is wanted here")),
        };
        let degrees = [
            whole(instance, base.first())?,
            whole(instance, base.get(1))?,
        ];
        let mut net = Vec::new();
        let mut count = 0;
        for row in list(instance, base.get(2))? {
            net.push(self.resolver.points(instance, Some(row))?);
            count += net.last().map_or(0, Vec::len);
            if count > MAX_SPLINE_POINTS {
                return Err(ReadError::TooMuch {
                    place: instance.place(),
                    what: "control points of a surface",
                    most: MAX_SPLINE_POINTS,
                });
            }
        }
        let sizes = [net.len(), net.first().map_or(0, Vec::len)];
        if degrees
            .iter()
            .zip(sizes)
            .any(|(degree, size)| *degree >= size)
        {
            return Err(at(
                &instance.place(),
                format!("degrees {degrees:?} with {sizes:?} control points"),
            ));
        }
        let each = |k: usize, values: &[Value<'t>], first: usize| -> ReadResult<Vec<Rational>> {
            let most = sizes[k] + degrees[k] + 1;
            knots(
                instance,
                values.get(first + k),
                values.get(first + 2 + k),
                most,
            )
        };
        let knots = match (with_knots, kind) {
            (Some(values), _) => {
                let first = if simple { 8 } else { 0 };
                [each(0, values, first)?, each(1, values, first)?]
            }
            (None, kind) => {
                [0, 1].map(|k| implied_knots(kind.unwrap_or_default(), degrees[k], sizes[k]))
            }
        };
        let weights = match instance.part("RATIONAL_B_SPLINE_SURFACE") {
            Some(values) => {
                let rows = list(instance, values.first())?.iter();
                let row = |row: &Value<'t>| -> ReadResult<Vec<Rational>> {
                    list(instance, Some(row))?
                        .iter()
                        .map(|w| exact(instance, Some(w)))
                        .collect()
                };
                Some(rows.map(row).collect::<ReadResult<Vec<_>>>()?)
            }
            None => None,
        };
        SplineSurface::new(degrees, knots, net, weights)
            .map(Some)
            .map_err(refused(&instance.place()))
    }
}

pub(super) fn frame_of(axes: &Axes) -> SurfaceFrame {
    SurfaceFrame {
        origin: axes.place(),
        axis: axes.z,
        across: axes.x,
    }
}
