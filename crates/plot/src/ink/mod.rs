//! Ink on paper: type, paths and the two writers (SVG and PNG).
//!
//! A picture is first recorded as a [`Scene`](scene::Scene), a list of filled and stroked paths, lines of type
//! and images in fractional pixels, and then written twice. Both writers see the same outlines, type included,
//! so the two files agree and neither depends on the fonts of the machine that shows them.

pub(crate) mod chart;
pub(crate) mod font;
pub(crate) mod label;
pub(crate) mod markup;
pub(crate) mod raster;
pub(crate) mod scene;
pub(crate) mod svg;
pub(crate) mod ticks;
pub(crate) mod typeset;
