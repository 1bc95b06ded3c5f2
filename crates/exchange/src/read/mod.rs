//! Reading files of other programs: curves, faces and meshes, with names and places, in millimetres.
//!
//! | format | what is read | by |
//! |---|---|---|
//! | CSV | points, tables of offsets | the crate `csv` |
//! | SVG | paths and shapes, with groups, transforms and units | the crates `roxmltree` and `svgtypes` |
//! | DXF | lines, arcs, circles, ellipses, polylines with bulges, splines, blocks | here |
//! | STEP | curves, surfaces, faces with edges, placements of parts | here |
//! | IGES | curves, surfaces, trimmed faces | here |
//! | OBJ, STL | triangles | here |
//!
//! Formats are read by hand where no crate tells the line and entity of what is wrong and bounds its own work, and
//! keeps the decimals of the text. Reading needs time and memory in proportion to the file, which has at most
//! [`MAX_FILE_BYTES`].
//!
//! ```
//! use torse_exchange::read;
//! let table = "station,x,y,z\n0,0,0,0\n1,400,180,-40\n2,900,260,-30\n3,1500,200,20\n";
//! let found = read("chine.csv", table.as_bytes(), None)?;
//! assert_eq!(found.curves[0].name, "chine");
//! assert_eq!(found.curves[0].shape.rail()?.count(), 3);
//! assert_eq!(found.unit.to_string(), "mm, assumed: the file states no unit");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod csv;
mod decimal;
pub(crate) mod dxf;
pub(crate) mod error;
mod iges;
mod imported;
pub(crate) mod kind;
mod obj;
mod obj_lines;
mod open_conic;
mod polygon;
mod step;
mod stl;
mod straight;
pub(crate) mod svg;
mod trim;
mod turned;
mod unit;

pub use error::{FilePlace, ReadError, ReadResult};
pub use imported::{
    CurveShape, FaceBorder, Imported, ImportedCurve, ImportedFace, ImportedMesh, SplineSurface,
    SurfaceFrame, SurfaceShape,
};
pub use kind::FileKind;
pub use straight::Straightened;
pub use unit::{LengthUnit, UnitSource};

use imported::{Names, PassedOver};

/// The largest file that is read, in bytes.
pub const MAX_FILE_BYTES: usize = 1 << 28;
/// The most curves of a file.
pub const MAX_IMPORTED_CURVES: usize = 200_000;

/// Reads a file of another program; `name` is that of the file, `unit` holds where the file states none.
///
/// # Errors
/// [`ReadError`], with line and entity.
pub fn read(name: &str, bytes: &[u8], unit: Option<&LengthUnit>) -> ReadResult<Imported> {
    if bytes.len() > MAX_FILE_BYTES {
        return Err(ReadError::TooMuch {
            place: FilePlace::default(),
            what: "bytes",
            most: MAX_FILE_BYTES,
        });
    }
    let kind = FileKind::of_file(name, bytes);
    let text = || text_of_file(bytes);
    let stem = std::path::Path::new(name)
        .file_stem()
        .unwrap_or_default()
        .to_string_lossy();
    match kind {
        FileKind::Csv => csv::read(&stem, &text()?, unit),
        FileKind::Svg => svg::read(&text()?, unit),
        FileKind::Dxf => dxf::read(&text()?, unit),
        FileKind::Step => step::read(&text()?, unit),
        FileKind::Iges => iges::read(&text()?, unit),
        FileKind::Obj => obj::read(&stem, &text()?, unit),
        FileKind::Stl => stl::read(&stem, bytes, unit),
        kind => Err(ReadError::Kind { kind }),
    }
}

