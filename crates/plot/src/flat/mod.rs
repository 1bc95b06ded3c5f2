//! Plane pictures: families of curves, control polygons, marked points, on axes or bare.

mod clip;
mod draw;
mod plot;

pub use plot::{Aspect, Axis, Frame, GuideAxis, Layer, Plot};
