//! Closed curves on plane patches: lines and arcs of circles are what they are, other curves are fitted.

use crate::fit::fitted_run;
use torse_geometry::pattern::{
    FlatPattern, PatternContour, PatternEvidence, PatternPlace, Segment,
};
use torse_geometry::prelude::{PiecewiseRail, Point, Rail, RailCurve, Sheet};
use torse_geometry::vector::{cross, dot, norm, scale, sub, unit};

/// The share of the size of a plane within which a ruling or a point counts as in it.
const ROUNDING: f64 = 1e-12;
/// The part of the tolerance that the polygon of a curve may take; its lines and arcs as much again.
const POLYGON: f64 = 0.1;

/// A plane patch with rulings of one length and direction, and where its points are in the plane.
#[derive(Debug, Clone, Copy)]
pub struct PlaneFrame {
    origin: Point,
    /// Unit vectors: across the rulings, along them, and the normal.
    axes: [Point; 3],
    /// The lengths of its sides and the distance from the origin of space: what rounding goes with.
    size: f64,
}

/// A closed curve in a plane as lines and arcs of half a circle at most.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneContour {
    /// The segments, counterclockwise, each from where the one before ends.
    pub segments: Vec<Segment>,
    /// No point of it is farther from the curve in space, nor of the curve from it.
    pub distance: f64,
    /// Whether the curve consists of lines and arcs of circles: then the distance is that of the curve from the plane, of its
    /// ends from one another, and rounding.
    pub exact: bool,
    /// How far its length is from that of the curve: bounded where it is `exact`, else measured.
    pub length_error: f64,
}

impl PlaneFrame {
    /// Returns the frame of a patch that is a parallelogram, from its first point: the second axis runs along the first
    /// ruling; the patch is on the side of the first axis. `None` of any other patch.
    pub fn of_sheet(sheet: &Sheet) -> Option<Self> {
        let [p, q] = sheet.ruling(0.0).ok()?;
        let [r, s] = sheet.ruling(1.0).ok()?;
        let [along, away] = [sub(&q, &p), sub(&r, &p)];
        let size = norm(&along) + norm(&away) + norm(&p);
        let skew = norm(&sub(&sub(&s, &r), &along));
        let ruling = unit(&along)?;
        let across = unit(&sub(&away, &scale(&dot(&away, &ruling), &ruling)))?;
        let frame = Self {
            origin: p,
            axes: [across, ruling, cross(&across, &ruling)],
            size,
        };
        let off = |x: f64| {
            let ends = sheet.ruling(x).ok()?;
            let off = ends.map(|end| frame.height(&end).abs());
            let straight = norm(&sub(&ends[0], &lerp(&p, &r, x)));
            Some(off[0].max(off[1]).max(straight))
        };
        let flat = [0.25, 0.5, 0.75, 1.0].into_iter();
        let flat = flat.map(|x| off(x).unwrap_or(f64::INFINITY));
        let flat = flat.fold(skew, f64::max);
        (flat <= ROUNDING * size).then_some(frame)
    }

    /// Returns the distance of a point from the plane, positive on the side of the normal.
    fn height(&self, point: &Point) -> f64 {
        dot(&sub(point, &self.origin), &self.axes[2])
    }

    /// Returns where a point is in the plane.
    pub fn place(&self, point: &Point) -> [f64; 2] {
        let arm = sub(point, &self.origin);
        [dot(&arm, &self.axes[0]), dot(&arm, &self.axes[1])]
    }

