//! Samples of a layer: its exact points at enough parameters for a smooth picture.

use crate::PlateError;
use crate::figure::{Interval, Layer, Running};
use crate::function::Function;
use torse_syntax::derivation::schema::figure::Shape;

/// Maximum number of samples of one layer.
const MAX_SAMPLES: u64 = 250_000;

/// The points of a layer.
pub(crate) struct Samples {
    /// The points; one list for each exact point, with its samples.
    pub lists: Vec<Vec<Vec<f64>>>,
    /// Samples along the first and the second running variable.
    pub grid: [usize; 2],
    /// The numbers that become colours.
    pub shade: Option<Vec<f64>>,
}

/// Samples a layer, with `default` samples along each running variable if the file gives no number.
pub(crate) fn samples(layer: &Layer) -> Result<Samples, PlateError> {
    let names: Vec<&str> = layer.running.iter().map(|r| r.name.as_str()).collect();
    let [first, second] = parameters(layer)?;
    let lists = layer
        .points
        .iter()
        .map(|point| {
            let coordinates = point
                .iter()
                .map(|c| Ok(Function::new(c, &names)?.grid(&first, &second)))
                .collect::<Result<Vec<_>, PlateError>>()?;
            let count = first.len() * second.len();
            (0..count)
                .map(|k| gathered(layer, &coordinates, k))
                .collect()
        })
        .collect::<Result<_, PlateError>>()?;
    let shade = match &layer.shade {
        None => None,
        Some(formula) => {
            let values = Function::new(formula, &names)?.grid(&first, &second);
            for (k, value) in values.iter().enumerate() {
                finite(layer, k, *value)?;
            }
            Some(values)
        }
    };
    Ok(Samples {
        lists,
        grid: [first.len(), second.len()],
        shade,
    })
}

fn gathered(layer: &Layer, coordinates: &[Vec<f64>], k: usize) -> Result<Vec<f64>, PlateError> {
    coordinates
        .iter()
        .map(|list| finite(layer, k, list.get(k).copied().unwrap_or(f64::NAN)))
        .collect()
}

fn finite(layer: &Layer, index: usize, value: f64) -> Result<f64, PlateError> {
    if value.is_finite() {
        return Ok(value);
    }
    let formula = layer.formula.clone();
    Err(PlateError::NotFinite {
        formula,
        index,
        value,
    })
}

/// Returns the parameters of the samples along both variables; a missing variable is zero.
pub(crate) fn parameters(layer: &Layer) -> Result<[Vec<f64>; 2], PlateError> {
    let default = match layer.shape {
        Shape::Curve | Shape::Region => 161,
        Shape::Surface => 81,
        Shape::Segments | Shape::Arrows => 25,
        _ => 5,
    };
    let counts: Vec<u64> = layer
        .running
        .iter()
        .map(|r| u64::from(r.samples.unwrap_or(default)))
        .collect();
    let wanted = counts.iter().product();
    if wanted > MAX_SAMPLES {
        let (formula, most) = (layer.formula.clone(), MAX_SAMPLES);
        return Err(PlateError::Samples {
            formula,
            wanted,
            most,
        });
    }
    let along = |place: usize| match (layer.running.get(place), counts.get(place)) {
        (Some(running), Some(count)) => values(running, *count),
        _ => Ok(vec![0.0]),
    };
    Ok([along(0)?, along(1)?])
}

/// Returns `count` parameters from end to end; a single one is the lower end.
pub(crate) fn values(running: &Running, count: u64) -> Result<Vec<f64>, PlateError> {
    let [low, high] = ends(&running.range)?;
    let steps = count.saturating_sub(1).max(1) as f64;
    Ok((0..count)
        .map(|k| {
            let t = k as f64 / steps;
            (1.0 - t) * low + t * high
        })
        .collect())
}

/// The ends of an interval.
pub(crate) fn ends(interval: &Interval) -> Result<[f64; 2], PlateError> {
    Ok([number(&interval.low)?, number(&interval.high)?])
}

/// A constant formula.
pub(crate) fn number(formula: &torse_algebra::Fraction) -> Result<f64, PlateError> {
    let value = Function::new(formula, &[])?.line(&[0.0]);
    Ok(value.first().copied().unwrap_or(f64::NAN))
}

/// Returns points with N coordinates; the layer must have that many.
pub(crate) fn fixed<const N: usize>(points: &[Vec<f64>]) -> Vec<[f64; N]> {
    let fit = |p: &Vec<f64>| std::array::from_fn(|k| p.get(k).copied().unwrap_or(0.0));
    points.iter().map(fit).collect()
}
