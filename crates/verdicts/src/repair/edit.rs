//! One edit of a formula.

use std::borrow::Cow;
use std::fmt;
use torse_algebra::Rational;
use torse_syntax::formula::{Expr, Node};

/// A changed formula with a description of the change.
#[derive(Debug, Clone)]
pub struct Edit {
    /// The formula after the edit.
    pub expr: Expr,
    /// The change.
    pub change: Change,
}

/// A change in words. Thousands are tried and few are shown, so the formulas become text on demand.
#[derive(Debug, Clone)]
pub struct Change {
    /// The words around the formulas: before each one, and after the last.
    words: Vec<Cow<'static, str>>,
    formulas: Vec<Expr>,
}

impl Edit {
    /// The edit with its change in words.
    #[must_use]
    pub fn described(self) -> (Self, Vec<String>) {
        let words = vec![self.change.to_string()];
        (self, words)
    }
}

impl Change {
    /// Makes a sentence in which `_` stands for each of the formulas: "the sign of _ changed".
    #[must_use]
    pub fn new<const N: usize>(sentence: &'static str, formulas: [&Expr; N]) -> Self {
        Self {
            words: sentence.split('_').map(Cow::Borrowed).collect(),
            formulas: formulas.map(Expr::clone).to_vec(),
        }
    }

    /// "old replaced by new".
    #[must_use]
    pub fn replaced(old: &Expr, new: &Expr) -> Self {
        Self::new("_ replaced by _", [old, new])
    }

    /// Whether a factor was put in before something: of several corrections that which says least of what went wrong.
    #[must_use]
    pub fn is_factor_inserted(&self) -> bool {
        self.words.iter().any(|words| words == " inserted before ")
    }

    /// Describes the change and its place.
    #[must_use]
    pub fn at(mut self, place: &str) -> Self {
        match self.words.last_mut() {
            Some(last) => last.to_mut().push_str(place),
            None => self.words.push(place.to_owned().into()),
        }
        self
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut formulas = self.formulas.iter();
        for words in &self.words {
            f.write_str(words)?;
            if let Some(formula) = formulas.next() {
                write!(f, "`{}`", text(formula))?;
            }
        }
        Ok(())
    }
}

/// Replaces the part at `path` of the formula.
pub(crate) fn placed(expr: &Expr, path: &[usize], by: Expr) -> Expr {
    let Some((first, rest)) = path.split_first() else {
        return by;
    };
    let parts = expr.parts();
    let part = parts.get(*first).map(|part| placed(part, rest, by));
    part.and_then(|part| expr.with_part(*first, part))
        .unwrap_or_else(|| expr.clone())
}

/// Returns every part of a formula with the path to it, the formula itself first; the heads of calls and members, which
/// are names of functions and families, are left out.
pub(super) fn parts(expr: &Expr) -> Vec<(Vec<usize>, &Expr)> {
    let mut found = vec![];
    let mut pending = vec![(vec![], expr)];
    while let Some((path, part)) = pending.pop() {
        let head = usize::from(matches!(&part.node, Node::Call(..) | Node::Index(..)));
        for (position, inner) in part.parts().into_iter().enumerate().skip(head).rev() {
            pending.push(([path.as_slice(), &[position]].concat(), inner));
        }
        found.push((path, part));
    }
    found
}

/// Returns every number of a formula that is written exactly, with the path to it.
pub(super) fn exact_numbers(expr: &Expr) -> Vec<(Vec<usize>, &Expr, &Rational)> {
    let all = parts(expr).into_iter();
    let exact = all.filter_map(|(path, part)| match &part.node {
        Node::Number {
            value,
            decimals: None,
        } => Some((path, part, value)),
        _ => None,
    });
    exact.collect()
}

/// Replaces one name by another in all places, with primes kept.
pub(super) fn with_name(expr: &Expr, old: &str, new: &str) -> Expr {
    let mut result = expr.with_parts(|part| with_name(part, old, new));
    if let Node::Name(name) = &mut result.node {
        let base = name.trim_end_matches('\'');
        if base == old {
            *name = format!("{new}{}", name.get(base.len()..).unwrap_or(""));
        }
    }
    result
}

/// The formula as text.
pub(super) fn text(expr: &Expr) -> String {
    torse_syntax::notation::text(expr)
}
