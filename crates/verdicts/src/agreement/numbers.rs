//! Numbers for core terms: those of an assignment, and the values of names that the engine makes.

use super::functions::arc_value;
use super::terms::Terms;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core as core;
use torse_semantics::tree::{Assignment, Compared};
use torse_semantics::{Class, Name, Scrambled, Value};
use torse_syntax::formula::Expr;

/// Supplies numbers to core terms.
pub(super) struct Numbers<'a, 's> {
    pub core: &'s core::Claim,
    pub made: &'s BTreeMap<Arc<str>, Option<Expr>>,
    pub trees: &'a Compared<'s, 'a>,
    pub assignment: &'a Assignment<'s>,
    pub arithmetic: &'a Scrambled<'a>,
    pub known: RefCell<BTreeMap<Arc<str>, Option<Value<Class>>>>,
}

impl Numbers<'_, '_> {
    /// Returns the residue of a number.
    pub fn number(&self, name: &Name) -> Option<Class> {
        let declared = name.declared();
        if !self.made.contains_key(declared) {
            return self.assignment.number(name);
        }
        let known = self.known.borrow().get(declared).cloned();
        let value = match known {
            Some(known) => known,
            None => {
                let found = self.made_value(declared);
                let mut known = self.known.borrow_mut();
                known.insert(Arc::clone(declared), found.clone());
                found
            }
        };
        let value = match name {
            Name::Coordinate(_, c) => {
                let entry = value?.entries().ok()?;
                entry.get(usize::from(*c).checked_sub(1)?)?.clone()
            }
            _ => value?.number().ok()?,
        };
        value.as_number().copied()
    }

    /// Returns the value of a name that the engine made: the root of its square, the logarithm of its exponential, the arc of
    /// its tangent or sine, or the value of its text.
    fn made_value(&self, name: &Arc<str>) -> Option<Value<Class>> {
        if let Some((_, argument)) = self.core.logarithms().find(|(own, _)| *own == name) {
            let values = |name: &Name| self.number(name);
            let argument = Terms::new(self.arithmetic, &values, None).value(argument);
            let logarithm = argument.ok()?.number().ok()?.logarithm(self.arithmetic);
            return logarithm.ok().map(Value::Number);
        }
        if let Some(arc) = self.core.arcs().find(|arc| arc.name == name) {
            let values = |name: &Name| self.number(name);
            let argument = Terms::new(self.arithmetic, &values, None).value(arc.argument);
            let argument = argument.ok()?.number().ok()?;
            let value = arc_value(arc.function, &argument, self.arithmetic);
            return value.ok().map(Value::Number);
        }
        if let Some((_, radicand)) = self.core.roots().find(|(own, _)| *own == name) {
            let values = |name: &Name| self.number(name);
            let radicand = Terms::new(self.arithmetic, &values, None).value(radicand);
            let root = radicand.ok()?.number().ok()?.square_root(self.arithmetic);
            return root.ok().map(Value::Number);
        }
        let text = self.made.get(name)?.as_ref()?;
        self.trees.value(text).ok()
    }
}
