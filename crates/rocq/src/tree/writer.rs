//! The state of writing one claim: the names in Rocq, and the definitions so far.

use super::kinds::Kind;
use super::moving::Along;
use super::reach::{Names, Reach};
use super::scope::Scope;
use crate::code::Code;
use crate::gap::Untranslatable;
use crate::name::{self, identifier};
use crate::shape::Shape;
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::Expr;

/// The most bytes of a claim's definitions and statement together.
const MAX_BYTES: usize = 60_000;
/// The most terms that are looked at for one claim.
const MAX_TERMS: usize = 100_000;

/// A value and its shape.
#[derive(Debug, Clone)]
pub(super) struct Value {
    pub code: Code,
    pub shape: Shape,
}

impl Value {
    pub fn number(code: Code) -> Self {
        Self {
            code,
            shape: Shape::Number,
        }
    }

    pub fn applied(head: &str, arguments: &[Code], shape: Shape) -> Self {
        Self {
            code: Code::apply(head, arguments),
            shape,
        }
    }
}

/// A definition that was written, as it is used.
#[derive(Debug, Clone)]
pub(super) struct Head {
    /// Its name.
    pub name: String,
    /// The declared symbols that it takes, in their order.
    pub symbols: Vec<String>,
    /// What it is worth.
    pub shape: Shape,
}

/// The state of writing one claim.
#[derive(Debug)]
pub(super) struct Writer<'a> {
    pub names: Names<'a>,
    /// The names in Rocq of declared symbols and functions.
    symbols: BTreeMap<String, String>,
    /// The names in Rocq of definitions and of bases.
    heads: BTreeMap<(Named, String), String>,
    /// The definitions that were written.
    written: BTreeMap<(Named, String, Vec<Kind>), Head>,
    /// The names in Rocq that were given.
    supply: name::Names,
    /// Their texts, in order.
    pub definitions: Vec<(String, String)>,
    /// The numbers that equations determine.
    pub unknowns: Vec<Expr>,
    /// The unknowns as functions of symbols whose coefficients are asked for.
    pub alongs: Vec<Along>,
    /// How many definitions are being written inside of each other.
    pub depth: usize,
    bytes: usize,
    terms: usize,
}

/// What a `Definition` is written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Named {
    Basis,
    Definition,
}

impl<'a> Writer<'a> {
    /// A writer of formulas that reach these names. Symbols keep their names, so that bases and definitions give way.
    pub fn new(declarations: &'a Declarations, reach: &Reach) -> Self {
        let mut supply = name::Names::default();
        let symbols: BTreeSet<&String> = reach.symbols.union(&reach.moved).collect();
        let symbols = symbols.into_iter();
        let symbols = symbols.map(|name| (name.clone(), supply.fresh(name)));
        let symbols: BTreeMap<String, String> = symbols.collect();
        let bases = reach.bases.iter().map(|name| (Named::Basis, name));
        let definitions = reach.definitions.iter();
        let heads = bases.chain(definitions.map(|name| (Named::Definition, name)));
        let heads = heads.map(|(what, name)| ((what, name.clone()), supply.fresh(name)));
        let heads = heads.collect();
        Self {
            names: Names::new(declarations),
            symbols,
            heads,
            written: BTreeMap::new(),
            supply,
            definitions: vec![],
            unknowns: vec![],
            alongs: vec![],
            depth: 0,
            bytes: 0,
            terms: 0,
        }
    }

    /// Counts bytes.
    ///
    /// # Errors
    /// [`Untranslatable::Size`].
    pub fn spend(&mut self, bytes: usize) -> Result<(), Untranslatable> {
        self.bytes += bytes;
        match self.bytes <= MAX_BYTES {
            true => Ok(()),
            false => Err(Untranslatable::Size { limit: MAX_BYTES }),
        }
    }

    /// Counts a term that is looked at.
    ///
    /// # Errors
    /// [`Untranslatable::Size`].
    pub fn visit(&mut self) -> Result<(), Untranslatable> {
        self.terms += 1;
        match self.terms <= MAX_TERMS {
            true => Ok(()),
            false => Err(Untranslatable::Size { limit: MAX_TERMS }),
        }
    }

    /// The name of a declared symbol.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] if nothing was said to reach it.
    pub fn symbol(&self, name: &str) -> Result<&str, Untranslatable> {
        let found = self.symbols.get(name).map(String::as_str);
        found.ok_or_else(|| Untranslatable::Unread(format!("the symbol `{name}` is not declared")))
    }

    /// The names of all declared symbols.
    pub fn all_symbols(&self) -> BTreeSet<String> {
        self.symbols.values().cloned().collect()
    }

    /// What stands for a declared symbol.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] if nothing was said to reach it.
    pub fn standing(&self, name: &str, scope: &Scope) -> Result<Code, Untranslatable> {
        match scope.moved.get(name) {
            Some(code) => Ok(code.clone()),
            None => Ok(Code::atom(self.symbol(name)?)),
        }
    }

    /// The type of a declared symbol, as a definition takes it.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] for what is not declared.
    pub fn symbol_type(&self, name: &str) -> Result<String, Untranslatable> {
        let declarations = self.names.declarations;
        if let (None, Some(dimension)) = (declarations.symbol(name), declarations.function(name)) {
            return Ok(match dimension {
                None | Some(1) => "R -> R".to_owned(),
                Some(_) => "R -> list R".to_owned(),
            });
        }
        let kind = declarations.symbol(name);
        let kind = kind.ok_or_else(|| {
            Untranslatable::Unread(format!("the symbol `{name}` is not declared"))
        })?;
        Ok(match kind {
            SymbolKind::Real(_) | SymbolKind::Vector(None) => "R".to_owned(),
            SymbolKind::Integer { .. } => "Z".to_owned(),
            SymbolKind::Vector(Some(_)) => "list R".to_owned(),
            SymbolKind::Family { dimension, ranges } => {
                let member = match dimension {
                    None | Some(1) => "R",
                    Some(_) => "list R",
                };
                format!("{}{member}", "Z -> ".repeat(ranges.len().max(1)))
            }
        })
    }

