//! The shape of a figure in a derivation file, as TOML. See "Figures" in `derivations/README.md`.

use crate::derivation::schema::{SymbolEntry, Text};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use toml::Spanned;

/// A figure: `[claim.figure]` draws the figure of the claim, `[[figure]]` one that the paper does not have.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FigureEntry {
    /// The id of a figure of our own, `paper/name`; the figure of a claim has the id of the claim.
    pub id: Option<Text>,
    /// The claims that a figure of our own illustrates.
    #[serde(default)]
    pub claims: Vec<Text>,
    /// A one-line title.
    pub title: String,
    /// The caption, for the reader of a report.
    pub caption: String,
    /// A description for those who cannot see the figure.
    pub alt: String,
    /// Data that are not printed and were assumed.
    #[serde(default)]
    pub assumes: Vec<String>,
    /// Data that are not printed and were replaced by data of our own.
    #[serde(default)]
    pub stand_in: Vec<String>,
    /// Symbols that are declared for this figure only.
    #[serde(default)]
    pub symbols: BTreeMap<String, SymbolEntry>,
    /// Definitions for this figure only.
    #[serde(default, rename = "let")]
    pub local: BTreeMap<String, Text>,
    /// Values of symbols, in the order of the file: numbers, vectors, families of points (as a matrix).
    #[serde(default)]
    pub set: BTreeMap<String, Text>,
    /// Values of families with two indices: a matrix for each first index.
    #[serde(default)]
    pub nets: BTreeMap<String, Vec<Text>>,
    /// Linear equations that determine the unknowns, as in a claim.
    #[serde(default)]
    pub given: Vec<Text>,
    /// The unknowns of the given equations.
    #[serde(default)]
    pub solve_for: Vec<Text>,
    /// Symbols that a reader may move in the interactive version, with their initial values.
    #[serde(default)]
    pub sliders: BTreeMap<String, Text>,
    /// The developable of the figure, for the interactive version in which it is unrolled.
    pub torse: Option<TorseEntry>,
    /// The number of panels in a row; chosen automatically if left out.
    pub columns: Option<usize>,
    /// Width and height of a panel in pixels of 1/96 inch.
    pub size: Option<[u32; 2]>,
    /// The panels.
    pub panel: Vec<PanelEntry>,
}

/// A developable that depends on sliders.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TorseEntry {
    /// The sliders: `[least, initial, greatest]`. Values of these symbols in `set` of the figure are ignored.
    pub sliders: BTreeMap<String, Text>,
    /// Values that replace those of the figure; they may depend on sliders.
    #[serde(default)]
    pub set: BTreeMap<String, Text>,
    /// Azimuth and elevation in degrees.
    pub view: [f64; 2],
    /// The pieces, each joined to the next.
    pub piece: Vec<PieceEntry>,
}

/// A piece of a developable.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PieceEntry {
    /// How its rulings are defined.
    pub draw: Rulings,
    /// A plane [p, q, r, s] that depends on the running variable, or for a ruled piece two points that depend on it.
    pub at: Vec<Text>,
    /// The running variable: `"x"`, `"x in [0, 1/2]"`.
    pub over: Text,
    /// The parameter values at which each ruling starts and ends.
    pub along: Text,
    /// The largest distance, in both directions, to which rulings are shown from their parameter origin.
    pub limit: Option<Text>,
    /// Its label in the legend.
    #[serde(default)]
    pub label: String,
    /// Its colour, as a number of the palette.
    #[serde(default)]
    pub colour: usize,
}

/// How the rulings of a piece are defined, and what its `along` means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rulings {
    /// Characteristic lines of a family of planes. `along` counts multiples of the cross product of the normal and
    /// its derivative, from the point nearest to the origin.
    Envelope,
    /// Tangents of the edge of regression. `along` counts multiples of its derivative.
    Tangent,
    /// Segments between two curves. `along` is the fraction of the way from the first to the second.
    Ruled,
}

/// A panel; with `for`, one panel for each iteration of its loops.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PanelEntry {
    /// The caption; `{name}` stands for the value of a loop.
    #[serde(default)]
    pub caption: String,
    /// One panel for each iteration.
    #[serde(default, rename = "for")]
    pub loops: Vec<Loop>,
    /// Additional values of symbols.
    #[serde(default)]
    pub set: BTreeMap<String, Text>,
    /// Additional values of families with two indices.
    #[serde(default)]
    pub nets: BTreeMap<String, Vec<Text>>,
    /// Titles of the axes.
    pub axes: Option<Spanned<Vec<String>>>,
    /// The shown interval `[low, high]` of the first axis.
    pub x: Option<Text>,
    /// The interval shown of the second axis.
    pub y: Option<Text>,
    /// The interval shown of the third axis.
    pub z: Option<Text>,
    /// The ratio of the units of the axes of a plane panel.
    #[serde(default)]
    pub aspect: Aspect,
    /// What surrounds the drawing.
    #[serde(default)]
    pub frame: Frame,
    /// Where the legend stands.
    #[serde(default)]
    pub legend: Legend,
    /// Azimuth and elevation of a view, in degrees.
    pub view: Option<[f64; 2]>,
    /// How values on surfaces become colours.
    #[serde(default)]
    pub scale: ScaleEntry,
    /// The layers, from below to above.
    pub layer: Vec<LayerEntry>,
}

