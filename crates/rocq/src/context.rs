//! The meaning of names while a claim is written: declared symbols, bound variables, and the definitions that come
//! before the statement.
//!
//! Every expanded definition and every basis family becomes a `Definition` of its own, with the symbols and variables
//! that occur in it as arguments. So the statement reads like the claim, and repeated parts are written once.

use crate::code::Code;
use crate::gap::Untranslatable;
use crate::name::{Names, identifier};
use crate::shape::Shape;
use crate::unknowns::Along;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_core::{Family, Node, Set, Term, Variable};

/// Maximum number of bytes of a claim's definitions and statement together.
pub const MAX_BYTES: usize = 60_000;

/// A value and its shape.
#[derive(Debug, Clone)]
pub struct Value {
    /// The text.
    pub code: Code,
    /// The shape.
    pub shape: Shape,
}

/// The kind of a bound variable.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// An integer, of type `Z`.
    Integer,
    /// A value.
    Value(Shape),
}

impl Kind {
    fn rocq_type(&self) -> &'static str {
        match self {
            Self::Integer => "Z",
            Self::Value(shape) => shape.rocq_type(),
        }
    }
}

/// A variable in scope: its text and its kind.
#[derive(Debug, Clone)]
pub struct Local {
    /// The text: a name, or the argument of an applied function.
    pub code: Code,
    /// The kind.
    pub kind: Kind,
}

/// A written definition, as it is used.
#[derive(Debug, Clone)]
pub struct Head {
    /// Its name.
    pub name: String,
    /// The declared symbols that it takes, in their order.
    pub symbols: Vec<Arc<str>>,
    /// The bound variables that it takes.
    pub variables: Vec<Variable>,
    /// The shape of its value.
    pub shape: Shape,
}

/// The state of writing one claim.
#[derive(Debug)]
pub struct Context<'a> {
    /// The declared symbols of the claim.
    pub symbols: &'a BTreeMap<Arc<str>, Set>,
    /// Their names in Rocq.
    symbol_names: BTreeMap<Arc<str>, String>,
    /// The names of symbols.
    outer: Names,
    /// Every name that a variable ever had; a definition of that name could be hidden by it.
    hidden: BTreeSet<String>,
    /// The names in use in the definition or statement that is being written.
    names: Names,
    /// The variables in scope.
    locals: BTreeMap<u32, Local>,
    /// Definitions by the address of the expanded term and the kinds of their variables.
    heads: BTreeMap<(usize, Vec<Kind>), Head>,
    /// Definitions by text, so that the same text is written once.
    texts: BTreeMap<String, String>,
    /// The definitions, in order.
    definitions: Vec<(String, String)>,
    /// The number of bytes written.
    bytes: usize,
    /// Whether coefficients occur of forms that are not seen to be linear.
    unclear_forms: bool,
    /// The unknowns of the `given` equations.
    unknowns: Vec<Term>,
    /// Texts that replace the names of symbols.
    moved: Vec<(Arc<str>, String)>,
    /// The unknowns as functions of symbols.
    alongs: Vec<Along>,
    /// The nesting depth of definitions being written.
    depth: u32,
}

impl<'a> Context<'a> {
    /// Makes the context of a claim with these symbols.
    #[must_use]
    pub fn new(symbols: &'a BTreeMap<Arc<str>, Set>) -> Self {
        let mut outer = Names::default();
        let named = |name: &Arc<str>| (Arc::clone(name), outer.fresh(name));
        let symbol_names = symbols.keys().map(named).collect();
        Self {
            symbols,
            symbol_names,
            names: outer.clone(),
            outer,
            hidden: BTreeSet::new(),
            locals: BTreeMap::new(),
            heads: BTreeMap::new(),
            texts: BTreeMap::new(),
            definitions: vec![],
            bytes: 0,
            unclear_forms: false,
            unknowns: vec![],
            moved: vec![],
            alongs: vec![],
            depth: 0,
        }
    }

