//! The curves of a drawing as lines and arcs.

use super::rules::LintRules;
use crate::numbers::number;
use torse_exchange::{CurveShape, Imported, ReadError};
use torse_geometry::Coordinate;
use torse_geometry::GeometryError;
use torse_geometry::pattern::Segment;

/// Lines that stand for one piece of a curve that is neither a line nor a circle.
const CHORDS: u32 = 64;
/// Steps in which the height of a piece of a curve is looked at.
const HEIGHTS: u32 = 8;
/// Axes that differ by no more, as a share, are those of a circle.
const ROUND: f64 = 1e-9;

/// A curve of a file.
#[derive(Debug, Clone)]
pub(super) struct Traced {
    /// The line and the entity.
    pub place: String,
    pub layer: String,
    /// Whether it is on a layer that is cut.
    pub cut: bool,
    /// One after the other.
    pub segments: Vec<Segment>,
    /// How many pieces the file has: a spline piece counts once, however many lines stand for it.
    pub nodes: usize,
    /// Whether lines stand for pieces that are curved.
    pub sampled: bool,
}

impl Traced {
    pub(super) fn ends(&self) -> Option<[[f64; 2]; 2]> {
        Some([self.segments.first()?.from, self.segments.last()?.to])
    }
}

/// Refuses a curve that leaves the plane of the drawing by more than `within`: what is cut is flat.
pub(super) fn check_flat(found: &Imported, within: f64) -> Result<(), ReadError> {
    for curve in &found.curves {
        let refused = |reason: GeometryError| ReadError::Geometry {
            place: curve.place.clone(),
            reason: Box::new(reason),
        };
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for rail in curve
            .shape
            .rail()
            .map_err(refused)?
            .rails()
            .map_err(refused)?
        {
            for k in 0..=HEIGHTS {
                let z = rail
                    .point(f64::from(k) / f64::from(HEIGHTS))
                    .map_err(refused)?[2];
                range = [range[0].min(z), range[1].max(z)];
            }
        }
        if range[1] - range[0] > within {
            return Err(ReadError::Wrong {
                place: curve.place.clone(),
                reason: format!(
                    "the curve leaves the plane of the drawing: z runs from {} to {} mm",
                    number(range[0]),
                    number(range[1])
                ),
            });
        }
    }
    Ok(())
}

/// Returns the curves of a file that are drawn, not only edges of faces.
pub(super) fn traced(found: &Imported, rules: &LintRules) -> Result<Vec<Traced>, GeometryError> {
    let mut all = Vec::new();
    for curve in &found.curves {
        let mut traced = Traced {
            place: curve.place.to_string().trim_end_matches(": ").to_owned(),
            layer: curve.layer.clone(),
            cut: rules.is_cut(&curve.layer),
            segments: Vec::new(),
            nodes: 0,
            sampled: false,
        };
        trace(&curve.shape, &mut traced)?;
        if !traced.segments.is_empty() {
            all.push(traced);
        }
    }
    Ok(all)
}

fn flat(point: [f64; 3]) -> [f64; 2] {
    [point[0], point[1]]
}

fn trace(shape: &CurveShape, traced: &mut Traced) -> Result<(), GeometryError> {
    match shape {
        CurveShape::Row(parts) => {
            for part in parts {
                trace(part, traced)?;
            }
        }
        CurveShape::Spline(spline) if spline.degree() == 1 => {
            let corners = spline.points().iter();
            let corners: Vec<[f64; 2]> = corners
                .map(|point| flat(point.each_ref().map(Coordinate::approximate)))
                .collect();
            for pair in corners.windows(2) {
                traced.segments.push(Segment::line(pair[0], pair[1]));
                traced.nodes += 1;
            }
        }
        CurveShape::Arc(arc) => match circular(arc) {
            Some(arcs) => {
                traced.nodes += 1;
                traced.segments.extend(arcs);
            }
            None => sampled(shape, traced)?,
        },
        _ => sampled(shape, traced)?,
    }
    Ok(())
}

/// Returns lines between points of a curve.
fn sampled(shape: &CurveShape, traced: &mut Traced) -> Result<(), GeometryError> {
    let rail = shape.rail()?;
    let pieces = u32::try_from(rail.count()).unwrap_or(u32::MAX);
    traced.nodes += rail.count();
    traced.sampled = true;
    let count = pieces.saturating_mul(CHORDS);
    let mut last = flat(rail.point(0.0)?);
    for k in 1..=count {
        let next = flat(rail.point(f64::from(k) / f64::from(count))?);
        if next != last {
            traced.segments.push(Segment::line(last, next));
        }
        last = next;
    }
    Ok(())
}

/// Returns the arcs, of half a circle at most, of an arc of a circle in the plane of the drawing.
fn circular(arc: &torse_geometry::curve::EllipticHelix) -> Option<Vec<Segment>> {
    let [cosine, sine] = arc.axes();
    let lengths = [cosine, sine].map(torse_geometry::vector::norm);
    let across = torse_geometry::vector::dot(cosine, sine);
    let flat_axes = cosine[2] == 0.0 && sine[2] == 0.0 && arc.rise().iter().all(|c| *c == 0.0);
    let round = (lengths[0] - lengths[1]).abs() <= ROUND * lengths[0]
        && across.abs() <= ROUND * lengths[0] * lengths[1];
    if !(flat_axes && round) {
        return None;
    }
    let [from, to] = *arc.range();
    let quarter = std::f64::consts::FRAC_PI_2;
    let turn = (to - from) * quarter;
    // The axes may be those of a mirrored circle.
    let way = (cosine[0] * sine[1] - cosine[1] * sine[0]).signum();
    let parts = (turn.abs() / std::f64::consts::PI * (1.0 - 1e-12))
        .ceil()
        .max(1.0);
    let centre = arc.centre();
    let point = |share: f64| {
        let (s, c) = libm::sincos(from * quarter + share * turn);
        [0, 1].map(|i| centre[i] + c * cosine[i] + s * sine[i])
    };
    let mut arcs = Vec::new();
    let mut k = 0.0;
    while k < parts {
        arcs.push(Segment {
            from: point(k / parts),
            to: point((k + 1.0) / parts),
            bulge: libm::tan(0.25 * way * turn / parts),
        });
        k += 1.0;
    }
    if parts > 1.0 && turn.abs() >= 4.0 * quarter * (1.0 - 1e-12) {
        // A whole circle ends where it starts.
        let start = arcs.first().map(|arc| arc.from);
        if let (Some(last), Some(start)) = (arcs.last_mut(), start) {
            last.to = start;
        }
    }
    Some(arcs)
}
