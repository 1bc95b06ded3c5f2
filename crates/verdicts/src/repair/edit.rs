//! One edit of a formula.

use torse_language::syntax::{Expr, Node};

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
    let parts = expr.parts();
    let part = parts.get(*first).map(|part| placed(part, rest, by));
    part.and_then(|part| expr.with_part(*first, part))
        .unwrap_or_else(|| expr.clone())
}

/// Every part of a formula with the way to it, the formula itself first; the heads of calls and members, which are names
/// of functions and families, are left out.
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

/// The formula with one name put for another in all places, primes kept.
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
    torse_language::notation::text(expr)
}
