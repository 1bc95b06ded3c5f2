//! The values of variables and moved symbols where a term stands.

use torse_core::Variable;
use torse_semantics::{Class, Name, Series, Value};

/// The values of the variables of enclosing binders, and of symbols that are moved, innermost first.
pub(super) struct Scope<'s> {
    outer: Option<&'s Scope<'s>>,
    binding: Binding,
    /// The number of infinitesimals.
    pub level: usize,
    /// The symbols that are moved, and how: each way to move a symbol has its own number; 0 stands for none.
    pub moved_as: usize,
}

enum Binding {
    Nothing,
    Variable(u32, Value<Class>),
    Symbol(Name, Series<Class>),
}

impl Scope<'_> {
    pub fn outermost() -> Self {
        Self {
            outer: None,
            binding: Binding::Nothing,
            level: 0,
            moved_as: 0,
        }
    }

    fn inner<'t>(&'t self, binding: Binding, level: usize) -> Scope<'t> {
        Scope {
            outer: Some(self),
            moved_as: self.moved_as,
            binding,
            level,
        }
    }

    pub fn with<'t>(&'t self, variable: &Variable, value: Value<Class>) -> Scope<'t> {
        self.inner(Binding::Variable(variable.number(), value), self.level)
    }

    /// Gives the variable an infinitesimal of its own.
    pub fn within<'t>(&'t self, variable: &Variable, value: Series<Class>) -> Scope<'t> {
        let binding = Binding::Variable(variable.number(), Value::Number(value));
        self.inner(binding, self.level + 1)
    }

    /// Moves a declared number by one more infinitesimal; `moved_as` is the number of this way to move it.
    pub fn moved<'t>(&'t self, name: Name, value: Series<Class>, moved_as: usize) -> Scope<'t> {
        Scope {
            moved_as,
            ..self.inner(Binding::Symbol(name, value), self.level + 1)
        }
    }

    fn enclosing(&self) -> impl Iterator<Item = &Scope<'_>> {
        std::iter::successors(Some(self), |scope| scope.outer)
    }

    pub fn variable(&self, number: u32) -> Option<&Value<Class>> {
        self.enclosing().find_map(|scope| match &scope.binding {
            Binding::Variable(own, value) if *own == number => Some(value),
            _ => None,
        })
    }

    pub fn symbol(&self, name: &Name) -> Option<&Series<Class>> {
        let mut all = self.enclosing().take_while(|scope| scope.moved_as > 0);
        all.find_map(|scope| match &scope.binding {
            Binding::Symbol(own, value) if own == name => Some(value),
            _ => None,
        })
    }
}
