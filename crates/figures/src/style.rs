//! Translates the style words of a file.

use crate::figure::Layer;
use torse_plot::{Colour, Dash, Legend, Line, Marker, Place, palette};
use torse_syntax::derivation::schema::figure::{self as schema, ColourName, NamedColour};

/// Assigns palette numbers: a layer has the number it asks for, else that of its round in a loop, else the next free
/// one.
#[derive(Default)]
pub(crate) struct PaletteCycle {
    next: usize,
}

impl PaletteCycle {
    /// The palette number of a layer.
    pub fn deal(&mut self, layer: &Layer) -> usize {
        let number = match (layer.style.colour, layer.round) {
            (Some(ColourName::Palette(number)), _) => number,
            (_, Some(round)) => round,
            _ => self.next,
        };
        self.next = self.next.max(number + 1);
        number
    }
}

/// A line with the width, pattern and colour that the layer asks for, or those of `default`.
pub(crate) fn line(layer: &Layer, default: Line) -> Line {
    let style = &layer.style;
    Line {
        colour: colour(layer, default.colour),
        width: style.width.unwrap_or(default.width),
        dash: style.dash.map_or(default.dash, dash),
    }
}

/// The line of a curve: colour and pattern of its number.
pub(crate) fn curve(layer: &Layer, number: usize) -> Line {
    line(layer, Line::nth(number))
}

/// The colour that the layer asks for, or `default`.
pub(crate) fn colour(layer: &Layer, default: Colour) -> Colour {
    match layer.style.colour {
        None => default,
        Some(ColourName::Palette(number)) => palette(number),
        Some(ColourName::Named(NamedColour::Ink)) => Colour::INK,
        Some(ColourName::Named(NamedColour::Grey)) => Colour::GREY,
    }
}

fn dash(word: schema::Dash) -> Dash {
    match word {
        schema::Dash::Solid => Dash::Solid,
        schema::Dash::Dashed => Dash::Dashed,
        schema::Dash::DashDot => Dash::DashDot,
        schema::Dash::Dotted => Dash::Dotted,
    }
}

pub(crate) fn marker(layer: &Layer) -> Marker {
    match layer.style.marker.unwrap_or_default() {
        schema::Marker::Disc => Marker::Disc,
        schema::Marker::Ring => Marker::Ring,
        schema::Marker::Square => Marker::Square,
        schema::Marker::Diamond => Marker::Diamond,
    }
}

pub(crate) fn place(layer: &Layer) -> Place {
    match layer.style.place.unwrap_or_default() {
        schema::Place::Right => Place::Right,
        schema::Place::Left => Place::Left,
        schema::Place::Above => Place::Above,
        schema::Place::Below => Place::Below,
        schema::Place::AboveRight => Place::AboveRight,
        schema::Place::AboveLeft => Place::AboveLeft,
        schema::Place::BelowRight => Place::BelowRight,
        schema::Place::BelowLeft => Place::BelowLeft,
    }
}

pub(crate) fn legend(word: schema::Legend) -> Legend {
    match word {
        schema::Legend::Below => Legend::Below,
        schema::Legend::Right => Legend::Right,
        schema::Legend::Hidden => Legend::Hidden,
    }
}
