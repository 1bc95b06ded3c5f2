//! One edit of a formula.

use torse_language::syntax::Expr;

/// A changed formula and what was changed, in words.
#[derive(Debug, Clone)]
pub struct Edit {
    /// The formula after the edit.
    pub expr: Expr,
    /// The change in words.
    pub change: String,
}

/// The formula with the part at `path` replaced.
pub(crate) fn placed(expr: &Expr, path: &[usize], by: Expr) -> Expr {
    let Some((first, rest)) = path.split_first() else {
        return by;
    };
    let mut result = expr.clone();
    if let Some(part) = result.parts_mut().into_iter().nth(*first) {
        *part = placed(part, rest, by);
    }
    result
}

/// The formula as text.
pub(super) fn text(expr: &Expr) -> String {
    torse_language::notation::text(expr)
}
