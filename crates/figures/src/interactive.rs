//! Figures with sliders.
//!
//! With the sliders left symbolic, positions that are polynomials in them are split by their monomials: `position = sum
//! over monomials of slider powers times a function of the running variables`. Each of these functions is sampled once;
//! a viewer then needs only sums, and no basis.

use crate::PlateError;
use crate::figure::{Drawing, Layer, Panel};
use crate::function::Function;
use crate::plate::Plate;
use crate::sample::{ends, fixed, number, values};
use crate::style::{self, PaletteCycle};
use std::collections::BTreeMap;
use torse_algebra::{Fraction, Polynomial, Symbol};
use torse_plot::{Ambient, HIGHEST_EXPONENT, Interactive, Part, Slider, palette};
use torse_syntax::derivation::schema::figure::{ColourName, Shape};
use torse_syntax::greek;

/// Samples of a curve, and of a surface along both variables.
const CURVE: u64 = 65;
const SURFACE: [u64; 2] = [29, 15];

/// A formula by monomials of the sliders.
type Split = BTreeMap<Vec<u32>, Fraction>;

impl Plate {
    /// Returns the first panel as a picture that follows sliders; none if the figure has no sliders, or if some
    /// position is not a polynomial in them.
    ///
    /// # Errors
    /// As [`Plate::draw`].
    pub fn interactive(&self) -> Result<Option<Interactive>, PlateError> {
        match &self.movable {
            Some(drawing) => interactive(drawing),
            None => Ok(None),
        }
    }
}

fn interactive(drawing: &Drawing) -> Result<Option<Interactive>, PlateError> {
    let Some(panel) = drawing.panels.first() else {
        return Ok(None);
    };
    let names: Vec<&str> = drawing.sliders.iter().map(|s| s.name.as_str()).collect();
    let mut split = vec![];
    for layer in &panel.layers {
        let Some(shape) = part_shape(layer)? else {
            continue;
        };
        let Some(points) = split_points(layer, &names) else {
            return Ok(None);
        };
        split.push((layer, shape, points));
    }
    let mut monomials: Vec<Vec<u32>> = split
        .iter()
        .flat_map(|(_, _, points)| points.iter().flatten())
        .flat_map(|coordinate| coordinate.keys().cloned())
        .collect();
    monomials.sort();
    monomials.dedup();
    let moves = monomials.iter().any(|m| m.iter().any(|e| *e > 0));
    if !moves || monomials.iter().flatten().any(|e| *e > HIGHEST_EXPONENT) {
        return Ok(None);
    }
    let mut dealer = PaletteCycle::default();
    let mut parts = vec![];
    for (layer, shape, points) in split {
        let nets = monomials
            .iter()
            .map(|monomial| net(layer, &points, monomial))
            .collect::<Result<_, PlateError>>()?;
        let colour = match (layer.shape, layer.style.colour) {
            (Shape::Curve | Shape::Surface, None | Some(ColourName::Palette(_))) => {
                palette(dealer.deal(layer))
            }
            _ => style::colour(layer, torse_plot::Colour::GREY),
        };
        let label = live(&layer.label, &names);
        parts.push(Part {
            label,
            colour,
            shape,
            nets,
        });
    }
    let sliders = drawing
        .sliders
        .iter()
        .map(slider)
        .collect::<Result<_, PlateError>>()?;
    let ambient = ambient(panel);
    let picture = Interactive::new(sliders, monomials, ambient, parts)?;
    // The view of the printed panel, if the file gives one.
    Ok(Some(match panel.view {
        Some(view) => picture.seen_from(view),
        None => picture,
    }))
}

/// Puts the name of a slider in `{name}` between two signs that a viewer replaces by the value.
fn live(label: &str, sliders: &[&str]) -> String {
    sliders.iter().fold(label.to_owned(), |label, name| {
        label.replace(&format!("{{{name}}}"), &format!("\\mathrm{{@{name}@}}"))
    })
}

fn ambient(panel: &Panel) -> Ambient {
    match panel.dimension {
        3 => Ambient::Space,
        _ => Ambient::Plane,
    }
}

fn slider(slider: &crate::figure::Slider) -> Result<Slider, PlateError> {
    let [least, greatest] = ends(&slider.range)?;
    Ok(Slider {
        name: slider.name.clone(),
        label: label(&slider.name),
        least,
        greatest,
        start: number(&slider.start)?,
        step: (greatest - least) / 200.0,
    })
}

