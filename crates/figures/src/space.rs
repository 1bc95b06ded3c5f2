//! Views of solids.

use crate::PlateError;
use crate::figure::{Layer, Panel};
use crate::plane::pairs;
use crate::sample::{Samples, ends, fixed, samples};
use crate::style::{self, PaletteCycle};
use torse_plot::{
    Border, Bounds, Camera, Colour, ColourMap, Grid, Line, Paint, Scale, Solid, Stage, Surface,
    SurfaceLines, View,
};
use torse_syntax::derivation::schema::figure::{self as schema, ColourName, Shape};

type Point = [f64; 3];

/// Makes a view of the panel.
pub(crate) fn view(panel: &Panel) -> Result<View, PlateError> {
    let sides = match &panel.ranges {
        [Some(x), Some(y), Some(z)] => Some([ends(x)?, ends(y)?, ends(z)?]),
        _ => None,
    };
    let titles = panel
        .axes
        .as_deref()
        .and_then(|axes| <[String; 3]>::try_from(axes.to_vec()).ok());
    let mut view = View {
        solids: vec![],
        camera: match panel.view {
            Some([azimuth, elevation]) => Camera::Angles { azimuth, elevation },
            None => Camera::Auto,
        },
        bounds: sides.map_or(Bounds::Data, Bounds::Fixed),
        stage: match (panel.frame, titles) {
            (schema::Frame::Bare, _) => Stage::Bare,
            (schema::Frame::Box, Some(titles)) => Stage::Box(titles),
            (schema::Frame::Box, None) => Stage::default(),
        },
        scale: Scale {
            map: match panel.scale.map {
                schema::ColourMap::Sequential => ColourMap::Sequential,
                schema::ColourMap::Diverging => ColourMap::Diverging,
            },
            range: panel.scale.range.as_ref().map(ends).transpose()?,
            label: panel.scale.label.clone(),
        },
        legend: style::legend(panel.legend),
    };
    let surfaces = panel
        .layers
        .iter()
        .filter(|l| l.shape == Shape::Surface)
        .count();
    let (mut lines, mut paints) = (PaletteCycle::default(), PaletteCycle::default());
    let mut labels = vec![String::new()];
    for layer in &panel.layers {
        let mut label = layer.label.clone();
        if labels.contains(&label) {
            label.clear();
        } else {
            labels.push(label.clone());
        }
        let sampled = samples(layer)?;
        let solids = match layer.shape {
            Shape::Surface => {
                let number = paints.deal(layer);
                let paint = match layer.style.colour {
                    None if surfaces == 1 => Paint::default(),
                    None | Some(ColourName::Palette(_)) => Paint::nth(number),
                    Some(ColourName::Named(_)) => Paint::plain(style::colour(layer, Colour::GREY)),
                };
                vec![Solid::Surface(surface(layer, sampled, paint, label)?)]
            }
            Shape::Plane => {
                let paint = Paint::plain(torse_plot::palette(paints.deal(layer)));
                vec![Solid::Surface(plane(layer, &sampled, sides, paint, label)?)]
            }
            _ => thin(layer, &sampled, label, &mut lines)?,
        };
        view.solids.extend(solids);
    }
    Ok(view)
}

fn surface(
    layer: &Layer,
    sampled: Samples,
    paint: Paint,
    label: String,
) -> Result<Surface, PlateError> {
    let [rows, columns] = sampled.grid;
    let style = &layer.style;
    let [u, v] = style.lines.unwrap_or([8, 8]);
    Ok(Surface {
        paint: sampled.shade.map_or(paint, Paint::Values),
        lines: SurfaceLines { u, v },
        border: border(style.border.unwrap_or_default()),
        opacity: style.opacity.unwrap_or(1.0),
        label,
        ..Surface::new(Grid::new(rows, columns, fixed(&sampled.lists.concat()))?)
    })
}

fn border(word: schema::Border) -> Border {
    match word {
        schema::Border::Drawn => Border::Drawn,
        schema::Border::Hidden => Border::Hidden,
    }
}