    /// A name for what a binder binds, like that of the text: nothing that is meant where it is bound has it.
    pub fn binder(&self, like: &str, reach: &Reach, scope: &Scope) -> String {
        let mut taken = scope.words(like);
        taken.extend(self.rocq_names(reach));
        fresh(like, &taken)
    }

    /// A name for what is bound beside texts with these names.
    pub fn fresh_beside(&self, like: &str, reach: &Reach, mut taken: BTreeSet<String>) -> String {
        taken.extend(self.rocq_names(reach));
        fresh(like, &taken)
    }

    /// The names in Rocq of what a formula reaches.
    fn rocq_names(&self, reach: &Reach) -> BTreeSet<String> {
        let symbols = reach
            .symbols
            .iter()
            .filter_map(|name| self.symbols.get(name));
        let head = |what| move |name: &String| self.heads.get(&(what, name.clone()));
        let bases = reach.bases.iter().filter_map(head(Named::Basis));
        let definitions = reach.definitions.iter();
        let definitions = definitions.filter_map(head(Named::Definition));
        symbols.chain(bases).chain(definitions).cloned().collect()
    }

    /// The names in Rocq that a definition goes by.
    pub fn heads_of(&self, name: &str) -> Option<String> {
        self.heads
            .get(&(Named::Definition, name.to_owned()))
            .cloned()
    }

    /// The definition of a name, written where it is met first with parameters of these kinds. `own` are its parameters,
    /// `indices` integers that come last; `write` writes its body.
    ///
    /// # Errors
    /// What `write` finds, and [`Untranslatable::Size`].
    pub fn define(
        &mut self,
        what: Named,
        name: &str,
        own: &[(String, Kind)],
        indices: &[&str],
        write: impl FnOnce(&mut Self, &Scope, &[Code]) -> Result<Value, Untranslatable>,
    ) -> Result<Head, Untranslatable> {
        let kinds = own.iter().map(|(_, kind)| *kind).collect();
        let key = (what, name.to_owned(), kinds);
        if let Some(head) = self.written.get(&key) {
            return Ok(head.clone());
        }
        let reach = match what {
            Named::Basis => self.names.of_basis(name),
            Named::Definition => self.names.of_definition(name),
        };
        let symbols: Vec<String> = reach.symbols.iter().cloned().collect();
        let mut parameters = String::new();
        for symbol in &symbols {
            let (name, kind) = (self.symbol(symbol)?, self.symbol_type(symbol)?);
            parameters.push_str(&format!(" ({name} : {kind})"));
        }
        let mut scope = Scope::default();
        let mut taken = self.rocq_names(&reach);
        for (parameter, kind) in own {
            let bound = fresh(parameter, &taken);
            taken.insert(bound.clone());
            parameters.push_str(&format!(" ({bound} : {})", kind.rocq_type()));
            scope = scope.with_local(parameter, Code::atom(bound), *kind);
        }
        let mut last = vec![];
        for index in indices {
            let bound = fresh(index, &taken);
            taken.insert(bound.clone());
            parameters.push_str(&format!(" ({bound} : Z)"));
            last.push(Code::atom(bound));
        }
        self.depth += 1;
        let written = write(self, &scope, &last);
        self.depth -= 1;
        let Value { code, shape } = written?;
        let rest = format!(
            "{parameters} : {} :=\n  {}.",
            shape.rocq_type(),
            code.text()
        );
        let mut others = self
            .written
            .iter()
            .filter(|((w, n, _), _)| (*w, n) == (what, &key.1));
        let same = others.find_map(|(_, head)| {
            let text = format!("Definition {}{rest}", head.name);
            let known = self.definitions.iter().any(|(_, known)| *known == text);
            known.then(|| head.name.clone())
        });
        let rocq_name = match same {
            Some(known) => known,
            None => {
                let own = self.head_name(what, name);
                self.spend(rest.len())?;
                self.definitions
                    .push((own.clone(), format!("Definition {own}{rest}")));
                own
            }
        };
        let head = Head {
            name: rocq_name,
            symbols,
            shape,
        };
        self.written.insert(key, head.clone());
        Ok(head)
    }

    /// The name of a definition: that of the text, unless it was written for parameters of other kinds.
    fn head_name(&mut self, what: Named, name: &str) -> String {
        let own = self.heads.get(&(what, name.to_owned())).cloned();
        let own = own.unwrap_or_else(|| identifier(name));
        match self.definitions.iter().any(|(known, _)| *known == own) {
            true => self.supply.fresh(&own),
            false => own,
        }
    }

    /// A definition with the symbols that it takes.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`].
    pub fn with_symbols(&self, head: &Head, scope: &Scope) -> Result<Vec<Code>, Untranslatable> {
        let symbols = head.symbols.iter();
        symbols.map(|name| self.standing(name, scope)).collect()
    }

    /// What a formula reaches where these names are bound.
    pub fn reach(&self, expr: &Expr, scope: &Scope) -> Reach {
        self.names.reach(expr, &scope.bound())
    }
}

/// A name like this one that is none of those that are taken, and no word of Rocq.
pub(super) fn fresh(like: &str, taken: &BTreeSet<String>) -> String {
    let mut supply = name::Names::default();
    for name in taken {
        supply.reserve(name);
    }
    supply.fresh(like)
}
