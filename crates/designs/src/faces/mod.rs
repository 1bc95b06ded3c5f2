//! A design from a file of another program: each face with rulings between two of its edges is a patch.

mod around;
mod edge_rails;
mod loops;
mod plane;
mod round;
mod runs;
mod sectors;
mod straight;

use crate::DesignUnit;
use crate::audit::FaceAudit;
use crate::bending::Bending;
use crate::design::{
    Chain, ChainLayout, Design, DesignView, LeftOut, Mark, NamedCurve, Patch, PatchEnds,
    Tolerances, USUAL_RULINGS,
};
use crate::error::DesignError;
use around::{between_planes, has_opening_over_seam};
use loops::sheets_with_openings;
use plane::{plane_of_net, plane_sheet};
use round::RoundFace;
use sectors::in_sectors;
use std::path::Path;
use straight::{is_straight, rounding_note, spline_rails};
use torse_exchange::{FaceBorder, Imported, ImportedFace, SurfaceShape};
use torse_geometry::prelude::{
    GeometryError, PiecewiseRail, Point, Rail, RailCurve, Sheet, SweptEdge,
};
use torse_geometry::vector::{cross, dot, norm, sub};
use torse_geometry::{AffineMap, Coordinate, Rational};

/// Points of a file that are nearer than this share of the size of a face are one, unless it states an uncertainty.
const SAME: f64 = 1e-6;
/// Rulings at which a patch is compared with the surface of its face.
const SAMPLES: u32 = 9;

/// What is said of a face of which not all edges are there.
const NOT_READ: &str = "a part of its border is not read";

/// What the edges of a face are to its rulings.
enum Border {
    /// Rulings run from the one to the other.
    Between([PiecewiseRail; 2]),
    /// Rulings run to a point.
    Apex(PiecewiseRail, Point),
}

/// Returns the design of the faces of a file.
///
/// # Errors
/// [`DesignError::NoFace`] where no face has rulings between its edges, with the reason for each.
pub fn design_of_faces(path: &str, imported: &Imported) -> Result<Design, DesignError> {
    let name = Path::new(path).file_stem().unwrap_or_default();
    let name = name.to_string_lossy().into_owned();
    let mut design = Design {
        title: name.clone(),
        name,
        unit: DesignUnit::Millimetre,
        metal: None,
        material: None,
        bending: Bending::USUAL,
        tolerances: Tolerances::USUAL,
        view: DesignView {
            angles: None,
            rulings: USUAL_RULINGS,
        },
        patches: Vec::new(),
        chains: Vec::new(),
        notes: vec![format!(
            "{path}: {}, {}",
            imported.kind,
            imported.unit.above_millimetres()
        )],
        left_out: Vec::new(),
        surfaces: Vec::new(),
        covers: Vec::new(),
        points: Vec::new(),
        seams: Vec::new(),
        allowance: 0.0,
    };
    let mut left_out: Vec<LeftOut> = Vec::new();
    for face in &imported.faces {
        match sheets_of_face(face, imported) {
            Ok(found) => add(&mut design, face, found),
            Err(reason) => {
                let verdict = FaceAudit::of_surface(face).map(|audit| audit.words);
                let verdict =
                    verdict.map_or(String::new(), |words| format!(" (developable: {words})"));
                left_out.push(LeftOut {
                    name: face.name.clone(),
                    reason: format!("{reason}{verdict}"),
                });
            }
        }
    }
    left_out.extend(imported.lost().map(|(words, count)| LeftOut {
        name: format!("{count} {words}"),
        reason: "it is not read".to_owned(),
    }));
    if design.patches.is_empty() {
        let reasons = left_out.iter();
        return Err(DesignError::NoFace {
            path: path.to_owned(),
            reasons: reasons
                .map(|face| format!("{}: {}", face.name, face.reason))
                .collect(),
        });
    }
    design.left_out = left_out;
    Ok(design)
}

/// Returns how many loops of a face are openings; `None` where it is not unrolled.
pub(crate) fn openings_of_face(face: &ImportedFace, imported: &Imported) -> Option<usize> {
    let found = sheets_of_face(face, imported);
    found.ok().map(|found| found.openings.len())
}

