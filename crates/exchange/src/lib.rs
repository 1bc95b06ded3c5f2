//! Meshes, drawings and CAD patches of the geometry, and the file formats that carry them, in and out.
//!
//! | you have | you make | you write |
//! |---|---|---|
//! | a surface | [`Mesh::sample`], [`Mesh::ruled`], [`Mesh::welded`], [`Mesh::thickened`] | [`stl`], [`obj`], [`ply`], [`three_mf`], [`glb`] |
//! | a polynomial or rational patch | [`ExactForm`], [`CadModel`] | [`step`], [`iges`] |
//! | any patch | [`convert`], [`approximate`], [`approximate_tensor`]: B-splines within a proved distance, [`CadModel`] | [`step`], [`iges`] |
//! | a flat pattern | [`Drawing::of_pattern`] | [`dxf`], [`svg`]; [`Drawing::from_dxf`] and [`Drawing::from_svg`] read |
//!
//! [`read`] reads what other programs wrote: curves, faces and meshes of STEP, IGES, DXF, SVG, CSV, OBJ and STL files,
//! each with its place, lengths in millimetres.
//!
//! Writers return the whole file; [`write_file`] puts it in place whole or not at all. The bytes depend on
//! the geometry alone: no clock, no path, no locale. Lengths are in millimetres (glTF knows metres only and
//! gets a scale). Numbers that a format cannot hold are refused with a typed [`ExchangeError`].
//!
//! What independent readers say of the files is checked by `tests/exchange/check.py`: ezdxf, svgpathtools,
//! trimesh, OpenCASCADE and the glTF validator of Khronos.
//!
//! A part from a developable patch to a CAD file:
//!
//! ```
//! use torse_exchange::{CadModel, approximate, step, write_file};
//! use torse_geometry::{PatchBounds, EnvelopingPatch, Gbt, PlaneFamily};
//! let planes = vec![[7., -7., 5., 125.], [-7., -7., 5., 120.], [-7., 7., 5., 130.], [7., 7., 5., 125.]];
//! let family = PlaneFamily::new(Gbt::new(0.5, 0.25)?, planes)?;
//! let sheet = EnvelopingPatch::new(family, PatchBounds::Planes([[0., 0., 1., 0.], [0., 0., 1., 3.]]))?;
//! // Neighbours would share edges that are a micrometre apart.
//! let mut part = CadModel::new("sheet", 1e-3)?;
//! part.add("sheet", approximate(&sheet, 1e-2)?)?;
//! assert!(part.error() <= 1e-2);
//! let folder = tempfile::tempdir()?;
//! write_file(&folder.path().join("sheet.step"), step(&part)?.as_bytes())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![warn(missing_docs)]

mod cad;
mod drawing;
mod error;
mod formats;
mod mesh;
mod read;
mod write;

pub use cad::{
    BezierForm, BsplinePatch, CadModel, Converted, ConvexBasis, ExactForm, HomogeneousRail, Knots,
    PolynomialBasis, approximate, approximate_tensor, convert,
};
pub use drawing::{BendLine, Drawing, Layer, Path, Text, Vertex};
pub use error::{ExchangeError, Result};
pub use formats::{dxf, glb, iges, obj, ply, step, stl, svg, three_mf};
pub use mesh::{MAX_VERTICES, Mesh};
pub use read::{
    CurveShape, FaceBorder, FileKind, FilePlace, Imported, ImportedCurve, ImportedFace,
    ImportedMesh, LengthUnit, MAX_FILE_BYTES, MAX_IMPORTED_CURVES, ReadError, ReadResult,
    SplineSurface, Straightened, SurfaceFrame, SurfaceShape, UnitSource, read, text_of_file,
};
pub use write::write_file;
