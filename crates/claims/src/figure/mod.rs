//! Figures as data: what a figure shows is written in formulas of the claims' language.
//!
//! [`schema`] is the text of a file, [`drawing`] what comes out: each formula is evaluated once, exactly, with
//! the variables that run left symbolic. So a figure shows what the claims define, and a formula that makes no
//! sense is an error with file, line and caret. Drawing itself is the business of another room.
//!
//! Whether a figure is reproduced is computed: it is [`Verdict::Reproduced`] if it is drawn from printed data
//! alone, [`Verdict::Partial`] if something was assumed, and [`Verdict::Underspecified`] if data had to be
//! replaced.

pub mod drawing;
mod environment;
mod layer;
mod loops;
mod panel;
pub mod schema;
#[cfg(test)]
mod tests;

pub use drawing::{Drawing, Interval, Layer, Panel, Running, Scale, Slider};

use crate::derivation::schema::Text;
use crate::derivation::{DerivationError, Origin, Source};
use crate::evaluate::scope::{Declarations, SymbolKind};
use crate::outcome::Verdict;
use environment::{Environment, complaint};
use loops::Round;
use schema::FigureEntry;
use std::collections::BTreeMap;
use std::sync::Arc;

type Faulty<T> = Result<T, Box<DerivationError>>;

/// A figure of a file, not evaluated.
#[derive(Debug, Clone)]
pub struct Figure {
    /// The name, `paper/name`.
    pub id: String,
    /// The claims that it illustrates.
    pub claims: Vec<String>,
    /// The fields of the file.
    pub entry: FigureEntry,
    /// Where it stands, for errors about the figure as a whole.
    pub origin: Origin,
    /// The file.
    pub(crate) source: Arc<Source>,
    /// What its formulas may use.
    pub(crate) declarations: Arc<Declarations>,
}

impl Figure {
    /// The figure as printed on a page: sliders stand where they start, unless a loop moves them.
    ///
    /// # Errors
    /// A [`DerivationError`] for the first formula that makes no sense, or leaves a symbol without a value.
    pub fn drawing(&self) -> Result<Drawing, Box<DerivationError>> {
        self.elaborated(&[])
    }

    /// The figure with its sliders left symbolic and without the loops that would move them; none if it has
    /// no sliders.
    ///
    /// # Errors
    /// As [`Figure::drawing`].
    pub fn interactive(&self) -> Result<Option<Drawing>, Box<DerivationError>> {
        let free: Vec<String> = self.entry.sliders.keys().cloned().collect();
        if free.is_empty() {
            return Ok(None);
        }
        self.elaborated(&free).map(Some)
    }

    /// What the figure says about the paper's: nothing is decided by drawing, but something had to be assumed
    /// or not.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match (
            self.entry.stand_in.is_empty(),
            self.entry.assumes.is_empty(),
        ) {
            (true, true) => Verdict::Reproduced,
            (true, false) => Verdict::Partial,
            (false, _) => Verdict::Underspecified,
        }
    }

    fn elaborated(&self, free: &[String]) -> Faulty<Drawing> {
        let mut environment = Environment::new(&self.source, &self.declarations);
        let mut sliders = vec![];
        for (name, text) in in_file_order(&self.entry.sliders) {
            let start = environment.number(text)?;
            let range = match environment.declared(name, text)? {
                SymbolKind::Real(interval) => match (&interval.lower, &interval.upper) {
                    (Some(low), Some(high)) => Interval {
                        low: low.value.clone(),
                        high: high.value.clone(),
                    },
                    _ => return Err(unbounded(&self.source, text, name)),
                },
                _ => return Err(unbounded(&self.source, text, name)),
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
            figure: self,
            round: Round::only(environment),
            free,
        };
        let mut panels = vec![];
        for entry in &self.entry.panel {
            panels.extend(context.panels(entry)?);
        }
        let entry = &self.entry;
        Ok(Drawing {
            id: self.id.clone(),
            claims: self.claims.clone(),
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
}

fn unbounded(source: &Arc<Source>, text: &Text, name: &str) -> Box<DerivationError> {
    let message = format!("`{name}` is no real number of an interval with two ends");
    Box::new(complaint(source, text, message))
}

/// The entries of a table by their place in the file: a later one may use an earlier one.
fn in_file_order(table: &BTreeMap<String, Text>) -> Vec<(&String, &Text)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(_, text)| text.span().start);
    entries
}