/// Returns what is unrolled of a face, or why nothing is.
fn sheets_of_face(face: &ImportedFace, imported: &Imported) -> Result<FaceSheets, String> {
    match face.border {
        FaceBorder::NotRead => return Err(NOT_READ.to_owned()),
        FaceBorder::OwnOfSurface => {
            return sheets_with_openings(face, imported, |face| sheets(face, imported));
        }
        FaceBorder::Loop(_) | FaceBorder::Unstated => {}
    }
    if let SurfaceShape::Plane(frame) = &face.surface {
        return plane_sheet(face, frame, imported);
    }
    let found = sheets_with_openings(face, imported, |face| sheets(face, imported));
    match (&found, &face.surface) {
        // One that is plane all the same, within edges between which its rulings do not run.
        (Err(_), SurfaceShape::Spline(surface)) => match plane_of_net(surface) {
            Some(frame) => plane_sheet(face, &frame, imported),
            None => found,
        },
        (Err(_), SurfaceShape::Cylinder(..) | SurfaceShape::Cone(..)) => {
            let round = RoundFace::new(face, imported)?;
            between_planes(&round).or_else(|_| in_sectors(round))
        }
        (Ok(sheets), SurfaceShape::Cylinder(..) | SurfaceShape::Cone(..))
            if !sheets.openings.is_empty() =>
        {
            match RoundFace::new(face, imported) {
                Ok(round) if has_opening_over_seam(&round) => between_planes(&round).or(found),
                _ => found,
            }
        }
        _ => found,
    }
}

/// What is unrolled of a face.
struct FaceSheets {
    sheets: Vec<Sheet>,
    /// Whether the last meets the first.
    closed: bool,
    /// What was made equal.
    note: Option<String>,
    /// What bounds it, where its sheet reaches beyond.
    border: Option<NamedCurve>,
    /// The loops that do not bound it.
    openings: Vec<Mark>,
}

fn words(error: GeometryError) -> String {
    error.to_string()
}

fn add(design: &mut Design, face: &ImportedFace, found: FaceSheets) {
    let FaceSheets {
        sheets,
        closed,
        note,
        mut border,
        mut openings,
    } = found;
    let first = design.patches.len();
    let several = sheets.len() > 1;
    let joints = sheets.len().saturating_sub(1);
    for (index, sheet) in sheets.into_iter().enumerate() {
        let name = if several {
            format!("{}.{}", face.name, index + 1)
        } else {
            face.name.clone()
        };
        design.patches.push(Patch {
            name,
            kind: "face",
            sheet,
            border: border.take(),
            ends: PatchEnds {
                planes: None,
                rails: None,
                part: [0.0, 1.0],
            },
            marks: std::mem::take(&mut openings),
            bend: false,
            edges: Vec::new(),
            allowances: Vec::new(),
            notes: note.iter().filter(|_| index == 0).cloned().collect(),
        });
    }
    if several {
        design.chains.push(Chain {
            name: face.name.clone(),
            patches: (first..design.patches.len()).collect(),
            continuity: None,
            closed,
            layout: ChainLayout::Attached,
            radii: vec![None; joints],
        });
    }
}

/// Returns the sheets of a face, or why it has none.
fn sheets(face: &ImportedFace, imported: &Imported) -> Result<FaceSheets, String> {
    let border = border(face, imported)?;
    match border {
        Border::Apex(rail, apex) => {
            let tolerance = tolerance(imported, &rail, &rail).map_err(words)?;
            let edges = [SweptEdge::Share(1.0), SweptEdge::Share(0.0)];
            let mut cones = Vec::new();
            for piece in rail.rails().map_err(words)? {
                cones.push(Sheet::cone(&piece, apex, edges).map_err(words)?);
            }
            on_surface(face, &cones, tolerance)?;
            Ok(FaceSheets {
                sheets: cones,
                closed: is_closed(&rail, tolerance).map_err(words)?,
                note: None,
                border: None,
                openings: Vec::new(),
            })
        }
        Border::Between([first, second]) => {
            let tolerance = tolerance(imported, &first, &second).map_err(words)?;
            let own = own_rails(&face.surface).map_err(words)?;
            let [first, second] = match own {
                // The surface says itself between which curves its rulings run.
                Some(own) => match crossed(&own).map_err(words)? {
                    Some(others) => untrimmed(&[&first, &second], own, tolerance)
                        .or_else(|_| untrimmed(&[&first, &second], others, tolerance))?,
                    None => untrimmed(&[&first, &second], own, tolerance)?,
                },
                None => [first, second],
            };
            let closed = is_closed(&first, tolerance).map_err(words)?
                && is_closed(&second, tolerance).map_err(words)?;
            let pair = first.common_refinement(&second).map_err(words)?;
            let [p, q] = [
                pair[0].rails().map_err(words)?,
                pair[1].rails().map_err(words)?,
            ];
            let pairs: Vec<[Rail; 2]> = p.into_iter().zip(q).map(|(p, q)| [p, q]).collect();
            let (sheets, note) = match swept(&face.surface, &pairs, tolerance).map_err(words)? {
                Some((sheets, off)) => {
                    let note = format!(
                        "made over its first edge: the second one is that of the file but for {off:.1e} mm, measured"
                    );
                    (sheets, Some(note))
                }
                None => {
                    let ruled = pairs.into_iter().map(|[p, q]| Sheet::ruled(p, q));
                    (
                        ruled.collect(),
                        rounding_note(&face.surface).map_err(words)?,
                    )
                }
            };
            on_surface(face, &sheets, tolerance)?;
            Ok(FaceSheets {
                sheets,
                closed,
                note,
                border: None,
                openings: Vec::new(),
            })
        }
    }
}

