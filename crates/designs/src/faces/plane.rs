//! Plane faces, with any outline: a rectangle around the face that is cut along its border.

use super::loops::{curve_of, named, opening};
use super::{FaceSheets, SAME, words};
use crate::design::Mark;
use crate::plane_contour::PlaneFrame;
use crate::simple_contour::{goes_around_once, self_contact};
use torse_exchange::{FaceBorder, Imported, ImportedFace, SplineSurface, SurfaceFrame};
use torse_geometry::prelude::{PiecewiseRail, Point, Rail, Sheet, SweptEdge};
use torse_geometry::vector::{add, cross, dot, norm, scale, sub, unit};
use torse_geometry::{Coordinate, Rational};

/// Points of each piece of a loop by which its reach is found; of what lies between, the margin takes care.
const SAMPLES: u32 = 64;
/// Control points within this share of their size of a plane are in it.
const FLAT: f64 = 1e-12;
/// How far the rectangle reaches beyond the face, as a share of its size.
const MARGIN: f64 = 0.05;

/// Returns the sheet of a plane face, or why it has none: the loop that the file names bounds it, or else the one around the
/// largest area; the others are openings.
/// That they lie within it, and that no loop leaves the plane by more than the tolerance `gap`, is found out where they are
/// cut.
pub(super) fn plane_sheet(
    face: &ImportedFace,
    frame: &SurfaceFrame,
    imported: &Imported,
) -> Result<FaceSheets, String> {
    let mut curves: Vec<PiecewiseRail> = Vec::with_capacity(face.loops.len());
    for edges in &face.loops {
        curves.push(curve_of(edges, imported)?);
    }
    let across = unit(&cross(&frame.axis, &frame.across)).ok_or("its plane has no axes")?;
    let axes = [frame.across, across];
    // The area between chords is twice that of triangles with the origin.
    let area = |curve: &PiecewiseRail| -> Result<f64, String> {
        let points = places(curve, frame, &axes)?;
        let next = points.iter().cycle().skip(1);
        let twice = points
            .iter()
            .zip(next)
            .map(|(a, b)| a[0] * b[1] - a[1] * b[0]);
        Ok(twice.sum::<f64>().abs())
    };
    let mut largest: Option<(f64, usize)> = None;
    for (index, curve) in curves.iter().enumerate() {
        let area = area(curve)?;
        if largest.is_none_or(|(known, _)| area > known) {
            largest = Some((area, index));
        }
    }
    let outer = match face.border {
        FaceBorder::Loop(index) => Some(index),
        FaceBorder::Unstated | FaceBorder::OwnOfSurface | FaceBorder::NotRead => {
            largest.map(|(_, index)| index)
        }
    };
    let outer = outer.ok_or("it has no loop")?;
    let border = curves.get(outer).ok_or("it has no loop")?;
    let sheet = rectangle(&places(border, frame, &axes)?, frame, &axes)?;
    let size = sheet.ruling(0.0).map_err(words)?;
    let within = (SAME * norm(&sub(&size[1], &size[0]))).max(imported.uncertainty.unwrap_or(0.0));
    // What is no closed curve in the plane is left out, and not found out later.
    let plane = PlaneFrame::of_sheet(&sheet).ok_or("its plane has no axes")?;
    let contour = plane
        .contour(border, within, within)
        .map_err(|reason| format!("its border is no outline: {reason}"))?;
    let meets_itself = self_contact(&contour.segments, 2.0 * contour.distance).is_some();
    if meets_itself || !goes_around_once(&contour.segments) {
        return Err("its border is no outline: it crosses itself or touches itself".to_owned());
    }
    let inner = curves.iter().enumerate();
    let inner = inner.filter(|(index, _)| *index != outer);
    let openings: Vec<Mark> = inner
        .map(|(index, curve)| opening(index, curve.clone()))
        .collect();
    Ok(FaceSheets {
        sheets: vec![sheet],
        closed: false,
        note: None,
        border: Some(named(outer, border.clone())),
        openings,
    })
}

/// Returns the plane of a B-spline surface, in which all of its control points lie but for rounding; `None` of any other.
pub(super) fn plane_of_net(surface: &SplineSurface) -> Option<SurfaceFrame> {
    let near = |p: &[Rational; 3]| p.each_ref().map(Coordinate::approximate);
    let points: Vec<Point> = surface.net.iter().flatten().map(near).collect();
    let plane = PlaneOfPoints::new(&points)?;
    let size = plane.reach + norm(&plane.frame.origin);
    (plane.height <= FLAT * size).then_some(plane.frame)
}

/// A plane through the first of points, the farthest from it, and the one farthest from the line of both.
pub(super) struct PlaneOfPoints {
    /// The first point, the normal, and the way to the farthest point.
    pub frame: SurfaceFrame,
    /// The largest distance of a point from the plane.
    pub height: f64,
    /// The largest distance of a point from the first.
    pub reach: f64,
}

impl PlaneOfPoints {
    /// Returns the plane, if the points are not all in one line.
    pub(super) fn new(points: &[Point]) -> Option<Self> {
        let origin = *points.first()?;
        let away = |p: &Point| norm(&sub(p, &origin));
        let far = points
            .iter()
            .max_by(|a, b| away(a).total_cmp(&away(b)))
            .copied()?;
        let across = unit(&sub(&far, &origin))?;
        let beside = |p: &Point| cross(&across, &sub(p, &origin));
        let widest = points
            .iter()
            .max_by(|a, b| norm(&beside(a)).total_cmp(&norm(&beside(b))))?;
        let axis = unit(&beside(widest))?;
        let height = points
            .iter()
            .map(|p| dot(&sub(p, &origin), &axis).abs())
            .fold(0.0, f64::max);
        Some(Self {
            frame: SurfaceFrame {
                origin,
                axis,
                across,
            },
            height,
            reach: away(&far),
        })
    }
}

/// Returns points of a closed curve, by the axes of its plane.
fn places(
    curve: &PiecewiseRail,
    frame: &SurfaceFrame,
    axes: &[Point; 2],
) -> Result<Vec<[f64; 2]>, String> {
    let mut points = Vec::new();
    for rail in curve.rails().map_err(words)? {
        for k in 0..SAMPLES {
            let point = rail
                .point(f64::from(k) / f64::from(SAMPLES))
                .map_err(words)?;
            let arm = sub(&point, &frame.origin);
            points.push(axes.each_ref().map(|axis| dot(&arm, axis)));
        }
    }
    Ok(points)
}

/// Returns the rectangle around points, and somewhat more.
fn rectangle(
    points: &[[f64; 2]],
    frame: &SurfaceFrame,
    axes: &[Point; 2],
) -> Result<Sheet, String> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in points {
        for i in 0..2 {
            low[i] = low[i].min(point[i]);
            high[i] = high[i].max(point[i]);
        }
    }
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    if !(size > 0.0 && size.is_finite()) {
        return Err("its border has no extent".to_owned());
    }
    let more = MARGIN * size;
    let corner = |x: f64, y: f64| {
        let along = add(&scale(&x, &axes[0]), &scale(&y, &axes[1]));
        add(&frame.origin, &along)
    };
    let start = low[1] - more;
    let ends = [corner(low[0] - more, start), corner(high[0] + more, start)];
    let rail = Rail::bezier(&ends).map_err(words)?;
    let direction = scale(&(high[1] + more - start), &axes[1]);
    let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
    Sheet::cylinder(&rail, direction, edges).map_err(words)
}
