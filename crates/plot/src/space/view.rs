//! The contents of a view.

use crate::colormap::ColourMap;
use crate::colour::{Colour, Line};
use crate::error::{FigureError, at_least, finite, range, within};
use crate::ink::scene::Place;
use crate::legend::Legend;
use crate::space::camera::Camera;
use crate::space::grid::Grid;

/// The colours of a surface.
#[derive(Debug, Clone, PartialEq)]
pub enum Paint {
    /// One colour for each side; the front is that of the normal `r_u x r_v`.
    TwoSided {
        /// Colour of the front.
        front: Colour,
        /// Colour of the back.
        back: Colour,
    },
    /// One value per vertex of the grid, coloured by the [`Scale`] of the view.
    Values(Vec<f64>),
}

impl Paint {
    /// Paint of the `k`-th patch of a composite, greyer on the back; repeats after six. Neighbours differ in
    /// lightness, so that they stay apart in grey print.
    #[must_use]
    pub fn nth(k: usize) -> Self {
        let front = TONES[k % TONES.len()];
        Paint::TwoSided {
            front,
            back: front.mix(Colour::rgb(0xd9, 0xd2, 0xc5), 0.55),
        }
    }

    /// The same colour on both sides.
    #[must_use]
    pub fn plain(colour: Colour) -> Self {
        Paint::TwoSided {
            front: colour,
            back: colour,
        }
    }
}

/// Colours of patches: lighter than those of lines, by turns dark and light.
const TONES: [Colour; 6] = [
    Colour::rgb(0x5d, 0x95, 0xd1),
    Colour::rgb(0xf2, 0xb4, 0x78),
    Colour::rgb(0x4f, 0xa3, 0x83),
    Colour::rgb(0xe0, 0xb4, 0xd8),
    Colour::rgb(0xb8, 0x88, 0x30),
    Colour::rgb(0xae, 0xd8, 0xee),
];

impl Default for Paint {
    /// Blue in front, sand behind.
    fn default() -> Self {
        Paint::TwoSided {
            front: Colour::rgb(0x6f, 0xa3, 0xd8),
            back: Colour::rgb(0xe6, 0xbd, 0x7a),
        }
    }
}

/// Parameter lines drawn on a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SurfaceLines {
    /// The range of `u` is cut into this many parts by lines `u = const`, the rulings of a developable whose rows
    /// are its rulings; 0 or 1 for none.
    pub u: usize,
    /// The same for lines `v = const`.
    pub v: usize,
}

/// Whether the boundary of a surface is outlined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Border {
    /// A dark line along all four sides.
    #[default]
    Drawn,
    /// None: for closed surfaces, whose seam should not show.
    Hidden,
}

/// A patch of surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Its vertices.
    pub grid: Grid,
    /// Its normals, one per vertex, of any length; `None` takes them from the grid.
    pub normals: Option<Vec<[f64; 3]>>,
    /// Its colours.
    pub paint: Paint,
    /// Parameter lines on it.
    pub lines: SurfaceLines,
    /// Its outline.
    pub border: Border,
    /// 1 for a solid surface, less for a translucent one such as a tangent plane.
    pub opacity: f64,
    /// Its entry in the legend; empty for none.
    pub label: String,
}

impl Surface {
    /// An opaque two-sided surface with its border and no further lines.
    #[must_use]
    pub fn new(grid: Grid) -> Self {
        Surface {
            grid,
            normals: None,
            paint: Paint::default(),
            lines: SurfaceLines::default(),
            border: Border::default(),
            opacity: 1.0,
            label: String::new(),
        }
    }

    /// The surface in other colours.
    #[must_use]
    pub fn paint(self, paint: Paint) -> Self {
        Surface { paint, ..self }
    }

    /// The surface with parameter lines.
    #[must_use]
    pub fn lines(self, u: usize, v: usize) -> Self {
        Surface {
            lines: SurfaceLines { u, v },
            ..self
        }
    }

    /// The surface with another border.
    #[must_use]
    pub fn border(self, border: Border) -> Self {
        Surface { border, ..self }
    }

    /// The surface, translucent.
    #[must_use]
    pub fn opacity(self, opacity: f64) -> Self {
        Surface { opacity, ..self }
    }