    /// Makes the same context with these unknowns of given equations.
    #[must_use]
    pub fn with_unknowns(mut self, unknowns: &[Term]) -> Self {
        self.unknowns = unknowns.to_vec();
        self
    }

    /// Returns the unknowns of the `given` equations.
    #[must_use]
    pub fn unknowns(&self) -> &[Term] {
        &self.unknowns
    }

    /// Whether a term contains an unknown, or a part or member of the vector or family of one.
    #[must_use]
    pub fn has_unknowns(&self, term: &Term) -> bool {
        let mut names = BTreeSet::new();
        for unknown in &self.unknowns {
            unknown.declared_names(&mut |name| {
                names.insert(Arc::clone(name));
            });
        }
        let mut found = false;
        term.declared_names(&mut |name| found |= names.contains(name));
        found
    }

    /// Returns the unknowns as functions of symbols, as far as they were requested.
    #[must_use]
    pub fn alongs(&self) -> &[Along] {
        &self.alongs
    }

    /// Adds functions of one more symbol.
    pub fn add_along(&mut self, along: Along) {
        self.alongs.push(along);
    }

    /// Replaces symbols by texts from here on, and returns the previous replacements.
    pub fn moved(&mut self, values: Vec<(Arc<str>, String)>) -> Vec<(Arc<str>, String)> {
        std::mem::replace(&mut self.moved, values)
    }

    /// Whether the body of a definition is being written.
    #[must_use]
    pub fn is_in_definition(&self) -> bool {
        self.depth > 0
    }

    /// Returns the definitions written so far: names and texts, in order.
    #[must_use]
    pub fn definitions(&self) -> &[(String, String)] {
        &self.definitions
    }

    /// Sets whether coefficients occur of forms that are not seen to be linear, and returns the previous value.
    pub fn unclear_forms(&mut self, occur: bool) -> bool {
        std::mem::replace(&mut self.unclear_forms, occur)
    }

    /// Returns the name of a symbol.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] if the claim does not declare it.
    pub fn symbol(&self, name: &Arc<str>) -> Result<&str, Untranslatable> {
        let moved = self.moved.iter().find(|(symbol, _)| symbol == name);
        let found = match moved {
            Some((_, text)) => Some(text.as_str()),
            None => self.symbol_names.get(name).map(String::as_str),
        };
        found.ok_or_else(|| Untranslatable::Unread(format!("the symbol `{name}` is not declared")))
    }

    /// Returns the type of a symbol, as it stands in the head of a definition.
    ///
    /// # Errors
    /// [`Untranslatable`] for vectors and families that cannot be written.
    pub fn symbol_type(&self, name: &Arc<str>) -> Result<String, Untranslatable> {
        let set = self.symbols.get(name);
        let set = set.ok_or_else(|| {
            Untranslatable::Unread(format!("the symbol `{name}` is not declared"))
        })?;
        Ok(match set {
            Set::Real(_) | Set::Vector(None) => "R".to_owned(),
            Set::Integer { .. } => "Z".to_owned(),
            Set::Vector(Some(_)) => "list R".to_owned(),
            Set::Family { dimension, ranges } => {
                // Without a declared range the number of indices is unknown here; usually it is one.
                let indices = "Z -> ".repeat(ranges.len().max(1));
                let member = match dimension {
                    None | Some(1) => "R",
                    Some(_) => "list R",
                };
                format!("{indices}{member}")
            }
        })
    }

    /// Adds a variable to the scope, with a name for it.
    pub fn bind(&mut self, variable: &Variable, kind: Kind) -> String {
        let name = self.fresh(variable.name());
        let code = Code::atom(&name);
        self.locals.insert(variable.number(), Local { code, kind });
        name
    }

    /// Ends the scope of a variable: its name is free again.
    pub fn release(&mut self, variable: &Variable) {
        if let Some(local) = self.locals.remove(&variable.number()) {
            self.names.release(local.code.text());
        }
    }

