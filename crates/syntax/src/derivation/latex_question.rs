//! A single statement in LaTeX with a one-line setting.

use super::error::{DerivationError, LoadError};
use super::latex_formula::{complaint, several};
use super::latex_names::latex_names;
use super::question::{question, undeclared_names};
use super::source::{Origin, SETTING, STATEMENT, Source};
use crate::formula::{Expr, Node, Relation};
use crate::latex::{LatexCondition, LatexError, LatexGuess, LatexKind, layout, read_latex};
use crate::notation::text as written_text;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Reads a statement in LaTeX with a setting as that of [`question`]; returns both in the language of the files.
///
/// What undeclared letters stand for is concluded as [`LatexGuess`] says; those in bounds of sums and in binomial coefficients are
/// integers from 0 on. Conditions behind the statement, such as `, \quad t \in [0, 1]`, are added to the setting. An entry of the
/// setting with a backslash is LaTeX too: `\alpha \in [-2, 1]`, `B_i^n(t) := \binom{n}{i} t^i (1-t)^{n-i}`.
///
/// # Errors
/// What is not understood or is read in two ways, at its place; the first mistake of the setting.
///
/// ```
/// let read = torse_syntax::derivation::latex_question(r"\sin^2 x + \cos^2 x = 1", "")?;
/// assert_eq!(read, ("sin(x)^2 + cos(x)^2 == 1".to_owned(), String::new()));
/// let read = torse_syntax::derivation::latex_question(r"\sum_{i=0}^n \alpha^i \le n + 1", r"\alpha\in[0,1]")?;
/// assert_eq!(read.1, "alpha in [0, 1]; n in 0..");
/// # Ok::<(), torse_syntax::derivation::LoadError>(())
/// ```
pub fn latex_question(latex: &str, setting: &str) -> Result<(String, String), LoadError> {
    let source = Arc::new(Source::new(STATEMENT, latex));
    let origin = |error: &LatexError| {
        Origin::range(
            &source,
            error.place.start,
            error.place.end.max(error.place.start),
        )
    };
    let wrong = |error: DerivationError| LoadError::Derivation(Box::new(error));
    let refused = |error: LatexError| {
        let shown = complaint(&origin(&error), &error);
        wrong(match error.message.ends_with("is not declared") {
            true => shown.with_help(UNDECLARED),
            false => shown,
        })
    };
    let setting = &plain_setting(setting)?;
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
            LatexKind::Number | LatexKind::Open | LatexKind::NumberOrBase => {}
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
    let open = undeclared_names(&written_text(&statement.formula), &settings.join("; "));
    let mut integers = BTreeSet::new();
    integers_of(&statement.formula, &mut integers);
    let integers = open.into_iter().filter(|name| integers.contains(name));
    settings.extend(integers.map(|name| format!("{name} in 0..")));
    Ok((written_text(&statement.formula), settings.join("; ")))
}

/// What to do about a name that is not declared.
const UNDECLARED: &str = "declare it by --where: \"B(i, n, t) := ...\" for a function with scripts, \"P: vector 3\", \"f: function 1\"";

/// A setting whose entries in LaTeX are written in the language of the files.
fn plain_setting(setting: &str) -> Result<String, LoadError> {
    let source = Arc::new(Source::new(SETTING, setting));
    let mut start = 0;
    let mut entries = vec![];
    for entry in setting.split(';') {
        if entry.contains('\\') {
            let refused = |error: LatexError| {
                let origin = Origin::range(&source, start, start + entry.len());
                LoadError::Derivation(Box::new(complaint(&origin, &error)))
            };
            entries.extend(latex_entries(entry).map_err(refused)?);
        } else {
            entries.push(entry.to_owned());
        }
        start += entry.len() + 1;
    }
    Ok(entries.join(";"))
}

/// An entry of a setting in LaTeX, as entries in the language of the files.
fn latex_entries(entry: &str) -> Result<Vec<String>, LatexError> {
    let mut guess = LatexGuess::default();
    if entry.contains(":=") {
        let equation = entry.replacen(":=", "=", 1);
        guess.add(&layout(&equation)?);
        let statement = read_latex(&equation, &guess.names())?.statement;
        if let Node::Compare(head, rest) = &statement.formula.node
            && let [(Relation::Equal, body)] = rest.as_slice()
        {
            return Ok(vec![format!(
                "{} := {}",
                written_text(head),
                written_text(body)
            )]);
        }
        let place = statement.formula.place;
        return Err(LatexError::new(place, "this is no definition"));
    }
    // What stands behind a statement is read as its condition.
    let behind = format!("0 = 0, \\quad {entry}");
    guess.add(&layout(&behind)?);
    let statement = read_latex(&behind, &guess.names())?.statement;
    if statement.conditions.is_empty() {
        let read = read_latex(entry, &guess.names())?.statement.formula;
        return Ok(vec![written_text(&read)]);
    }
    Ok(statement
        .conditions
        .iter()
        .flat_map(self::entries)
        .collect())
}

/// The names in bounds of sums and products, and in what a binomial coefficient or a factorial takes.
fn integers_of(formula: &Expr, found: &mut BTreeSet<String>) {
    if let Node::Call(head, arguments) = &formula.node
        && let Node::Name(called) = &head.node
    {
        let integers = match (called.as_str(), arguments.as_slice()) {
            ("sum" | "product", [_, low, high, _]) => vec![low, high],
            ("binom", [n, k]) => vec![n, k],
            ("factorial", [n]) => vec![n],
            _ => vec![],
        };
        found.extend(
            integers
                .into_iter()
                .flat_map(Expr::names)
                .map(str::to_owned),
        );
    }
    for part in formula.parts() {
        integers_of(part, found);
    }
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
        LatexCondition::Interval {
            names, low, high, ..
        } => {
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
