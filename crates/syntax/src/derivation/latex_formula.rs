//! Statements of claims in LaTeX.

use super::declarations::Declarations;
use super::error::{DerivationError, LoadError};
use super::latex_names::latex_names;
use super::source::{Origin, Source, whole};
use super::written::Written;
use crate::latex::{LatexError, LatexReading, read_latex};
use crate::notation::text as written_text;
use std::sync::Arc;
use toml::Spanned;

/// The error of LaTeX at its place in a file.
pub(super) fn complaint(origin: &Origin, error: &LatexError) -> DerivationError {
    let shown = DerivationError::at(origin, error.place, error.message.clone());
    match &error.help {
        Some(help) => shown.with_help(help.clone()),
        None => shown,
    }
}

/// The error for a formula with several readings, with what may be done.
pub(super) fn several(
    origin: &Origin,
    reading: &LatexReading,
    choice: &str,
) -> Option<DerivationError> {
    let (doubt, other) = reading.others.first()?;
    let [first_says, other_says] = &doubt.says;
    let (first, other) = (
        written_text(&reading.statement.formula),
        written_text(&other.formula),
    );
    let message =
        format!("this is read in two ways: `{first}` ({first_says}) or `{other}` ({other_says})");
    let help = format!("write brackets or a fraction, or {choice}");
    Some(DerivationError::at(origin, doubt.place, message).with_help(help))
}

/// Reads the statement of a claim in LaTeX, with the declarations of the claim.
pub(super) fn latex_written(
    source: &Arc<Source>,
    text: &Spanned<String>,
    declarations: &Declarations,
) -> Result<Written, LoadError> {
    let origin = Origin::from_spanned(source, text);
    let names = latex_names(declarations);
    let wrong = |error: DerivationError| LoadError::Derivation(Box::new(error));
    let reading =
        read_latex(text.get_ref(), &names).map_err(|error| wrong(complaint(&origin, &error)))?;
    if let Some(error) = several(&origin, &reading, "choose one of the two as `states`") {
        return Err(wrong(error));
    }
    if !reading.statement.conditions.is_empty() {
        let message = "the formula has conditions beside its statement";
        let error = DerivationError::at(&origin, whole(text), message);
        return Err(wrong(error.with_help(
            "ranges belong in `symbols`, other conditions in `assume`",
        )));
    }
    Ok(Written {
        expr: reading.statement.formula,
        origin,
    })
}
