//! Which declared symbols, definitions and bases a formula depends on.
//!
//! A definition is written as a function of the symbols that it reaches, so that `D` and `at` by such a symbol reach
//! into it. What a binder binds is not reached: `at(e, x, t)` reaches what t reaches, and of e all but x.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;
use torse_syntax::derivation::declarations::{Basis, Declarations, Definition};
use torse_syntax::formula::functions::FUNCTIONS;
use torse_syntax::formula::{Expr, Node};

/// How deep definitions may use each other.
const MAX_DEPTH: usize = 80;

/// What a formula depends on.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Reach {
    /// Declared symbols and smooth functions.
    pub symbols: BTreeSet<String>,
    /// Symbols on which it does not depend, although parts of it do: another value was put in there.
    pub moved: BTreeSet<String>,
    /// Definitions, through others too.
    pub definitions: BTreeSet<String>,
    /// Basis families.
    pub bases: BTreeSet<String>,
}

impl Reach {
    /// Adds what another formula depends on.
    pub fn extend(&mut self, other: &Self) {
        self.symbols.extend(other.symbols.iter().cloned());
        self.moved.extend(other.moved.iter().cloned());
        self.definitions.extend(other.definitions.iter().cloned());
        self.bases.extend(other.bases.iter().cloned());
    }
}

/// The names that are bound where a formula stands.
pub(super) type Bound = BTreeSet<String>;

/// The names of a claim, and what its definitions and bases reach: each is looked through once.
#[derive(Debug)]
pub(super) struct Names<'a> {
    pub declarations: &'a Declarations,
    known: RefCell<BTreeMap<String, Rc<Reach>>>,
    depth: Cell<usize>,
}

impl<'a> Names<'a> {
    /// Those of these declarations.
    pub fn new(declarations: &'a Declarations) -> Self {
        Self {
            declarations,
            known: RefCell::default(),
            depth: Cell::new(0),
        }
    }

