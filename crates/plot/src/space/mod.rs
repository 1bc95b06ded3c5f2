//! Pictures of space: surfaces, control nets, space curves, tangent planes.

mod animation;
mod axes;
mod camera;
mod clip;
mod corner;
mod dash;
mod draw;
mod grid;
mod mesh;
mod raster;
mod scalebar;
mod shade;
pub(crate) mod vector;
mod view;

pub use animation::Animation;
pub use camera::Camera;
pub use grid::Grid;
pub use raster::WORK_LIMIT;
pub use view::{Border, Bounds, Paint, Scale, Solid, Stage, Surface, SurfaceLines, View};
