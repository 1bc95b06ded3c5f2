//! A single statement in LaTeX with a one-line setting.

use super::error::{DerivationError, LoadError};
use super::latex_formula::{complaint, several};
use super::latex_names::latex_names;
use super::question::question;
use super::source::{Origin, Source};
use crate::formula::Expr;
use crate::latex::{LatexCondition, LatexError, LatexGuess, LatexKind, layout, read_latex};
use crate::notation::text as written_text;
use std::sync::Arc;

/// Reads a statement in LaTeX with a setting as that of [`question`]; returns both in the language of the files.
///
/// What undeclared letters stand for is concluded as [`LatexGuess`] says. Conditions behind the statement, such as
/// `, \quad t \in [0, 1]`, are added to the setting.
///
/// # Errors
/// What is not understood or is read in two ways, at its place; the first mistake of the setting.
///
/// ```
/// let read = torse_syntax::derivation::latex_question(r"\sin^2 x + \cos^2 x = 1", "")?;
/// assert_eq!(read, ("sin(x)^2 + cos(x)^2 == 1".to_owned(), String::new()));
/// # Ok::<(), torse_syntax::derivation::LoadError>(())
/// ```
pub fn latex_question(latex: &str, setting: &str) -> Result<(String, String), LoadError> {
    let source = Arc::new(Source::new("the statement", latex));
    let origin = |error: &LatexError| {
        Origin::range(
            &source,
            error.place.start,
            error.place.end.max(error.place.start),
        )
    };
    let wrong = |error: DerivationError| LoadError::Derivation(Box::new(error));
    let refused = |error: LatexError| wrong(complaint(&origin(&error), &error));
    let declared = question("1 == 1", setting)?;
    let mut names = match declared.claims.first() {
        Some(claim) => latex_names(&claim.declarations),
        None => latex_names(&declared.declarations),
    };
    let mut guess = LatexGuess::default();
    guess.add(&layout(latex).map_err(refused)?);
    let mut settings: Vec<String> = vec![setting.trim().trim_end_matches(';').to_owned()];
    settings.retain(|setting| !setting.is_empty());
    let guessed = guess.names();
    let mut added = vec![];
    for (name, kind) in guessed.kinds() {
        if names.kind(name).is_some() {
            continue;
        }
        match kind {
            LatexKind::Vector => added.push((name, format!("{name}: vector 3"))),
            LatexKind::Function {
                parameters,
                is_vector,
            } if parameters.len() == 1 => {
                let dimension = if *is_vector { 3 } else { 1 };
                added.push((name, format!("{name}: function {dimension}")));
            }
            LatexKind::Number | LatexKind::Open => {}
            // Families and functions of several variables are declared by the user, or not at all.
            _ => continue,
        }
        names.declare(name, kind.clone());
        if let Some(printed) = guessed.printed(name) {
            names.display(name, printed);
        }
    }
    let reading = read_latex(latex, &names).map_err(refused)?;
    if let Some((doubt, _)) = reading.others.first() {
        let place = Origin::range(&source, doubt.place.start, doubt.place.end);
        if let Some(error) = several(&place, &reading, "give it in the language of the files") {
            return Err(wrong(error));
        }
    }
    let statement = reading.statement;
    let mut used: Vec<&str> = statement.formula.names();
    for condition in &statement.conditions {
        if let LatexCondition::Formula(formula) = condition {
            used.extend(formula.names());
        }
    }
    let occurs = |name: &str| {
        used.iter()
            .any(|other| other.trim_end_matches('\'') == name)
    };
    settings.extend(
        added
            .into_iter()
            .filter(|(name, _)| occurs(name))
            .map(|(_, entry)| entry),
    );
    settings.extend(statement.conditions.iter().flat_map(entries));
    Ok((written_text(&statement.formula), settings.join("; ")))
}

/// A condition as entries of a setting.
fn entries(condition: &LatexCondition) -> Vec<String> {
    let end = |end: &Option<Expr>, infinite: &str| {
        end.as_ref()
            .map_or_else(|| infinite.to_owned(), written_text)
    };
    match condition {
        LatexCondition::Formula(formula) => vec![written_text(formula)],
        LatexCondition::Integers { name, low, high } => {
            let high = high.as_ref().map(written_text).unwrap_or_default();
            vec![format!("{name} in {}..{high}", written_text(low))]
        }
        LatexCondition::Interval { names, low, high } => {
            let open = if low.1 { '[' } else { '(' };
            let close = if high.1 { ']' } else { ')' };
            let set = format!(
                "{open}{}, {}{close}",
                end(&low.0, "-inf"),
                end(&high.0, "inf")
            );
            names
                .iter()
                .map(|name| format!("{name} in {set}"))
                .collect()
        }
    }
}
