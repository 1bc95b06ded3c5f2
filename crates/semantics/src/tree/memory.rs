//! What was evaluated before, under the same values of all that it can see.
//!
//! The body of a definition sees its parameters and the moved symbols, and of these only those that it mentions, be it
//! through other definitions. So its value is remembered under the tree itself (trees outlive the evaluator: no address is
//! used again), its arguments, and the serials of the moved numbers that it reaches. A serial stands for a number with its
//! value as a series: the infinitesimals in it and where they are cut off belong to the value, so that the same place
//! under another order, or another level, has another serial. The point and the arithmetic belong to the evaluator. A
//! [`Memory::none`] remembers nothing; a test compares both.

use super::environment::{Environment, Moved, Part};
use super::evaluate::{Evaluator, Meaning, Outcome};
use crate::arithmetic::Arithmetic;
use crate::gap::Gap;
use crate::series::Series;
use crate::value::Value;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::Expr;

/// The most values of one function, or rows of one basis, that are remembered.
const MAX_CALLS: usize = 24;
/// The most moved numbers that are told from new ones.
const MAX_SERIALS: usize = 48;

/// A tree, by where it is, and the serials of the moved numbers that it reaches.
type Key = (usize, Vec<u64>);
/// Values by arguments.
type Calls<N, T> = Vec<(Vec<Value<N>>, T)>;
/// A number with the value to which it is moved.
type Binding<'a, N> = (&'a str, Part, Series<N>, u64);

/// What was evaluated before.
pub(super) struct Memory<'a, N> {
    remembers: bool,
    values: RefCell<BTreeMap<Key, Value<N>>>,
    calls: RefCell<BTreeMap<Key, Calls<N, Value<N>>>>,
    rows: RefCell<BTreeMap<(Key, i64), Calls<N, Rc<[Series<N>]>>>>,
    serials: RefCell<Vec<Binding<'a, N>>>,
    next: Cell<u64>,
    reached: RefCell<BTreeMap<usize, Rc<BTreeSet<&'a str>>>>,
}

impl<N> Memory<'_, N> {
    /// One that forgets everything.
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

    /// One that remembers nothing yet.
    pub fn new() -> Self {
        Self {
            remembers: true,
            ..Self::none()
        }
    }
}

