//! Symbols that a program makes: SymPy's, which are none of its parameters.
//!
//! A symbol of the claim's name is that symbol of the claim, unless an argument has it in its value: for numbers the two are two things,
//! and for symbols one. Any other symbol gets a name that neither the claim nor a sum has, and has to be bound in the end.

use super::Runner;
use super::value::{Term, Value};
use crate::grammar::Read;
use crate::program::Kind;
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::formula::{Expr, Node, Place, is_name};

/// The symbols of a run.
#[derive(Debug, Default)]
pub(super) struct Symbols {
    /// The names of formulas by those of the program.
    made: BTreeMap<String, String>,
    /// The names in the values of arguments.
    passed: BTreeSet<String>,
    /// The names that indices of sums had.
    indices: BTreeSet<String>,
}

impl Symbols {
    /// Notes the names of an argument.
    pub(super) fn pass(&mut self, value: &Value) {
        match value {
            Value::Term(term) => self.passed.extend(free_names(&term.expr)),
            Value::List(list) => list.values.iter().for_each(|value| self.pass(value)),
            Value::Family(family) => drop(self.passed.insert(family.name.clone())),
            Value::Truth(_) => {}
        }
    }

    /// Notes the name of an index; false if a symbol has it.
    pub(super) fn is_index(&mut self, name: &str) -> bool {
        let is_free = self.made.values().all(|made| made != name);
        is_free && {
            self.indices.insert(name.to_owned());
            true
        }
    }

    /// How the program writes a name.
    pub(super) fn written(&self, name: &str) -> String {
        let mut made = self.made.iter();
        let found = made.find(|(_, made)| *made == name);
        found.map_or(name, |(written, _)| written).to_owned()
    }

    pub(super) fn into_dummies(self) -> Vec<String> {
        self.made.into_values().collect()
    }
}

impl Runner<'_> {
    /// A new symbol of SymPy.
    pub(super) fn symbol(&mut self, name: &str, place: Place) -> Read<Value> {
        if let Some(value) = self.setting.own_symbol(name) {
            let mut own = Symbols::default();
            own.pass(&value);
            let is_fixed = matches!(&value, Value::Term(term) if term.constant.is_some());
            if !is_fixed && own.passed.is_disjoint(&self.symbols.passed) {
                return Ok(value);
            }
            let message =
                format!("the symbol `{name}` is a symbol of the claim that a parameter stands for");
            let help = "give the symbol a name of its own: for numbers it is not the parameter";
            return Err(self.refused(place, message, help));
        }
        if !self.symbols.made.contains_key(name) {
            let made = self.fresh(name);
            self.symbols.made.insert(name.to_owned(), made);
        }
        let made = self.symbols.made.get(name).map_or(name, String::as_str);
        Ok(Value::Term(Term::formula(Expr::name(made), Kind::Float)))
    }

    /// A name like this that nothing else has.
    fn fresh(&self, name: &str) -> String {
        let letters: String = name.chars().filter(|c| c.is_alphanumeric()).collect();
        let base = if is_name(&letters) {
            letters
        } else {
            "u".to_owned()
        };
        let is_free = |name: &String| {
            let symbols = &self.symbols;
            is_name(name)
                && !self.setting.is_declared(name)
                && !symbols.indices.contains(name)
                && !symbols.passed.contains(name)
                && symbols.made.values().all(|made| made != name)
        };
        let numbered = (1..).map(|number: u32| format!("{base}{number}"));
        let mut names = std::iter::once(base.clone()).chain(numbered);
        names.find(is_free).unwrap_or(base)
    }
}

/// The names of a formula that nothing in it binds.
pub(super) fn free_names(expr: &Expr) -> Vec<String> {
    let Node::Call(head, arguments) = &expr.node else {
        return match &expr.node {
            Node::Name(name) => vec![name.clone()],
            _ => expr.parts().into_iter().flat_map(free_names).collect(),
        };
    };
    let name = match &head.node {
        Node::Name(name) => name.as_str(),
        _ => "",
    };
    // What is bound, in which argument, and by which.
    let (body, bound) = match (name, arguments.as_slice()) {
        ("sum" | "product", [bound, _, _, body]) => (body, bound),
        ("integral", [body, bound, _, _]) | ("at", [body, bound, _]) => (body, bound),
        _ => return expr.parts().into_iter().flat_map(free_names).collect(),
    };
    let mut found: Vec<String> = free_names(body);
    found.retain(|name| !matches!(&bound.node, Node::Name(bound) if bound == name));
    for other in arguments {
        if !std::ptr::eq(other, body) && !std::ptr::eq(other, bound) {
            found.extend(free_names(other));
        }
    }
    found
}
