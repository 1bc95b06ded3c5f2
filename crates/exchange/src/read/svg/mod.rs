//! SVG: what is drawn, as curves in the plane, with y up.
//!
//! Numbers of SVG are read as f64, which is the definition from then on. The unit is that of the width or height of the
//! outermost element; a drawing without either has none. Texts and pictures are passed over, hidden elements too.

pub(crate) mod document;
pub(crate) mod path;
mod style;

use super::error::{ReadResult, at, refused};
use super::imported::Imported;
use super::{CurveShape, Drafts, FileKind, LengthUnit, check_unit};
use document::{Element, Matrix};
use path::{Segment, Subpath, centred, subpaths};
use torse_algebra::Rational;
use torse_geometry::GeometryError;
use torse_geometry::curve::{EllipticHelix, Spline};

pub(super) fn read(text: &str, given: Option<&LengthUnit>) -> ReadResult<Imported> {
    let document = document::parse(text)?;
    let stated = document::stated_unit(document.root_element())?;
    let unit = check_unit(stated, given)?;
    let document::Drawn {
        elements,
        mut passed,
        ..
    } = document::drawn(&document, unit.unit().millimetres())?;
    let mut drafts = Drafts::new(&unit);
    for element in &elements {
        if element.tag == "text" {
            passed.add_at("text", &element.place);
            continue;
        }
        for part in parts(element)? {
            let shape = match shape(&part, element.matrix) {
                // A part without length draws a dot.
                Err(GeometryError::Degenerate { .. } | GeometryError::TooFew { .. }) => {
                    passed.add("part without length");
                    continue;
                }
                other => other.map_err(refused(&element.place))?,
            };
            let index = drafts.curve(element.name(), element.place.clone(), shape)?;
            drafts.set_layer(index, element.layers.last().copied().unwrap_or_default());
        }
    }
    drafts.finish(FileKind::Svg, None, passed)
}

/// The outline of an element, in its coordinates.
pub(crate) fn parts(element: &Element<'_>) -> ReadResult<Vec<Subpath>> {
    let wrong = |reason: String| at(&element.place, reason);
    let number = |name: &str| element.length(name).map(|value| value.unwrap_or(0.0));
    let polygon = |points: Vec<[f64; 2]>, closed| {
        let (start, rest) = points.split_first()?;
        Some(Subpath {
            start: *start,
            segments: rest.iter().map(|p| Segment::Line(*p)).collect(),
            closed,
        })
    };
    Ok(match element.tag {
        "path" => subpaths(element.node.attribute("d").unwrap_or_default()).map_err(wrong)?,
        "line" => {
            let points = vec![
                [number("x1")?, number("y1")?],
                [number("x2")?, number("y2")?],
            ];
            polygon(points, false).into_iter().collect()
        }
        "polyline" | "polygon" => {
            let text = element.node.attribute("points").unwrap_or_default();
            let points: Vec<[f64; 2]> = svgtypes::PointsParser::from(text)
                .map(|(x, y)| [x, y])
                .collect();
            if points.iter().flatten().any(|c| !c.is_finite()) {
                return Err(wrong("`points` has a number that is not finite".to_owned()));
            }
            polygon(points, element.tag == "polygon")
                .into_iter()
                .collect()
        }
        "rect" => {
            let ([x, y], [w, h]) = (
                [number("x")?, number("y")?],
                [number("width")?, number("height")?],
            );
            let (rx, ry) = (element.length("rx")?, element.length("ry")?);
            let rx = rx.or(ry).unwrap_or(0.0).clamp(0.0, 0.5 * w.max(0.0));
            let ry = ry
                .or(element.length("rx")?)
                .unwrap_or(0.0)
                .clamp(0.0, 0.5 * h.max(0.0));
            let corner = |to: [f64; 2]| Segment::Arc {
                radii: [rx, ry],
                turn: 0.0,
                large: false,
                sweep: true,
                to,
            };
            if rx == 0.0 || ry == 0.0 {
                let points = vec![[x, y], [x + w, y], [x + w, y + h], [x, y + h]];
                polygon(points, true).into_iter().collect()
            } else {
                vec![Subpath {
                    start: [x + rx, y],
                    segments: vec![
                        Segment::Line([x + w - rx, y]),
                        corner([x + w, y + ry]),
                        Segment::Line([x + w, y + h - ry]),
                        corner([x + w - rx, y + h]),
                        Segment::Line([x + rx, y + h]),
                        corner([x, y + h - ry]),
                        Segment::Line([x, y + ry]),
                        corner([x + rx, y]),
                    ],
                    closed: true,
                }]
            }
        }
        "circle" | "ellipse" => {
            let (rx, ry) = match element.tag {
                "circle" => (number("r")?, number("r")?),
                _ => (number("rx")?, number("ry")?),
            };
            let [x, y] = [number("cx")?, number("cy")?];
            let half = |to: [f64; 2]| Segment::Arc {
                radii: [rx, ry],
                turn: 0.0,
                large: false,
                sweep: true,
                to,
            };
            vec![Subpath {
                start: [x + rx, y],
                segments: vec![half([x - rx, y]), half([x + rx, y])],
                closed: true,
            }]
        }
        _ => Vec::new(),
    })
}

