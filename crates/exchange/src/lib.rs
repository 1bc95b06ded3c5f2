//! What leaves the house: meshes, drawings and CAD patches of the geometry, and the files that carry them.
//!
//! | you have | you make | you write |
//! |---|---|---|
//! | a surface | [`Mesh::of`], [`Mesh::ruled`], [`Mesh::welded`], [`Mesh::thickened`] | [`stl`], [`obj`], [`ply`], [`three_mf`], [`glb`] |
//! | a polynomial or rational patch | [`ExactForm`], [`Model`] | [`step`], [`iges`] |
//! | any patch | [`approximate`], [`approximate_tensor`]: B-splines within a proved distance, [`Model`] | [`step`], [`iges`] |
//! | a flat pattern | [`Drawing`] | [`dxf`], [`svg`]; [`Drawing::from_dxf`] reads |
//!
//! Writers return the whole file; [`write_file`] puts it in place whole or not at all. The bytes depend on
//! the geometry alone: no clock, no path, no locale. Lengths are in millimetres (glTF knows metres only and
//! gets a scale). Numbers that a format cannot hold are refused with a typed [`ExchangeError`].
#![warn(missing_docs)]

mod cad;
mod drawing;
mod error;
mod formats;
mod mesh;
mod write;

pub use cad::{
    BsplinePatch, Converted, ConvexBasis, ExactForm, HomogeneousRail, Knots, Model, approximate,
    approximate_tensor,
};
pub use drawing::{Drawing, Layer, Path, Text, Vertex};
pub use error::{ExchangeError, Result};
pub use formats::{dxf, glb, iges, obj, ply, step, stl, svg, three_mf};
pub use mesh::{MOST_VERTICES, Mesh};
pub use write::write_file;
