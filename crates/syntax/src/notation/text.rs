//! Writes formulas in the derivation language; [`crate::formula::parse`] reads the result back as the same tree.

use super::walk::{Level, Notation, Piece};
use crate::formula::Expr;

struct Text;

impl Notation for Text {
    /// Indices are written without spaces, as in `Q[k-2,1]`.
    fn index(&self, head: &Expr, indices: &[Expr]) -> Piece {
        let head = self.operand(head, Level::Atom);
        let indices = self.listed(indices);
        let tight = indices
            .replace(" + ", "+")
            .replace(" - ", "-")
            .replace(", ", ",");
        Piece::atom(format!("{head}[{tight}]"))
    }
}

/// The formula in the derivation language, with as few brackets as possible.
///
/// ```
/// use torse_syntax::{notation, formula::parse};
/// let formula = parse("((Q[k - 1])) - (c * (x))^(2)").unwrap();
/// assert_eq!(notation::text(&formula), "Q[k-1] - (c*x)^2");
/// ```
#[must_use]
pub fn text(formula: &Expr) -> String {
    Text.write(formula).text
}
