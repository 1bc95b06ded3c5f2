//! The figures of the papers, redrawn: one file a figure.
//!
//! Each file holds the printed data of its figure, has `torse-geometry` evaluate them and `torse-figures`
//! draw what comes out. What a paper does not print (a view, a range of rulings) is said in the caption.

mod basis_functions;
mod enveloping_developable;
mod quintic_patch;

use crate::exit::Failure;
use torse_figures::{FigureError, Grid, Picture, Surface};
use torse_geometry::{GeometryError, Mesh};

/// A figure of a paper, as data: drawing it may fail.
pub struct Redrawn {
    /// The paper's slug.
    pub paper: &'static str,
    /// The name of its files, unique among all figures.
    pub name: &'static str,
    /// What it shows and what was assumed, for the reader of a report.
    pub caption: &'static str,
    /// What is seen, for those who cannot see it.
    pub alt: &'static str,
    /// The claims it illustrates; the report shows it beside the first that it has.
    pub claims: &'static [&'static str],
    draw: fn() -> Result<Picture, Undrawn>,
}

/// All figures, paper by paper.
pub const ALL: [Redrawn; 3] = [
    basis_functions::FIGURE,
    enveloping_developable::FIGURE,
    quintic_patch::FIGURE,
];

impl Redrawn {
    /// Draws the figure.
    pub fn draw(&self) -> Result<Picture, Failure> {
        let figure = self.name;
        (self.draw)().map_err(|undrawn| match undrawn {
            Undrawn::Geometry(source) => Failure::Geometry { figure, source },
            Undrawn::Figure(source) => Failure::Figure { figure, source },
        })
    }
}

/// Why a figure could not be drawn.
enum Undrawn {
    Geometry(GeometryError),
    Figure(FigureError),
}

impl From<GeometryError> for Undrawn {
    fn from(error: GeometryError) -> Self {
        Undrawn::Geometry(error)
    }
}

impl From<FigureError> for Undrawn {
    fn from(error: FigureError) -> Self {
        Undrawn::Figure(error)
    }
}

/// The `count + 1` ends of equal parts of [0, 1].
fn parts(count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| f64::from(i) / f64::from(count))
}

/// A patch over the unit square, shaded by its own normals, from `u_cells` by `v_cells` cells.
fn shaded(
    patch: &impl torse_geometry::Surface<f64>,
    u_cells: usize,
    v_cells: usize,
) -> Result<Surface, Undrawn> {
    let mesh = Mesh::of(patch, u_cells, v_cells)?;
    Ok(Surface {
        normals: Some(mesh.normals),
        ..Surface::new(Grid::new(u_cells + 1, v_cells + 1, mesh.vertices)?)
    })
}
