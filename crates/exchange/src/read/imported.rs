//! What was read: curves, faces and meshes with names and the places they come from, in millimetres.

use super::{FileKind, FilePlace, UnitSource};
use crate::mesh::Mesh;
use torse_algebra::Rational;
use torse_geometry::curve::{
    EllipticHelix, EndCondition, Spacing, Spline, interpolate, interpolate_closed,
};
use torse_geometry::sheet::PiecewiseRail;
use torse_geometry::surface::BezierNet;
use torse_geometry::vector::unit;
use torse_geometry::{AffineMap, Coordinate, GeometryError};

/// What a file holds, whatever its format.
///
/// Invariants: lengths are millimetres; names of curves, of faces and of meshes are unique among their kind; an edge of
/// a face names a curve of the list.
#[derive(Debug, Clone, PartialEq)]
pub struct Imported {
    /// The format.
    pub kind: FileKind,
    /// The unit of the file, and who says so.
    pub unit: UnitSource,
    /// The distance, in millimetres, within which the file says that its points are known.
    pub uncertainty: Option<f64>,
    /// The curves: wires of a drawing, edges of faces.
    pub curves: Vec<ImportedCurve>,
    /// The faces of surfaces.
    pub faces: Vec<ImportedFace>,
    /// The meshes.
    pub meshes: Vec<ImportedMesh>,
    /// Kinds of entities that were passed over, with their numbers, in the order of their names.
    pub passed_over: Vec<(String, usize)>,
    /// Where the first of each of these kinds stands, in the same order, as far as the format tells.
    pub passed_places: Vec<FilePlace>,
}

/// A curve of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedCurve {
    /// Its name, unique in the file.
    pub name: String,
    /// Where it stands.
    pub place: FilePlace,
    /// The layer or group that it is in; empty where there is none.
    pub layer: String,
    /// Its shape.
    pub shape: CurveShape,
    /// Whether it is only an edge of a face.
    pub edge: bool,
}

/// The shape of a curve.
#[derive(Debug, Clone, PartialEq)]
pub enum CurveShape {
    /// A spline; straight lines, polygons and Bezier curves are such. Exact where the text has decimals.
    Spline(Spline),
    /// An arc of an ellipse, of any angle.
    Arc(EllipticHelix),
    /// Points without a curve: through them goes the cubic spline with natural ends, a closed one where the last is the
    /// first, with the distances of the points as parameters.
    Through(Vec<[Rational; 3]>),
    /// Curves in a row.
    Row(Vec<CurveShape>),
}

impl CurveShape {
    /// The straight line between two points.
    ///
    /// # Errors
    /// [`GeometryError::Degenerate`] for one point twice.
    pub fn line(from: [Rational; 3], to: [Rational; 3]) -> Result<Self, GeometryError> {
        Spline::polyline(vec![from, to]).map(Self::Spline)
    }

    /// The pieces of the curve.
    ///
    /// # Errors
    /// What does not fit f64.
    pub fn rail(&self) -> Result<PiecewiseRail, GeometryError> {
        match self {
            Self::Spline(spline) => PiecewiseRail::spline(spline),
            Self::Arc(arc) => Ok(arc.clone().into()),
            Self::Through(points) => {
                let points: Vec<[f64; 3]> = points
                    .iter()
                    .map(|p| p.each_ref().map(Coordinate::approximate))
                    .collect();
                let closed = points.len() > 3 && points.first() == points.last();
                let found = match points.split_last() {
                    Some((_, ring)) if closed => interpolate_closed(ring, Spacing::Chord),
                    _ => interpolate(&points, Spacing::Chord, [EndCondition::Natural; 2]),
                };
                PiecewiseRail::spline(&found?.spline)
            }
            Self::Row(parts) => {
                let parts: Result<Vec<_>, _> = parts.iter().map(Self::rail).collect();
                PiecewiseRail::joined(&parts?)
            }
        }
    }

    /// The image under an affine map; exact except of arcs.
    #[must_use]
    pub fn mapped(&self, map: &AffineMap<Rational>) -> Self {
        match self {
            Self::Spline(spline) => Self::Spline(spline.mapped(map)),
            Self::Arc(arc) => Self::Arc(arc.mapped(&rounded(map))),
            Self::Through(points) => Self::Through(points.iter().map(|p| map.apply(p)).collect()),
            Self::Row(parts) => Self::Row(parts.iter().map(|part| part.mapped(map)).collect()),
        }
    }

