//! One format a module.

mod dxf;
mod glb;
mod iges;
mod obj;
mod ply;
mod single;
mod step;
mod stl;
mod svg;
mod three_mf;
mod zip;

pub use dxf::dxf;
pub use glb::glb;
pub use iges::iges;
pub use obj::obj;
pub use ply::ply;
pub use step::step;
pub use stl::stl;
pub use svg::svg;
pub use three_mf::three_mf;

use crate::error::{ExchangeError, Result};
use crate::mesh::Mesh;

/// Refuses a mesh without triangles.
fn check_not_empty(mesh: &Mesh) -> Result<()> {
    if mesh.triangles().is_empty() {
        return Err(ExchangeError::Empty { what: "triangles" });
    }
    Ok(())
}
