//! SVG of drawings.

mod commands;
mod read;

use crate::drawing::{Drawing, Layer};
use crate::error::{ExchangeError, Result};
use commands::commands;
use std::fmt::Write;

/// The drawing as SVG in true size: one unit is one millimetre, each layer a group with its name (a layer for Inkscape
/// too), arcs as arcs, notes as the description. The bend angle of a line is its attribute `data-bend`, in radians, its
/// inside radius `data-inside-radius`; `data-order` is its place among all paths of the drawing. Numbers are in the
/// shortest form that reads back to the same f64.
///
/// # Errors
/// [`ExchangeError::Empty`] for a drawing without paths.
///
/// ```
/// use torse_exchange::{Drawing, Layer, svg};
/// let mut drawing = Drawing::default();
/// drawing.polygon(Layer::Outline, &[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]])?;
/// let text = svg(&drawing)?;
/// // A margin of a fiftieth of the larger side; y points up in the drawing and down in SVG.
/// assert!(text.contains(r#"width="1.08mm" height="2.08mm" viewBox="-0.04 -2.04 1.08 2.08""#));
/// assert!(text.contains(r#"d="M0 0L1 0L1 -2Z""#));
/// # Ok::<(), torse_exchange::ExchangeError>(())
/// ```
pub fn svg(drawing: &Drawing) -> Result<String> {
    let Some([low, high]) = drawing.bounds().filter(|_| !drawing.paths().is_empty()) else {
        return Err(ExchangeError::Empty { what: "paths" });
    };
    let (width, height) = (high[0] - low[0], high[1] - low[1]);
    let margin = 0.02 * width.max(height);
    let (w, h) = (width + 2.0 * margin, height + 2.0 * margin);
    let (left, top) = (low[0] - margin, -high[1] - margin);
    let mut text = format!(
        concat!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" ",
            "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" ",
            "width=\"{w}mm\" height=\"{h}mm\" viewBox=\"{left} {top} {w} {h}\" ",
            "fill=\"none\" stroke-width=\"{stroke}\">\n"
        ),
        w = w,
        h = h,
        left = left,
        top = top,
        stroke = drawing.stroke_width().unwrap_or(0.1 * margin),
    );
    if !drawing.notes().is_empty() {
        let notes = escaped(&drawing.notes().join("\n"));
        let _ = writeln!(text, "<desc>{notes}</desc>");
    }
    for layer in Layer::ALL {
        let all = || drawing.paths().iter().enumerate();
        let paths = || all().filter(|(_, path)| path.layer() == layer);
        let letters = || drawing.texts().iter().filter(|text| text.layer == layer);
        if paths().next().is_none() && letters().next().is_none() {
            continue;
        }
        let (name, colour) = (layer.name(), colour(layer));
        let dashes = match dashes(layer) {
            Some([dash, gap, dot]) => {
                let [dash, gap, dot] = [dash, gap, dot].map(|share| share * margin);
                format!(" stroke-dasharray=\"{dash} {gap} {dot} {gap}\"")
            }
            None => String::new(),
        };
        let _ = writeln!(
            text,
            "<g id=\"{name}\" inkscape:groupmode=\"layer\" inkscape:label=\"{name}\" stroke=\"{colour}\"{dashes}>"
        );
        for (order, path) in paths() {
            let bend = path.bend().map(|a| format!(" data-bend=\"{}\"", a + 0.0));
            let bend = bend.unwrap_or_default();
            let radius = path
                .inside_radius()
                .map(|radius| format!(" data-inside-radius=\"{radius}\""))
                .unwrap_or_default();
            let _ = writeln!(
                text,
                "<path d=\"{}\" data-order=\"{order}\"{bend}{radius}/>",
                commands(path)
            );
        }
        for letter in letters() {
            let ([x, y], content) = (letter.at, escaped(&letter.content));
            let (size, turn) = (letter.height, -letter.angle.to_degrees() + 0.0);
            let (x, y) = (x + 0.0, 0.0 - y);
            let _ = writeln!(
                text,
                "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" transform=\"rotate({turn} {x} {y})\" \
                 fill=\"{colour}\" stroke=\"none\">{content}</text>"
            );
        }
        text.push_str("</g>\n");
    }
    text.push_str("</svg>\n");
    Ok(text)
}

/// The strokes of bend lines, upward dashed and downward dashed with dots: stroke, gap and second stroke as shares of the
/// margin.
fn dashes(layer: Layer) -> Option<[f64; 3]> {
    match layer {
        Layer::BendUp => Some([1.0, 0.5, 1.0]),
        Layer::BendDown => Some([1.0, 0.5, 0.125]),
        _ => None,
    }
}

fn colour(layer: Layer) -> &'static str {
    match layer {
        Layer::Outline => "black",
        Layer::Rulings => "gray",
        Layer::BendUp => "blue",
        Layer::BendDown => "red",
        Layer::Regression => "magenta",
        Layer::Marks => "green",
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