    /// The same curve traversed backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Spline(spline) => Self::Spline(spline.reversed()),
            Self::Arc(arc) => Self::Arc(arc.reversed()),
            Self::Through(points) => Self::Through(points.iter().rev().cloned().collect()),
            Self::Row(parts) => Self::Row(parts.iter().rev().map(Self::reversed).collect()),
        }
    }

    /// What it is, in words.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Spline(spline) => match (spline.degree(), spline.breaks().len() - 1) {
                (1, 1) => "line".to_owned(),
                (1, sides) => format!("polygon of {sides} sides"),
                (_, 1) if spline.weights().is_none() => "Bezier curve".to_owned(),
                (_, 1) => "rational Bezier curve".to_owned(),
                (_, pieces) => {
                    let kind = if spline.weights().is_none() {
                        "spline"
                    } else {
                        "rational spline"
                    };
                    let closed = if spline.is_closed() { "closed " } else { "" };
                    format!("{closed}{kind} of {pieces} pieces")
                }
            },
            Self::Arc(arc) => {
                let [from, to] = *arc.range();
                let lengths = arc.axes().map(torse_geometry::vector::norm);
                let round = (lengths[0] - lengths[1]).abs() <= 1e-9 * lengths[0]
                    && torse_geometry::vector::dot(arc.axes()[0], arc.axes()[1]).abs()
                        <= 1e-9 * lengths[0] * lengths[1];
                let whole = (to - from).abs() >= 4.0;
                match (round, whole) {
                    (true, true) => "circle",
                    (true, false) => "arc",
                    (false, true) => "ellipse",
                    (false, false) => "arc of an ellipse",
                }
                .to_owned()
            }
            Self::Through(points) => format!("spline through {} points", points.len()),
            Self::Row(parts) => format!("row of {} curves", parts.len()),
        }
    }

    /// The largest degree of its splines; none of arcs alone.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        match self {
            Self::Spline(spline) => Some(spline.degree()),
            Self::Arc(_) => None,
            Self::Through(_) => Some(3),
            Self::Row(parts) => parts.iter().filter_map(Self::degree).max(),
        }
    }
}

/// An affine map on f64.
pub(super) fn rounded(map: &AffineMap<Rational>) -> AffineMap<f64> {
    let number = |q: &Rational| q.approximate();
    AffineMap {
        linear: map.linear.each_ref().map(|row| row.each_ref().map(number)),
        shift: map.shift.each_ref().map(number),
    }
}

/// A face of a file: a surface within edges.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedFace {
    /// Its name, unique in the file.
    pub name: String,
    /// Where it stands.
    pub place: FilePlace,
    /// Its surface.
    pub surface: SurfaceShape,
    /// Its edges: indices of curves, loop by loop, and whether each is passed forward.
    pub loops: Vec<Vec<(usize, bool)>>,
    /// What of it is its outer border.
    pub border: FaceBorder,
    /// Whether its normal is that of the surface.
    pub forward: bool,
}

/// What bounds a face on its outside, as far as its file says so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaceBorder {
    /// The loop of this index, as FACE_OUTER_BOUND of STEP or entity 144 of IGES with an outer curve. Of a surface that is closed,
    /// another loop may bound it too.
    Loop(usize),
    /// The border of the surface itself, as entity 144 of IGES without an outer curve, or a surface without any loop: every
    /// loop is an opening.
    OwnOfSurface,
    /// One of the loops; the file does not say which.
    Unstated,
    /// A loop, or an edge of one, is not read: those that are left do not show what bounds it.
    NotRead,
}

/// Axes of an analytic surface: a place, the main direction, a direction across it; unit vectors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceFrame {
    /// The place.
    pub origin: [f64; 3],
    /// The axis.
    pub axis: [f64; 3],
    /// Where angles begin.
    pub across: [f64; 3],
}

