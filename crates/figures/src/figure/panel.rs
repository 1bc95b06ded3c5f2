//! Panels: their loops, the values they set, their axes.

use super::drawing::{Interval, Layer, Panel, Scale};
use super::environment::{Environment, complaint, fraction, wrong};
use super::loops::Round;
use super::reader::Reader;
use super::{Faulty, in_file_order};
use torse_algebra::Fraction;
use torse_prove::evaluate::value::Value;
use torse_syntax::derivation::schema::Text;
use torse_syntax::derivation::schema::figure::{LayerEntry, PanelEntry, Shape};
use torse_syntax::derivation::{DerivationError, Figure};

/// The context in which the panels of a figure are evaluated.
pub(super) struct Context<'a> {
    pub figure: &'a Figure,
    pub round: Round<'a>,
    /// The sliders, if they stay symbolic.
    pub free: &'a [String],
}

impl<'a> Context<'a> {
    /// Returns the panels of the entry with this number.
    pub fn panels(&self, number: usize, entry: &PanelEntry) -> Faulty<Vec<Panel>> {
        let mut round = self.round.clone();
        for set in [&self.figure.entry.set, &entry.set] {
            round.environment.set_integers(set)?;
        }
        round
            .rounds(&entry.loops, self.free)?
            .iter()
            .map(|round| self.panel(number, entry, round))
            .collect()
    }

    fn panel(&self, number: usize, entry: &PanelEntry, round: &Round<'a>) -> Faulty<Panel> {
        let environment = self.with_values(entry, round)?;
        let reader = Reader::new(&environment);
        let layers = self.layers(entry, round, &reader)?;
        let dimension = layers.first().map_or(2, |(_, layer)| layer.dimension());
        for (text, layer) in &layers {
            if layer.dimension() != dimension {
                let (what, wanted) = match dimension {
                    2 => (
                        "a point in space",
                        "a point of the plane, as in the first layer,",
                    ),
                    _ => (
                        "a point of the plane",
                        "a point in space, as in the first layer,",
                    ),
                };
                return Err(wrong(reader.source, &text.at, what, wanted));
            }
        }
        if let Some(axes) = &entry.axes
            && axes.get_ref().len() != dimension
        {
            let range = axes.span();
            let origin =
                torse_syntax::derivation::Origin::range(reader.source, range.start, range.end);
            let message = format!("{} titles for {dimension} axes", axes.get_ref().len());
            return Err(Box::new(DerivationError::at(
                &origin,
                Default::default(),
                message,
            )));
        }
        check_ranges(entry, &reader, dimension, &layers)?;
        let side = |text: &Option<Text>| text.as_ref().map(|t| interval(&reader, t)).transpose();
        Ok(Panel {
            entry: number,
            caption: round.filled(&entry.caption),
            dimension,
            axes: entry.axes.as_ref().map(|axes| {
                axes.get_ref()
                    .iter()
                    .map(|title| round.filled(title))
                    .collect()
            }),
            ranges: [side(&entry.x)?, side(&entry.y)?, side(&entry.z)?],
            aspect: entry.aspect,
            frame: entry.frame,
            legend: entry.legend,
            view: entry.view,
            scale: Scale {
                label: entry.scale.label.clone(),
                map: entry.scale.map,
                range: side(&entry.scale.range)?,
            },
            layers: layers.into_iter().map(|(_, layer)| layer).collect(),
        })
    }

