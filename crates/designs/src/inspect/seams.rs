//! Edges that meet: how long both are, and where they part.

use crate::design::Design;
use crate::seams::{EdgeName, PatchEdge, Seam};
use serde::Serialize;
use torse_geometry::prelude::{GeometryError, Point};
use torse_geometry::vector::{dot, norm, sub};

/// Steps in which the rail of a patch is passed when its length is measured.
const STEPS: u32 = 1024;
/// Places at which two edges are compared.
const PLACES: u32 = 64;

/// A seam, measured; lengths in millimetres.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SeamReport {
    /// The names of both edges.
    pub edges: [String; 2],
    /// Their lengths in space, which are those on the pattern.
    pub lengths: [f64; 2],
    /// By how much the first is longer on purpose.
    pub ease: f64,
    /// By how much it is longer beyond that.
    pub difference: f64,
    /// By how much the lengths may be off, as a finer measurement shows.
    pub length_error: f64,
    /// The largest distance in space of points at equal shares of both lengths, the second edge passed as fits better,
    /// and the share at which it is.
    pub apart: [f64; 2],
    /// Whether the second edge was passed backwards for that.
    pub backwards: bool,
    /// The share of the length of the second edge at which the first begins: zero unless both are closed.
    pub offset: f64,
}

/// Measures the seams of a design; what differs is said in `missed`.
///
/// # Errors
/// What the geometry of a patch refuses.
pub fn seams(design: &Design, missed: &mut Vec<String>) -> Result<Vec<SeamReport>, GeometryError> {
    let mut reports = Vec::with_capacity(design.seams.len());
    for seam in &design.seams {
        let report = measured(design, seam)?;
        let allowed = design.tolerances.outline;
        if report.difference.is_nan() || report.difference.abs() > allowed + report.length_error {
            let [one, other] = &report.edges;
            let ease = match seam.ease {
                0.0 => String::new(),
                ease => format!(" with an ease of {ease} mm"),
            };
            missed.push(format!(
                "the seam of {one}, {:.4} mm, and {other}, {:.4} mm{ease}: they differ by {:.4} mm, {allowed} allowed; at \
                 equal shares they are farthest apart, {:.4} mm, at {:.3} of their length",
                report.lengths[0],
                report.lengths[1],
                report.difference,
                report.apart[0],
                report.apart[1]
            ));
        }
        reports.push(report);
    }
    Ok(reports)
}

/// An edge as points with the lengths up to them.
struct Passed {
    points: Vec<Point>,
    lengths: Vec<f64>,
    /// The length, extrapolated from two measurements, and their difference.
    length: f64,
    error: f64,
}

fn measured(design: &Design, Seam { edges, ease }: &Seam) -> Result<SeamReport, GeometryError> {
    let [one, other] = [passed(design, &edges[0])?, passed(design, &edges[1])?];
    let shares = || (0..=PLACES).map(|k| f64::from(k) / f64::from(PLACES));
    let farthest = |way: SeamPassage| {
        shares()
            .map(|share| {
                [
                    norm(&sub(&one.at(share), &other.at(way.share(share)))),
                    share,
                ]
            })
            .fold(
                [0.0, 0.0],
                |far, next| if next[0] > far[0] { next } else { far },
            )
    };
    // Closed edges may begin at different places.
    let gap = design.tolerances.gap;
    let mut offsets = vec![0.0];
    if one.is_closed(gap) && other.is_closed(gap) {
        let near = other.share_near(&one.at(0.0));
        offsets.extend(Some(near).filter(|share| *share > 0.0 && *share < 1.0));
    }
    let ways = offsets
        .into_iter()
        .flat_map(|offset| [false, true].map(|backwards| SeamPassage { backwards, offset }));
    let mut best: Option<([f64; 2], SeamPassage)> = None;
    for way in ways {
        let apart = farthest(way);
        // Another beginning has to be nearer than rounding makes it.
        let room = if way.offset == 0.0 { 0.0 } else { gap };
        if best.is_none_or(|(least, _)| apart[0] + room < least[0]) {
            best = Some((apart, way));
        }
    }
    let (apart, way) = best.unwrap_or((
        [f64::NAN; 2],
        SeamPassage {
            backwards: false,
            offset: 0.0,
        },
    ));
    Ok(SeamReport {
        edges: [0, 1].map(|i| edges[i].text.clone()),
        lengths: [one.length, other.length],
        ease: *ease,
        difference: one.length - other.length - ease,
        length_error: one.error + other.error,
        apart,
        backwards: way.backwards,
        offset: way.offset,
    })
}