/// Of a cone or cylinder between two edges that are images of one another along its rulings: the cones or cylinders
/// over the first edge, which are exact whatever the rounding of the numbers in the file, and how far the second edge
/// is from theirs, as samples show. `None` of any other face.
fn swept(
    surface: &SurfaceShape,
    pairs: &[[Rail; 2]],
    tolerance: f64,
) -> Result<Option<(Vec<Sheet>, f64)>, GeometryError> {
    let Some([p, q]) = pairs.first() else {
        return Ok(None);
    };
    let [start, end] = [p.point(0.0)?, q.point(0.0)?];
    let along = |base: &Point, axis: &Point, share: f64| -> Point {
        std::array::from_fn(|k| base[k] + share * axis[k])
    };
    // Where the second edge should be, and the sheet over the first one.
    type Image = Box<dyn Fn(&Point) -> Point>;
    type Swept = Box<dyn Fn(&Rail) -> Result<Sheet, GeometryError>>;
    let (image, sheet): (Image, Swept) = match surface {
        SurfaceShape::Cone(frame, radius, angle) => {
            let apex = along(&frame.origin, &frame.axis, -radius / libm::tan(*angle));
            let share = norm(&sub(&end, &apex)) / norm(&sub(&start, &apex));
            let edges = [SweptEdge::Share(1.0), SweptEdge::Share(share)];
            (
                Box::new(move |p| along(&apex, &sub(p, &apex), share)),
                Box::new(move |rail| Sheet::cone(rail, apex, edges)),
            )
        }
        SurfaceShape::Cylinder(frame, _) => {
            let height = dot(&sub(&end, &start), &frame.axis);
            let direction = frame.axis.map(|c| c * height);
            let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
            (
                Box::new(move |p| along(p, &direction, 1.0)),
                Box::new(move |rail| Sheet::cylinder(rail, direction, edges)),
            )
        }
        _ => return Ok(None),
    };
    let (mut sheets, mut farthest) = (Vec::with_capacity(pairs.len()), 0.0_f64);
    for [p, q] in pairs {
        for k in 0..=SAMPLES {
            let x = f64::from(k) / f64::from(SAMPLES);
            let off = norm(&sub(&q.point(x)?, &image(&p.point(x)?)));
            if off.is_nan() || off > tolerance {
                return Ok(None);
            }
            farthest = farthest.max(off);
        }
        sheets.push(sheet(p)?);
    }
    Ok(Some((sheets, farthest)))
}

/// Returns the distance within which points are one.
fn tolerance(
    imported: &Imported,
    first: &PiecewiseRail,
    second: &PiecewiseRail,
) -> Result<f64, GeometryError> {
    let mut points = Vec::new();
    for rail in [first, second] {
        for x in [0.0, 0.5, 1.0] {
            points.push(rail.point(x)?);
        }
    }
    let reach = points
        .iter()
        .flat_map(|a| points.iter().map(|b| norm(&sub(a, b))));
    let size = reach.fold(0.0, f64::max);
    Ok((SAME * size).max(imported.uncertainty.unwrap_or(0.0)))
}

fn is_closed(rail: &PiecewiseRail, tolerance: f64) -> Result<bool, GeometryError> {
    Ok(norm(&sub(&rail.point(0.0)?, &rail.point(1.0)?)) <= tolerance)
}

