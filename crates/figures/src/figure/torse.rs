//! The developable surface of a figure, with its sliders symbolic.

use super::drawing::{Interval, Piece, Running, Slider, Torse};
use super::environment::{Environment, complaint, fraction};
use super::layer::{Over, range};
use super::loops::Round;
use super::panel::{Context, ends};
use super::reader::Reader;
use super::{Faulty, in_file_order};
use torse_prove::evaluate::value::Value;
use torse_syntax::derivation::schema::Text;
use torse_syntax::derivation::schema::figure::{PieceEntry, Rulings, TorseEntry};
use torse_syntax::derivation::{Figure, parsed};

/// Returns the developable surface of the figure; none if it has none.
///
/// # Errors
/// A [`DerivationError`](torse_syntax::derivation::DerivationError) for the first formula that makes no sense, or
/// leaves a symbol without a value that is no slider.
pub fn torse(figure: &Figure) -> Faulty<Option<Torse>> {
    let Some(entry) = &figure.entry.torse else {
        return Ok(None);
    };
    let environment = values(figure, entry)?;
    let reader = Reader::new(&environment);
    let sliders = in_file_order(&entry.sliders)
        .into_iter()
        .map(|(name, text)| slider(&reader, name, text))
        .collect::<Faulty<_>>()?;
    let free: Vec<String> = entry.sliders.keys().cloned().collect();
    let context = Context {
        figure,
        round: Round::only(environment.clone()),
        free: &free,
    };
    let pieces = entry
        .piece
        .iter()
        .map(|piece| context.piece(piece, &reader));
    Ok(Some(Torse {
        sliders,
        view: entry.view,
        pieces: pieces.collect::<Faulty<_>>()?,
    }))
}

/// Sets the values of the figure, except those that the surface leaves free or sets itself, and solves its equations.
fn values<'a>(figure: &'a Figure, entry: &TorseEntry) -> Faulty<Environment<'a>> {
    let mut environment = Environment::new(&figure.source, &figure.declarations);
    let mut common = figure.entry.set.clone();
    common.retain(|name, _| !entry.sliders.contains_key(name) && !entry.set.contains_key(name));
    environment.set_integers(&common)?;
    for set in [&common, &entry.set] {
        for (name, text) in in_file_order(set) {
            environment.set(name, text)?;
        }
    }
    for (name, rows) in &figure.entry.nets {
        environment.set_net(name, rows)?;
    }
    environment.solve(&figure.entry.given, &figure.entry.solve_for)?;
    Ok(environment)
}

/// Reads `[minimum, initial value, maximum]`.
fn slider(reader: &Reader<'_>, name: &str, text: &Text) -> Faulty<Slider> {
    reader.declared(name, text)?;
    let unusable = || {
        let message = format!("`{name}` needs three numbers: least, at first, greatest");
        Box::new(complaint(reader.source, text, message))
    };
    let Value::Vector(vector) = reader.value(text)? else {
        return Err(unusable());
    };
    let numbers = vector
        .entries
        .iter()
        .map(|q| fraction(reader.source, text, q));
    let numbers = numbers.collect::<Faulty<Vec<_>>>()?;
    let [low, start, high] = <[_; 3]>::try_from(numbers).map_err(|_| unusable())?;
    Ok(Slider {
        name: name.to_owned(),
        range: Interval { low, high },
        start,
    })
}

impl Context<'_> {
    fn piece(&self, entry: &PieceEntry, reader: &Reader<'_>) -> Faulty<Piece> {
        let over = match range(reader, &entry.over)? {
            Over::Running(running) => *running,
            Over::Index(_) => {
                let message = "a number runs along a developable, not an index";
                return Err(Box::new(complaint(reader.source, &entry.over, message)));
            }
        };
        let (count, dimension, wanted) = match entry.draw {
            Rulings::Envelope | Rulings::Tangent => (1, 4, "one plane [p, q, r, s]"),
            Rulings::Ruled => (2, 3, "two points in space"),
        };
        let mut curves = vec![];
        for text in &entry.at {
            let formula = parsed(reader.source, text)?;
            let running: &Running = &over;
            curves.extend(self.positions(reader, text, &formula, &[&running.name])?);
        }
        if curves.len() != count || curves.iter().any(|curve| curve.len() != dimension) {
            let message = format!("{wanted} wanted");
            let at = entry.at.first().unwrap_or(&entry.over);
            return Err(Box::new(complaint(reader.source, at, message)));
        }
        let along = ends(reader, &entry.along, &reader.value(&entry.along)?)?;
        let limit = entry.limit.as_ref().map(|text| reader.number(text));
        Ok(Piece {
            rulings: entry.draw,
            curves,
            over,
            along,
            limit: limit.transpose()?,
            label: entry.label.clone(),
            colour: entry.colour,
        })
    }
}
