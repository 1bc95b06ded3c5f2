//! What is known of terms whatever the point: found out once, it serves all points at which a statement is judged.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use std::sync::Arc;
use torse_language::core::Term;

/// The names of declared symbols.
pub(crate) type Names = Rc<BTreeSet<Arc<str>>>;

/// Facts by the addresses of terms; the terms are kept, so that no other one gets the address of one of them.
#[derive(Debug, Default)]
pub(crate) struct Known {
    closed: RefCell<BTreeMap<usize, (Term, bool)>>,
    names: RefCell<BTreeMap<usize, (Term, Names)>>,
}

impl Known {
    /// Whether a term depends on no variable of an enclosing binder.
    pub(crate) fn is_closed(&self, term: &Term) -> bool {
        let key = Arc::as_ptr(&term.node).addr();
        let mut all = self.closed.borrow_mut();
        let found = all
            .entry(key)
            .or_insert_with(|| (term.clone(), term.is_closed()));
        found.1
    }

    /// The declared symbols that occur in a term.
    pub(crate) fn names(&self, term: &Term) -> Names {
        let key = Arc::as_ptr(&term.node).addr();
        let mut all = self.names.borrow_mut();
        let found = all.entry(key).or_insert_with(|| {
            let mut names = BTreeSet::new();
            term.declared_names(&mut |name| {
                names.insert(Arc::clone(name));
            });
            (term.clone(), Rc::new(names))
        });
        Rc::clone(&found.1)
    }
}