/// Adds everything without area.
fn thin(
    layer: &Layer,
    sampled: &Samples,
    label: String,
    dealer: &mut PaletteCycle,
) -> Result<Vec<Solid>, PlateError> {
    let points: Vec<Point> = fixed(&sampled.lists.concat());
    let grey = style::line(layer, Line::solid(Colour::rgb(0x50, 0x52, 0x58), 1.0));
    Ok(match layer.shape {
        Shape::Curve => {
            let number = dealer.deal(layer);
            let line = style::line(
                layer,
                Line {
                    width: 2.2,
                    ..Line::nth(number)
                },
            );
            vec![Solid::Curve {
                points,
                line,
                label,
            }]
        }
        Shape::Polygon => {
            let dots = Solid::Points {
                points: points.clone(),
                colour: grey.colour,
                label: String::new(),
            };
            vec![
                Solid::Curve {
                    points,
                    line: grey,
                    label,
                },
                dots,
            ]
        }
        Shape::Points => vec![Solid::Points {
            points,
            colour: style::colour(layer, Colour::INK),
            label,
        }],
        Shape::Net => {
            let columns = layer.columns.max(1);
            let grid = Grid::new(points.len() / columns, columns, points)?;
            vec![Solid::Net {
                grid,
                line: grey,
                label,
            }]
        }
        Shape::Note => {
            let place = style::place(layer);
            let note = |at| Solid::Note {
                at,
                text: layer.text.clone(),
                place,
            };
            points.into_iter().map(note).collect()
        }
        Shape::Arrows => {
            let line = style::line(layer, Line::solid(Colour::INK, 1.6));
            let arrow = |[from, to]: [Point; 2]| Solid::Arrow { from, to, line };
            pairs(&sampled.lists).into_iter().map(arrow).collect()
        }
        Shape::Segments => {
            let mut label = label;
            let segment = |[from, to]: [Point; 2]| Solid::Curve {
                points: vec![from, to],
                line: grey,
                label: std::mem::take(&mut label),
            };
            pairs(&sampled.lists).into_iter().map(segment).collect()
        }
        Shape::Region | Shape::Surface | Shape::Plane => vec![],
    })
}

/// Returns the part of a plane around the box of the panel, which clips it: a square about the point of the plane
/// nearest to the middle of the box, as wide as the diagonal.
fn plane(
    layer: &Layer,
    sampled: &Samples,
    sides: Option<[[f64; 2]; 3]>,
    paint: Paint,
    label: String,
) -> Result<Surface, PlateError> {
    let missing = || PlateError::Plane {
        formula: layer.formula.clone(),
    };
    let sides = sides.ok_or_else(missing)?;
    let coordinates: Vec<[f64; 4]> = fixed(&sampled.lists.concat());
    let [p, q, r, s] = coordinates.first().copied().ok_or_else(missing)?;
    let length = (p * p + q * q + r * r).sqrt();
    if length == 0.0 || !length.is_finite() {
        return Err(missing());
    }
    let normal = [p / length, q / length, r / length];
    let middle = sides.map(|[low, high]| (low + high) / 2.0);
    let above = dot(normal, middle) - s / length;
    let foot: Point = std::array::from_fn(|k| middle[k] - above * normal[k]);
    let reach = sides
        .map(|[low, high]| (high - low).powi(2))
        .iter()
        .sum::<f64>()
        .sqrt();
    // The axis most nearly across the normal gives the first side of the square.
    let steep = (0..3)
        .min_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs()))
        .unwrap_or(0);
    let axis: Point = std::array::from_fn(|k| f64::from(u8::from(k == steep)));
    let first = unit(cross(normal, axis));
    let second = cross(normal, first);
    let grid = Grid::sample(2, 2, |a, b| {
        std::array::from_fn(|k| foot[k] + reach * ((a - 0.5) * first[k] + (b - 0.5) * second[k]))
    })?;
    Ok(Surface::new(grid)
        .paint(paint)
        .border(Border::Hidden)
        .opacity(layer.style.opacity.unwrap_or(0.4))
        .label(&label))
}

fn dot(a: Point, b: Point) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn cross([a, b, c]: Point, [x, y, z]: Point) -> Point {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn unit(v: Point) -> Point {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}