    /// The surface with an entry in the legend.
    #[must_use]
    pub fn label(self, label: &str) -> Self {
        Surface {
            label: label.to_owned(),
            ..self
        }
    }

    fn check(&self) -> Result<(), FigureError> {
        let expected = self.grid.points().len();
        let same = |what, got| match got == expected {
            true => Ok(()),
            false => Err(FigureError::Length {
                what,
                expected,
                got,
            }),
        };
        if let Some(normals) = &self.normals {
            same("normals of a surface", normals.len())?;
            finite("normals of a surface", normals)?;
        }
        if let Paint::Values(values) = &self.paint {
            same("values on a surface", values.len())?;
            let values: Vec<[f64; 1]> = values.iter().map(|&v| [v]).collect();
            finite("values on a surface", &values)?;
        }
        within("opacity", self.opacity, 0.0, 1.0)
    }
}

/// Something in space.
#[derive(Debug, Clone, PartialEq)]
pub enum Solid {
    /// A patch of surface.
    Surface(Surface),
    /// A space curve.
    Curve {
        /// Its samples, at least two.
        points: Vec<[f64; 3]>,
        /// How it is drawn.
        line: Line,
        /// Entry in the legend; empty for none.
        label: String,
    },
    /// A control net: thin lines along rows and columns and a dot at every vertex.
    Net {
        /// Its control points.
        grid: Grid,
        /// Lines, and colour of the dots.
        line: Line,
        /// Entry in the legend; empty for none.
        label: String,
    },
    /// Marked points.
    Points {
        /// Where.
        points: Vec<[f64; 3]>,
        /// Colour.
        colour: Colour,
        /// Entry in the legend; empty for none.
        label: String,
    },
    /// An arrow, such as a tangent or normal vector.
    Arrow {
        /// Foot.
        from: [f64; 3],
        /// Tip.
        to: [f64; 3],
        /// Shaft.
        line: Line,
    },
    /// A note beside a point; notes are never hidden.
    Note {
        /// The point.
        at: [f64; 3],
        /// The text, in the [label language](crate#labels).
        text: String,
        /// On which side.
        place: Place,
    },
}

impl Solid {
    fn check(&self) -> Result<(), FigureError> {
        let (what, needed) = match self {
            Solid::Surface(surface) => return surface.check(),
            Solid::Curve { .. } => ("space curve", 2),
            Solid::Net { .. } => ("control net", 4),
            Solid::Points { .. } => ("marked points", 1),
            Solid::Arrow { .. } => ("arrow", 2),
            Solid::Note { .. } => ("note", 1),
        };
        let points = self.points();
        finite(what, &points)?;
        at_least(what, needed, points.len())?;
        match self {
            Solid::Curve { line, .. } | Solid::Net { line, .. } | Solid::Arrow { line, .. } => {
                within("line width", line.width, 0.1, 20.0)
            }
            _ => Ok(()),
        }
    }

    /// Every point the solid is made of.
    pub(crate) fn points(&self) -> Vec<[f64; 3]> {
        match self {
            Solid::Surface(Surface { grid, .. }) | Solid::Net { grid, .. } => {
                grid.points().to_vec()
            }
            Solid::Curve { points, .. } | Solid::Points { points, .. } => points.clone(),
            Solid::Arrow { from, to, .. } => vec![*from, *to],
            Solid::Note { at, .. } => vec![*at],
        }
    }
}

/// How values on surfaces become colours.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scale {
    /// The colours.
    pub map: ColourMap,
    /// Values at the ends of the map; values outside take the end colour. `None` takes the range of the values.
    pub range: Option<[f64; 2]>,
    /// Title of the scale bar, units included.
    pub label: String,
}

/// The part of space that is shown.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Bounds {
    /// All of it.
    #[default]
    Data,
    /// A box, given by an interval per axis; what sticks out is cut off. Developables run to infinity.
    Fixed([[f64; 2]; 3]),
}

/// What surrounds the solids.
#[derive(Debug, Clone, PartialEq)]
pub enum Stage {
    /// The three rear walls of the bounding box with grid lines, ticks and axis titles x, y, z.
    Box([String; 3]),
    /// Nothing.
    Bare,
}

impl Default for Stage {
    fn default() -> Self {
        Stage::Box(["$x$", "$y$", "$z$"].map(str::to_owned))
    }
}

