//! The values of variables where a term stands, and what is known under them.

use crate::name::Name;
use crate::series::Series;
use crate::value::Value;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The values of variables of enclosing binders, innermost first.
pub(crate) struct Scope<'s, N> {
    outer: Option<&'s Scope<'s, N>>,
    binding: Binding<N>,
    /// How many infinitesimals there are.
    pub(crate) level: usize,
    /// The innermost enclosing binding of a declared symbol. Every symbol is looked up among these, so that the others are
    /// not walked through.
    symbols: Option<&'s Scope<'s, N>>,
}

enum Binding<N> {
    Nothing,
    Variable(u32, Value<N>),
    /// A declared symbol as a variable: its own value plus an infinitesimal, and what is known under it. Boxed, for most
    /// bindings are of variables.
    Symbol(Box<(Name, Series<N>, Memory<N>)>),
}

impl<N: Clone> Scope<'_, N> {
    pub(crate) fn outermost() -> Self {
        Self {
            outer: None,
            binding: Binding::Nothing,
            level: 0,
            symbols: None,
        }
    }

    fn inner<'t>(&'t self, binding: Binding<N>) -> Scope<'t, N> {
        Scope {
            outer: Some(self),
            level: self.level,
            symbols: self.innermost_symbol(),
            binding,
        }
    }

    pub(crate) fn with<'t>(&'t self, variable: u32, value: Value<N>) -> Scope<'t, N> {
        self.inner(Binding::Variable(variable, value))
    }

    /// A declared symbol has another value, one infinitesimal further in.
    pub(crate) fn changed<'t>(&'t self, name: Name, value: Series<N>) -> Scope<'t, N> {
        let symbol = Box::new((name, value, Memory::default()));
        let mut inner = self.inner(Binding::Symbol(symbol));
        inner.level = self.level + 1;
        inner
    }

    pub(crate) fn variable(&self, number: u32) -> Option<&Value<N>> {
        match &self.binding {
            Binding::Variable(own, value) if *own == number => Some(value),
            _ => self.outer.and_then(|outer| outer.variable(number)),
        }
    }

    pub(crate) fn innermost_symbol(&self) -> Option<&Scope<'_, N>> {
        match &self.binding {
            Binding::Symbol(_) => Some(self),
            _ => self.symbols,
        }
    }

    /// The bindings of declared symbols, innermost first.
    fn symbols(&self) -> impl Iterator<Item = (&Name, &Series<N>, &Memory<N>)> {
        let scopes = std::iter::successors(self.innermost_symbol(), |scope| scope.symbols);
        scopes.filter_map(|scope| match &scope.binding {
            Binding::Symbol(symbol) => {
                let (name, value, memory) = &**symbol;
                Some((name, value, memory))
            }
            _ => None,
        })
    }

    /// The memory of the innermost binding of one of these declared symbols; `None` if all have their values of the
    /// point.
    pub(crate) fn memory_of(&self, names: &BTreeSet<Arc<str>>) -> Option<&Memory<N>> {
        let mut bound = self.symbols();
        let found = bound.find(|(name, ..)| names.contains(name.declared()));
        found.map(|(.., memory)| memory)
    }

    pub(crate) fn symbol(&self, name: &Name) -> Option<&Series<N>> {
        let found = self.symbols().find(|(own, ..)| *own == name);
        found.map(|(_, value, _)| value)
    }
}

/// What was evaluated under the same values of all declared symbols, by the addresses of terms.
pub(crate) struct Memory<N> {
    /// The values of closed terms.
    pub closed: RefCell<BTreeMap<usize, Value<N>>>,
    /// The expansions of formulas that are closed but for the variable they were expanded by.
    pub expansions: RefCell<BTreeMap<usize, Vec<Expansion<N>>>>,
}

impl<N> Default for Memory<N> {
    fn default() -> Self {
        Self {
            closed: RefCell::default(),
            expansions: RefCell::default(),
        }
    }
}

/// A formula at `point + e` with the infinitesimal e of this level, up to `e^order`.
pub(crate) struct Expansion<N> {
    pub point: Series<N>,
    pub level: usize,
    pub order: usize,
    pub value: Value<N>,
}
