//! What leaves the house: meshes, drawings and CAD patches of the geometry, and the files that carry them.
//!
//! | you have | you make | you write |
//! |---|---|---|
//! | a surface | [`Mesh::of`], [`Mesh::ruled`], [`Mesh::welded`], [`Mesh::thickened`] | [`stl`], [`obj`], [`ply`], [`three_mf`], [`glb`] |
//! | a flat pattern | [`Drawing`] | [`dxf`], [`svg`]; [`Drawing::from_dxf`] reads |
//!
//! Writers return the whole file; [`write_file`] puts it in place whole or not at all. The bytes depend on
//! the geometry alone: no clock, no path, no locale. Lengths are in millimetres (glTF knows metres only and
//! gets a scale). Numbers that a format cannot hold are refused with a typed [`ExchangeError`].
#![warn(missing_docs)]

mod drawing;
mod error;
mod formats;
mod mesh;
mod write;

pub use drawing::{Drawing, Layer, Path, Text, Vertex};
pub use error::{ExchangeError, Result};
pub use formats::{dxf, glb, obj, ply, stl, svg, three_mf};
pub use mesh::{MOST_VERTICES, Mesh};
pub use write::write_file;
