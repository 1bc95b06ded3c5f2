//! A cache of values, keyed by everything that they depend on.
//!
//! The body of a definition depends on its parameters and on those moved symbols that occur in it, directly or
//! through other definitions. So its value is cached under the tree itself (trees outlive the evaluator, so no
//! address is reused), its arguments, and the serials of the moved numbers that it reaches. A serial identifies a
//! number together with its value as a series: infinitesimals and truncation belong to the value, so a different
//! order or level gets a different serial. The point and the arithmetic are fixed for an evaluator. [`Memory::none`]
//! caches nothing; a test compares both.

use super::environment::Part;
use crate::series::Series;
use crate::value::Value;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::Expr;

/// The largest number of cached values of one function, or rows of one basis.
const MAX_CALLS: usize = 24;
/// The largest number of moved numbers that are recognized again.
const MAX_SERIALS: usize = 48;

/// The address of a tree, and the serials of the moved numbers that it reaches.
pub(super) type Key = (usize, Vec<u64>);
/// Values by arguments.
pub(super) type Calls<N, T> = Vec<(Vec<Value<N>>, T)>;
/// A number with its moved value and serial.
type Binding<'a, N> = (&'a str, Part, Series<N>, u64);

/// The functions of a basis of one degree at one argument.
type Row<N> = Rc<[Series<N>]>;
/// The rows of each basis and degree, by their arguments.
type Rows<N> = BTreeMap<(Key, i64), Calls<N, Row<N>>>;

/// A cache of values.
pub(super) struct Memory<'a, N> {
    pub remembers: bool,
    pub values: RefCell<BTreeMap<Key, Value<N>>>,
    pub calls: RefCell<BTreeMap<Key, Calls<N, Value<N>>>>,
    pub rows: RefCell<Rows<N>>,
    serials: RefCell<Vec<Binding<'a, N>>>,
    next: Cell<u64>,
    reached: RefCell<BTreeMap<usize, Rc<BTreeSet<&'a str>>>>,
}

impl<N> Memory<'_, N> {
    /// A cache that stores nothing.
    pub fn none() -> Self {
        Self {
            remembers: false,
            values: RefCell::default(),
            calls: RefCell::default(),
            rows: RefCell::default(),
            serials: RefCell::default(),
            next: Cell::default(),
            reached: RefCell::default(),
        }
    }

    /// An empty cache.
    pub fn new() -> Self {
        Self {
            remembers: true,
            ..Self::none()
        }
    }
}

impl<'a, N: Clone + PartialEq> Memory<'a, N> {
    /// The serial of a moved number: the former one if it is known, otherwise a new one.
    pub fn serial(&self, symbol: &'a str, part: &Part, value: &Series<N>) -> u64 {
        let mut all = self.serials.borrow_mut();
        let known = all.iter().rev().find(|(own, own_part, own_value, _)| {
            *own == symbol && own_part == part && own_value == value
        });
        if let Some((.., serial)) = known.filter(|_| self.remembers) {
            return *serial;
        }
        let serial = self.next.get();
        self.next.set(serial + 1);
        if self.remembers {
            if all.len() >= MAX_SERIALS {
                all.remove(0);
            }
            all.push((symbol, part.clone(), value.clone(), serial));
        }
        serial
    }

    /// The names that a tree reaches: those in it, and those in their definitions.
    pub fn reached(&self, declarations: &'a Declarations, tree: &'a Expr) -> Rc<BTreeSet<&'a str>> {
        let address = std::ptr::from_ref(tree).addr();
        if let Some(known) = self.reached.borrow().get(&address) {
            return Rc::clone(known);
        }
        let names = Rc::new(reached(declarations, [tree]));
        let mut all = self.reached.borrow_mut();
        all.insert(address, Rc::clone(&names));
        names
    }
}

/// Stores a value, and drops the oldest one if there are too many.
pub(super) fn keep<N, T>(calls: &mut Calls<N, T>, arguments: Vec<Value<N>>, value: T) {
    if calls.len() >= MAX_CALLS {
        calls.remove(0);
    }
    calls.push((arguments, value));
}

/// All names in trees, and in the definitions and bases that they name; arguments of bases that are left out count as
/// names.
pub(super) fn reached<'a>(
    declarations: &'a Declarations,
    trees: impl IntoIterator<Item = &'a Expr>,
) -> BTreeSet<&'a str> {
    let mut names = BTreeSet::new();
    let mut pending: Vec<&'a Expr> = trees.into_iter().collect();
    while let Some(tree) = pending.pop() {
        let mut written = tree.names();
        while let Some(name) = written.pop() {
            if !names.insert(name) {
                continue;
            }
            written.push(name.trim_end_matches('\''));
            if let Some(definition) = declarations.definition(name) {
                pending.push(&definition.body.expr);
            }
            if let Some(basis) = declarations.basis(name) {
                written.push(&basis.variable);
                written.extend(basis.parameters.iter().map(String::as_str));
                let parts = basis.seeds.iter().chain([&basis.step.0, &basis.step.1]);
                pending.extend(parts.map(|part| &part.expr));
            }
        }
    }
    names
}
