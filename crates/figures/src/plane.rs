//! Plane panels.

use crate::PlateError;
use crate::figure::{Interval, Panel};
use crate::sample::{ends, fixed, samples};
use crate::style::{self, PaletteCycle};
use torse_plot::{Aspect, Axis, Colour, Frame, Layer, Line, Plot};
use torse_syntax::derivation::schema::figure::{self as schema, Shape};

/// Makes a plot of the panel.
pub(crate) fn plot(panel: &Panel) -> Result<Plot, PlateError> {
    let titles = panel
        .axes
        .clone()
        .unwrap_or_else(|| vec!["$x$".to_owned(), "$y$".to_owned()]);
    let axis = |number: usize| -> Result<Axis, PlateError> {
        let range = panel.ranges.get(number).and_then(Option::as_ref);
        Ok(Axis {
            label: titles.get(number).cloned().unwrap_or_default(),
            range: range.map(|r: &Interval| ends(r)).transpose()?,
        })
    };
    let mut plot = Plot {
        aspect: match panel.aspect {
            schema::Aspect::Equal => Aspect::Equal,
            schema::Aspect::Free => Aspect::Free,
        },
        frame: match panel.frame {
            schema::Frame::Box => Frame::Box,
            schema::Frame::Bare => Frame::Bare,
        },
        legend: style::legend(panel.legend),
        ..Plot::new(axis(0)?, axis(1)?)
    };
    let mut dealer = PaletteCycle::default();
    let mut labels = vec![String::new()];
    for layer in &panel.layers {
        let mut label = layer.label.clone();
        if labels.contains(&label) {
            label.clear();
        } else {
            labels.push(label.clone());
        }
        plot.layers.extend(drawn(layer, label, &mut dealer)?);
    }
    Ok(plot)
}

fn drawn(
    layer: &crate::figure::Layer,
    label: String,
    dealer: &mut PaletteCycle,
) -> Result<Vec<Layer>, PlateError> {
    let sampled = samples(layer)?;
    let points: Vec<[f64; 2]> = fixed(&sampled.lists.concat());
    let grey = |width| style::line(layer, Line::solid(Colour::GREY, width));
    Ok(match layer.shape {
        Shape::Curve => {
            let line = style::curve(layer, dealer.deal(layer));
            vec![Layer::Curve {
                points,
                line,
                label,
            }]
        }
        Shape::Polygon => vec![Layer::ControlPolygon {
            points,
            line: grey(0.9),
            label,
        }],
        Shape::Points => vec![Layer::Points {
            points,
            marker: style::marker(layer),
            colour: style::colour(layer, Colour::INK),
            label,
        }],
        Shape::Region => vec![Layer::Region {
            boundary: points,
            colour: style::colour(layer, torse_plot::palette(dealer.deal(layer))),
            opacity: layer.style.opacity.unwrap_or(0.25),
            label,
        }],
        Shape::Note => {
            let place = style::place(layer);
            let note = |at| Layer::Note {
                at,
                text: layer.text.clone(),
                place,
            };
            points.into_iter().map(note).collect()
        }
        Shape::Segments | Shape::Arrows => {
            let arrows = layer.shape == Shape::Arrows;
            let mut label = label;
            pairs(&sampled.lists)
                .into_iter()
                .map(|[from, to]| match arrows {
                    true => Layer::Arrow {
                        from,
                        to,
                        line: style::line(layer, Line::solid(Colour::INK, 1.4)),
                    },
                    false => Layer::Curve {
                        points: vec![from, to],
                        line: grey(1.0),
                        label: std::mem::take(&mut label),
                    },
                })
                .collect()
        }
        Shape::Surface | Shape::Net | Shape::Plane => vec![],
    })
}

/// Joins every list at an even place with the next one, point by point.
pub(crate) fn pairs<const N: usize>(lists: &[Vec<Vec<f64>>]) -> Vec<[[f64; N]; 2]> {
    lists
        .chunks(2)
        .flat_map(|pair| match pair {
            [from, to] => fixed(from)
                .into_iter()
                .zip(fixed(to))
                .map(|(a, b)| [a, b])
                .collect(),
            _ => vec![],
        })
        .collect()
}
