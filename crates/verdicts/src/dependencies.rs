//! Declarations and definitions that a statement depends on, for a reader who checks it against the print.
//!
//! These are the declared set of every symbol that occurs, the definitions and bases that are used directly or through
//! others, each once and in the order of use, and the unknowns of given equations.

use serde::Serialize;
use std::collections::BTreeSet;
use torse_core as core;
use torse_syntax::derivation::declarations::{Basis, Declarations, Definition, SymbolKind};
use torse_syntax::derivation::{Claim, Hypothesis, Written};
use torse_syntax::formula::{Expr, Node};
use torse_syntax::notation::{self, Formula, domain};

/// The dependencies of a statement.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Dependencies {
    /// The symbols, in the order of use.
    pub symbols: Vec<Declared>,
    /// The definitions, in the order of use.
    pub definitions: Vec<Defined>,
    /// The basis families, in the order of use.
    pub bases: Vec<Family>,
    /// The unknowns of the given equations.
    pub unknowns: Vec<Formula>,
    /// The letters that the paper prints bold, whatever their scripts.
    pub bold: BTreeSet<char>,
}

/// A symbol with its set.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Declared {
    /// The name.
    pub name: String,
    /// Its set, in words: `mu in [-1, 1]`.
    pub set: String,
    /// Whether it is one coordinate of a point or a vector, which stands for each.
    pub is_generic: bool,
    /// How the paper prints the name: mathematics between dollar signs.
    pub display: Option<String>,
}

/// A definition.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Defined {
    /// What is defined: `c`, `H(x)`.
    pub head: Formula,
    /// Its formula.
    pub body: Formula,
    /// Whether the claim itself contains the definition, rather than its file or paper.
    pub own: bool,
    /// How the paper prints the name: mathematics between dollar signs.
    pub display: Option<String>,
}

/// A basis family.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Family {
    /// A function of it with its arguments: `g[i,k](x, mu, nu)`.
    pub head: Formula,
    /// The degree of the seeds.
    pub degree: u8,
    /// The functions of that degree.
    pub seeds: Vec<Formula>,
    /// The factors a and b of the step `g[i,k] = a*g[i,k-1] + b*g[i-1,k-1]`.
    pub step: [Formula; 2],
    /// How the paper prints the name: mathematics between dollar signs.
    pub display: Option<String>,
}

impl Family {
    /// Whether it has no step, which is stored with zero factors: a list of functions of one degree.
    #[must_use]
    pub fn is_list(&self) -> bool {
        self.step.iter().all(|factor| factor.text == "0")
    }
}

/// Collects the dependencies of a statement on the domain of a claim; `core` has both as core terms.
#[must_use]
pub fn find_dependencies(claim: &Claim, statement: &Written, core: &core::Claim) -> Dependencies {
    let mut walk = Walk {
        declarations: &claim.declarations,
        own: claim.entry.local.keys().map(|head| name_of(head)).collect(),
        seen: BTreeSet::new(),
        names: vec![],
        table: Dependencies::default(),
    };
    let hypotheses = |list: &'_ [Hypothesis]| -> Vec<Written> {
        list.iter().map(|h| h.formula.clone()).collect()
    };
    walk.formula(&statement.expr, &[]);
    let (given, assumed) = (hypotheses(&claim.given), hypotheses(&claim.assumptions));
    for written in given.iter().chain(&claim.unknowns).chain(&assumed) {
        walk.formula(&written.expr, &[]);
    }
    // First the names that occur and mean symbols, then the symbols in whose terms others are declared.
    let mut symbols = vec![];
    let rest = core.symbols.keys().map(|name| name.to_string());
    for name in walk.names.iter().cloned().chain(rest) {
        let kind = claim.declarations.symbol(&name);
        let known = core.symbols.contains_key(name.as_str());
        if let Some(kind) = kind
            && known
            && !symbols.iter().any(|s: &Declared| s.name == name)
        {
            symbols.push(Declared {
                set: domain::words(&name, kind),
                is_generic: matches!(
                    kind,
                    SymbolKind::Vector(None)
                        | SymbolKind::Family {
                            dimension: None,
                            ..
                        }
                ),
                display: claim.declarations.display(&name).map(str::to_owned),
                name,
            });
        }
    }
    let unknowns = claim.unknowns.iter();
    Dependencies {
        symbols,
        unknowns: unknowns.map(|w| notation::formula(&w.expr)).collect(),
        bold: claim.declarations.bold_letters(),
        ..walk.table
    }
}

