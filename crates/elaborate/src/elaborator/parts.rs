//! Caches the core terms of parts that many formulas share.
//!
//! A formula and its single-place variants share all parts outside of that place, and a part outside of all binders
//! always opens to the same term.

use super::Elaborator;
use super::binders::Scope;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_core::Term;
use torse_syntax::formula::{Expr, Node};

/// The cached parts, by address. The trees are kept alive so that no address is reused.
#[derive(Debug, Default)]
pub(super) struct Parts {
    opened: BTreeMap<usize, (Arc<Expr>, Option<Term>)>,
    /// The addresses of the cached terms.
    terms: BTreeSet<usize>,
}

impl Scope {
    pub(super) fn is_outermost(&self) -> bool {
        self.locals.is_empty() && self.globals.is_empty()
    }
}

impl Elaborator<'_> {
    /// From now on, the parts of this formula are opened once and cached.
    pub fn keep_parts_of(&self, formula: &Expr) {
        let mut parts = self.parts.borrow_mut();
        let mut pending = vec![formula];
        while let Some(node) = pending.pop() {
            for part in shared(node) {
                let address = Arc::as_ptr(part).addr();
                let entry = parts.opened.entry(address);
                entry.or_insert_with(|| (Arc::clone(part), None));
            }
            pending.extend(node.parts());
        }
    }

    /// Whether the term is a cached one, which its address then identifies.
    #[must_use]
    pub fn is_kept(&self, term: &Term) -> bool {
        let parts = self.parts.borrow();
        parts.terms.contains(&Arc::as_ptr(&term.node).addr())
    }

    /// The cached term of a part.
    pub(super) fn kept(&self, expr: &Expr, scope: &Scope) -> Option<Term> {
        let parts = self.parts.borrow();
        let entry = parts.opened.get(&std::ptr::from_ref(expr).addr())?;
        entry.1.clone().filter(|_| scope.is_outermost())
    }

    pub(super) fn keep(&self, expr: &Expr, scope: &Scope, term: &Term) {
        let mut parts = self.parts.borrow_mut();
        let Parts { opened, terms } = &mut *parts;
        if let Some((_, slot)) = opened.get_mut(&std::ptr::from_ref(expr).addr())
            && scope.is_outermost()
        {
            terms.insert(Arc::as_ptr(&term.node).addr());
            *slot = Some(term.clone());
        }
    }
}

/// The direct parts that are shared by pointer between copies of a formula.
fn shared(formula: &Expr) -> Vec<&Arc<Expr>> {
    match &formula.node {
        Node::Call(only, _)
        | Node::Index(only, _)
        | Node::Negative(only)
        | Node::Not(only)
        | Node::Compare(only, _) => vec![only],
        Node::Binary(_, a, b) | Node::Join(_, a, b) => vec![a, b],
        Node::Number { .. } | Node::Name(_) | Node::List(_) => vec![],
    }
}
