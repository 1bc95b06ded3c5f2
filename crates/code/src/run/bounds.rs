//! Bounds of integers: where an index is not negative, and where a conversion cuts nothing off.

use super::Runner;
use super::value::Term;
use torse_numbers::Affine;
use torse_syntax::formula::Expr;

/// The index of a sum, with its ends.
#[derive(Debug, Clone)]
pub(super) struct Index {
    pub(super) name: String,
    pub(super) ends: Option<(Affine, Affine)>,
}

impl Index {
    pub(super) fn new(name: &str, low: &Expr, high: &Expr) -> Self {
        Self {
            name: name.to_owned(),
            ends: low.affine().zip(high.affine()),
        }
    }
}

impl Runner<'_> {
    /// A lower bound of an integer for all declared values of the symbols, and all indices around.
    pub(super) fn least(&self, term: &Term) -> Option<i64> {
        if let Some(value) = term.integer() {
            return Some(value);
        }
        self.least_of(term.expr.affine()?)
    }

    /// An upper bound, likewise.
    pub(super) fn greatest(&self, term: &Term) -> Option<i64> {
        if let Some(value) = term.integer() {
            return Some(value);
        }
        self.least_of(term.expr.affine()? * -1)?.checked_neg()
    }

    fn least_of(&self, mut form: Affine) -> Option<i64> {
        // Ends of an inner sum may depend on the indices of outer ones.
        for index in self.bound.iter().rev() {
            let coefficient = form.multiple_of(&index.name);
            if coefficient == 0 {
                continue;
            }
            let (low, high) = index.ends.as_ref()?;
            let end = if coefficient > 0 { low } else { high };
            form = form.substituted(&index.name, end);
        }
        self.setting.declarations.least(&form)
    }

    /// Whether an integer is not negative, for all declared values of the symbols.
    pub(super) fn is_natural(&self, term: &Term) -> bool {
        self.least(term).is_some_and(|least| least >= 0)
    }
}
