//! The flat pattern as the page draws it: lines by layers.

use serde::Serialize;
use torse::Pattern;
use torse::exchange::Layer;

/// The pattern in the coordinates of its file, y upwards.
#[derive(Serialize)]
pub struct DrawnPattern {
    paths: Vec<DrawnPath>,
    texts: Vec<DrawnText>,
    /// The lower left and the upper right corner of what is drawn.
    bounds: [[f64; 2]; 2],
    /// What it promises.
    summary: String,
}

#[derive(Serialize)]
struct DrawnPath {
    layer: &'static str,
    points: Vec<[f64; 2]>,
    closed: bool,
}

#[derive(Serialize)]
struct DrawnText {
    at: [f64; 2],
    height: f64,
    /// In degrees, counterclockwise.
    angle: f64,
    text: String,
}

/// Arcs become polygons whose chords are off by this share of the radius.
pub const CHORD: f64 = 5e-4;

/// The name of a layer for styles.
fn layer_name(layer: Layer) -> &'static str {
    match layer {
        Layer::Outline => "outline",
        Layer::Rulings => "ruling",
        Layer::BendUp => "up",
        Layer::BendDown => "down",
        Layer::Regression => "regression",
        Layer::Marks => "mark",
    }
}

/// Draws it with every so many of its rulings.
pub fn drawn(pattern: &Pattern, every: usize) -> DrawnPattern {
    let drawing = pattern.drawing();
    let mut paths = Vec::new();
    let mut ruling = 0;
    for path in drawing.paths() {
        if path.layer() == Layer::Outline {
            // A piece begins.
            ruling = 0;
        }
        if path.bend().is_some() {
            ruling += 1;
            if (ruling - 1) % every != 0 {
                continue;
            }
        }
        paths.push(DrawnPath {
            layer: layer_name(path.layer()),
            points: path.polygon(CHORD),
            closed: path.is_closed(),
        });
    }
    let texts = drawing.texts().iter().map(|text| DrawnText {
        at: text.at,
        height: text.height,
        angle: text.angle.to_degrees(),
        text: text.content.clone(),
    });
    DrawnPattern {
        texts: texts.collect(),
        bounds: drawing.bounds().unwrap_or_default(),
        summary: pattern.summary().text(),
        paths,
    }
}