/// Returns the text of a file: UTF-8, UTF-16 with its mark, or the groups of a binary DXF drawing as lines. Lines end in a line
/// feed; bytes that are no text are shown as characters that are missing.
///
/// # Errors
/// [`ReadError::Wrong`] for a binary DXF drawing that is damaged.
///
/// ```
/// use torse_exchange::text_of_file;
/// assert_eq!(text_of_file(b"\xff\xfex\x00,\x00y\x00\r\x00\n\x00")?, "x,y\n");
/// # Ok::<(), torse_exchange::ReadError>(())
/// ```
pub fn text_of_file(bytes: &[u8]) -> ReadResult<String> {
    if bytes.starts_with(dxf::binary::SENTINEL) {
        return dxf::binary::text_of(bytes);
    }
    let bytes = kind::utf8(bytes);
    let text = String::from_utf8_lossy(&bytes);
    Ok(kind::unix_lines(text.strip_prefix('\u{feff}').unwrap_or(&text)).into_owned())
}

/// Where the unit comes from.
fn check_unit(stated: Option<LengthUnit>, given: Option<&LengthUnit>) -> ReadResult<UnitSource> {
    let shown = stated.as_ref().map_or("", LengthUnit::name).to_owned();
    UnitSource::agree(stated, given).ok_or_else(|| ReadError::OtherUnit {
        stated: shown,
        given: given.map_or("", LengthUnit::name).to_owned(),
    })
}

/// Curves, faces and meshes while they come in; all are in millimetres already.
struct Drafts {
    imported: Imported,
    curves: Names,
    faces: Names,
    meshes: Names,
}

impl Drafts {
    fn new(unit: &UnitSource) -> Self {
        Self {
            imported: Imported {
                kind: FileKind::Empty,
                unit: unit.clone(),
                uncertainty: None,
                curves: Vec::new(),
                faces: Vec::new(),
                meshes: Vec::new(),
                passed_over: Vec::new(),
                passed_places: Vec::new(),
            },
            curves: Names::default(),
            faces: Names::default(),
            meshes: Names::default(),
        }
    }

    /// Adds a curve; gives its index.
    fn curve(&mut self, name: &str, place: FilePlace, shape: CurveShape) -> ReadResult<usize> {
        let index = self.imported.curves.len();
        if index >= MAX_IMPORTED_CURVES {
            return Err(ReadError::TooMuch {
                place,
                what: "curves",
                most: MAX_IMPORTED_CURVES,
            });
        }
        self.imported.curves.push(ImportedCurve {
            name: self.curves.unique(name),
            place,
            layer: String::new(),
            shape,
            edge: false,
        });
        Ok(index)
    }

    /// Says in which layer a curve is.
    fn set_layer(&mut self, index: usize, layer: &str) {
        if let Some(curve) = self.imported.curves.get_mut(index) {
            layer.clone_into(&mut curve.layer);
        }
    }

    /// Marks a curve as the edge of a face.
    fn mark_edge(&mut self, index: usize) {
        if let Some(curve) = self.imported.curves.get_mut(index) {
            curve.edge = true;
        }
    }

    fn face(&mut self, name: &str, mut face: ImportedFace) {
        face.name = self.faces.unique(name);
        self.imported.faces.push(face);
    }

    fn mesh(&mut self, name: &str, place: FilePlace, mesh: crate::mesh::Mesh) {
        let name = self.meshes.unique(name);
        self.imported
            .meshes
            .push(ImportedMesh { name, place, mesh });
    }

    fn finish(
        mut self,
        kind: FileKind,
        uncertainty: Option<f64>,
        passed: PassedOver,
    ) -> ReadResult<Imported> {
        let (passed_over, passed_places) = passed.list();
        let found = &mut self.imported;
        if found.curves.is_empty() && found.faces.is_empty() && found.meshes.is_empty() {
            let words = passed_over
                .iter()
                .map(|(kind, count)| format!("{count} {kind}"));
            return Err(ReadError::Nothing {
                passed_over: words.collect::<Vec<_>>().join(", "),
            });
        }
        found.kind = kind;
        found.uncertainty = uncertainty;
        found.passed_over = passed_over;
        found.passed_places = passed_places;
        Ok(self.imported)
    }
}
