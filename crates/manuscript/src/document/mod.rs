//! A manuscript taken apart: its sections, theorems, numbered equations and formulas, in their order.

mod arguments;
mod cases;
mod rows;
mod scan;

use crate::macros::{ManuscriptError, Unread, expanded};
use crate::numbering::Numbering;
use arguments::balanced;
use scan::Scan;
use std::collections::BTreeMap;
use torse_syntax::formula::Place;
use torse_syntax::latex::LatexError;
use torse_syntax::latex::item::TexItem;
use torse_syntax::latex::token::tex_tokens;

/// A formula of the text.
#[derive(Debug, Clone)]
pub struct ManuscriptFormula {
    /// The formula in LaTeX, with its macros expanded.
    pub latex: String,
    /// Its items, or why it has none.
    pub items: Result<Vec<TexItem>, LatexError>,
    /// Its place in the text.
    pub place: Place,
    /// Whether it stands on lines of its own.
    pub is_display: bool,
    /// Whether it stands in a theorem, or something like one that is no definition.
    pub in_theorem: bool,
}

/// A numbered equation, or something like a theorem.
#[derive(Debug, Clone)]
pub struct ManuscriptItem {
    /// `equation`, or the title of the environment, such as `Theorem`.
    pub kind: String,
    /// Its number, if it has one.
    pub number: Option<String>,
    /// The number of its section; empty before the first one.
    pub section: String,
    /// Its label, if it has one.
    pub label: Option<String>,
    /// What the text says, formulas on one line.
    pub printed: String,
    /// Its place in the text.
    pub place: Place,
    /// The positions of its formulas in [`Manuscript::formulas`].
    pub formulas: Vec<usize>,
}

/// A manuscript.
#[derive(Debug, Clone, Default)]
pub struct Manuscript {
    /// The whole text.
    pub text: String,
    /// The title; empty if there is none.
    pub title: String,
    /// The authors; empty if there are none.
    pub authors: String,
    /// All formulas, in their order.
    pub formulas: Vec<ManuscriptFormula>,
    /// Numbered equations and theorems, in their order.
    pub items: Vec<ManuscriptItem>,
    /// What of the text is not followed: files that it includes, definitions that are not understood.
    pub unread: Vec<Unread>,
}

impl Manuscript {
    /// The line and the column of a byte of the text, both from 1.
    #[must_use]
    pub fn line_and_column(&self, byte: usize) -> (usize, usize) {
        let before = self
            .text
            .get(..byte.min(self.text.len()))
            .unwrap_or(&self.text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
        (line, column)
    }
}

/// Reads a manuscript.
///
/// # Errors
/// [`ManuscriptError`] if macros do not come to an end, or the text is too long. What is not understood is no error:
/// it is listed.
pub fn manuscript(text: &str) -> Result<Manuscript, ManuscriptError> {
    let (tokens, all) = tex_tokens(text);
    if !all {
        return Err(ManuscriptError::TooLong);
    }
    let (tokens, unread) = expanded(tokens)?;
    let (tokens, mut unbalanced) = balanced(tokens);
    unbalanced.extend(unread);
    let mut scan = Scan {
        manuscript: Manuscript {
            text: text.to_owned(),
            unread: unbalanced,
            ..Manuscript::default()
        },
        unclosed: 0,
        numbering: Numbering::default(),
        section: String::new(),
        labels: BTreeMap::new(),
        theorem: None,
        depth: 0,
    };
    scan.text(&tokens);
    Ok(scan.finished())
}