    /// Adds a variable to the scope, with the text that stands for it.
    pub fn bind_to(&mut self, variable: &Variable, local: Local) {
        self.locals.insert(variable.number(), local);
    }

    /// Returns the variables in scope.
    #[must_use]
    pub fn locals(&self) -> BTreeMap<u32, Local> {
        self.locals.clone()
    }

    /// Restores the variables that were in scope.
    pub fn put_back(&mut self, locals: BTreeMap<u32, Local>) {
        self.locals = locals;
    }

    /// Returns a name that nothing else has here.
    pub fn fresh(&mut self, like: &str) -> String {
        let name = self.names.fresh(like);
        self.hidden.insert(name.clone());
        name
    }

    /// Frees a name.
    pub fn free(&mut self, name: &str) {
        self.names.release(name);
    }

    /// Returns a name for a definition: no symbol and no variable has it, and none will.
    fn fresh_definition(&mut self, like: &str) -> String {
        let mut like = identifier(like);
        loop {
            let name = self.outer.fresh(&like);
            if !self.hidden.contains(&name) {
                return name;
            }
            like.push('_');
        }
    }

    /// Returns what a variable stands for.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] outside its binder.
    pub fn local(&self, variable: &Variable) -> Result<&Local, Untranslatable> {
        let found = self.locals.get(&variable.number());
        found.ok_or_else(|| {
            Untranslatable::Unread(format!("`{}` outside of its binder", variable.name()))
        })
    }

    /// Returns the definition of an expanded term or a family, and writes it on first use. `write` writes its body; the
    /// variables in `own` are further arguments, in this order, after those of enclosing binders, and integers called
    /// like `indices` come last.
    ///
    /// # Errors
    /// The error of `write`, and [`Untranslatable::Size`].
    pub fn define(
        &mut self,
        address: usize,
        like: &str,
        used: &Used,
        own: &[(Variable, Kind)],
        indices: &[&str],
        write: impl FnOnce(&mut Self, &[Code]) -> Result<Value, Untranslatable>,
    ) -> Result<Head, Untranslatable> {
        let variables: Vec<Variable> = used.variables.iter().cloned().collect();
        let kinds = variables.iter().map(|v| Ok(self.local(v)?.kind.clone()));
        let kinds = kinds.collect::<Result<Vec<_>, Untranslatable>>()?;
        let key = (address, kinds.clone());
        if let Some(head) = self.heads.get(&key) {
            return Ok(head.clone());
        }
        // The body has a scope of its own, so that the same formula always gives the same text.
        let moved = self.moved(vec![]);
        self.depth += 1;
        let mut inner = Names::default();
        self.reserve_definitions(&mut inner);
        for symbol in &used.symbols {
            inner.reserve(self.symbol(symbol)?);
        }
        let mut names = std::mem::replace(&mut self.names, inner);
        let locals = std::mem::take(&mut self.locals);
        let mut parameters = String::new();
        let symbols: Vec<Arc<str>> = used.symbols.iter().cloned().collect();
        for symbol in &symbols {
            let (name, kind) = (self.symbol(symbol)?.to_owned(), self.symbol_type(symbol)?);
            parameters.push_str(&format!(" ({name} : {kind})"));
        }
        for (variable, kind) in variables
            .iter()
            .cloned()
            .zip(kinds)
            .chain(own.iter().cloned())
        {
            let rocq_type = kind.rocq_type();
            let name = self.bind(&variable, kind);
            parameters.push_str(&format!(" ({name} : {rocq_type})"));
        }
        let mut last = vec![];
        for index in indices {
            let name = self.fresh(index);
            parameters.push_str(&format!(" ({name} : Z)"));
            last.push(Code::atom(name));
        }
        let written = write(self, &last);
        self.reserve_definitions(&mut names);
        self.names = names;
        self.locals = locals;
        self.moved(moved);
        self.depth -= 1;
        let Value { code, shape } = written?;
        let rest = format!(
            "{parameters} : {} :=\n  {}.",
            shape.rocq_type(),
            code.text()
        );
        let name = match self.texts.get(&rest) {
            Some(name) => name.clone(),
            None => {
                let name = self.fresh_definition(like);
                self.names.reserve(&name);
                self.spend(rest.len())?;
                self.definitions
                    .push((name.clone(), format!("Definition {name}{rest}")));
                self.texts.insert(rest, name.clone());
                name
            }
        };
        let head = Head {
            name,
            symbols,
            variables,
            shape,
        };
        self.heads.insert(key, head.clone());
        Ok(head)
    }

