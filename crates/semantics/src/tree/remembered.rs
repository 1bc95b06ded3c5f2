//! Evaluation through the cache ([`Memory`](super::memory::Memory)).

use super::environment::{Environment, Moved, Part};
use super::evaluate::{Evaluator, Meaning, Outcome};
use super::memory::{Key, keep, reached};
use crate::arithmetic::Arithmetic;
use crate::no_value::NoValue;
use crate::series::Series;
use crate::value::Value;
use std::collections::BTreeSet;
use std::rc::Rc;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_syntax::formula::Expr;

type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// Whether the cache may be used: not while divisors are recorded, since a cached value would hide them.
    fn remembers(&self) -> bool {
        self.memory.remembers && self.divisors.borrow().is_none()
    }

    /// The environment in which a number of a declared symbol is moved.
    pub(super) fn moving(
        &self,
        symbol: &'a str,
        part: Part,
        value: Series<A::Number>,
        place: &Place<'a, A>,
    ) -> Place<'a, A> {
        let serial = self.memory.serial(symbol, &part, &value);
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

    /// The serials of the moved numbers whose symbols a tree reaches; for each number the innermost one.
    fn key(&self, tree: &'a Expr, reached: &BTreeSet<&'a str>, place: &Place<'a, A>) -> Key {
        let mut seen: Vec<(&str, &Part)> = vec![];
        let mut serials = vec![];
        if injected(InjectedFault::StaleMemory) {
            return self.marked(tree, serials);
        }
        for moved in place.moved.iter() {
            let own = (moved.symbol, &moved.part);
            if reached.contains(moved.symbol) && !seen.contains(&own) {
                seen.push(own);
                serials.push(moved.serial);
            }
        }
        self.marked(tree, serials)
    }

    /// The key of a tree with these serials; with given equations for `coefficients` it is a different key.
    fn marked(&self, tree: &'a Expr, mut serials: Vec<u64>) -> Key {
        if self.given.borrow().is_some() {
            serials.push(u64::MAX);
        }
        (std::ptr::from_ref(tree).addr(), serials)
    }

    fn key_of(&self, tree: &'a Expr, place: &Place<'a, A>) -> Key {
        if place.moved.is_empty() {
            return self.marked(tree, vec![]);
        }
        let reached = self.memory.reached(self.declarations, tree);
        self.key(tree, &reached, place)
    }

    /// The value of the body of a definition without parameters.
    pub(super) fn remembered(
        &self,
        body: &'a Expr,
        place: &Place<'a, A>,
        evaluate: impl FnOnce() -> Result<Meaning<A::Number>, NoValue>,
    ) -> Result<Meaning<A::Number>, NoValue> {
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

    /// The functions of one degree of a basis at arguments; `first` is its first seed, whose address identifies the
    /// basis.
    pub(super) fn remembered_row(
        &self,
        first: &'a Expr,
        (degree, arguments): (i64, Vec<Value<A::Number>>),
        outside: &Place<'a, A>,
        parts: impl FnOnce() -> Vec<&'a Expr>,
        evaluate: impl FnOnce(&[Value<A::Number>]) -> Result<Rc<[Series<A::Number>]>, NoValue>,
    ) -> Result<Rc<[Series<A::Number>]>, NoValue> {
        if !self.remembers() {
            return evaluate(&arguments);
        }
        let key = if outside.moved.is_empty() {
            self.marked(first, vec![])
        } else {
            self.key(first, &reached(self.declarations, parts()), outside)
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
