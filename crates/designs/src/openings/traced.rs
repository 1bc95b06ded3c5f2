//! The curves of openings as fine polygons on the pattern, with bounds.

use super::MarkedPatch;
use crate::design::{MarkedOpening, NamedCurve, ParameterSide};
use crate::position::position;
use torse_geometry::pattern::PatternPlace;
use torse_geometry::prelude::{
    PiercingReach, Point, Sheet, SheetArc, SheetTracer, SweptEdge, TraceError,
};

/// The part of the tolerance of an outline that a polygon may take.
const POLYGON: f64 = 0.02;
/// What turns by less, in radians, is no corner.
const CORNER: f64 = 0.02;
/// Nor is what turns by no more than this times as much as its neighbours.
const SHARPER: f64 = 4.0;

/// A closed polygon on the pattern.
pub struct FinePolygon {
    /// Its corners, the first not repeated.
    pub points: Vec<[f64; 2]>,
    /// Which of them are corners of the curve, ascending.
    pub corners: Vec<usize>,
    /// No point of it is farther from the curve, but for the error of the pattern.
    pub distance: f64,
}

/// Returns the polygons of an opening.
///
/// # Errors
/// In words, why it cannot be had.
pub fn polygons(
    marked: &MarkedPatch<'_>,
    opening: &MarkedOpening,
) -> Result<Vec<FinePolygon>, String> {
    let within = POLYGON * marked.design.tolerances.outline;
    match opening {
        MarkedOpening::OnSheet { curve, at, angle } => {
            Ok(vec![on_sheet(marked, curve, *at, *angle, within)?])
        }
        MarkedOpening::OnParameters(sides) => Ok(vec![on_parameters(marked, sides, within)?]),
        MarkedOpening::InSpace { curve, along } => in_space(marked, curve, *along, within),
        MarkedOpening::Passed { patches, .. } => {
            let all = patches.iter();
            let through: Vec<&Sheet> = all
                .filter_map(|index| Some(&marked.design.patches.get(*index)?.sheet))
                .collect();
            pierced(marked, &through, PiercingReach::Ruling, within)
        }
    }
}

/// Returns the polygon of a plane curve about a place.
fn on_sheet(
    marked: &MarkedPatch<'_>,
    curve: &NamedCurve,
    [u, v]: [f64; 2],
    angle: f64,
    within: f64,
) -> Result<FinePolygon, String> {
    let piece = position(marked.flat, marked.patch);
    let flat = |v: f64| {
        let place = PatternPlace {
            piece: piece?,
            x: u,
            v,
        };
        marked.flat.flatten(place)
    };
    let (Some(origin), Some(from), Some(to)) = (flat(v), flat(0.0), flat(1.0)) else {
        return Err(format!("[{u}, {v}] is outside the patch"));
    };
    let ruling = [to[0] - from[0], to[1] - from[1]];
    let turn = libm::atan2(ruling[1], ruling[0]) + angle;
    let (sine, cosine) = libm::sincos(turn);
    let place = |[x, y, _]: Point| {
        [
            origin[0] + cosine * x - sine * y,
            origin[1] + sine * x + cosine * y,
        ]
    };
    let rails = curve.curve.rails().map_err(|error| error.to_string())?;
    let mut runs = Vec::with_capacity(rails.len());
    let mut reach = 0.0_f64;
    for rail in &rails {
        let corners = rail.polygon(within).map_err(|error| error.to_string())?;
        let far = corners.iter().map(|[x, y, _]| libm::hypot(*x, *y));
        reach = reach.max(far.fold(0.0, f64::max) + within);
        runs.push(corners.into_iter().map(place).collect());
    }
    // The ruling is turned by what its ends are off, and what is drawn along it with it.
    let turned = 2.0 * marked.flat.errors().point / libm::hypot(ruling[0], ruling[1]);
    Ok(joined(runs, within + 2.0 * turned * reach))
}

/// Returns the polygon of sides that are straight in the parameters.
fn on_parameters(
    marked: &MarkedPatch<'_>,
    sides: &[ParameterSide],
    within: f64,
) -> Result<FinePolygon, String> {
    let sheets = sheets(marked);
    let tracer = SheetTracer::new(&sheets).map_err(|error| error.to_string())?;
    let mut runs = Vec::with_capacity(sides.len());
    let mut distance = 0.0_f64;
    for side in sides {
        let sheet = marked.number.checked_add_signed(side.after);
        let [from, to] = side.ends;
        let arcs = tracer.straight(sheet.unwrap_or(usize::MAX), from, to);
        let arcs = arcs.map_err(|error| error.to_string())?;
        let (points, off) = carried(marked, &arcs, within)?;
        distance = distance.max(off);
        runs.push(points);
    }
    Ok(joined(runs, distance))
}

