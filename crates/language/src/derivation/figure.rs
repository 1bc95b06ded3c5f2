//! A figure of a derivation file: what it shows is written in formulas of the claims' language.
//!
//! Whether a figure is reproduced is read off what its file lists: it is [`Verdict::Reproduced`] if it is drawn
//! from printed data alone, [`Verdict::Partial`] if something was assumed, and [`Verdict::Underspecified`] if data
//! had to be replaced.

use super::declarations::Declarations;
use super::schema::figure::FigureEntry;
use super::source::{Origin, Source};
use crate::words::Verdict;
use std::sync::Arc;

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
    pub source: Arc<Source>,
    /// What its formulas may use.
    pub declarations: Arc<Declarations>,
}

impl Figure {
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
}