/// How the second edge of a seam is passed beside the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamPassage {
    /// Whether it runs against the first.
    pub backwards: bool,
    /// The share of its length at which the first begins; zero unless both are closed.
    pub offset: f64,
}

impl SeamPassage {
    /// Returns the share of the second edge that meets a share of the first.
    pub fn share(self, of_first: f64) -> f64 {
        let share = self.offset + if self.backwards { -of_first } else { of_first };
        match (self.offset == 0.0, self.backwards) {
            (true, false) => share,
            (true, true) => 1.0 + share,
            (false, _) => share.rem_euclid(1.0),
        }
    }
}

/// Returns how the second edge of a seam is passed, as its places in space show.
pub fn passage(design: &Design, seam: &Seam) -> Result<SeamPassage, GeometryError> {
    let report = measured(design, seam)?;
    Ok(SeamPassage {
        backwards: report.backwards,
        offset: report.offset,
    })
}

fn passed(design: &Design, edge: &EdgeName) -> Result<Passed, GeometryError> {
    let mut points: Vec<Point> = Vec::new();
    // The lengths of both measurements.
    let (mut coarse, mut fine) = (0.0, 0.0);
    let mut lengths = Vec::new();
    for patch in edge
        .patches
        .iter()
        .filter_map(|index| design.patches.get(*index))
    {
        let steps = match edge.edge {
            PatchEdge::Start | PatchEdge::End => 2,
            PatchEdge::First | PatchEdge::Second => STEPS,
        };
        let place = |share: f64| match edge.edge {
            PatchEdge::Start => patch.sheet.point(0.0, share),
            PatchEdge::End => patch.sheet.point(1.0, share),
            PatchEdge::First => patch.sheet.point(share, 0.0),
            PatchEdge::Second => patch.sheet.point(share, 1.0),
        };
        let own: Result<Vec<Point>, _> = (0..=steps)
            .map(|k| place(f64::from(k) / f64::from(steps)))
            .collect();
        let own = own?;
        let chord = |a: &Point, b: &Point| norm(&sub(a, b));
        coarse += own
            .iter()
            .step_by(2)
            .zip(own.iter().skip(2).step_by(2))
            .map(|(a, b)| chord(a, b))
            .sum::<f64>();
        for (k, point) in own.iter().enumerate() {
            if let Some(before) = k.checked_sub(1).and_then(|before| own.get(before)) {
                fine += chord(before, point);
            }
            points.push(*point);
            lengths.push(fine);
        }
    }
    // The error of chords falls with the square of their number.
    let error = (fine - coarse) / 3.0;
    Ok(Passed {
        points,
        lengths,
        length: fine + error,
        error: error.abs(),
    })
}

impl Passed {
    /// Returns whether its ends are no farther apart than this.
    fn is_closed(&self, gap: f64) -> bool {
        let ends = [self.points.first(), self.points.last()];
        matches!(ends, [Some(a), Some(b)] if norm(&sub(a, b)) <= gap && self.length > 4.0 * gap)
    }

    /// Returns the share of the length at which it is nearest to a point.
    fn share_near(&self, point: &Point) -> f64 {
        let whole = self.lengths.last().copied().unwrap_or(0.0);
        let mut best = (f64::INFINITY, 0.0);
        for (ends, lengths) in self.points.windows(2).zip(self.lengths.windows(2)) {
            let (way, arm) = (sub(&ends[1], &ends[0]), sub(point, &ends[0]));
            let square = dot(&way, &way);
            let part = if square > 0.0 {
                (dot(&arm, &way) / square).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let off: Point = std::array::from_fn(|i| arm[i] - part * way[i]);
            let off = norm(&off);
            if off < best.0 {
                best = (off, lengths[0] + part * (lengths[1] - lengths[0]));
            }
        }
        best.1 / whole
    }

    /// Returns the point at a share of the length.
    fn at(&self, share: f64) -> Point {
        let whole = self.lengths.last().copied().unwrap_or(0.0);
        let wanted = share * whole;
        let index = self.lengths.partition_point(|length| *length < wanted);
        let index = index.clamp(1, self.points.len().saturating_sub(1).max(1));
        let (Some(p), Some(q)) = (self.points.get(index - 1), self.points.get(index)) else {
            return [f64::NAN; 3];
        };
        let (from, to) = (self.lengths[index - 1], self.lengths[index]);
        let part = if to > from {
            ((wanted - from) / (to - from)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        std::array::from_fn(|i| p[i] + part * (q[i] - p[i]))
    }
}
