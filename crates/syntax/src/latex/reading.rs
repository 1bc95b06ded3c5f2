//! All readings of a formula.

use super::error::LatexError;
use super::item::{TexItem, place_of};
use super::layout::{layout, without_final_punctuation};
use super::names::LatexNames;
use super::reader::{LatexDoubt, Reader};
use super::statement::{LatexCondition, LatexStatement};
use super::suspects::no_suspects;
use crate::formula::{Expr, Place};
use std::collections::BTreeMap;

/// The largest number of items of a formula.
const MAX_ITEMS: usize = 3_000;
/// The largest height of the tree, as for formulas in the language of the files.
const MAX_TREE_HEIGHT: usize = 300;
/// The largest number of places with two readings.
const MAX_DOUBTS: usize = 8;

/// The readings of a formula.
#[derive(Debug, Clone)]
pub struct LatexReading {
    /// The first reading.
    pub statement: LatexStatement,
    /// The other readings, each with the place at which it differs from the first one; none if the formula is clear.
    pub others: Vec<(LatexDoubt, LatexStatement)>,
}

/// Reads a formula in LaTeX, without dollar signs.
///
/// # Errors
/// [`LatexError`] at what is not understood.
///
/// ```
/// use torse_syntax::formula::parse;
/// use torse_syntax::latex::{LatexKind, LatexNames, read_latex};
/// let mut names = LatexNames::default();
/// names.declare("x", LatexKind::Number);
/// let read = read_latex(r"\sin^2 x = \frac12(1 - \cos 2x)", &names)?;
/// assert!(read.others.is_empty());
/// assert_eq!(read.statement.formula.placeless(), parse("sin(x)^2 == 1/2*(1 - cos(2*x))").unwrap().placeless());
/// # Ok::<(), torse_syntax::latex::LatexError>(())
/// ```
pub fn read_latex(text: &str, names: &LatexNames) -> Result<LatexReading, LatexError> {
    let items = without_final_punctuation(layout(text)?);
    let around = Place {
        start: 0,
        end: text.len(),
    };
    read_items(&items, around, names)
}

/// Reads a list of items; `around` is its place if it is empty.
///
/// # Errors
/// As [`read_latex`].
pub fn read_items(
    items: &[TexItem],
    around: Place,
    names: &LatexNames,
) -> Result<LatexReading, LatexError> {
    if count(items) > MAX_ITEMS {
        return Err(LatexError::new(
            around,
            format!("the formula has more than {MAX_ITEMS} signs"),
        ));
    }
    no_suspects(items)?;
    let read =
        |chosen: BTreeMap<String, usize>| -> Result<(LatexStatement, Vec<LatexDoubt>), LatexError> {
            let mut reader = Reader::new(names, chosen);
            let statement = reader.statement(items, place_of(items, around))?;
            let conditions = statement
                .conditions
                .iter()
                .filter_map(|condition| match condition {
                    LatexCondition::Formula(formula) => Some(formula),
                    _ => None,
                });
            if conditions
                .chain([&statement.formula])
                .any(|formula| height(formula) > MAX_TREE_HEIGHT)
            {
                return Err(LatexError::new(
                    around,
                    format!("the operations are nested deeper than {MAX_TREE_HEIGHT} levels"),
                ));
            }
            Ok((statement, reader.doubts))
        };
    let (statement, doubts) = read(BTreeMap::new())?;
    if doubts.len() > MAX_DOUBTS {
        return Err(LatexError::new(
            around,
            format!("more than {MAX_DOUBTS} places can be read in two ways"),
        ));
    }
    let mut others: Vec<(LatexDoubt, LatexStatement)> = vec![];
    for doubt in doubts {
        // A second way that makes no sense is no reading.
        if let Ok((other, _)) = read(BTreeMap::from([(doubt.key.clone(), 1)]))
            && !same(&other, &statement)
        {
            others.push((doubt, other));
        }
    }
    Ok(LatexReading { statement, others })
}

fn same(a: &LatexStatement, b: &LatexStatement) -> bool {
    let placeless = |condition: &LatexCondition| match condition {
        LatexCondition::Formula(formula) => LatexCondition::Formula(formula.placeless()),
        other => other.clone(),
    };
    a.formula.placeless() == b.formula.placeless()
        && a.conditions
            .iter()
            .map(placeless)
            .eq(b.conditions.iter().map(placeless))
}

fn count(items: &[TexItem]) -> usize {
    items
        .iter()
        .map(|item| 1 + item.lists().into_iter().map(count).sum::<usize>())
        .sum()
}

fn height(formula: &Expr) -> usize {
    1 + formula.parts().into_iter().map(height).max().unwrap_or(0)
}