/// Writes the name of a symbol as a formula: a number at its end is a subscript.
pub(crate) fn label(name: &str) -> String {
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let index = name.get(base.len()..).unwrap_or("");
    let sign = if greek::by_name(base).is_some() {
        format!("\\{base}")
    } else {
        base.to_owned()
    };
    match index {
        "" => format!("${sign}$"),
        index => format!("${sign}_{{{index}}}$"),
    }
}

/// Returns the shape of the samples of a layer; none for layers that a viewer does not show.
fn part_shape(layer: &Layer) -> Result<Option<torse_plot::Shape>, PlateError> {
    let listed = layer.running.is_empty();
    Ok(match layer.shape {
        Shape::Curve => Some(torse_plot::Shape::Curve),
        Shape::Surface => {
            let [first, second] = counts(layer);
            let (rows, columns) = (first as usize, second as usize);
            Some(torse_plot::Shape::Surface { rows, columns })
        }
        Shape::Net => {
            let columns = layer.columns.max(1);
            let rows = layer.points.len() / columns;
            Some(torse_plot::Shape::Net { rows, columns })
        }
        Shape::Polygon => Some(torse_plot::Shape::Polygon),
        Shape::Points if listed => Some(torse_plot::Shape::Points),
        _ => None,
    })
}

fn counts(layer: &Layer) -> [u64; 2] {
    match layer.shape {
        Shape::Curve => [CURVE, 1],
        Shape::Surface => SURFACE,
        _ => [1, 1],
    }
}

/// Splits every coordinate of every point by monomials; none unless all are polynomials in the sliders.
fn split_points(layer: &Layer, sliders: &[&str]) -> Option<Vec<Vec<Split>>> {
    layer
        .points
        .iter()
        .map(|point| point.iter().map(|c| split(c, sliders)).collect())
        .collect()
}

fn split(coordinate: &Fraction, sliders: &[&str]) -> Option<Split> {
    let denominator = coordinate.denominator();
    let moves = |symbol: &Symbol| sliders.iter().any(|slider| symbol.depends_on(slider));
    // A divisor may depend on running variables, but not on a slider; and sliders are not angles.
    if denominator.symbols().iter().any(moves) {
        return None;
    }
    let mut parts: BTreeMap<Vec<u32>, Polynomial> =
        BTreeMap::from([(vec![], coordinate.numerator().clone())]);
    for slider in sliders {
        let symbol = Symbol::named(slider);
        let mut finer = BTreeMap::new();
        for (exponents, part) in parts {
            for (power, coefficient) in (0..).zip(part.coefficients_in(&symbol)) {
                if !coefficient.is_zero() {
                    let key: Vec<u32> = exponents.iter().copied().chain([power]).collect();
                    finer.insert(key, coefficient);
                }
            }
        }
        parts = finer;
    }
    if parts.values().any(|part| part.symbols().iter().any(moves)) {
        return None;
    }
    let denominator = Fraction::from(denominator);
    parts
        .into_iter()
        .map(|(exponents, part)| Some((exponents, Fraction::from(part).over(&denominator).ok()?)))
        .collect()
}

/// Samples the coefficient of one monomial.
fn net(
    layer: &Layer,
    points: &[Vec<Split>],
    monomial: &Vec<u32>,
) -> Result<Vec<[f64; 3]>, PlateError> {
    let names: Vec<&str> = layer.running.iter().map(|r| r.name.as_str()).collect();
    let along = |place: usize, count: u64| match layer.running.get(place) {
        Some(running) => values(running, count),
        None => Ok(vec![0.0]),
    };
    let [first, second] = counts(layer);
    let (first, second) = (along(0, first)?, along(1, second)?);
    let mut net = vec![];
    for point in points {
        let coordinates = point
            .iter()
            .map(|parts| match parts.get(monomial) {
                Some(part) => Ok(Function::new(part, &names)?.grid(&first, &second)),
                None => Ok(vec![0.0; first.len() * second.len()]),
            })
            .collect::<Result<Vec<_>, PlateError>>()?;
        let count = first.len() * second.len();
        let gathered: Vec<Vec<f64>> = (0..count)
            .map(|k| {
                coordinates
                    .iter()
                    .map(|c| c.get(k).copied().unwrap_or(0.0))
                    .collect()
            })
            .collect();
        net.extend(fixed::<3>(&gathered));
    }
    Ok(net)
}
