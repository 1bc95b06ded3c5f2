//! File formats: meshes as STL, OBJ and GLB, flat patterns as DXF R12 and SVG, polynomial and rational
//! patches as STEP.
//!
//! Each writer returns the whole file; the bytes depend on the geometry alone. Lengths are in
//! millimetres where a format knows units.

#![warn(missing_docs)]

mod dxf;
mod glb;
mod mesh;
mod obj;
mod step;
mod stl;
mod svg;

pub use dxf::dxf;
pub use glb::glb;
pub use mesh::Mesh;
pub use obj::obj;
pub use step::{BezierPatch, step};
pub use stl::stl;
pub use svg::svg;

/// A coordinate in single precision, as meshes store it.
#[allow(clippy::cast_possible_truncation)]
fn single(value: f64) -> f32 {
    value as f32
}

/// A number in plain decimal notation with at most nine places, without a negative zero.
fn decimal(value: f64) -> String {
    let text = format!("{value:.9}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// The flat rulings whose index is a multiple of `every`; none for zero.
fn every(flat: &torse_geometry::pattern::FlatPattern, every: usize) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let count = if every == 0 { 0 } else { usize::MAX };
    let rulings = flat.rulings().iter().step_by(every.max(1));
    rulings.take(count).map(|r| r.ends)
}
