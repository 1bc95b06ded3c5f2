//! What a file of another program holds: its curves, faces and meshes in a table.

use crate::audit::FaceAudit;
use crate::faces::openings_of_face;
use crate::lines::{columns, wrapped};
use crate::numbers::number;
use serde::Serialize;
use std::path::Path;
use torse_exchange::{FilePlace, Imported, LengthUnit, ReadError};
use torse_geometry::GeometryError;

/// What a file holds; lengths in millimetres.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FileListing {
    /// The name of the file.
    pub file: String,
    /// What it is.
    pub kind: String,
    /// Its unit, and who says so.
    pub unit: String,
    /// The same for people, above lengths in millimetres.
    #[serde(skip)]
    lengths: String,
    /// The distance within which it says that its points are known.
    pub uncertainty: Option<f64>,
    /// The curves, edges of faces among them.
    pub curves: Vec<ListedCurve>,
    /// The faces.
    pub faces: Vec<ListedFace>,
    /// The meshes.
    pub meshes: Vec<ListedMesh>,
    /// Kinds of entities that were passed over, and how many.
    pub passed_over: Vec<(String, usize)>,
}

/// A curve of a file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ListedCurve {
    /// Its name, as `import` wants it.
    pub name: String,
    /// Its line and its entity.
    pub place: String,
    /// What it is, in words.
    pub shape: String,
    /// Whether it is only an edge of a face.
    pub edge: bool,
    /// The largest degree of its splines.
    pub degree: Option<usize>,
    /// The number of its pieces.
    pub pieces: usize,
    /// Its length, measured; none where it is too uneven to be measured.
    pub length: Option<f64>,
    /// Its first point.
    pub start: [f64; 3],
    /// Its last point.
    pub end: [f64; 3],
}

/// A face of a file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ListedFace {
    /// Its name.
    pub name: String,
    /// Its line and its entity.
    pub place: String,
    /// What its surface is, in a word.
    pub surface: String,
    /// The degrees of a B-spline.
    pub degrees: Option<[usize; 2]>,
    /// Whether its surface is developable; none beyond the first [`MAX_AUDITED`] faces, and where its data say nothing.
    pub audit: Option<FaceAudit>,
    /// How many of its loops are openings; none where it has no pattern, and beyond the first [`MAX_AUDITED`] faces.
    pub openings: Option<usize>,
    /// The names of the curves at its border, loop by loop.
    pub edges: Vec<Vec<String>>,
}

/// A mesh of a file.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ListedMesh {
    /// Its name.
    pub name: String,
    /// How many vertices it has.
    pub vertices: usize,
    /// How many triangles.
    pub triangles: usize,
    /// The sum of their areas.
    pub area: f64,
}

/// The most faces of a file that are judged.
pub const MAX_AUDITED: usize = 1000;

/// The accuracy of lengths, as a share of the largest coordinate.
const ACCURACY: f64 = 1e-9;

/// Reads a file of another program and lists what is in it. `unit` holds for a file that states none.
///
/// # Errors
/// [`ReadError`].
///
/// ```
/// use torse_designs::listing::list;
/// let table = "x [in],y,z\n0,0,0\n3,4,0\n";
/// let found = list("sheer.csv", table.as_bytes(), None)?;
/// assert_eq!(found.curves[0].name, "sheer");
/// assert!(found.curves[0].length.is_some_and(|length| (length - 127.0).abs() < 1e-6));
/// assert!(found.text().contains("spline through 2 points"));
/// # Ok::<(), torse_exchange::ReadError>(())
/// ```
pub fn list(name: &str, bytes: &[u8], unit: Option<&LengthUnit>) -> Result<FileListing, ReadError> {
    let found = torse_exchange::read(name, bytes, unit)?;
    let file = Path::new(name)
        .file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    let mut curves = Vec::with_capacity(found.curves.len());
    for curve in &found.curves {
        let refused = |reason: GeometryError| ReadError::Geometry {
            place: curve.place.clone(),
            reason: Box::new(reason),
        };
        let rail = curve.shape.rail().map_err(refused)?;
        let (start, end) = match (rail.point(0.0), rail.point(1.0)) {
            (Ok(start), Ok(end)) => (start, end),
            (Err(reason), _) | (_, Err(reason)) => return Err(refused(reason)),
        };
        let size = start
            .iter()
            .chain(&end)
            .fold(1.0_f64, |m, c| m.max(c.abs()));
        curves.push(ListedCurve {
            name: curve.name.clone(),
            place: place(&curve.place),
            shape: curve.shape.words(),
            edge: curve.edge,
            degree: curve.shape.degree(),
            pieces: rail.count(),
            length: rail.length(ACCURACY * size).ok(),
            start,
            end,
        });
    }
    Ok(FileListing {
        file,
        kind: found.kind.to_string(),
        unit: found.unit.to_string(),
        lengths: found.unit.above_millimetres(),
        uncertainty: found.uncertainty,
        curves,
        faces: faces(&found),
        meshes: found
            .meshes
            .iter()
            .map(|mesh| ListedMesh {
                name: mesh.name.clone(),
                vertices: mesh.mesh.vertices().len(),
                triangles: mesh.mesh.triangles().len(),
                area: mesh.mesh.area(),
            })
            .collect(),
        passed_over: found.passed_over,
    })
}