/// The shape of a surface.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceShape {
    /// A plane.
    Plane(SurfaceFrame),
    /// A cylinder with its radius.
    Cylinder(SurfaceFrame, f64),
    /// A cone with its radius at the place and half its angle in radians.
    Cone(SurfaceFrame, f64, f64),
    /// A sphere with its radius.
    Sphere(SurfaceFrame, f64),
    /// A torus with the radius of its circle and that of its tube.
    Torus(SurfaceFrame, f64, f64),
    /// A curve moved along a vector.
    Extruded(Box<CurveShape>, [f64; 3]),
    /// A curve turned about an axis.
    Revolved(Box<CurveShape>, SurfaceFrame),
    /// Straight lines between two curves.
    Ruled(Box<[CurveShape; 2]>),
    /// A B-spline surface.
    Spline(SplineSurface),
}

impl SurfaceShape {
    /// The image under a motion and one stretch; exact of B-splines.
    #[must_use]
    pub(super) fn moved(&self, map: &AffineMap<Rational>, factor: f64) -> Self {
        let near = rounded(map);
        let frame = |frame: &SurfaceFrame| {
            let turned = |v: &[f64; 3]| unit(&near.turn(v)).unwrap_or(*v);
            SurfaceFrame {
                origin: near.apply(&frame.origin),
                axis: turned(&frame.axis),
                across: turned(&frame.across),
            }
        };
        match self {
            Self::Plane(f) => Self::Plane(frame(f)),
            Self::Cylinder(f, r) => Self::Cylinder(frame(f), factor * r),
            Self::Cone(f, r, angle) => Self::Cone(frame(f), factor * r, *angle),
            Self::Sphere(f, r) => Self::Sphere(frame(f), factor * r),
            Self::Torus(f, r, tube) => Self::Torus(frame(f), factor * r, factor * tube),
            Self::Extruded(curve, vector) => {
                Self::Extruded(Box::new(curve.mapped(map)), near.turn(vector))
            }
            Self::Revolved(curve, f) => Self::Revolved(Box::new(curve.mapped(map)), frame(f)),
            Self::Ruled(pair) => {
                Self::Ruled(Box::new(pair.each_ref().map(|curve| curve.mapped(map))))
            }
            Self::Spline(surface) => Self::Spline(SplineSurface {
                net: surface
                    .net
                    .iter()
                    .map(|row| row.iter().map(|p| map.apply(p)).collect())
                    .collect(),
                ..surface.clone()
            }),
        }
    }

    /// The degrees of a B-spline surface.
    #[must_use]
    pub fn degrees(&self) -> Option<[usize; 2]> {
        match self {
            Self::Spline(surface) => Some(surface.degrees),
            _ => None,
        }
    }

    /// What it is, in words.
    #[must_use]
    pub fn words(&self) -> &'static str {
        match self {
            Self::Plane(_) => "plane",
            Self::Cylinder(..) => "cylinder",
            Self::Cone(..) => "cone",
            Self::Sphere(..) => "sphere",
            Self::Torus(..) => "torus",
            Self::Extruded(..) => "extruded",
            Self::Revolved(..) => "revolved",
            Self::Ruled(_) => "ruled",
            Self::Spline(surface) if surface.degrees.contains(&1) => "B-spline, ruled",
            Self::Spline(_) => "B-spline",
        }
    }
}

/// The most patches that a B-spline surface is divided into, by its knots.
const MAX_PATCHES: usize = 4096;

/// A B-spline surface with exact control data: rows along the first parameter, weights where it is rational.
///
/// Invariant: knots, net and weights fit each other as those of a [`Spline`] do, in both directions.
#[derive(Debug, Clone, PartialEq)]
pub struct SplineSurface {
    /// The degrees.
    pub degrees: [usize; 2],
    /// The knots of both directions.
    pub knots: [Vec<Rational>; 2],
    /// The control points: `net[i][j]` belongs to knot `i` of the first and `j` of the second direction.
    pub net: Vec<Vec<[Rational; 3]>>,
    /// The weights.
    pub weights: Option<Vec<Vec<Rational>>>,
}