type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// Whether values may be looked up: not while the divisors are asked for that are met on the way to them.
    fn remembers(&self) -> bool {
        self.memory.remembers && self.divisors.borrow().is_none()
    }

    /// The inside of what moves a number of a declared symbol.
    pub(super) fn moving(
        &self,
        symbol: &'a str,
        part: Part,
        value: Series<A::Number>,
        place: &Place<'a, A>,
    ) -> Place<'a, A> {
        let serial = self.serial(symbol, &part, &value);
        let moved = Moved {
            symbol,
            part,
            value,
            serial,
        };
        Environment {
            local: place.local.clone(),
            moved: place.moved.with(moved),
        }
    }

    fn serial(&self, symbol: &'a str, part: &Part, value: &Series<A::Number>) -> u64 {
        let mut all = self.memory.serials.borrow_mut();
        let known = all.iter().rev().find(|(own, own_part, own_value, _)| {
            *own == symbol && own_part == part && own_value == value
        });
        if let Some((.., serial)) = known.filter(|_| self.memory.remembers) {
            return *serial;
        }
        let serial = self.memory.next.get();
        self.memory.next.set(serial + 1);
        if self.memory.remembers {
            if all.len() >= MAX_SERIALS {
                all.remove(0);
            }
            all.push((symbol, part.clone(), value.clone(), serial));
        }
        serial
    }

    /// The serials of the moved numbers whose symbols a tree reaches, the innermost of each number.
    fn key(&self, tree: &'a Expr, reached: &BTreeSet<&'a str>, place: &Place<'a, A>) -> Key {
        let mut seen: Vec<(&str, &Part)> = vec![];
        let mut serials = vec![];
        for moved in place.moved.iter() {
            let own = (moved.symbol, &moved.part);
            if reached.contains(moved.symbol) && !seen.contains(&own) {
                seen.push(own);
                serials.push(moved.serial);
            }
        }
        self.marked(tree, serials)
    }

    /// The key of a tree with these serials; where given equations are put into `coefficients` it is another one.
    fn marked(&self, tree: &'a Expr, mut serials: Vec<u64>) -> Key {
        if self.given.borrow().is_some() {
            serials.push(u64::MAX);
        }
        (std::ptr::from_ref(tree).addr(), serials)
    }

    /// The names that a tree reaches: those written in it, and those in what they mean.
    fn reached(&self, tree: &'a Expr) -> Rc<BTreeSet<&'a str>> {
        let address = std::ptr::from_ref(tree).addr();
        if let Some(known) = self.memory.reached.borrow().get(&address) {
            return Rc::clone(known);
        }
        let names = Rc::new(reached(self.declarations, [tree]));
        let mut all = self.memory.reached.borrow_mut();
        all.insert(address, Rc::clone(&names));
        names
    }

    fn key_of(&self, tree: &'a Expr, place: &Place<'a, A>) -> Key {
        match place.moved.is_empty() {
            true => self.marked(tree, vec![]),
            false => self.key(tree, &self.reached(tree), place),
        }
    }

    /// The value of the body of a definition without parameters.
    pub(super) fn remembered(
        &self,
        body: &'a Expr,
        place: &Place<'a, A>,
        evaluate: impl FnOnce() -> Result<Meaning<A::Number>, Gap>,
    ) -> Result<Meaning<A::Number>, Gap> {
        if !self.remembers() {
            return evaluate();
        }
        let key = self.key_of(body, place);
        if let Some(known) = self.memory.values.borrow().get(&key) {
            return Ok(Meaning::Value(known.clone()));
        }
        let meaning = evaluate()?;
        if let Meaning::Value(value) = &meaning {
            let mut all = self.memory.values.borrow_mut();
            all.insert(key, value.clone());
        }
        Ok(meaning)
    }

    /// The value of the body of a function at arguments.
    pub(super) fn remembered_call(
        &self,
        body: &'a Expr,
        outside: &Place<'a, A>,
        arguments: Vec<Value<A::Number>>,
        evaluate: impl FnOnce(Vec<Value<A::Number>>) -> Outcome<A>,
    ) -> Outcome<A> {
        if !self.remembers() {
            return evaluate(arguments);
        }
        let key = self.key_of(body, outside);
        if let Some(calls) = self.memory.calls.borrow().get(&key)
            && let Some((_, known)) = calls.iter().rev().find(|(own, _)| *own == arguments)
        {
            return Ok(known.clone());
        }
        let value = evaluate(arguments.clone())?;
        let mut all = self.memory.calls.borrow_mut();
        keep(all.entry(key).or_default(), arguments, value.clone());
        Ok(value)
    }

    /// The functions of one degree of a basis at arguments; `first` is its first seed, which stands for the basis.
    pub(super) fn remembered_row(
        &self,
        first: &'a Expr,
        (degree, arguments): (i64, Vec<Value<A::Number>>),
        outside: &Place<'a, A>,
        parts: impl FnOnce() -> Vec<&'a Expr>,
        evaluate: impl FnOnce(&[Value<A::Number>]) -> Result<Rc<[Series<A::Number>]>, Gap>,
    ) -> Result<Rc<[Series<A::Number>]>, Gap> {
        if !self.remembers() {
            return evaluate(&arguments);
        }
        let key = match outside.moved.is_empty() {
            true => self.marked(first, vec![]),
            false => self.key(first, &reached(self.declarations, parts()), outside),
        };
        let key = (key, degree);
        if let Some(rows) = self.memory.rows.borrow().get(&key)
            && let Some((_, known)) = rows.iter().rev().find(|(own, _)| *own == arguments)
        {
            return Ok(Rc::clone(known));
        }
        let row = evaluate(&arguments)?;
        let mut all = self.memory.rows.borrow_mut();
        keep(all.entry(key).or_default(), arguments, Rc::clone(&row));
        Ok(row)
    }
}

fn keep<N, T>(calls: &mut Calls<N, T>, arguments: Vec<Value<N>>, value: T) {
    if calls.len() >= MAX_CALLS {
        calls.remove(0);
    }
    calls.push((arguments, value));
}

/// All names written in trees, and in the definitions and bases that they name; left-out arguments of bases are names too.
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
