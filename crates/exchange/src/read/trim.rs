//! Parts of curves between two places: what edges, trimmed curves and arcs of files are.

use super::CurveShape;
use super::open_conic::OpenConic;
use torse_algebra::Rational;
use torse_geometry::curve::{EllipticHelix, Spline};
use torse_geometry::vector::{dot, norm, scale, sub};
use torse_geometry::{Coordinate, GeometryError, exact};

/// A curve before it is cut.
#[derive(Debug, Clone)]
pub(super) enum Base {
    /// A line without ends; its parameter goes with the direction.
    Line {
        point: [Rational; 3],
        direction: [f64; 3],
    },
    /// A circle or an ellipse: centre and directions of the axes, and their lengths; its parameter is the angle in radians.
    Conic {
        axes: [[f64; 3]; 3],
        radii: [f64; 2],
    },
    /// A hyperbola or a parabola: centre or vertex, and directions of the axes.
    Open {
        axes: [[f64; 3]; 3],
        conic: OpenConic,
    },
    /// A curve with ends.
    Curve(CurveShape),
}

/// Where a curve is cut.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Trim {
    Point([Rational; 3]),
    Parameter(Rational),
}

/// Points of a file are one where they differ by less than this share of the size of a curve.
const SAME: f64 = 1e-7;

/// The part of a curve from one place to another; forward, or against its own direction.
pub(super) fn between(
    base: Base,
    ends: [Trim; 2],
    forward: bool,
) -> Result<CurveShape, GeometryError> {
    match base {
        Base::Line { point, direction } => {
            let place = |trim: Trim| match trim {
                Trim::Point(point) => point,
                Trim::Parameter(t) => {
                    std::array::from_fn(|k| point[k].clone() + t.clone() * exact(direction[k]))
                }
            };
            let [from, to] = ends.map(place);
            CurveShape::line(from, to)
        }
        Base::Conic { axes, radii } => conic(&axes, radii, ends, forward),
        // From one end to the other there is one way, whatever the direction of the curve.
        Base::Open { axes, conic } => {
            let parameter = |trim: &Trim| match trim {
                Trim::Point(point) => {
                    conic.parameter(&axes, &point.each_ref().map(Coordinate::approximate))
                }
                Trim::Parameter(u) => Ok(u.approximate()),
            };
            let [from, to] = ends.each_ref().map(parameter);
            conic.arc(&axes, [from?, to?])
        }
        Base::Curve(CurveShape::Spline(spline)) => {
            if forward {
                return part(&spline, ends).map(CurveShape::Spline);
            }
            let [from, to] = ends;
            part(&spline, [to, from]).map(|spline| CurveShape::Spline(spline.reversed()))
        }
        Base::Curve(shape) => Ok(if forward { shape } else { shape.reversed() }),
    }
}

/// A whole ellipse.
pub(super) fn whole_conic(
    axes: &[[f64; 3]; 3],
    radii: [f64; 2],
) -> Result<CurveShape, GeometryError> {
    arc(axes, radii, [0.0, 4.0])
}

fn arc(
    axes: &[[f64; 3]; 3],
    radii: [f64; 2],
    range: [f64; 2],
) -> Result<CurveShape, GeometryError> {
    let [centre, x, y] = axes;
    EllipticHelix::new(
        *centre,
        scale(&radii[0], x),
        scale(&radii[1], y),
        [0.0; 3],
        range,
    )
    .map(CurveShape::Arc)
}