    /// Returns a closed curve in the plane; what is neither a line nor an arc of a circle is fitted within a share of `within`.
    ///
    /// # Errors
    /// In words: a curve that leaves the plane by more than `off_plane`, is not closed, or has no area.
    pub fn contour(
        &self,
        curve: &PiecewiseRail,
        within: f64,
        off_plane: f64,
    ) -> Result<PlaneContour, String> {
        let rails = curve.rails().map_err(|error| error.to_string())?;
        let mut runs: Vec<Run> = Vec::with_capacity(rails.len());
        for rail in &rails {
            runs.push(self.run(rail, within)?);
        }
        let off = runs.iter().map(|run| run.off).fold(0.0, f64::max);
        if off.is_nan() || off > off_plane {
            return Err(format!("it is up to {off:.2e} mm from the plane"));
        }
        let mut segments: Vec<Segment> = runs.iter().flat_map(|run| run.segments.clone()).collect();
        let count = segments.len();
        let mut gap = 0.0_f64;
        for k in 0..count {
            let start = segments[(k + 1) % count].from;
            let end = segments[k].to;
            gap = gap.max(libm::hypot(start[0] - end[0], start[1] - end[1]));
            segments[k].to = start;
        }
        if gap.is_nan() || gap > off_plane {
            return Err(format!("its ends are {gap:.2e} mm apart"));
        }
        segments.retain(|segment| segment.from != segment.to);
        let area: f64 = segments.iter().map(Segment::area).sum();
        if area == 0.0 || area.is_nan() || segments.len() < 2 {
            return Err("it has no area".to_owned());
        }
        if area < 0.0 {
            segments = segments.iter().rev().map(Segment::reversed).collect();
        }
        let most = |of: fn(&Run) -> f64| runs.iter().map(of).fold(0.0, f64::max);
        let length: f64 = segments.iter().map(Segment::length).sum();
        let exact = runs.iter().all(|run| run.measured.is_none());
        // An end that is moved takes its segment along: an arc is no more than twice as long as its chord. A line is longer
        // than its shadow by what it rises at most; of a whole turn the length changes by 2 pi times what its axes do.
        let moved: f64 = runs
            .iter()
            .map(|run| run.measured.unwrap_or(run.off + run.round))
            .sum();
        #[allow(clippy::cast_precision_loss)]
        let ends = segments.len() as f64;
        Ok(PlaneContour {
            distance: most(|run| run.distance) + off + gap + ROUNDING * self.size,
            exact,
            length_error: 8.0 * (ends * gap + moved) + ROUNDING * length,
            segments,
        })
    }

    /// Returns one piece of a curve.
    fn run(&self, rail: &Rail, within: f64) -> Result<Run, String> {
        let words = |error: torse_geometry::GeometryError| error.to_string();
        if let Some(run) = self.line(rail).or_else(|| self.arc(rail)) {
            return Ok(run);
        }
        let within = POLYGON * within;
        let corners = rail.polygon(within).map_err(words)?;
        let heights = corners.iter().map(|corner| self.height(corner).abs());
        let off = heights.fold(0.0, f64::max);
        let points: Vec<[f64; 2]> = corners.iter().map(|corner| self.place(corner)).collect();
        let (segments, distance) = fitted_run(&points, within);
        let length: f64 = segments.iter().map(Segment::length).sum();
        let exact = rail.length(1e-3 * within).map_err(words)?;
        Ok(Run {
            segments,
            off,
            round: 0.0,
            distance: within + distance,
            measured: Some((exact - length).abs() + within),
        })
    }

    fn line(&self, rail: &Rail) -> Option<Run> {
        let RailCurve::Plain(curve) = rail.curve() else {
            return None;
        };
        let [from, to] = curve.points() else {
            return None;
        };
        let off = self.height(from).abs().max(self.height(to).abs());
        Some(Run {
            segments: vec![Segment::line(self.place(from), self.place(to))],
            off,
            round: 0.0,
            distance: 0.0,
            measured: None,
        })
    }