/// Returns the border that a surface has of itself.
fn own_border(surface: &SurfaceShape) -> Result<Border, String> {
    if let SurfaceShape::Spline(spline) = surface {
        let sides = spline_rails(spline).map_err(words)?;
        for [rail, other] in sides.iter().flat_map(|[a, b]| [[a, b], [b, a]]) {
            let mut points = other.points().iter();
            let apex = points.next().filter(|first| points.all(|p| p == *first));
            if let Some(apex) = apex {
                let rail = PiecewiseRail::spline(rail).map_err(words)?;
                return Ok(Border::Apex(
                    rail,
                    apex.each_ref().map(Coordinate::approximate),
                ));
            }
        }
    }
    if let SurfaceShape::Extruded(curve, vector) = surface {
        let mut shift = AffineMap::stretch(&Rational::from(1));
        shift.shift = vector.map(torse_geometry::exact);
        let rails = [curve.rail(), curve.mapped(&shift).rail()].map(|rail| rail.map_err(words));
        let [first, second] = rails;
        return Ok(Border::Between([first?, second?]));
    }
    let rails = own_rails(surface).map_err(words)?;
    rails.map(Border::Between).ok_or_else(|| {
        let kind = surface.words();
        format!("the file gives it no outer border, and a {kind} surface has none of its own between rulings")
    })
}

/// Returns two edges between which rulings may run, passed side by side.
fn border(face: &ImportedFace, imported: &Imported) -> Result<Border, String> {
    match face.border {
        FaceBorder::OwnOfSurface => return own_border(&face.surface),
        FaceBorder::NotRead | FaceBorder::Loop(_) | FaceBorder::Unstated => {}
    }
    let shape = |index: usize| imported.curves.get(index).map(|curve| &curve.shape);
    let all: Vec<(usize, bool)> = face.loops.iter().flatten().copied().collect();
    // The seam of a closed surface is passed twice.
    let times = |edge: usize| all.iter().filter(|(other, _)| *other == edge).count();
    let kept: Vec<(usize, bool)> = all
        .iter()
        .filter(|(edge, _)| times(*edge) == 1)
        .copied()
        .collect();
    let straight = |k: usize| {
        let edge = kept.get(k).and_then(|(edge, _)| shape(*edge));
        edge.is_some_and(|edge| is_straight(edge, imported))
    };
    let rail = |k: usize| -> Result<PiecewiseRail, String> {
        let missing = || "an edge is missing".to_owned();
        let (edge, forward) = kept.get(k).ok_or_else(missing)?;
        let shape = shape(*edge).ok_or_else(missing)?;
        let shape = if *forward {
            shape.clone()
        } else {
            shape.reversed()
        };
        shape.rail().map_err(words)
    };
    let between = |a: usize, b: usize| -> Result<Border, String> {
        let second = rail(b)?.reversed().map_err(words)?;
        Ok(Border::Between([rail(a)?, second]))
    };
    match (kept.len(), face.loops.len()) {
        (1, _) => {
            // A cone whose seam leads from its edge to its apex.
            let base = rail(0)?;
            let start = base.point(0.0).map_err(words)?;
            let seam = all.iter().find(|(edge, _)| times(*edge) == 2);
            let seam = seam.and_then(|(edge, _)| shape(*edge));
            let Some(seam) = seam else {
                return Err("one edge and no seam: it has no rulings between edges".to_owned());
            };
            let seam = seam.rail().map_err(words)?;
            let ends = [
                seam.point(0.0).map_err(words)?,
                seam.point(1.0).map_err(words)?,
            ];
            let away = |point: &Point| norm(&sub(point, &start));
            let apex = if away(&ends[0]) > away(&ends[1]) {
                ends[0]
            } else {
                ends[1]
            };
            Ok(Border::Apex(base, apex))
        }
        (2, _) => between(0, 1),
        (3, 1) => {
            let base = (0..3).find(|k| straight((k + 1) % 3) && straight((k + 2) % 3));
            let Some(base) = base else {
                return Err("three edges of which not two are straight".to_owned());
            };
            let apex = rail((base + 1) % 3)?.point(1.0).map_err(words)?;
            Ok(Border::Apex(rail(base)?, apex))
        }
        (4, 1) if straight(1) && straight(3) => between(0, 2),
        (4, 1) if straight(0) && straight(2) => between(1, 3),
        (count, loops) => Err(format!(
            "{count} edges in {loops} loops: only faces between two edges and two rulings are unrolled"
        )),
    }
}

/// Returns the curves between which a surface says that its rulings run.
fn own_rails(surface: &SurfaceShape) -> Result<Option<[PiecewiseRail; 2]>, GeometryError> {
    match surface {
        SurfaceShape::Ruled(pair) => {
            let [first, second] = pair.as_ref();
            Ok(Some([first.rail()?, second.rail()?]))
        }
        SurfaceShape::Spline(surface) => match spline_rails(surface)? {
            Some([first, second]) => Ok(Some([
                PiecewiseRail::spline(&first)?,
                PiecewiseRail::spline(&second)?,
            ])),
            None => Ok(None),
        },
        _ => Ok(None),
    }
}