impl SplineSurface {
    /// The surface with these degrees, knots, control points and, if it is rational, weights.
    ///
    /// # Errors
    /// As [`Spline::new`], for the rows and the columns; [`GeometryError::LengthMismatch`] for rows of different lengths.
    pub fn new(
        degrees: [usize; 2],
        knots: [Vec<Rational>; 2],
        net: Vec<Vec<[Rational; 3]>>,
        weights: Option<Vec<Vec<Rational>>>,
    ) -> Result<Self, GeometryError> {
        let width = net.first().map_or(0, Vec::len);
        let ragged = |what, index, given| {
            Err(GeometryError::LengthMismatch {
                what,
                index,
                expected: width,
                given,
            })
        };
        if let Some((index, row)) = net.iter().enumerate().find(|(_, row)| row.len() != width) {
            return ragged("row of a net", index, row.len());
        }
        if let Some(weights) = &weights {
            if weights.len() != net.len() {
                return ragged("rows of weights", 0, weights.len());
            }
            if let Some((index, row)) = weights
                .iter()
                .enumerate()
                .find(|(_, row)| row.len() != width)
            {
                return ragged("row of weights", index, row.len());
            }
            let bad = |w: &&Rational| **w <= Rational::default();
            if let Some((index, value)) = weights.iter().flatten().enumerate().find(|(_, w)| bad(w))
            {
                let value = value.approximate();
                return Err(GeometryError::BadWeight { index, value });
            }
        }
        let column = net.iter().filter_map(|row| row.first().cloned()).collect();
        Spline::new(degrees[0], knots[0].clone(), column, None)?;
        Spline::new(
            degrees[1],
            knots[1].clone(),
            net.first().cloned().unwrap_or_default(),
            None,
        )?;
        Ok(Self {
            degrees,
            knots,
            net,
            weights,
        })
    }

    /// The Bezier patches of the surface, exact, row by row along the first parameter.
    ///
    /// # Errors
    /// As [`Spline::pieces`]; [`GeometryError::OutOfRange`] for more than 4096.
    pub fn patches(&self) -> Result<Vec<BezierNet>, GeometryError> {
        let [u, v] = &self.knots;
        let count = u.len().saturating_mul(v.len());
        if count > MAX_PATCHES {
            #[allow(clippy::cast_precision_loss)]
            return Err(GeometryError::OutOfRange {
                name: "patches of a B-spline surface",
                value: count as f64,
                range: "at most 4096",
            });
        }
        // Along the second parameter first: of each row its pieces.
        let mut strips: Vec<Vec<Vec<[Rational; 4]>>> = Vec::new();
        for (index, row) in self.net.iter().enumerate() {
            let weights = self
                .weights
                .as_ref()
                .and_then(|all| all.get(index).cloned());
            let spline = Spline::new(self.degrees[1], v.clone(), row.clone(), weights)?;
            for (piece, bezier) in spline.pieces()?.iter().enumerate() {
                if strips.len() <= piece {
                    strips.push(Vec::new());
                }
                if let Some(strip) = strips.get_mut(piece) {
                    strip.push(bezier.homogeneous());
                }
            }
        }
        let mut patches: Vec<Vec<BezierNet>> = Vec::new();
        for strip in &strips {
            let width = strip.first().map_or(0, Vec::len);
            // Then the columns of each strip: by piece, then by column, the control points.
            let mut columns: Vec<Vec<Vec<[Rational; 4]>>> = Vec::new();
            for column in 0..width {
                let (points, weights): (Vec<[Rational; 3]>, Vec<Rational>) = strip
                    .iter()
                    .filter_map(|row| row.get(column))
                    .map(|[x, y, z, w]| {
                        let point = [x, y, z].map(|c| c.clone() / w.clone());
                        (point, w.clone())
                    })
                    .unzip();
                let weights = self.weights.is_some().then_some(weights);
                let spline = Spline::new(self.degrees[0], u.clone(), points, weights)?;
                for (piece, bezier) in spline.pieces()?.iter().enumerate() {
                    if columns.len() <= piece {
                        columns.push(Vec::new());
                    }
                    if let Some(all) = columns.get_mut(piece) {
                        all.push(bezier.homogeneous());
                    }
                }
            }
            for (piece, columns) in columns.into_iter().enumerate() {
                let height = columns.first().map_or(0, Vec::len);
                let row = |i: usize| columns.iter().filter_map(|c| c.get(i).cloned()).collect();
                let net = BezierNet::new((0..height).map(row).collect(), self.weights.is_some())?;
                if patches.len() <= piece {
                    patches.push(Vec::new());
                }
                if let Some(all) = patches.get_mut(piece) {
                    all.push(net);
                }
            }
        }
        Ok(patches.into_iter().flatten().collect())
    }