fn faces(found: &Imported) -> Vec<ListedFace> {
    let name = |index: usize| {
        found
            .curves
            .get(index)
            .map_or(String::new(), |curve| curve.name.clone())
    };
    let faces = found.faces.iter().enumerate();
    faces
        .map(|(index, face)| ListedFace {
            audit: (index < MAX_AUDITED)
                .then(|| FaceAudit::of_surface(face).ok())
                .flatten(),
            openings: (index < MAX_AUDITED)
                .then(|| openings_of_face(face, found))
                .flatten(),
            name: face.name.clone(),
            place: place(&face.place),
            surface: face.surface.words().to_owned(),
            degrees: face.surface.degrees(),
            edges: face
                .loops
                .iter()
                .map(|edges| edges.iter().map(|(index, _)| name(*index)).collect())
                .collect(),
        })
        .collect()
}

fn place(place: &FilePlace) -> String {
    place.to_string().trim_end_matches(": ").to_owned()
}

/// Rows of a table that are shown; the rest is counted.
const MAX_ROWS: usize = 200;

impl FileListing {
    /// Returns the listing for people.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = format!("{}: {}, {}\n", self.file, self.kind, self.lengths);
        if let Some(uncertainty) = self.uncertainty {
            text.push_str(&format!(
                "points are known within {uncertainty:e} mm, as the file says\n"
            ));
        }
        let coordinates = |p: &[f64; 3]| p.map(number).join(", ");
        let row = |curve: &ListedCurve| {
            vec![
                curve.name.clone(),
                curve.shape.clone(),
                curve
                    .degree
                    .map_or("-".to_owned(), |degree| degree.to_string()),
                curve.length.map_or("-".to_owned(), number),
                coordinates(&curve.start),
                coordinates(&curve.end),
            ]
        };
        let heads = ["curve", "shape", "degree", "length", "from", "to"];
        let (edges, wires): (Vec<_>, Vec<_>) = self.curves.iter().partition(|curve| curve.edge);
        table(&mut text, &heads, &wires, |curve| row(curve));
        let heads = [
            "face",
            "surface",
            "degrees",
            "developable",
            "openings",
            "edges",
        ];
        table(&mut text, &heads, &self.faces, |face| {
            vec![
                face.name.clone(),
                face.surface.clone(),
                face.degrees
                    .map_or("-".to_owned(), |[u, v]| format!("{u} x {v}")),
                face.audit
                    .as_ref()
                    .map_or("-".to_owned(), |audit| audit.developable.words().to_owned()),
                face.openings
                    .map_or("-".to_owned(), |count| count.to_string()),
                face.edges
                    .iter()
                    .map(|edges| edges.join(" "))
                    .collect::<Vec<_>>()
                    .join(" | "),
            ]
        });
        for face in self.faces.iter().take(MAX_ROWS) {
            if let Some(audit) = &face.audit {
                text.push_str(&wrapped(
                    &format!("{}: developable ", face.name),
                    &audit.words,
                ));
            }
        }
        let heads = ["edge", "shape", "degree", "length", "from", "to"];
        table(&mut text, &heads, &edges, |curve| row(curve));
        let heads = ["mesh", "vertices", "triangles", "area"];
        table(&mut text, &heads, &self.meshes, |mesh| {
            vec![
                mesh.name.clone(),
                mesh.vertices.to_string(),
                mesh.triangles.to_string(),
                number(mesh.area),
            ]
        });
        if !self.passed_over.is_empty() {
            let words: Vec<String> = self
                .passed_over
                .iter()
                .map(|(kind, count)| format!("{count} {kind}"))
                .collect();
            text.push('\n');
            text.push_str(&wrapped("passed over: ", &words.join(", ")));
        }
        if !self.faces.is_empty() {
            text.push('\n');
            text.push_str(&wrapped(
                "",
                &format!(
                    "faces are unrolled by `torse unroll {} --to FILE.dxf`",
                    self.file
                ),
            ));
        }
        if let Some(curve) = self.curves.first() {
            text.push('\n');
            text.push_str(&wrapped(
                "",
                &format!(
                    "a design takes a curve with `import = \"{}#{}\"`",
                    self.file, curve.name
                ),
            ));
        }
        text
    }
}

fn table<T>(text: &mut String, heads: &[&str], all: &[T], row: impl Fn(&T) -> Vec<String>) {
    if all.is_empty() {
        return;
    }
    text.push('\n');
    let rows: Vec<Vec<String>> = all.iter().take(MAX_ROWS).map(row).collect();
    text.push_str(&columns(heads, &rows));
    if all.len() > MAX_ROWS {
        text.push_str(&format!(
            ".. and {} more: all of them with --format json\n",
            all.len() - MAX_ROWS
        ));
    }
}
