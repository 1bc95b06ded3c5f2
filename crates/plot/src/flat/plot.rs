//! What a plane picture consists of.

use crate::colour::{Colour, Line};
use crate::error::{FigureError, at_least, finite, range, within};
use crate::ink::scene::Place;
use crate::legend::{Legend, Marker};

/// One coordinate axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Its title, units included; see the [label language](crate#labels).
    pub label: String,
    /// The interval shown; `None` takes that of the data.
    pub range: Option<[f64; 2]>,
}

impl Axis {
    /// An axis as long as the data.
    #[must_use]
    pub fn auto(label: &str) -> Self {
        Axis {
            label: label.to_owned(),
            range: None,
        }
    }

    /// An axis from `low` to `high`.
    #[must_use]
    pub fn fixed(label: &str, low: f64, high: f64) -> Self {
        Axis {
            label: label.to_owned(),
            range: Some([low, high]),
        }
    }
}

/// Whether a unit is as long on both axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Aspect {
    /// Each axis fills the picture: graphs of functions.
    #[default]
    Free,
    /// Equal units: curves in the plane. The range of one axis is widened about its middle.
    Equal,
}

/// What surrounds the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Frame {
    /// A box with ticks, light grid lines and axis titles.
    #[default]
    Box,
    /// Nothing: a drawing.
    Bare,
}

/// One layer of a plot; later layers cover earlier ones. Coordinates are data units.
#[derive(Debug, Clone, PartialEq)]
pub enum Layer {
    /// A curve through at least two points.
    Curve {
        /// Samples in order.
        points: Vec<[f64; 2]>,
        /// How it is drawn.
        line: Line,
        /// Its entry in the legend; empty for none.
        label: String,
    },
    /// A control polygon: a thin line with a ring at every vertex.
    ControlPolygon {
        /// The control points in order, at least two.
        points: Vec<[f64; 2]>,
        /// Line through them, and colour of the rings.
        line: Line,
        /// Its entry in the legend; empty for none.
        label: String,
    },
    /// Marked points.
    Points {
        /// Where.
        points: Vec<[f64; 2]>,
        /// Shape.
        marker: Marker,
        /// Colour.
        colour: Colour,
        /// Entry in the legend; empty for none.
        label: String,
    },
    /// A filled region.
    Region {
        /// Its boundary, at least three points, closed by itself.
        boundary: Vec<[f64; 2]>,
        /// Colour.
        colour: Colour,
        /// 0 (invisible) to 1.
        opacity: f64,
        /// Entry in the legend; empty for none.
        label: String,
    },
    /// An arrow, such as a tangent vector or the gap between two curves.
    Arrow {
        /// Foot.
        from: [f64; 2],
        /// Tip.
        to: [f64; 2],
        /// Shaft.
        line: Line,
    },
    /// A straight line across the whole plotting area.
    Guide {
        /// The axis that it crosses, on which `at` is measured.
        across: GuideAxis,
        /// Where it crosses.
        at: f64,
        /// How it is drawn.
        line: Line,
    },
    /// Lettering of a size in data units, such as that of a drawing.
    Lettering {
        /// Where its base line starts.
        at: [f64; 2],
        /// The text, in the [label language](crate#labels).
        text: String,
        /// The height of its capitals in data units.
        height: f64,
        /// The direction of the base line in radians, counter-clockwise from the first axis.
        angle: f64,
        /// Colour.
        colour: Colour,
    },
    /// A note beside a point.
    Note {
        /// The point.
        at: [f64; 2],
        /// The text, in the [label language](crate#labels).
        text: String,
        /// On which side.
        place: Place,
    },
}

/// The axis that a [`Layer::Guide`] crosses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GuideAxis {
    /// A vertical line.
    X,
    /// A horizontal line.
    Y,
}

/// A plane picture.
///
/// ```
/// use torse_plot::{Axis, Line, Plot, Size};
/// let parabola: Vec<[f64; 2]> = (0..=50).map(|i| { let t = i as f64 / 50.0; [t, t * t] }).collect();
/// let picture = Plot::new(Axis::fixed("$t$", 0.0, 1.0), Axis::auto("$f(t)$"))
///     .curve(parabola, Line::nth(0), "$t^2$")
///     .draw("A parabola", Size::COLUMN)?;
/// assert!(picture.svg.starts_with("<svg"));
/// assert_eq!(picture.png()?[1..4], *b"PNG");
/// # Ok::<(), torse_plot::FigureError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Plot {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Relation of the units.
    pub aspect: Aspect,
    /// Surroundings.
    pub frame: Frame,
    /// What is drawn, from below to above.
    pub layers: Vec<Layer>,
    /// Place of the legend.
    pub legend: Legend,
}

