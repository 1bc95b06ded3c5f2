//! The shape of a figure in a derivation file, as TOML. See "Figures" in `derivations/README.md`.

use crate::derivation::schema::{SymbolEntry, Text};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use toml::Spanned;

/// A figure: `[claim.figure]` draws the figure that the claim is about, `[[figure]]` one of our own.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FigureEntry {
    /// The name of a figure of our own, `paper/name`; the figure of a claim has the claim's.
    pub id: Option<Text>,
    /// The claims that a figure of our own illustrates.
    #[serde(default)]
    pub claims: Vec<Text>,
    /// A line that names the figure.
    pub title: String,
    /// What it shows, for the reader of a report.
    pub caption: String,
    /// What is seen, for those who cannot see it.
    pub alt: String,
    /// What is not printed and was filled with a default.
    #[serde(default)]
    pub assumes: Vec<String>,
    /// Data that are not printed and were replaced by our own.
    #[serde(default)]
    pub stand_in: Vec<String>,
    /// Symbols of this figure alone.
    #[serde(default)]
    pub symbols: BTreeMap<String, SymbolEntry>,
    /// Definitions of this figure alone.
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
    /// Symbols that a reader may move in the interactive version, and where they start.
    #[serde(default)]
    pub sliders: BTreeMap<String, Text>,
    /// The developable of the figure, for readers who move and unroll it.
    pub torse: Option<TorseEntry>,
    /// Panels in a row; as many as look well if left out.
    pub columns: Option<usize>,
    /// Width and height of a panel in pixels of 1/96 inch.
    pub size: Option<[u32; 2]>,
    /// The panels.
    pub panel: Vec<PanelEntry>,
}

/// A developable that follows sliders.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TorseEntry {
    /// What a reader may move: `[least, at first, greatest]`. Their values in `set` of the figure do not count.
    pub sliders: BTreeMap<String, Text>,
    /// Values in place of those of the figure; they may follow sliders.
    #[serde(default)]
    pub set: BTreeMap<String, Text>,
    /// Azimuth and elevation in degrees.
    pub view: [f64; 2],
    /// The pieces, one joined to the other.
    pub piece: Vec<PieceEntry>,
}

/// A piece of a developable.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PieceEntry {
    /// How its rulings are given.
    pub draw: Rulings,
    /// A plane [p, q, r, s] that runs, or for a ruled piece two points that run.
    pub at: Vec<Text>,
    /// What runs: `"x"`, `"x in [0, 1/2]"`.
    pub over: Text,
    /// Where each ruling starts and ends.
    pub along: Text,
    /// Rulings are shown to this distance from where they are counted, both ways.
    pub limit: Option<Text>,
    /// Its entry in the legend.
    #[serde(default)]
    pub label: String,
    /// Its number in the palette.
    #[serde(default)]
    pub colour: usize,
}

/// How the rulings of a piece are given, and what its `along` counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rulings {
    /// Lines in which a plane that runs meets its neighbours: multiples of the cross product of the normal and its
    /// derivative, from the foot of the origin.
    Envelope,
    /// Tangents of their edge of regression: multiples of its derivative.
    Tangent,
    /// Segments between two curves: shares of the way.
    Ruled,
}

/// A panel, or with `for` one panel for each round of its loops.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PanelEntry {
    /// The caption; `{name}` stands for the value of a loop.
    #[serde(default)]
    pub caption: String,
    /// One panel for each round.
    #[serde(default, rename = "for")]
    pub loops: Vec<Loop>,
    /// More values of symbols.
    #[serde(default)]
    pub set: BTreeMap<String, Text>,
    /// More values of families with two indices.
    #[serde(default)]
    pub nets: BTreeMap<String, Vec<Text>>,
    /// Titles of the axes.
    pub axes: Option<Spanned<Vec<String>>>,
    /// The interval `[low, high]` shown of the first axis.
    pub x: Option<Text>,
    /// The interval shown of the second axis.
    pub y: Option<Text>,
    /// The interval shown of the third axis.
    pub z: Option<Text>,
    /// Relation of the units of a plane panel.
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

/// A loop: names that run through lists of values in step. Several loops are nested, the first outermost.
pub type Loop = BTreeMap<String, Spanned<Vec<Text>>>;

/// One thing that is drawn, or with `for` one for each round of its loops.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LayerEntry {
    /// What it is.
    pub draw: Spanned<Shape>,
    /// Its positions, as a formula.
    pub at: Text,
    /// The variables that run: `"x"`, `"x in [0, 1/2]"`, `"i in 0..3"`.
    #[serde(default)]
    pub over: Vec<Text>,
    /// One layer for each round.
    #[serde(default, rename = "for")]
    pub loops: Vec<Loop>,
    /// The number of samples along each running variable.
    #[serde(default)]
    pub samples: Vec<Spanned<u32>>,
    /// A number on a surface that becomes its colour.
    pub shade: Option<Text>,
    /// Its entry in the legend; `{name}` stands for the value of a loop.
    #[serde(default)]
    pub label: String,
    /// The text of a note.
    #[serde(default)]
    pub text: String,
    /// Everything about its looks.
    #[serde(default)]
    pub style: Style,
}

/// What a layer is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shape {
    /// A curve; one variable runs.
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
    /// A surface in space; two variables run.
    Surface,
    /// A control net in space; two indices run.
    Net,
    /// The plane p X + q Y + r Z = s in space, as the vector [p, q, r, s].
    Plane,
}

/// The looks of a layer; what is left out is chosen.
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
    /// From 0, invisible, to 1.
    pub opacity: Option<f64>,
    /// Number of parts into which parameter lines cut a surface, along each variable.
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
    /// A colour of its own.
    Named(NamedColour),
}

/// The colours outside the palette.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NamedColour {
    /// That of text.
    Ink,
    /// That of secondary lines.
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
