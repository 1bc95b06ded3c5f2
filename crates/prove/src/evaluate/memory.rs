//! What was evaluated before.
//!
//! The value of a term depends on the values of its free variables alone: those that no binder inside it binds. So the
//! bodies of definitions and derivatives, which a claim calls again and again, are evaluated once for each choice of them.

use super::value::Value;
use super::{Environment, Evaluator, Outcome};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use std::sync::Arc;
use torse_algebra::{Fraction, work};
use torse_core::{Node, Term};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

/// The most values of one term that are kept.
const MAX_KEPT: usize = 24;

/// The free variables of a term; the term is kept, so that no other one gets its address.
type Free = (Term, Rc<BTreeSet<u32>>);
/// The value of a term where its free variables have these values.
type Remembered = (Vec<Fraction>, Value);
/// The value of a part that many formulas share, and the work it took.
type Part = (Value, u64);

/// Free variables by the address of a term, values by that and by whether it stands in an angle.
#[derive(Clone, Default)]
pub(super) struct Memory {
    /// The free variables of what has none.
    none: Rc<BTreeSet<u32>>,
    free: RefCell<BTreeMap<usize, Free>>,
    values: RefCell<BTreeMap<(usize, bool), Vec<Remembered>>>,
    parts: RefCell<BTreeMap<(usize, bool), Part>>,
}

impl Memory {
    /// Forgets all values: symbols mean something else from here on.
    pub(super) fn forget(&self) {
        self.values.borrow_mut().clear();
        self.parts.borrow_mut().clear();
    }

    /// The numbers of the variables that a term takes from outside.
    fn free(&self, term: &Term) -> Rc<BTreeSet<u32>> {
        if let Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Vector(..) = &*term.node {
            return Rc::clone(&self.none);
        }
        let address = Arc::as_ptr(&term.node).addr();
        if let Some((_, known)) = self.free.borrow().get(&address) {
            return Rc::clone(known);
        }
        let mut all: BTreeSet<u32> = BTreeSet::new();
        let inside = |all: &mut BTreeSet<u32>, body: &Term, bound: &[u32]| {
            let of_body = self.free(body);
            all.extend(of_body.iter().filter(|n| !bound.contains(n)));
        };
        match &*term.node {
            Node::Variable(variable) => {
                all.insert(variable.number());
            }
            Node::Sum {
                index,
                low,
                high,
                term,
            }
            | Node::Product {
                index,
                low,
                high,
                term,
            }
            | Node::Integral {
                variable: index,
                low,
                high,
                body: term,
            } => {
                inside(&mut all, low, &[]);
                inside(&mut all, high, &[]);
                inside(&mut all, term, &[index.number()]);
            }
            Node::Let {
                variable,
                value,
                body,
            } => {
                inside(&mut all, value, &[]);
                inside(&mut all, body, &[variable.number()]);
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => {
                inside(&mut all, order, &[]);
                inside(&mut all, at, &[]);
                inside(&mut all, body, &[variable.number()]);
            }
            _ => {
                for part in term.parts() {
                    inside(&mut all, part, &[]);
                }
                if let Node::Basis { family, .. } = &*term.node {
                    let own: Vec<u32> = family.bound().map(|v| v.number()).collect();
                    let steps = [&family.step.0, &family.step.1];
                    for part in family.seeds.iter().chain(steps) {
                        inside(&mut all, part, &own);
                    }
                }
            }
        }
        let all = Rc::new(all);
        let kept = (term.clone(), Rc::clone(&all));
        self.free.borrow_mut().insert(address, kept);
        all
    }
}

/// What a job that is over came to is not kept: others would take it for the value. See [`work`].
pub(super) fn lasting(place: Place) -> Outcome<()> {
    work::check().map_err(|limit| Fault::limit(place, limit.to_string()))
}

impl Evaluator<'_> {
    /// The value of a term, from memory if its free variables had the same values before.
    pub(super) fn remembered(
        &self,
        term: &Term,
        bound: &Environment,
        evaluate: impl FnOnce() -> Outcome<Value>,
    ) -> Outcome<Value> {
        let free = self.memory.free(term);
        // Inside a sum of symbolic length a value may rest on the range of its index.
        if !free.is_empty() && !self.sums.borrow().is_empty() {
            return evaluate();
        }
        let value = |number: &u32| match bound.get(number) {
            Some(Value::Scalar(q)) => q.as_fraction().cloned(),
            _ => None,
        };
        let Some(values) = free.iter().map(value).collect::<Option<Vec<Fraction>>>() else {
            return evaluate();
        };
        let key = (Arc::as_ptr(&term.node).addr(), self.in_angle.get());
        let same = |(own, _): &&Remembered| {
            own.len() == values.len() && own.iter().zip(&values).all(|(x, y)| x.is_identical(y))
        };
        if let Some(known) = self.memory.values.borrow().get(&key)
            && let Some((_, value)) = known.iter().find(same)
        {
            return Ok(value.clone());
        }
        let value = evaluate()?;
        lasting(term.place)?;
        let mut kept = self.memory.values.borrow_mut();
        let kept = kept.entry(key).or_default();
        if kept.len() < MAX_KEPT {
            kept.push((values, value.clone()));
        }
        Ok(value)
    }

    /// The value of a part that many formulas share. It is charged each time, so that how far a search gets does not hang on
    /// what was asked before.
    pub(super) fn shared(
        &self,
        term: &Term,
        evaluate: impl FnOnce() -> Outcome<Value>,
    ) -> Outcome<Value> {
        let key = (Arc::as_ptr(&term.node).addr(), self.in_angle.get());
        if let Some((value, work)) = self.memory.parts.borrow().get(&key) {
            self.spend(*work);
            return Ok(value.clone());
        }
        let before = self.work();
        let value = evaluate()?;
        lasting(term.place)?;
        let work = self.work().saturating_sub(before);
        let kept = (value.clone(), work);
        self.memory.parts.borrow_mut().insert(key, kept);
        Ok(value)
    }
}
