//! Plots of curves and shaded views of surfaces, for papers.
//!
//! This crate draws and decides nothing: it takes samples (points, grids of vertices, values) and labels, and returns a
//! [`Picture`], as SVG and as anti-aliased PNG with twice the pixels. The same input gives the same bytes, on every
//! machine: type is set with embedded fonts, nothing is read from the system.
//!
//! | wanted | call |
//! |---|---|
//! | curves, control polygons, points on axes | [`Plot`] |
//! | surfaces, nets, space curves, tangent planes | [`View`] |
//! | views that follow each other, as a GIF | [`Animation`] |
//! | panels (a), (b), ... with captions | [`Figure`] |
//! | panels that are compared | [`same_scales`] |
//! | data for a viewer with sliders | [`Interactive`] |
//! | a developable for a viewer that unrolls it | [`Torse`] |
//!
//! How it works: charts are laid out by plotters (axes of the plane, projection of space) on a drawing backend
//! that records vectors; solids are rasterised by our own z-buffer in linear light and laid between the axes
//! and the labels.
//!
//! # Labels
//!
//! Titles, captions, legends and notes are plain text with mathematics between dollar signs, in the manner of
//! TeX: `"degree $k = 4$, $\\mu_{1} = 1/2$"`. Inside, letters are italic; `_` and `^` set scripts (two levels);
//! `\alpha` to `\omega` and the capitals are Greek; further `\le \ge \ne \approx \in \to \times \cdot \pm \infty
//! \partial \nabla \sum \int \sqrt \degree \ldots`, the functions `\sin \cos \tan \log \ln \exp \det \max \min
//! \lim \arg`, `\mathbf{r}` for vectors, `\mathrm{text}` and the spaces `\,` and `\quad`. A dollar sign is `\$`.
//! A label that does not parse is an error with the byte at fault.

mod colormap;
mod colour;
mod compare;
mod error;
mod flat;
mod ink;
mod interactive;
mod legend;
mod picture;
mod space;
mod torse;

pub use colormap::ColourMap;
pub use colour::{Colour, DASHES, Dash, Line, PALETTE, palette};
pub use compare::same_scales;
pub use error::{FigureError, LabelProblem};
pub use flat::{Aspect, Axis, Frame, GuideAxis, Layer, Plot};
pub use ink::markup::label_html;
pub use ink::scene::Place;
pub use interactive::{
    Ambient, HIGHEST_EXPONENT, Interactive, InteractiveError, MAX_POINTS, MAX_SLIDERS, Part, Shape,
    Slider,
};
pub use legend::{Legend, Marker};
pub use picture::{Content, Figure, Panel, Picture, Size};
pub use space::{
    Animation, Border, Bounds, Camera, Grid, Paint, Scale, Solid, Stage, Surface, SurfaceLines,
    View, WORK_LIMIT,
};
pub use torse::{MAX_MONOMIALS, Monomial, Quotient, Rulings, Torse, TorsePiece};