/// A loop: names that take the values of lists of equal length in parallel. Several loops are nested, the first
/// outermost.
pub type Loop = BTreeMap<String, Spanned<Vec<Text>>>;

/// A layer of a drawing; with `for`, one layer for each iteration of its loops.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LayerEntry {
    /// The shape that is drawn.
    pub draw: Spanned<Shape>,
    /// Its positions, as a formula.
    pub at: Text,
    /// The running variables: `"x"`, `"x in [0, 1/2]"`, `"i in 0..3"`.
    #[serde(default)]
    pub over: Vec<Text>,
    /// One layer for each iteration.
    #[serde(default, rename = "for")]
    pub loops: Vec<Loop>,
    /// The number of samples along each running variable.
    #[serde(default)]
    pub samples: Vec<Spanned<u32>>,
    /// A number on a surface that determines its colour.
    pub shade: Option<Text>,
    /// Its label in the legend; `{name}` stands for the value of a loop.
    #[serde(default)]
    pub label: String,
    /// The text of a note.
    #[serde(default)]
    pub text: String,
    /// The appearance.
    #[serde(default)]
    pub style: Style,
}

/// The shape of a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shape {
    /// A curve; one running variable.
    Curve,
    /// A control polygon; a list of points.
    Polygon,
    /// Marked points; a point or a list of points.
    Points,
    /// Straight segments, such as rulings; a list of two points.
    Segments,
    /// Arrows from the first of two points to the second.
    Arrows,
    /// A filled region of the plane, bounded by a closed curve or polygon.
    Region,
    /// A text beside a point.
    Note,
    /// A surface in space; two running variables.
    Surface,
    /// A control net in space; two running indices.
    Net,
    /// The plane p X + q Y + r Z = s in space, as the vector [p, q, r, s].
    Plane,
}

/// The appearance of a layer; what is left out is chosen automatically.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields, default)]
pub struct Style {
    /// A number of the palette, or `ink`, `grey`.
    pub colour: Option<ColourName>,
    /// Width of lines in pixels of 1/96 inch.
    pub width: Option<f64>,
    /// Pattern of lines.
    pub dash: Option<Dash>,
    /// Shape of marked points.
    pub marker: Option<Marker>,
    /// Opacity from 0 (invisible) to 1.
    pub opacity: Option<f64>,
    /// The number of parts into which parameter lines divide a surface, along each variable.
    pub lines: Option<[usize; 2]>,
    /// Whether a surface is outlined.
    pub border: Option<Border>,
    /// On which side of its point a note stands.
    pub place: Option<Place>,
}

/// A colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(untagged)]
pub enum ColourName {
    /// A number of the palette.
    Palette(usize),
    /// A named colour.
    Named(NamedColour),
}

/// The colours outside the palette.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NamedColour {
    /// The colour of text.
    Ink,
    /// The colour of secondary lines.
    Grey,
}

macro_rules! words {
    ($(#[$doc:meta])* $name:ident { $($(#[$variant:meta])* $word:ident),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum $name { $($(#[$variant])* $word),+ }
    };
}

words!(
    /// Relation of the units of a plane panel.
    Aspect {
        /// Equal units on both axes.
        #[default] Equal,
        /// Each axis fills the panel: graphs of functions.
        Free,
    }
);
words!(
    /// What surrounds a drawing.
    Frame {
        /// Axes with ticks.
        #[default] Box,
        /// Nothing.
        Bare,
    }
);
words!(
    /// Where a legend stands.
    Legend {
        /// Rows below.
        #[default] Below,
        /// A column to the right.
        Right,
        /// Nowhere.
        Hidden,
    }
);
words!(
    /// A pattern of lines.
    Dash {
        /// Unbroken.
        #[default] Solid,
        /// Long strokes.
        Dashed,
        /// Stroke and dot.
        DashDot,
        /// Dots.
        Dotted,
    }
);
words!(
    /// The shape of marked points.
    Marker {
        /// A filled disc.
        #[default] Disc,
        /// A ring.
        Ring,
        /// A square.
        Square,
        /// A square on its corner.
        Diamond,
    }
);
words!(
    /// Whether a surface is outlined.
    Border {
        /// A dark line along all sides.
        #[default] Drawn,
        /// None: closed surfaces.
        Hidden,
    }
);
words!(
    /// A side of a point.
    Place {
        /// Right of it.
        #[default] Right,
        /// Left of it.
        Left,
        /// Above it.
        Above,
        /// Below it.
        Below,
        /// Above and right of it.
        AboveRight,
        /// Above and left of it.
        AboveLeft,
        /// Below and right of it.
        BelowRight,
        /// Below and left of it.
        BelowLeft,
    }
);
words!(
    /// Colours for numbers.
    ColourMap {
        /// From dark to light: magnitudes.
        #[default] Sequential,
        /// Blue to red through white, for numbers of both signs.
        Diverging,
    }
);

/// How numbers on surfaces become colours.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ScaleEntry {
    /// Title of the scale bar.
    pub label: String,
    /// The colours.
    pub map: ColourMap,
    /// The numbers at the ends of the map, `[low, high]`; those of the data if left out.
    pub range: Option<Text>,
}