/// The curve of a part, on the sheet: runs of lines are one polygon, runs of Bezier curves one each, arcs are arcs.
fn shape(part: &Subpath, matrix: Matrix) -> Result<CurveShape, GeometryError> {
    let exact = |p: [f64; 2]| -> [Rational; 3] {
        let [x, y] = matrix.point(p);
        [x, y, 0.0].map(torse_geometry::exact)
    };
    if let Some(circle) = whole_turn(part) {
        return arc(circle, matrix).map(CurveShape::Arc);
    }
    let mut row: Vec<CurveShape> = Vec::new();
    let mut corners: Vec<[Rational; 3]> = vec![exact(part.start)];
    let mut at = part.start;
    let flush = |row: &mut Vec<CurveShape>,
                 corners: &mut Vec<[Rational; 3]>,
                 next: [f64; 2]|
     -> Result<(), GeometryError> {
        corners.dedup();
        if corners.len() > 1 {
            row.push(CurveShape::Spline(Spline::polyline(std::mem::take(
                corners,
            ))?));
        }
        *corners = vec![exact(next)];
        Ok(())
    };
    let closing = part.closed.then_some(Segment::Line(part.start));
    for segment in part.segments.iter().copied().chain(closing) {
        let bezier = |control: &[[f64; 2]]| {
            let points: Vec<[Rational; 3]> = std::iter::once(at)
                .chain(control.iter().copied())
                .map(exact)
                .collect();
            let degree = control.len();
            let ends = |x: i64| std::iter::repeat_n(Rational::from(x), degree + 1);
            Spline::new(degree, ends(0).chain(ends(1)).collect(), points, None)
        };
        match segment {
            Segment::Line(to) => corners.push(exact(to)),
            Segment::Quadratic(control) => {
                if control.iter().any(|p| *p != at) {
                    let curve = bezier(&control)?;
                    flush(&mut row, &mut corners, segment.end())?;
                    row.push(CurveShape::Spline(curve));
                }
            }
            Segment::Cubic(control) => {
                if control.iter().any(|p| *p != at) {
                    let curve = bezier(&control)?;
                    flush(&mut row, &mut corners, segment.end())?;
                    row.push(CurveShape::Spline(curve));
                }
            }
            Segment::Arc {
                radii,
                turn,
                large,
                sweep,
                to,
            } => match centred(at, to, radii, turn, large, sweep) {
                None => corners.push(exact(to)),
                Some(found) => {
                    flush(&mut row, &mut corners, to)?;
                    row.push(CurveShape::Arc(arc(found, matrix)?));
                }
            },
        }
        at = segment.end();
    }
    flush(&mut row, &mut corners, at)?;
    match row.len() {
        0 => Err(GeometryError::Degenerate {
            what: "a path without length",
            at: torse_geometry::Place::Whole,
        }),
        1 => Ok(row.swap_remove(0)),
        _ => Ok(CurveShape::Row(row)),
    }
}

fn arc(arc: path::CentredArc, matrix: Matrix) -> Result<EllipticHelix, GeometryError> {
    let flat = |[x, y]: [f64; 2]| [x, y, 0.0];
    let [first, second] = arc.axes.map(|axis| flat(matrix.vector(axis)));
    EllipticHelix::new(
        flat(matrix.point(arc.centre)),
        first,
        second,
        [0.0; 3],
        arc.range,
    )
}

/// Two half turns about one centre are a whole one.
fn whole_turn(part: &Subpath) -> Option<path::CentredArc> {
    let [
        Segment::Arc {
            radii,
            turn,
            large,
            sweep,
            to,
        },
        Segment::Arc {
            radii: others,
            turn: angle,
            sweep: way,
            to: end,
            ..
        },
    ] = part.segments[..]
    else {
        return None;
    };
    if radii != others || turn != angle || sweep != way || end != part.start {
        return None;
    }
    let first = centred(part.start, to, radii, turn, large, sweep)?;
    let [from, until] = first.range;
    // Half a turn, up to rounding: the chord is a diameter.
    ((until - from).abs() - 2.0)
        .abs()
        .le(&1e-9)
        .then(|| path::CentredArc {
            range: [from, from + 2.0 * (until - from).signum() * 2.0],
            ..first
        })
}