    /// Returns the arc of a circle in the plane; `None` of any other curve.
    fn arc(&self, rail: &Rail) -> Option<Run> {
        let RailCurve::Elliptic(arc) = rail.curve() else {
            return None;
        };
        let [cosine, sine] = arc.axes();
        let radius = norm(cosine);
        let tilted = dot(cosine, &self.axes[2]).abs() + dot(sine, &self.axes[2]).abs();
        let oval = (norm(sine) - radius).abs() + dot(cosine, sine).abs() / radius;
        let still = arc.rise().iter().all(|c| *c == 0.0);
        let round = tilted + oval;
        // A tilted circle is an ellipse.
        if !still || round.is_nan() || round > ROUNDING.sqrt() * radius {
            return None;
        }
        let [from, to] = *arc.range();
        let quarters = (to - from).abs();
        let parts = quarters.ceil().clamp(1.0, 4.0);
        let seen = dot(&cross(cosine, sine), &self.axes[2]);
        let turn = (to - from) / parts * seen.signum();
        let bulge = libm::tan(std::f64::consts::FRAC_PI_8 * turn);
        let mut ends = Vec::new();
        let mut k = 0.0;
        while k <= parts {
            ends.push(self.place(&rail.point(k / parts).ok()?));
            k += 1.0;
        }
        let off = self.height(arc.centre()).abs() + tilted;
        let segments = ends.windows(2).map(|pair| Segment {
            from: pair[0],
            to: pair[1],
            bulge,
        });
        Some(Run {
            segments: segments.collect(),
            off,
            round,
            // The ends are moved, and arcs between them by half as much again.
            distance: 3.0 * round,
            measured: None,
        })
    }
}

/// What a piece of a curve is in the plane.
struct Run {
    segments: Vec<Segment>,
    /// No point of the piece is farther from the plane; of a fitted one, no corner of its polygon.
    off: f64,
    /// How far an arc is from that of a circle in the plane.
    round: f64,
    /// No point of the segments is farther from the shadow of the piece on the plane, nor the other way round.
    distance: f64,
    /// How far its length is off, where that is measured.
    measured: Option<f64>,
}

impl PlaneContour {
    /// Returns whether its bounds are proved.
    pub fn evidence(&self) -> PatternEvidence {
        if self.exact {
            PatternEvidence::Proved
        } else {
            PatternEvidence::Measured
        }
    }
}

/// Returns a contour in the plane of a patch where it lies on the pattern of that patch alone.
///
/// # Errors
/// In words: a pattern without corners.
pub fn on_pattern(flat: &FlatPattern, contour: &PlaneContour) -> Result<PatternContour, String> {
    let corner = |x: f64, v: f64| flat.flatten(PatternPlace { piece: 0, x, v });
    let (Some(from), Some(along), Some(away)) =
        (corner(0.0, 0.0), corner(0.0, 1.0), corner(1.0, 0.0))
    else {
        return Err("the pattern has no corners".to_owned());
    };
    let less = |a: [f64; 2]| [a[0] - from[0], a[1] - from[1]];
    let (ruling, rail) = (less(along), less(away));
    let length = libm::hypot(ruling[0], ruling[1]);
    let second = [ruling[0] / length, ruling[1] / length];
    // The patch lies to the right of its first ruling, or the pattern shows its other face.
    let mirrored = rail[0] * second[1] - rail[1] * second[0] < 0.0;
    let sign = if mirrored { -1.0 } else { 1.0 };
    let first = [sign * second[1], -sign * second[0]];
    let place = |[x, y]: [f64; 2]| [0, 1].map(|i| from[i] + x * first[i] + y * second[i]);
    let mut segments: Vec<Segment> = contour
        .segments
        .iter()
        .map(|segment| Segment {
            from: place(segment.from),
            to: place(segment.to),
            bulge: sign * segment.bulge,
        })
        .collect();
    if mirrored {
        segments = segments.iter().rev().map(Segment::reversed).collect();
    }
    let reach = contour
        .segments
        .iter()
        .map(|segment| libm::hypot(segment.from[0], segment.from[1]));
    let reach = reach.fold(0.0, f64::max);
    // The corner and the direction of the ruling are off by what the pattern is; its own bound allows for one of them.
    let point = flat.errors().point;
    let distance = contour.distance + 2.0 * point * reach / length;
    let around: f64 = segments.iter().map(Segment::length).sum();
    Ok(PatternContour {
        area_error: distance * (2.0 * around + std::f64::consts::PI * distance),
        length_error: contour.length_error + ROUNDING * around,
        evidence: contour.evidence(),
        distance,
        segments,
    })
}

fn lerp(from: &Point, to: &Point, share: f64) -> Point {
    torse_geometry::vector::lerp(from, to, &share)
}