fn conic(
    axes: &[[f64; 3]; 3],
    radii: [f64; 2],
    ends: [Trim; 2],
    forward: bool,
) -> Result<CurveShape, GeometryError> {
    let [centre, x, y] = axes;
    let closed = match &ends {
        [Trim::Point(a), Trim::Point(b)] => {
            let away: [f64; 3] =
                std::array::from_fn(|k| (a[k].clone() - b[k].clone()).approximate());
            norm(&away) <= SAME * radii[0].max(radii[1])
        }
        _ => false,
    };
    let quarter = |trim: &Trim| match trim {
        Trim::Point(point) => {
            let away = sub(&point.each_ref().map(Coordinate::approximate), centre);
            let angle = libm::atan2(dot(&away, y) / radii[1], dot(&away, x) / radii[0]);
            angle * std::f64::consts::FRAC_2_PI
        }
        Trim::Parameter(angle) => angle.approximate() * std::f64::consts::FRAC_2_PI,
    };
    let [from, to] = ends.each_ref().map(quarter);
    let turn = if closed {
        4.0
    } else if forward {
        (to - from).rem_euclid(4.0)
    } else {
        (from - to).rem_euclid(4.0)
    };
    // Two parameters that differ by a whole turn are a whole ellipse, up to the digits of the file.
    let turn = if turn < 1e-9 { 4.0 } else { turn };
    arc(
        axes,
        radii,
        [from, if forward { from + turn } else { from - turn }],
    )
}

/// The part of a spline between two places along it.
fn part(spline: &Spline, ends: [Trim; 2]) -> Result<Spline, GeometryError> {
    let [start, end] = spline.domain();
    let size = spline
        .points()
        .iter()
        .flatten()
        .map(|c| c.approximate().abs())
        .fold(0.0, f64::max);
    let same = |a: &[Rational; 3], b: &[Rational; 3]| {
        let away: [f64; 3] = std::array::from_fn(|k| (a[k].clone() - b[k].clone()).approximate());
        norm(&away) <= SAME * size
    };
    let [first, last] = [spline.point(&start)?, spline.point(&end)?];
    let parameter = |trim: &Trim, usual: &Rational, at: &[Rational; 3]| match trim {
        Trim::Point(point) if same(point, at) => Ok(usual.clone()),
        Trim::Point(point) => nearest(spline, &point.each_ref().map(Coordinate::approximate)),
        Trim::Parameter(t) => Ok(t.clone().clamp(start.clone(), end.clone())),
    };
    let [from, to] = [
        parameter(&ends[0], &start, &first)?,
        parameter(&ends[1], &end, &last)?,
    ];
    if from == start && to == end {
        return Ok(spline.clone());
    }
    if from < to {
        return spline.part(&from, &to);
    }
    // Across the seam of a closed curve there would be two parts: the whole is taken.
    Ok(spline.clone())
}

/// The parameter of the point of a spline that is nearest to another, to rounding: by samples and halving.
fn nearest(spline: &Spline, point: &[f64; 3]) -> Result<Rational, GeometryError> {
    let pieces = spline.approximate_pieces()?;
    let at = |control: &[[f64; 4]], x: f64| {
        let mut level = control.to_vec();
        while level.len() > 1 {
            level = level
                .windows(2)
                .map(|pair| std::array::from_fn(|k| (1.0 - x) * pair[0][k] + x * pair[1][k]))
                .collect();
        }
        let [a, b, c, w] = level.first().copied().unwrap_or([0.0, 0.0, 0.0, 1.0]);
        norm(&sub(&[a / w, b / w, c / w], point))
    };
    let mut best = (f64::INFINITY, 0, 0.0);
    for (index, control) in pieces.iter().enumerate() {
        for k in 0..=16 {
            let x = f64::from(k) / 16.0;
            let distance = at(control, x);
            if distance < best.0 {
                best = (distance, index, x);
            }
        }
    }
    let (mut distance, index, mut x) = best;
    let Some(control) = pieces.get(index) else {
        return Ok(spline.domain()[0].clone());
    };
    let mut step = 1.0 / 32.0;
    while step > 1e-15 {
        let better = [x - step, x + step]
            .into_iter()
            .filter(|t| (0.0..=1.0).contains(t))
            .map(|t| (at(control, t), t));
        match better
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .filter(|(d, _)| *d < distance)
        {
            Some(found) => (distance, x) = found,
            None => step *= 0.5,
        }
    }
    let breaks = spline.breaks();
    let [start, end] = spline.domain();
    let zero = Rational::default();
    let (low, high) = (
        breaks.get(index).unwrap_or(&zero),
        breaks.get(index + 1).unwrap_or(&zero),
    );
    let share = low.clone() + exact(x) * (high.clone() - low.clone());
    Ok(start.clone() + share * (end - start))
}