    /// Returns the layers of a panel, one for each round of their loops. Layers with the same rounds share a reader,
    /// and a layer whose loops change nothing has the reader of the panel.
    fn layers<'e>(
        &self,
        entry: &'e PanelEntry,
        round: &Round<'a>,
        own: &Reader<'_>,
    ) -> Faulty<Vec<(&'e LayerEntry, Layer)>> {
        let mut rounds = vec![];
        for layer in &entry.layer {
            let inner = round.rounds(&layer.loops, self.free)?;
            rounds.extend(inner.into_iter().map(|inner| (layer, inner)));
        }
        let mut others: Vec<&Round<'a>> = vec![];
        for (_, inner) in &rounds {
            if !inner.is_like(round) && !others.iter().any(|other| inner.is_like(other)) {
                others.push(inner);
            }
        }
        let environments = others.iter().map(|other| self.with_values(entry, other));
        let environments = environments.collect::<Faulty<Vec<_>>>()?;
        let readers: Vec<Reader<'_>> = environments.iter().map(Reader::new).collect();
        let layer = |(layer, inner): (&'e LayerEntry, &Round<'a>)| {
            let mut known = others.iter().zip(&readers);
            let other = known.find(|(other, _)| inner.is_like(other));
            let reader = other.map_or(own, |(_, reader)| reader);
            Ok((layer, self.layer(layer, inner, reader)?))
        };
        let placed = rounds.iter().map(|(layer, inner)| (*layer, inner));
        placed.map(layer).collect()
    }

    /// Makes the environment of a round with the values that figure and panel set. All but integers, which may bound
    /// loops, are set after the loops, so that points may depend on loop variables.
    fn with_values(&self, entry: &PanelEntry, round: &Round<'a>) -> Faulty<Environment<'a>> {
        let mut environment = round.environment.clone();
        let figure = &self.figure.entry;
        for (set, nets) in [(&figure.set, &figure.nets), (&entry.set, &entry.nets)] {
            for (name, text) in in_file_order(set) {
                environment.set(name, text)?;
            }
            for (name, rows) in nets {
                environment.set_net(name, rows)?;
            }
        }
        environment.solve(&figure.given, &figure.solve_for)?;
        Ok(environment)
    }
}

/// A box in space has three sides, and a plane needs one.
fn check_ranges(
    entry: &PanelEntry,
    reader: &Reader<'_>,
    dimension: usize,
    layers: &[(&LayerEntry, Layer)],
) -> Faulty<()> {
    let given = [&entry.x, &entry.y, &entry.z].map(Option::as_ref);
    let plane = layers.iter().find(|(_, layer)| layer.shape == Shape::Plane);
    let message = match (dimension, given) {
        (2, [_, _, Some(text)]) => Some((text, "a plane has no third axis")),
        (2, _) | (_, [Some(_), Some(_), Some(_)]) => None,
        (_, [Some(text), ..] | [_, Some(text), _] | [_, _, Some(text)]) => Some((
            text,
            "in space all three of `x`, `y` and `z` are given, or none",
        )),
        (_, [None, None, None]) => plane.map(|(layer, _)| {
            let message = "a plane has no end: the panel needs intervals `x`, `y` and `z`";
            (&layer.at, message)
        }),
    };
    match message {
        None => Ok(()),
        Some((text, message)) => Err(Box::new(complaint(reader.source, text, message))),
    }
}

/// Returns the two ends of an interval, written as a vector `[low, high]`.
pub(super) fn interval(reader: &Reader<'_>, text: &Text) -> Faulty<Interval> {
    let value = reader.value(text)?;
    ends(reader, text, &value)
}

/// Returns the two ends of an interval from its value.
pub(super) fn ends(reader: &Reader<'_>, text: &Text, value: &Value) -> Faulty<Interval> {
    let Value::Vector(vector) = value else {
        return Err(wrong(
            reader.source,
            text,
            value.kind(),
            "an interval `[low, high]`",
        ));
    };
    let numbers = vector
        .entries
        .iter()
        .map(|q| fraction(reader.source, text, q))
        .collect::<Faulty<Vec<Fraction>>>()?;
    match <[Fraction; 2]>::try_from(numbers) {
        Ok([low, high]) => Ok(Interval { low, high }),
        Err(_) => Err(wrong(
            reader.source,
            text,
            "a longer vector",
            "an interval `[low, high]`",
        )),
    }
}