impl Plot {
    /// An empty plot.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        Plot {
            x,
            y,
            aspect: Aspect::default(),
            frame: Frame::default(),
            layers: Vec::new(),
            legend: Legend::default(),
        }
    }

    /// A bare drawing with equal units.
    #[must_use]
    pub fn bare() -> Self {
        Plot {
            aspect: Aspect::Equal,
            frame: Frame::Bare,
            ..Plot::new(Axis::auto(""), Axis::auto(""))
        }
    }

    /// The plot with one more layer.
    #[must_use]
    pub fn layer(mut self, layer: Layer) -> Self {
        self.layers.push(layer);
        self
    }

    /// The plot with a curve.
    #[must_use]
    pub fn curve(self, points: Vec<[f64; 2]>, line: Line, label: &str) -> Self {
        let label = label.to_owned();
        self.layer(Layer::Curve {
            points,
            line,
            label,
        })
    }

    /// The plot with a control polygon in the usual thin grey.
    #[must_use]
    pub fn control_polygon(self, points: Vec<[f64; 2]>, label: &str) -> Self {
        let (line, label) = (Line::solid(Colour::GREY, 0.9), label.to_owned());
        self.layer(Layer::ControlPolygon {
            points,
            line,
            label,
        })
    }

    /// The plot with marked points.
    #[must_use]
    pub fn points(
        self,
        points: Vec<[f64; 2]>,
        marker: Marker,
        colour: Colour,
        label: &str,
    ) -> Self {
        let label = label.to_owned();
        self.layer(Layer::Points {
            points,
            marker,
            colour,
            label,
        })
    }

    /// The plot with a note.
    #[must_use]
    pub fn note(self, at: [f64; 2], text: &str, place: Place) -> Self {
        let text = text.to_owned();
        self.layer(Layer::Note { at, text, place })
    }

    /// The plot with other units.
    #[must_use]
    pub fn aspect(self, aspect: Aspect) -> Self {
        Plot { aspect, ..self }
    }

    /// The plot with its legend elsewhere.
    #[must_use]
    pub fn legend(self, legend: Legend) -> Self {
        Plot { legend, ..self }
    }

    /// Refuse what cannot be drawn.
    pub(crate) fn check(&self) -> Result<(), FigureError> {
        for (what, axis) in [("x axis", &self.x), ("y axis", &self.y)] {
            if let Some([low, high]) = axis.range {
                range(what, low, high)?;
            }
        }
        self.layers.iter().try_for_each(Layer::check)
    }
}

impl Layer {
    fn check(&self) -> Result<(), FigureError> {
        let (what, needed) = match self {
            Layer::Curve { .. } => ("curve", 2),
            Layer::ControlPolygon { .. } => ("control polygon", 2),
            Layer::Points { .. } => ("marked points", 1),
            Layer::Region { .. } => ("region", 3),
            Layer::Arrow { .. } => ("arrow", 2),
            Layer::Lettering { height, angle, .. } => {
                finite("lettering", &[[*height, *angle]])?;
                ("lettering", 1)
            }
            Layer::Note { .. } => ("note", 1),
            Layer::Guide { at, .. } => {
                return self.check_line().and_then(|()| finite("guide", &[[*at]]));
            }
        };
        let extent = self.extent();
        finite(what, &extent)?;
        at_least(what, needed, extent.len())?;
        if let Layer::Region { opacity, .. } = self {
            within("opacity", *opacity, 0.0, 1.0)?;
        }
        self.check_line()
    }

    fn check_line(&self) -> Result<(), FigureError> {
        match self {
            Layer::Curve { line, .. }
            | Layer::ControlPolygon { line, .. }
            | Layer::Arrow { line, .. }
            | Layer::Guide { line, .. } => within("line width", line.width, 0.1, 20.0),
            _ => Ok(()),
        }
    }

    /// The points an automatic range has to show.
    pub(crate) fn extent(&self) -> Vec<[f64; 2]> {
        match self {
            Layer::Curve { points, .. }
            | Layer::ControlPolygon { points, .. }
            | Layer::Points { points, .. } => points.clone(),
            Layer::Region { boundary, .. } => boundary.clone(),
            Layer::Arrow { from, to, .. } => vec![*from, *to],
            Layer::Lettering { at, .. } | Layer::Note { at, .. } => vec![*at],
            Layer::Guide { .. } => Vec::new(),
        }
    }
}