    /// Reserves the names of all definitions.
    fn reserve_definitions(&self, names: &mut Names) {
        for (name, _) in &self.definitions {
            names.reserve(name);
        }
    }

    /// Counts bytes.
    ///
    /// # Errors
    /// [`Untranslatable::Size`] beyond [`MAX_BYTES`].
    pub fn spend(&mut self, bytes: usize) -> Result<(), Untranslatable> {
        self.bytes += bytes;
        match self.bytes <= MAX_BYTES {
            true => Ok(()),
            false => Err(Untranslatable::Size { limit: MAX_BYTES }),
        }
    }

    /// Returns the arguments that a definition takes here.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] outside a binder.
    pub fn arguments(&self, head: &Head) -> Result<Vec<Code>, Untranslatable> {
        let symbols = head
            .symbols
            .iter()
            .map(|name| Ok(Code::atom(self.symbol(name)?)));
        let variables = head
            .variables
            .iter()
            .map(|v| Ok(self.local(v)?.code.clone()));
        symbols.chain(variables).collect()
    }
}

/// Symbols and variables that occur free in a term.
#[derive(Debug, Default)]
pub struct Used {
    /// Declared symbols.
    pub symbols: BTreeSet<Arc<str>>,
    /// Bound variables of enclosing binders.
    pub variables: BTreeSet<Variable>,
}

impl Used {
    /// Collects the free symbols and variables of a term.
    #[must_use]
    pub fn from_term(term: &Term) -> Self {
        let mut used = Self::default();
        term.declared_names(&mut |name| {
            used.symbols.insert(Arc::clone(name));
        });
        used.variables = free(std::iter::once(term), &[]);
        used
    }

    /// Collects those of seeds and step of a family.
    #[must_use]
    pub fn of_family(family: &Family) -> Self {
        let parts = || family.seeds.iter().chain([&family.step.0, &family.step.1]);
        let mut used = Self::default();
        for part in parts() {
            part.declared_names(&mut |name| {
                used.symbols.insert(Arc::clone(name));
            });
        }
        let bound: Vec<Variable> = family.bound().cloned().collect();
        used.variables = free(parts(), &bound);
        used
    }
}

/// Returns the variables that occur free. No two binders have the same variable.
fn free<'t>(terms: impl Iterator<Item = &'t Term>, bound: &[Variable]) -> BTreeSet<Variable> {
    let mut seen = BTreeSet::new();
    let mut used = BTreeSet::new();
    let mut bound: BTreeSet<Variable> = bound.iter().cloned().collect();
    let mut pending: Vec<Term> = terms.cloned().collect();
    while let Some(term) = pending.pop() {
        if !seen.insert(Arc::as_ptr(&term.node).addr()) {
            continue;
        }
        match &*term.node {
            Node::Variable(variable) => {
                used.insert(variable.clone());
            }
            Node::Sum { index, .. }
            | Node::Product { index, .. }
            | Node::Integral {
                variable: index, ..
            } => {
                bound.insert(index.clone());
            }
            Node::Let { variable, .. } | Node::Derivative { variable, .. } => {
                bound.insert(variable.clone());
            }
            Node::Basis { family, .. } => {
                bound.extend(family.bound().cloned());
                pending.extend(family.seeds.iter().cloned());
                pending.extend([family.step.0.clone(), family.step.1.clone()]);
            }
            _ => {}
        }
        pending.extend(term.parts().into_iter().cloned());
    }
    used.difference(&bound).cloned().collect()
}