/// Returns the other two curves between which the rulings of a surface run as well, where both of these are straight: those from
/// start to start and from end to end.
fn crossed(own: &[PiecewiseRail; 2]) -> Result<Option<[PiecewiseRail; 2]>, GeometryError> {
    for rail in own {
        let straight = rail.single()?.is_some_and(
            |rail| matches!(rail.curve(), RailCurve::Plain(curve) if curve.degree() == 1),
        );
        if !straight {
            return Ok(None);
        }
    }
    let side = |x: f64| -> Result<PiecewiseRail, GeometryError> {
        let ends = [own[0].point(x)?, own[1].point(x)?];
        Ok(PiecewiseRail::from(Rail::bezier(&ends)?))
    };
    Ok(Some([side(0.0)?, side(1.0)?]))
}

/// Returns the curves of the surface, if the edges are these curves: else the face is trimmed.
fn untrimmed(
    edges: &[&PiecewiseRail; 2],
    own: [PiecewiseRail; 2],
    tolerance: f64,
) -> Result<[PiecewiseRail; 2], String> {
    let same = |a: &PiecewiseRail, b: &PiecewiseRail| -> Result<bool, String> {
        for k in 0..=SAMPLES {
            let x = f64::from(k) / f64::from(SAMPLES);
            let (p, q) = (a.point(x).map_err(words)?, b.point(x).map_err(words)?);
            if norm(&sub(&p, &q)) > tolerance {
                return Ok(false);
            }
        }
        Ok(true)
    };
    let turned = [
        own[0].reversed().map_err(words)?,
        own[1].reversed().map_err(words)?,
    ];
    let mut found = false;
    for [p, q] in [[&own[0], &own[1]], [&turned[0], &turned[1]]] {
        for [p, q] in [[p, q], [q, p]] {
            found = found || (same(edges[0], p)? && same(edges[1], q)?);
        }
    }
    if found {
        return Ok(own);
    }
    Err("its edges are not the curves between which its rulings run: it is trimmed".to_owned())
}

/// Returns whether rulings of these sheets lie on the surface of a face, as far as samples show.
fn on_surface(face: &ImportedFace, sheets: &[Sheet], tolerance: f64) -> Result<(), String> {
    let is_own = match &face.surface {
        SurfaceShape::Ruled(_) => true,
        SurfaceShape::Spline(surface) => {
            surface.degrees.contains(&1) || spline_rails(surface).map_err(words)?.is_some()
        }
        _ => false,
    };
    if is_own {
        // Its own curves were taken.
        return Ok(());
    }
    for sheet in sheets {
        for k in 0..=SAMPLES {
            let u = f64::from(k) / f64::from(SAMPLES);
            for v in [0.25, 0.5, 0.75] {
                let point = sheet.point(u, v).map_err(words)?;
                let off = match &face.surface {
                    SurfaceShape::Plane(frame) => {
                        dot(&sub(&point, &frame.origin), &frame.axis).abs()
                    }
                    SurfaceShape::Cylinder(frame, radius) => {
                        let [_, out] = polar(&point, &frame.origin, &frame.axis);
                        (out - radius).abs()
                    }
                    SurfaceShape::Cone(frame, radius, angle) => {
                        let [along, out] = polar(&point, &frame.origin, &frame.axis);
                        (out - (radius + along * libm::tan(*angle)).abs()).abs() * libm::cos(*angle)
                    }
                    SurfaceShape::Extruded(_, vector) => {
                        let [p, q] = sheet.ruling(u).map_err(words)?;
                        norm(&cross(&sub(&q, &p), vector)) / norm(vector)
                    }
                    _ => {
                        return Err(format!(
                            "the rulings of a {} surface are not known",
                            face.surface.words()
                        ));
                    }
                };
                if off.is_nan() || off > 4.0 * tolerance {
                    return Err(format!(
                        "lines between its edges at equal parameters leave its surface by {off:.2e} mm: no rulings"
                    ));
                }
            }
        }
    }
    Ok(())
}

/// Returns the way along an axis and the distance from it.
fn polar(point: &Point, origin: &Point, axis: &Point) -> [f64; 2] {
    let arm = sub(point, origin);
    [dot(&arm, axis), norm(&cross(&arm, axis))]
}