    /// The curves of the net that the surface is ruled between, if it is straight in one direction and of one piece there.
    ///
    /// # Errors
    /// As [`Spline::new`].
    pub fn rails(&self) -> Result<Option<[Spline; 2]>, GeometryError> {
        let weights = |index: &dyn Fn(&Vec<Rational>) -> Vec<Rational>| {
            self.weights
                .as_ref()
                .map(|all| all.iter().flat_map(index).collect::<Vec<_>>())
        };
        let [u, v] = &self.knots;
        if self.degrees[1] == 1 && self.net.iter().all(|row| row.len() == 2) {
            let side = |k: usize| {
                let points = self
                    .net
                    .iter()
                    .filter_map(|row| row.get(k).cloned())
                    .collect();
                let weights =
                    weights(&|row: &Vec<Rational>| row.get(k).cloned().into_iter().collect());
                Spline::new(self.degrees[0], u.clone(), points, weights)
            };
            return Ok(Some([side(0)?, side(1)?]));
        }
        if self.degrees[0] == 1 && self.net.len() == 2 {
            let side = |k: usize| {
                let points = self.net.get(k).cloned().unwrap_or_default();
                let weights = self.weights.as_ref().and_then(|all| all.get(k).cloned());
                Spline::new(self.degrees[1], v.clone(), points, weights)
            };
            return Ok(Some([side(0)?, side(1)?]));
        }
        Ok(None)
    }
}

/// A mesh of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedMesh {
    /// Its name.
    pub name: String,
    /// Where it stands.
    pub place: FilePlace,
    /// The mesh.
    pub mesh: Mesh,
}

impl Imported {
    /// The curve of this name.
    #[must_use]
    pub fn curve(&self, name: &str) -> Option<&ImportedCurve> {
        self.curves.iter().find(|curve| curve.name == name)
    }

    /// The names of the curves, in their order.
    pub fn curve_names(&self) -> impl Iterator<Item = &str> {
        self.curves.iter().map(|curve| curve.name.as_str())
    }
}

/// Gives names that no other thing has: the second `hull` becomes `hull.2`.
#[derive(Default)]
pub(super) struct Names {
    taken: std::collections::HashMap<String, usize>,
}

impl Names {
    pub(super) fn unique(&mut self, wanted: &str) -> String {
        let clean: String = wanted
            .chars()
            .map(|c| if c.is_control() { ' ' } else { c })
            .take(100)
            .collect();
        let clean = match clean.trim() {
            "" => "curve".to_owned(),
            name => name.to_owned(),
        };
        loop {
            let count = self.taken.entry(clean.clone()).or_insert(0);
            *count += 1;
            if *count == 1 {
                return clean;
            }
            let name = format!("{clean}.{count}");
            if !self.taken.contains_key(&name) {
                self.taken.insert(name.clone(), 1);
                return name;
            }
        }
    }
}

/// How the words for faces on surfaces that are not read begin, and for parts and solids.
pub(super) const LOST: [&str; 3] = ["face on ", "part placed by ", "solid "];

impl Imported {
    /// What was passed over though it has surfaces: faces on surfaces that are not read, parts, solids; and how many of each.
    pub fn lost(&self) -> impl Iterator<Item = &(String, usize)> {
        let all = self.passed_over.iter();
        all.filter(|(words, _)| LOST.iter().any(|start| words.starts_with(start)))
    }
}

/// Counts what is passed over.
#[derive(Default)]
pub(crate) struct PassedOver {
    counts: std::collections::BTreeMap<String, (usize, FilePlace)>,
}

impl PassedOver {
    pub(super) fn add(&mut self, kind: &str) {
        self.add_at(kind, &FilePlace::default());
    }

    /// As [`PassedOver::add`], of an entity at a place.
    pub(super) fn add_at(&mut self, kind: &str, place: &FilePlace) {
        // A hostile file may have a kind for each of its entities.
        if self.counts.len() < 100 || self.counts.contains_key(kind) {
            let kind: String = kind.chars().take(60).collect();
            let entry = self.counts.entry(kind);
            entry.or_insert_with(|| (0, place.clone())).0 += 1;
        }
    }

    pub(super) fn list(self) -> (Vec<(String, usize)>, Vec<FilePlace>) {
        let each = self.counts.into_iter();
        each.map(|(kind, (count, place))| ((kind, count), place))
            .unzip()
    }
}
