//! Formulas of a derivation file.

use super::error::{DerivationError, LoadError};
use super::source::{Origin, Source};
use crate::formula::{Expr, parse};
use std::sync::Arc;
use toml::Spanned;

/// A parsed formula and where it was written.
#[derive(Debug, Clone)]
pub struct Written {
    /// The formula.
    pub expr: Expr,
    /// Its origin.
    pub origin: Origin,
}

/// Parses a text of a file.
pub fn written(source: &Arc<Source>, text: &Spanned<String>) -> Result<Written, LoadError> {
    Ok(parsed(source, text)?)
}

/// Parses a text of a file, with the error type of evaluation.
pub fn parsed(
    source: &Arc<Source>,
    text: &Spanned<String>,
) -> Result<Written, Box<DerivationError>> {
    let origin = Origin::from_spanned(source, text);
    match parse(text.get_ref()) {
        Ok(expr) => Ok(Written { expr, origin }),
        Err(error) => Err(Box::new(DerivationError::syntax(&origin, &error))),
    }
}