    /// The definition that a name stands for, where it is not bound.
    pub fn definition(&self, name: &str, bound: &Bound) -> Option<&'a Definition> {
        let definition = self.declarations.definition(name);
        definition.filter(|_| !bound.contains(name))
    }

    /// The basis that a name stands for before an index, where the name is not bound and not defined.
    pub fn basis(&self, name: &str, bound: &Bound) -> Option<&'a Basis> {
        if bound.contains(name) || self.declarations.definition(name).is_some() {
            return None;
        }
        self.declarations.basis(name).map(|basis| &**basis)
    }

    /// The built-in function that a name stands for, where the name is not bound and not defined.
    pub fn built_in(&self, head: &Expr, bound: &Bound) -> Option<&'static str> {
        let Node::Name(name) = &head.node else {
            return None;
        };
        let hidden = bound.contains(name) || self.declarations.definition(name).is_some();
        let found = FUNCTIONS.iter().find(|own| *own == name);
        found.copied().filter(|_| !hidden)
    }

    /// Whether a name is a declared symbol or function, which nothing hides.
    pub fn is_symbol(&self, name: &str, bound: &Bound) -> bool {
        !bound.contains(name)
            && self.declarations.definition(name).is_none()
            && (self.declarations.symbol(name).is_some()
                || self.declarations.function(name).is_some())
    }

    /// The names of the parameters, if a formula is a function.
    pub fn parameters(&self, expr: &Expr, bound: &Bound) -> Option<Vec<String>> {
        match &expr.node {
            Node::Name(name) => {
                if bound.contains(name) {
                    return None;
                }
                if let Some(definition) = self.declarations.definition(name) {
                    return match definition.parameters.is_empty() {
                        true => {
                            self.deeper(|| self.parameters(&definition.body.expr, &Bound::new()))?
                        }
                        false => Some(definition.parameters.clone()),
                    };
                }
                if self.declarations.symbol(name).is_some() {
                    return None;
                }
                if self.declarations.function(name).is_some() {
                    return Some(vec!["x".to_owned()]);
                }
                let base = name.trim_end_matches('\'');
                match base.len() < name.len() {
                    true => self.parameters(&Expr::name(base), bound),
                    false => None,
                }
            }
            Node::Call(head, arguments) => {
                match (self.built_in(head, bound)?, arguments.as_slice()) {
                    ("D" | "at", [inner, ..]) => self.parameters(inner, bound),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// Runs what may go through definitions once more, unless they go round in a circle.
    fn deeper<T>(&self, run: impl FnOnce() -> T) -> Option<T> {
        if self.depth.get() >= MAX_DEPTH {
            return None;
        }
        self.depth.set(self.depth.get() + 1);
        let found = run();
        self.depth.set(self.depth.get() - 1);
        Some(found)
    }

    /// What a formula depends on, where these names are bound.
    pub fn reach(&self, expr: &Expr, bound: &Bound) -> Reach {
        let mut reach = Reach::default();
        self.collect(expr, bound, &mut reach);
        reach
    }

    /// What the body of a definition depends on.
    pub fn of_definition(&self, name: &str) -> Rc<Reach> {
        let key = format!("definition {name}");
        self.remembered(key, || {
            let definition = self.declarations.definition(name)?;
            let bound = definition.parameters.iter().cloned().collect();
            Some(self.reach(&definition.body.expr, &bound))
        })
    }

    /// What seeds and step of a basis depend on.
    pub fn of_basis(&self, name: &str) -> Rc<Reach> {
        self.remembered(format!("basis {name}"), || {
            let basis = self.declarations.basis(name)?;
            let mut bound: Bound = basis.parameters.iter().cloned().collect();
            bound.insert(basis.variable.clone());
            let mut reach = Reach::default();
            for seed in &basis.seeds {
                self.collect(&seed.expr, &bound, &mut reach);
            }
            if let Some((index, order)) = &basis.counters {
                bound.extend([index.clone(), order.clone()]);
            }
            self.collect(&basis.step.0.expr, &bound, &mut reach);
            self.collect(&basis.step.1.expr, &bound, &mut reach);
            Some(reach)
        })
    }

    fn remembered(&self, key: String, find: impl FnOnce() -> Option<Reach>) -> Rc<Reach> {
        if let Some(known) = self.known.borrow().get(&key) {
            return Rc::clone(known);
        }
        let found = Rc::new(self.deeper(find).flatten().unwrap_or_default());
        self.known.borrow_mut().insert(key, Rc::clone(&found));
        found
    }

    fn collect(&self, expr: &Expr, bound: &Bound, reach: &mut Reach) {
        match &expr.node {
            Node::Name(name) => self.named(name, bound, reach),
            Node::Call(head, arguments) => {
                if let Node::Index(family, indices) = &head.node
                    && let Node::Name(name) = &family.node
                    && let Some(basis) = self.basis(name, bound)
                {
                    self.member(name, basis, indices, arguments, bound, reach);
                    return;
                }
                match self.built_in(head, bound) {
                    Some(name) => self.applied(name, arguments, bound, reach),
                    None => {
                        self.collect(head, bound, reach);
                        self.all(arguments, bound, reach);
                    }
                }
            }
            Node::Index(head, indices) => {
                if let Node::Name(name) = &head.node
                    && let Some(basis) = self.basis(name, bound)
                {
                    self.member(name, basis, indices, &[], bound, reach);
                    return;
                }
                self.collect(head, bound, reach);
                self.all(indices, bound, reach);
            }
            _ => {
                for part in expr.parts() {
                    self.collect(part, bound, reach);
                }
            }
        }
    }

    fn all(&self, exprs: &[Expr], bound: &Bound, reach: &mut Reach) {
        for expr in exprs {
            self.collect(expr, bound, reach);
        }
    }

    fn named(&self, name: &str, bound: &Bound, reach: &mut Reach) {
        if bound.contains(name) {
            return;
        }
        if self.declarations.definition(name).is_some() {
            reach.definitions.insert(name.to_owned());
            reach.extend(&self.of_definition(name));
            return;
        }
        if self.is_symbol(name, bound) {
            reach.symbols.insert(name.to_owned());
            return;
        }
        let base = name.trim_end_matches('\'');
        if base.len() < name.len() {
            self.named(base, bound, reach);
        }
    }

    fn member(
        &self,
        name: &str,
        basis: &Basis,
        indices: &[Expr],
        arguments: &[Expr],
        bound: &Bound,
        reach: &mut Reach,
    ) {
        self.all(arguments, bound, reach);
        self.all(indices, bound, reach);
        let names = std::iter::once(&basis.variable).chain(&basis.parameters);
        for left_out in names.skip(arguments.len()) {
            self.named(left_out, &Bound::new(), reach);
        }
        self.family(name, reach);
    }

    /// A basis by its name.
    fn family(&self, name: &str, reach: &mut Reach) {
        reach.bases.insert(name.to_owned());
        reach.extend(&self.of_basis(name));
    }

    fn applied(&self, name: &str, arguments: &[Expr], bound: &Bound, reach: &mut Reach) {
        match (name, arguments) {
            ("sum" | "product", [index, low, high, term]) => {
                self.collect(low, bound, reach);
                self.collect(high, bound, reach);
                self.collect(term, &with(bound, index), reach);
            }
            ("integral", [body, variable, low, high]) => {
                self.collect(low, bound, reach);
                self.collect(high, bound, reach);
                self.without(body, variable, bound, reach);
            }
            ("at", [inner, variable, point]) => {
                self.collect(point, bound, reach);
                self.without(inner, variable, bound, reach);
            }
            ("D", [inner, rest @ ..]) => {
                if let Some(order) = rest.get(1) {
                    self.collect(order, bound, reach);
                }
                self.collect(inner, bound, reach);
                let own = self.parameters(inner, bound).unwrap_or_default();
                if let Some(Node::Name(name)) = rest.first().map(|e| &e.node)
                    && !own.contains(name)
                {
                    // The symbol has a value outside.
                    self.named(name, bound, reach);
                }
            }
            ("agrees", [value, _]) => self.collect(value, bound, reach),
            ("nonnegative" | "independent" | "variation_diminishing", [family, ..]) => {
                if let Node::Name(name) = &family.node
                    && let Some(basis) = self.declarations.basis(name)
                {
                    // The variable takes all values of its set.
                    self.family(name, reach);
                    for parameter in &basis.parameters {
                        self.named(parameter, &Bound::new(), reach);
                    }
                }
            }
            _ => self.all(arguments, bound, reach),
        }
    }

    /// A formula in which a name has another value.
    fn without(&self, inner: &Expr, variable: &Expr, bound: &Bound, reach: &mut Reach) {
        let mut own = self.reach(inner, bound);
        if let Node::Name(name) = &variable.node
            && !bound.contains(name)
        {
            own.symbols.remove(name);
            own.moved.insert(name.clone());
        }
        reach.extend(&own);
    }
}

/// The bound names with that of one more binder.
pub(super) fn with(bound: &Bound, variable: &Expr) -> Bound {
    let mut more = bound.clone();
    if let Node::Name(name) = &variable.node {
        more.insert(name.clone());
    }
    more
}