/// A view of solids, in parallel projection with equal units on all axes, z upwards.
///
/// ```
/// use torse_plot::{Grid, Size, Surface, View};
/// let saddle = Grid::sample(21, 21, |u, v| [u, v, (u - 0.5) * (v - 0.5)])?;
/// let picture = View::new().surface(Surface::new(saddle).lines(4, 4)).draw("A saddle", Size::PANEL)?;
/// assert!(picture.svg.contains("data:image/png;base64,"));
/// # Ok::<(), torse_plot::FigureError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct View {
    /// What is seen.
    pub solids: Vec<Solid>,
    /// From where.
    pub camera: Camera,
    /// The part that is shown.
    pub bounds: Bounds,
    /// The surroundings.
    pub stage: Stage,
    /// Colours of [`Paint::Values`]; its bar is drawn if a surface uses it.
    pub scale: Scale,
    /// Place of the legend.
    pub legend: Legend,
}

impl View {
    /// An empty view.
    #[must_use]
    pub fn new() -> Self {
        View::default()
    }

    /// The view with one more solid.
    #[must_use]
    pub fn solid(mut self, solid: Solid) -> Self {
        self.solids.push(solid);
        self
    }

    /// The view with a surface.
    #[must_use]
    pub fn surface(self, surface: Surface) -> Self {
        self.solid(Solid::Surface(surface))
    }

    /// The view with a space curve.
    #[must_use]
    pub fn curve(self, points: Vec<[f64; 3]>, line: Line, label: &str) -> Self {
        let label = label.to_owned();
        self.solid(Solid::Curve {
            points,
            line,
            label,
        })
    }

    /// The view with a control net in thin ink.
    #[must_use]
    pub fn net(self, grid: Grid, label: &str) -> Self {
        let (line, label) = (
            Line::solid(Colour::rgb(0x50, 0x52, 0x58), 1.0),
            label.to_owned(),
        );
        self.solid(Solid::Net { grid, line, label })
    }

    /// The view with marked points.
    #[must_use]
    pub fn points(self, points: Vec<[f64; 3]>, colour: Colour, label: &str) -> Self {
        let label = label.to_owned();
        self.solid(Solid::Points {
            points,
            colour,
            label,
        })
    }

    /// The view with an arrow.
    #[must_use]
    pub fn arrow(self, from: [f64; 3], to: [f64; 3], line: Line) -> Self {
        self.solid(Solid::Arrow { from, to, line })
    }

    /// The view with a note.
    #[must_use]
    pub fn note(self, at: [f64; 3], text: &str, place: Place) -> Self {
        let text = text.to_owned();
        self.solid(Solid::Note { at, text, place })
    }

    /// The view from elsewhere.
    #[must_use]
    pub fn camera(self, camera: Camera) -> Self {
        View { camera, ..self }
    }

    /// The view of a part.
    #[must_use]
    pub fn bounds(self, bounds: Bounds) -> Self {
        View { bounds, ..self }
    }

    /// The view with other surroundings.
    #[must_use]
    pub fn stage(self, stage: Stage) -> Self {
        View { stage, ..self }
    }

    /// The view with another colour scale.
    #[must_use]
    pub fn scale(self, scale: Scale) -> Self {
        View { scale, ..self }
    }

    /// The view with its legend elsewhere.
    #[must_use]
    pub fn legend(self, legend: Legend) -> Self {
        View { legend, ..self }
    }

    /// Refuse what cannot be drawn.
    pub(crate) fn check(&self) -> Result<(), FigureError> {
        if let Bounds::Fixed(sides) = self.bounds {
            for (what, [low, high]) in ["x bounds", "y bounds", "z bounds"].into_iter().zip(sides) {
                range(what, low, high)?;
            }
        }
        if let Some([low, high]) = self.scale.range {
            range("colour scale", low, high)?;
        }
        if let Camera::Angles { azimuth, elevation } = self.camera {
            within("azimuth", azimuth, -360.0, 360.0)?;
            within("elevation", elevation, -90.0, 90.0)?;
        }
        self.solids.iter().try_for_each(Solid::check)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbouring_patches_differ_in_lightness() {
        for (a, b) in TONES.iter().zip(TONES.iter().cycle().skip(1)) {
            assert!((a.luminance() - b.luminance()).abs() > 0.2, "{a:?} {b:?}");
        }
    }
}
