//! What is known of terms whatever the point: found out once, it serves all points at which a statement is judged.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use std::sync::Arc;
use torse_core::{Term, degree};

/// The names of declared symbols.
pub(crate) type Names = Rc<BTreeSet<Arc<str>>>;

/// Forms and symbols, and whether those are linear in these.
type Linear = ([Term; 2], bool);

/// Facts by the addresses of terms; the terms are kept, so that no other one gets the address of one of them.
#[derive(Debug, Default)]
pub(crate) struct Known {
    closed: RefCell<BTreeMap<usize, (Term, bool)>>,
    names: RefCell<BTreeMap<usize, (Term, Names)>>,
    linear: RefCell<BTreeMap<(usize, usize), Linear>>,
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

    /// Whether forms are linear in all symbols of a list together, by their form.
    pub(crate) fn is_linear(&self, forms: &Term, symbols: &Term) -> bool {
        let key = (
            Arc::as_ptr(&forms.node).addr(),
            Arc::as_ptr(&symbols.node).addr(),
        );
        let mut all = self.linear.borrow_mut();
        let found = all.entry(key).or_insert_with(|| {
            let mut names = BTreeSet::new();
            symbols.declared_names(&mut |name| {
                names.insert(Arc::clone(name));
            });
            let linear = degree::is_linear(forms, &names);
            ([forms.clone(), symbols.clone()], linear)
        });
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
