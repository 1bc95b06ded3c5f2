//! A figure of a derivation file, whose contents are formulas of the language of claims.
//!
//! The verdict of a figure follows from the lists in its file: [`Verdict::Reproduced`] if it is drawn from printed
//! data alone, [`Verdict::Partial`] if something was assumed, and [`Verdict::Underspecified`] if data had to be
//! replaced.

use super::declarations::Declarations;
use super::definitions::add_definitions;
use super::schema::figure::FigureEntry;
use super::source::{Origin, Source};
use super::table::Errors;
use super::{folder, table};
use crate::taxonomy::Verdict;
use std::sync::Arc;
use toml::Spanned;

/// A figure of a file, not yet evaluated.
#[derive(Debug, Clone)]
pub struct Figure {
    /// The id, `paper/name`.
    pub id: String,
    /// The claims that it illustrates.
    pub claims: Vec<String>,
    /// The fields of the file.
    pub entry: FigureEntry,
    /// The place of the figure, for errors about it as a whole.
    pub origin: Origin,
    /// The file.
    pub source: Arc<Source>,
    /// The declarations that its formulas may use.
    pub declarations: Arc<Declarations>,
}

impl Figure {
    /// The verdict. Drawing decides nothing; the verdict says only whether data had to be assumed or replaced.
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

/// Reads a figure that the paper does not have; it has an id of its own.
pub(super) fn own_figure(
    source: &Arc<Source>,
    shared: &Arc<Declarations>,
    slug: &str,
    entry: Spanned<FigureEntry>,
    errors: &mut Errors,
) -> Option<Figure> {
    let range = entry.span();
    let entry = entry.into_inner();
    let Some(id) = entry.id.clone() else {
        let message = "a figure of its own needs an `id`".to_owned();
        errors.0.push(table::complaint(source, range, message));
        return None;
    };
    let origin = Origin::from_spanned(source, &id);
    errors.keep(folder::check_id(source, &id, slug))?;
    let claims = entry.claims.iter().map(|c| c.get_ref().clone()).collect();
    Some(figure(
        source,
        origin,
        shared,
        id.into_inner(),
        claims,
        entry,
        errors,
    ))
}

/// Reads a figure, of a claim or of our own.
pub(super) fn figure(
    source: &Arc<Source>,
    origin: Origin,
    shared: &Arc<Declarations>,
    id: String,
    claims: Vec<String>,
    entry: FigureEntry,
    errors: &mut Errors,
) -> Figure {
    let mut declarations = (**shared).clone();
    declarations.add_symbols(source, &entry.symbols, None, errors);
    add_definitions(&mut declarations, source, &entry.local, errors);
    Figure {
        id,
        claims,
        entry,
        origin,
        source: Arc::clone(source),
        declarations: Arc::new(declarations),
    }
}
