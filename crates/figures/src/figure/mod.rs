//! Figures as data: formulas of the claims' language describe a figure.
//!
//! [`torse_syntax::derivation::schema::figure`] is the text of a file, [`Drawing`] the result: each formula is
//! evaluated once, exactly, with the running variables left symbolic. So a figure shows what the claims define, and a
//! formula that makes no sense is an error with file, line and caret. The crate `torse-plot` draws.

pub mod drawing;
mod environment;
mod layer;
mod loops;
mod panel;
mod reader;
#[cfg(test)]
mod tests;
mod torse;

pub use drawing::{Drawing, Interval, Layer, Panel, Piece, Running, Scale, Slider, Torse};
pub use torse::torse;

use environment::{Environment, complaint};
use loops::Round;
use reader::Reader;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_prove::decide::interval::exact;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::derivation::schema::Text;
use torse_syntax::derivation::{DerivationError, Figure, Source};

type Faulty<T> = Result<T, Box<DerivationError>>;

/// Evaluates the figure as printed: sliders have their initial values, unless a loop moves them.
///
/// # Errors
/// A [`DerivationError`] for the first formula that makes no sense, or leaves a symbol without a value.
pub fn drawing(figure: &Figure) -> Result<Drawing, Box<DerivationError>> {
    elaborated(figure, &[])
}

/// Evaluates the figure with its sliders left symbolic and without the loops that would move them; none if it has no
/// sliders.
///
/// # Errors
/// As [`drawing()`].
pub fn interactive(figure: &Figure) -> Result<Option<Drawing>, Box<DerivationError>> {
    let free: Vec<String> = figure.entry.sliders.keys().cloned().collect();
    if free.is_empty() {
        return Ok(None);
    }
    elaborated(figure, &free).map(Some)
}

fn elaborated(figure: &Figure, free: &[String]) -> Faulty<Drawing> {
    let mut environment = Environment::new(&figure.source, &figure.declarations);
    let mut sliders = vec![];
    for (name, text) in in_file_order(&figure.entry.sliders) {
        let start = Reader::new(&environment).number(text)?;
        let range = match environment.declared(name, text)? {
            SymbolKind::Real(interval) => match (&interval.lower, &interval.upper) {
                (Some(low), Some(high)) => Interval {
                    low: exact(&low.value),
                    high: exact(&high.value),
                },
                _ => return Err(unbounded(&figure.source, text, name)),
            },
            _ => return Err(unbounded(&figure.source, text, name)),
        };
        if !free.contains(name) {
            environment.fix(name, start.clone());
        }
        sliders.push(Slider {
            name: name.clone(),
            range,
            start,
        });
    }
    let context = panel::Context {
        figure,
        round: Round::only(environment),
        free,
    };
    let mut panels = vec![];
    for (number, entry) in figure.entry.panel.iter().enumerate() {
        panels.extend(context.panels(number, entry)?);
    }
    let entry = &figure.entry;
    Ok(Drawing {
        id: figure.id.clone(),
        claims: figure.claims.clone(),
        title: entry.title.clone(),
        caption: entry.caption.clone(),
        alt: entry.alt.clone(),
        assumes: entry.assumes.clone(),
        stand_in: entry.stand_in.clone(),
        columns: entry.columns,
        size: entry.size,
        sliders,
        panels,
    })
}

fn unbounded(source: &Arc<Source>, text: &Text, name: &str) -> Box<DerivationError> {
    let message = format!("`{name}` is no real number of an interval with two ends");
    Box::new(complaint(source, text, message))
}

/// Returns the entries of a table by their place in the file: a later one may use an earlier one.
fn in_file_order(table: &BTreeMap<String, Text>) -> Vec<(&String, &Text)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(_, text)| text.span().start);
    entries
}
