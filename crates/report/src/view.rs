//! Formulas and corrections as every part of a report shows them.

use crate::glossary;
use crate::text::visible;
use serde::Serialize;
use torse_syntax::notation::Formula;
use torse_typography::{MathBox, Mathematics, PrintedNames, Prose, changed, read, spans};
use torse_verdicts::{Correction, words};

/// A formula on lines of its own.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FormulaView {
    /// The formula; none if its notation cannot be parsed.
    pub math: Option<Mathematics>,
    /// The notation of the derivation files, shown if there is no mathematics.
    pub text: String,
}

/// A proved correction: the printed statement with deletions marked, and the corrected one with insertions marked.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct CorrectionView {
    /// The statement as printed.
    pub printed: Option<FormulaView>,
    /// The corrected statement.
    pub statement: FormulaView,
    /// What was changed, and the conditions, one entry each.
    pub edits: Vec<Prose>,
    /// Whether no other correction with as few edits was found.
    pub unique: bool,
}

/// A formula on lines of its own.
pub(crate) fn formula(formula: &Formula, names: &PrintedNames) -> FormulaView {
    FormulaView {
        math: read(&formula.text, names).map(|node| Mathematics::display(&node)),
        text: visible(&formula.text),
    }
}

/// A formula that the engine derived; a long one is replaced by its number of terms.
pub(crate) fn derived(formula: &Formula, names: &PrintedNames) -> FormulaView {
    match glossary::long(&formula.text) {
        Some(words) => FormulaView {
            math: Some(Mathematics::inline(&MathBox::word(&words.replace('`', "")))),
            text: words,
        },
        None => self::formula(formula, names),
    }
}

/// Makes the correction with its change marked.
pub(crate) fn correction(
    parsed: Option<&Formula>,
    repair: &Correction,
    names: &PrintedNames,
) -> CorrectionView {
    let marked = parsed.and_then(|parsed| changed(&parsed.text, &repair.statement.text, names));
    let view = |node: &MathBox, of: &Formula| FormulaView {
        math: Some(Mathematics::display(node)),
        text: visible(&of.text),
    };
    let (printed, statement) = match (&marked, parsed) {
        (Some([old, new]), Some(parsed)) => (Some(view(old, parsed)), view(new, &repair.statement)),
        _ => (
            parsed.map(|own| formula(own, names)),
            formula(&repair.statement, names),
        ),
    };
    let edits = words::correction(repair);
    CorrectionView {
        printed,
        statement,
        edits: (edits.iter())
            .map(|line| spans(&visible(line), names))
            .collect(),
        unique: repair.unique,
    }
}