/// Returns the name that a head `F(z, mu)` defines.
fn name_of(head: &str) -> &str {
    head.split(['(', '[']).next().unwrap_or(head).trim()
}

/// Walks from a statement through all that it uses.
struct Walk<'a> {
    declarations: &'a Declarations,
    own: BTreeSet<&'a str>,
    seen: BTreeSet<String>,
    names: Vec<String>,
    table: Dependencies,
}

impl Walk<'_> {
    /// Records what a formula uses; `bound` contains names of indices and parameters.
    fn formula(&mut self, expr: &Expr, bound: &[String]) {
        match &expr.node {
            Node::Name(name) => self.name(name, bound),
            Node::Call(head, arguments) => {
                let called = match &head.node {
                    Node::Name(name) => name.as_str(),
                    _ => "",
                };
                let binder = match (called, arguments.as_slice()) {
                    ("sum" | "product", [index, low, high, term])
                    | ("integral", [term, index, low, high]) => Some((index, low, high, term)),
                    _ => None,
                };
                if let Some((index, low, high, term)) = binder
                    && let Node::Name(index) = &index.node
                {
                    self.formula(low, bound);
                    self.formula(high, bound);
                    self.formula(term, &[bound, std::slice::from_ref(index)].concat());
                    return;
                }
                expr.parts()
                    .into_iter()
                    .for_each(|e| self.formula(e, bound));
            }
            _ => expr
                .parts()
                .into_iter()
                .for_each(|e| self.formula(e, bound)),
        }
    }

    fn name(&mut self, written: &str, bound: &[String]) {
        let base = written.trim_end_matches('\'');
        for name in [written, base] {
            if bound.iter().any(|b| b == name) || self.seen.contains(name) {
                return;
            }
            let definition = self.declarations.definition(name);
            let basis = self.declarations.basis(name);
            if definition.is_none() && basis.is_none() && self.declarations.symbol(name).is_none() {
                continue;
            }
            self.seen.insert(name.to_owned());
            self.names.push(name.to_owned());
            match (definition, basis) {
                (Some(definition), _) => self.definition(name, definition),
                (None, Some(basis)) => self.basis(name, basis),
                (None, None) => {}
            }
            return;
        }
    }

    fn definition(&mut self, name: &str, definition: &Definition) {
        self.table.definitions.push(Defined {
            head: notation::formula(&match definition.indexed {
                false => head(Expr::name(name), &definition.parameters),
                true => {
                    let indices = definition.parameters.iter().map(|name| Expr::name(name));
                    Expr::made(Node::Index(Expr::name(name).into(), indices.collect()))
                }
            }),
            body: notation::formula(&definition.body.expr),
            own: self.own.contains(name),
            display: self.declarations.display(name).map(str::to_owned),
        });
        self.formula(&definition.body.expr, &definition.parameters);
    }

    fn basis(&mut self, name: &str, basis: &Basis) {
        let variables = [std::slice::from_ref(&basis.variable), &basis.parameters].concat();
        let indices = ["i", "k"].map(Expr::name).to_vec();
        let function = Expr::made(Node::Index(Expr::name(name).into(), indices));
        let set = |written: &Written| notation::formula(&written.expr);
        self.table.bases.push(Family {
            head: notation::formula(&head(function, &variables)),
            degree: basis.degree,
            seeds: basis.seeds.iter().map(set).collect(),
            step: [set(&basis.step.0), set(&basis.step.1)],
            display: self.declarations.display(name).map(str::to_owned),
        });
        for written in basis.seeds.iter().chain([&basis.step.0, &basis.step.1]) {
            self.formula(&written.expr, &variables);
        }
        // Arguments that are left out are the symbols of these names.
        variables
            .iter()
            .for_each(|name| self.names.push(name.clone()));
    }
}

/// Writes `F(z, mu)`, or the function alone if it has no arguments.
fn head(function: Expr, parameters: &[String]) -> Expr {
    match parameters {
        [] => function,
        names => {
            let names = names.iter().map(|name| Expr::name(name)).collect();
            Expr::made(Node::Call(function.into(), names))
        }
    }
}
