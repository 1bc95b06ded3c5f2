//! A figure as exact data: every formula evaluated, with only the running variables symbolic.

use serde::{Serialize, Serializer};
use torse_algebra::Fraction;
use torse_syntax::derivation::schema::figure::{
    Aspect, ColourMap, Frame, Legend, Rulings, Shape, Style,
};

/// A figure ready to be sampled and drawn.
#[derive(Debug, Clone, Serialize)]
pub struct Drawing {
    /// The name, `paper/name`.
    pub id: String,
    /// The claims that it illustrates.
    pub claims: Vec<String>,
    /// The title.
    pub title: String,
    /// The description.
    pub caption: String,
    /// The visible objects.
    pub alt: String,
    /// Data with a default.
    pub assumes: Vec<String>,
    /// Data replaced by our own.
    pub stand_in: Vec<String>,
    /// Panels in a row.
    pub columns: Option<usize>,
    /// Width and height of a panel in pixels of 1/96 inch.
    pub size: Option<[u32; 2]>,
    /// The symbols with sliders; free in [`interactive`](super::interactive).
    pub sliders: Vec<Slider>,
    /// The panels.
    pub panels: Vec<Panel>,
}

/// A symbol with a slider.
#[derive(Debug, Clone, Serialize)]
pub struct Slider {
    /// The symbol.
    pub name: String,
    /// Its minimum and maximum.
    pub range: Interval,
    /// Its initial value.
    #[serde(serialize_with = "exact")]
    pub start: Fraction,
}

/// A closed interval with exact ends.
#[derive(Debug, Clone, Serialize)]
pub struct Interval {
    /// The lower end.
    #[serde(serialize_with = "exact")]
    pub low: Fraction,
    /// The upper end.
    #[serde(serialize_with = "exact")]
    pub high: Fraction,
}

/// A developable with its sliders left symbolic.
#[derive(Debug, Clone)]
pub struct Torse {
    /// The sliders.
    pub sliders: Vec<Slider>,
    /// Azimuth and elevation in degrees.
    pub view: [f64; 2],
    /// The pieces, one joined to the other.
    pub pieces: Vec<Piece>,
}

/// A piece of a developable.
#[derive(Debug, Clone)]
pub struct Piece {
    /// How its rulings are given.
    pub rulings: Rulings,
    /// The coordinates of the plane or of the two points that run.
    pub curves: Vec<Vec<Fraction>>,
    /// The running variable.
    pub over: Running,
    /// Where each ruling starts and ends.
    pub along: Interval,
    /// How far it is shown, from the place where its parameter is 0.
    pub limit: Option<Fraction>,
    /// Its entry in the legend.
    pub label: String,
    /// Its number in the palette.
    pub colour: usize,
}

/// One panel.
#[derive(Debug, Clone, Serialize)]
pub struct Panel {
    /// The entry of the figure that it comes from: panels of one entry show the same for other values, and are
    /// compared.
    pub entry: usize,
    /// The caption.
    pub caption: String,
    /// The number of coordinates, 2 or 3.
    pub dimension: usize,
    /// Titles of the axes.
    pub axes: Option<Vec<String>>,
    /// The interval shown of each axis.
    pub ranges: [Option<Interval>; 3],
    /// Relation of the units.
    pub aspect: Aspect,
    /// Surroundings.
    pub frame: Frame,
    /// Place of the legend.
    pub legend: Legend,
    /// Azimuth and elevation in degrees.
    pub view: Option<[f64; 2]>,
    /// Colours of numbers.
    pub scale: Scale,
    /// The layers, from below to above.
    pub layers: Vec<Layer>,
}

/// How numbers on surfaces become colours.
#[derive(Debug, Clone, Serialize)]
pub struct Scale {
    /// Title of the scale bar.
    pub label: String,
    /// The colours.
    pub map: ColourMap,
    /// The numbers at the ends of the map.
    pub range: Option<Interval>,
}

/// A drawn object.
#[derive(Debug, Clone, Serialize)]
pub struct Layer {
    /// Its kind.
    pub shape: Shape,
    /// The formula of its positions, for messages.
    pub formula: String,
    /// Its points, row by row: one that runs for a curve or a surface, several for a list.
    #[serde(serialize_with = "exact_points")]
    pub points: Vec<Vec<Fraction>>,
    /// The number of points in a row of a net.
    pub columns: usize,
    /// The running variables.
    pub running: Vec<Running>,
    /// The number that becomes a colour.
    #[serde(serialize_with = "exact_option")]
    pub shade: Option<Fraction>,
    /// Its entry in the legend.
    pub label: String,
    /// The text of a note.
    pub text: String,
    /// The round of the outermost loop; none without a loop.
    pub round: Option<usize>,
    /// Its style.
    pub style: Style,
}

/// A variable that runs through an interval.
#[derive(Debug, Clone, Serialize)]
pub struct Running {
    /// The variable.
    pub name: String,
    /// Where it runs.
    pub range: Interval,
    /// The number of samples; if none is given, enough for a smooth picture.
    pub samples: Option<u32>,
}

fn exact<S: Serializer>(value: &Fraction, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(value)
}

fn exact_option<S: Serializer>(value: &Option<Fraction>, serializer: S) -> Result<S::Ok, S::Error> {
    match value {
        Some(value) => serializer.collect_str(value),
        None => serializer.serialize_none(),
    }
}

fn exact_points<S: Serializer>(points: &[Vec<Fraction>], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(
        points
            .iter()
            .map(|point| point.iter().map(ToString::to_string).collect::<Vec<_>>()),
    )
}
