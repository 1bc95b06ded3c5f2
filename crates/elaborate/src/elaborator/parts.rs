//! Parts that many formulas have in common, each opened once.
//!
//! Formulas that differ from one in a single place share all its other parts, and a part outside of binders opens to the
//! same term wherever it stands.

use super::Elaborator;
use super::binders::Scope;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_core::Term;
use torse_syntax::formula::{Expr, Node};

/// The parts by their addresses; they are held, so that no other formula gets one.
#[derive(Debug, Default)]
pub(super) struct Parts {
    opened: BTreeMap<usize, (Arc<Expr>, Option<Term>)>,
    /// The addresses of their terms.
    terms: BTreeSet<usize>,
}

impl Scope {
    pub(super) fn is_outermost(&self) -> bool {
        self.locals.is_empty() && self.globals.is_empty()
    }
}

impl Elaborator<'_> {
    /// From here on the parts of this formula are opened once.
    pub fn keep_parts_of(&self, formula: &Expr) {
        let mut parts = self.parts.borrow_mut();
        let mut pending = vec![formula];
        while let Some(whole) = pending.pop() {
            for part in shared(whole) {
                let address = Arc::as_ptr(part).addr();
                let entry = parts.opened.entry(address);
                entry.or_insert_with(|| (Arc::clone(part), None));
            }
            pending.extend(whole.parts());
        }
    }

    /// Whether a term is that of a part that is opened once: its address stands for it.
    #[must_use]
    pub fn is_kept(&self, term: &Term) -> bool {
        let parts = self.parts.borrow();
        parts.terms.contains(&Arc::as_ptr(&term.node).addr())
    }

    /// The term of a part that was opened before.
    pub(super) fn kept(&self, expr: &Expr, scope: &Scope) -> Option<Term> {
        let parts = self.parts.borrow();
        let known = parts.opened.get(&std::ptr::from_ref(expr).addr())?;
        known.1.clone().filter(|_| scope.is_outermost())
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

/// The direct parts that copies of a formula share.
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