/// Returns the polygon of a curve that lies on the piece, or is thrown on it.
fn in_space(
    marked: &MarkedPatch<'_>,
    curve: &NamedCurve,
    along: Option<Point>,
    within: f64,
) -> Result<Vec<FinePolygon>, String> {
    let Some(along) = along else {
        let sheets = sheets(marked);
        let tracer = SheetTracer::new(&sheets).map_err(|error| error.to_string())?;
        let arcs = tracer.lying(&curve.curve, marked.design.tolerances.gap);
        let arcs = arcs.map_err(|error| error.to_string())?;
        return Ok(vec![followed(marked, &arcs, within)?]);
    };
    let rails = curve.curve.rails().map_err(|error| error.to_string())?;
    let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
    let lines = rails.iter().map(|rail| Sheet::cylinder(rail, along, edges));
    let lines: Vec<Sheet> = lines
        .collect::<Result<_, _>>()
        .map_err(|error| error.to_string())?;
    let lines: Vec<&Sheet> = lines.iter().collect();
    pierced(marked, &lines, PiercingReach::First, within)
}

/// Returns the polygons in which rulings pierce the piece.
fn pierced(
    marked: &MarkedPatch<'_>,
    through: &[&Sheet],
    reach: PiercingReach,
    within: f64,
) -> Result<Vec<FinePolygon>, String> {
    let sheets = sheets(marked);
    let found = SheetTracer::new(&sheets)
        .and_then(|tracer| tracer.pierced(through, reach, marked.design.tolerances.gap));
    let found = found.map_err(|error: TraceError| error.to_string())?;
    let all = found.iter().map(|arcs| followed(marked, arcs, within));
    all.collect()
}

/// Returns the sheets of the piece.
fn sheets<'a>(marked: &MarkedPatch<'a>) -> Vec<&'a Sheet> {
    let patches = marked.piece.patches.iter();
    patches
        .filter_map(|index| Some(&marked.design.patches.get(*index)?.sheet))
        .collect()
}

/// Returns the closed polygon of arcs.
fn followed(
    marked: &MarkedPatch<'_>,
    arcs: &[SheetArc],
    within: f64,
) -> Result<FinePolygon, String> {
    let mut runs = Vec::with_capacity(arcs.len());
    let mut distance = 0.0_f64;
    for arc in arcs {
        let (points, off) = carried(marked, std::slice::from_ref(arc), within)?;
        distance = distance.max(off);
        runs.push(points);
    }
    Ok(joined(runs, distance))
}

/// Returns points on the pattern along arcs, their ends included, and how far chords between them are from the curve.
fn carried(
    marked: &MarkedPatch<'_>,
    arcs: &[SheetArc],
    within: f64,
) -> Result<(Vec<[f64; 2]>, f64), String> {
    let mut points = Vec::new();
    let mut distance = 0.0_f64;
    for arc in arcs {
        let patch = marked.piece.patches.get(arc.sheet());
        let patch = patch.and_then(|index| marked.design.patches.get(*index));
        let piece = patch.and_then(|patch| position(marked.flat, patch));
        let (Some(piece), Some(chords)) = (piece, arc.chords(within)) else {
            return Err("its curve is not followed within the tolerance `outline`".to_owned());
        };
        distance = distance.max(arc.off() + arc.chord_distance(chords));
        let first = u32::from(!points.is_empty());
        for k in first..=chords {
            let [x, v] = arc.place(f64::from(k) / f64::from(chords));
            let point = marked.flat.flatten(PatternPlace { piece, x, v });
            points.push(point.ok_or_else(|| format!("[{x}, {v}] is outside the patch"))?);
        }
    }
    Ok((points, distance))
}

/// Returns the closed polygon of runs, of which each ends where the next begins but for what is no distance on a pattern:
/// that counts too. Corners are where runs meet at an angle.
fn joined(runs: Vec<Vec<[f64; 2]>>, distance: f64) -> FinePolygon {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let (mut ends, mut apart) = (Vec::new(), 0.0_f64);
    let count = runs.len();
    for (k, run) in runs.iter().enumerate() {
        let next = runs.get((k + 1) % count).and_then(|next| next.first());
        if let (Some(end), Some(start)) = (run.last(), next) {
            apart = apart.max(crate::polygon::distance(*end, *start));
        }
        ends.push(points.len());
        points.extend(run.iter().take(run.len().saturating_sub(1)));
    }
    if points.len() < 3 {
        return FinePolygon {
            points,
            corners: Vec::new(),
            distance,
        };
    }
    let turn = |k: usize| -> f64 {
        let count = points.len();
        let at = |k: usize| points.get(k % count).copied().unwrap_or_default();
        let [a, b, c] = [at(k + count - 1), at(k), at(k + 1)];
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        libm::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]).abs()
    };
    // How much a run turns beside its ends: a line not at all.
    let lengths: Vec<usize> = runs.iter().map(Vec::len).collect();
    let beside = |k: usize| {
        let before = lengths.get((k + count - 1) % count).copied().unwrap_or(0);
        let own = lengths.get(k).copied().unwrap_or(0);
        let at = ends.get(k).copied().unwrap_or(0);
        let inner = |length: usize, at: usize| if length > 2 { turn(at) } else { 0.0 };
        inner(before, at + points.len() - 1).max(inner(own, at + 1))
    };
    let is_corner = |(k, at): &(usize, &usize)| turn(**at) > CORNER + SHARPER * beside(*k);
    let corners: Vec<usize> = ends
        .iter()
        .enumerate()
        .filter(is_corner)
        .map(|(_, at)| *at)
        .collect();
    FinePolygon {
        corners,
        distance: distance + apart,
        points,
    }
}
