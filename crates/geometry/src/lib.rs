//! Bases, curves, surfaces, plane families, developables and joins, written once for every scalar.
#![warn(missing_docs)]

pub mod basis;
pub mod batch;
pub mod coordinate;
pub mod curve;
pub mod developable;
pub mod error;
pub mod export;
pub mod join;
pub mod mesh;
pub mod planes;
mod scalars;
pub mod surface;
pub mod vector;

pub use basis::{Basis, Bernstein, Gbt, hermite};
pub use coordinate::Coordinate;
pub use curve::{Affine, Curve, RationalCurve};
pub use developable::{Bounds, EnvelopingPatch, HermiteCone, TangentPatch};
pub use error::{GeometryError, Result};
pub use join::Continuity;
pub use mesh::Mesh;
pub use planes::{Plane, PlaneFamily, Ruling};
pub use scalars::{Over, exact, exact_ball};
pub use surface::{
    Forms, Half, Partials, Rails, RotationSurface, RuledSurface, SpaceCurve, Surface, TensorSurface,
};
