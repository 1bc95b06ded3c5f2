//! From syntax trees to core terms.
//!
//! One recursive traversal with a [`Scope`]: the variables of enclosing binders by their names in the text
//! (`locals`), and the variables that replace declared symbols below a `D` or an `at` by that symbol (`globals`). The
//! body of a definition sees `globals` only, because it is a formula in the declared symbols wherever it is used.

mod binders;
mod built_in;
mod denial;
mod families;
mod lists;
mod parts;
mod smooth;

use binders::{Local, Scope};
pub(crate) use denial::{is_about_domain, misplaced};
use parts::Parts;
use smooth::At;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core::{Family, Node, Points, Set, Statement, Term, Variable, stack};
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::rational;
use torse_syntax::derivation::declarations::{Declarations, Definition, SymbolKind};
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::functions::{FUNCTIONS, infinite, is_function, out_of_scope};
use torse_syntax::formula::{self, Connective, Expr, Operator, Place};
use torse_syntax::greek;
use torse_syntax::similar::similar;

/// The largest depth of definitions that use one another.
const MAX_DEPTH: usize = 80;
/// The largest number of core nodes that one formula may open to.
const MAX_NODES: u64 = 400_000;

/// What a formula is.
#[derive(Debug, Clone)]
pub enum Meaning {
    /// A number, a vector or a matrix.
    Term(Term),
    /// A statement.
    Statement(Statement),
    /// A function, to be applied.
    Function(Lambda),
}

impl Meaning {
    fn kind(&self) -> &'static str {
        match self {
            Self::Term(_) => "a formula",
            Self::Statement(_) => "a statement",
            Self::Function(_) => "a function",
        }
    }
}

/// A function: a term with bound parameters.
#[derive(Debug, Clone)]
pub struct Lambda {
    /// The name, for messages.
    pub name: Arc<str>,
    /// The parameters, bound in the body.
    pub parameters: Vec<Variable>,
    /// The body.
    pub body: Term,
}

/// Elaborates formulas under given declarations. Each definition is opened once and cached.
#[derive(Debug)]
pub struct Elaborator<'a> {
    declarations: &'a Declarations,
    next: Cell<u32>,
    depth: Cell<usize>,
    nodes: Cell<u64>,
    opened: RefCell<BTreeMap<String, Meaning>>,
    families: RefCell<BTreeMap<String, Arc<Family>>>,
    points: RefCell<BTreeMap<String, Arc<Points>>>,
    parts: RefCell<Parts>,
    /// For each smooth function the places at which it was evaluated, by the text of the place.
    places: RefCell<BTreeMap<Arc<str>, BTreeMap<String, At>>>,
}

type Outcome<T> = Result<T, Fault>;

impl<'a> Elaborator<'a> {
    /// An elaborator under these declarations.
    #[must_use]
    pub fn new(declarations: &'a Declarations) -> Self {
        Self {
            declarations,
            next: Cell::new(0),
            depth: Cell::new(0),
            nodes: Cell::new(0),
            opened: RefCell::default(),
            families: RefCell::default(),
            points: RefCell::default(),
            parts: RefCell::default(),
            places: RefCell::default(),
        }
    }

    /// The declarations under which formulas are elaborated.
    #[must_use]
    pub fn declarations(&self) -> &'a Declarations {
        self.declarations
    }

    /// Elaborates a formula, which may be a term, a statement or a function.
    ///
    /// # Errors
    /// [`Fault`] for undeclared names, wrong kinds, and wrong numbers of arguments.
    pub fn meaning(&self, expr: &Expr) -> Outcome<Meaning> {
        self.nodes.set(0);
        stack::deep(|| {
            Ok(match self.open(expr, &Scope::default())? {
                Meaning::Term(term) => Meaning::Term(self.in_jets(term)?),
                Meaning::Statement(statement) => {
                    let statement = self.with_lists_opened(statement, expr.place)?;
                    Meaning::Statement(self.statement_in_jets(statement)?)
                }
                Meaning::Function(function) => Meaning::Function(function),
            })
        })
    }

    /// Elaborates a formula that is a term.
    ///
    /// # Errors
    /// As [`Elaborator::meaning`].
    pub fn term(&self, expr: &Expr) -> Outcome<Term> {
        self.nodes.set(0);
        stack::deep(|| self.in_jets(self.term_in(expr, &Scope::default())?))
    }

    /// Elaborates a statement.
    ///
    /// # Errors
    /// As [`Elaborator::meaning`].
    pub fn statement(&self, expr: &Expr) -> Outcome<Statement> {
        let statement = self.unopened(expr)?;
        stack::deep(|| self.statement_in_jets(self.with_lists_opened(statement, expr.place)?))
    }

    /// A statement before properties of lists are opened.
    fn unopened(&self, expr: &Expr) -> Outcome<Statement> {
        self.nodes.set(0);
        stack::deep(|| self.statement_in(expr, &Scope::default()))
    }

    /// Elaborates a statement in which closed terms replace declared symbols wherever they occur, as `at` does.
    ///
    /// # Errors
    /// As [`Elaborator::meaning`].
    pub fn statement_where(&self, expr: &Expr, values: &[(&str, Term)]) -> Outcome<Statement> {
        stack::deep(|| self.statement_with(expr, values))
    }

    fn statement_with(&self, expr: &Expr, values: &[(&str, Term)]) -> Outcome<Statement> {
        self.nodes.set(0);
        let mut scope = Scope::default();
        let mut bound = vec![];
        for (name, value) in values {
            let variable = self.fresh(name);
            scope = scope.with_global(name, &variable);
            bound.push((variable, value));
        }
        let statement = self.with_lists_opened(self.statement_in(expr, &scope)?, expr.place)?;
        let substitute = |term: &Term| {
            bound.iter().fold(term.clone(), |body, (variable, value)| {
                let place = body.place;
                let node = Node::Let {
                    variable: variable.clone(),
                    value: (*value).clone(),
                    body,
                };
                self.made(node, place)
            })
        };
        for (_, value) in &bound {
            check_no_shared_variable(&statement, value)?;
        }
        self.statement_in_jets(statement.mapped_throughout(&substitute))
    }

    /// The basis family of this name.
    ///
    /// # Errors
    /// [`Fault`] if there is no such basis, or an error in its seeds or step.
    pub fn family(&self, name: &str, place: Place) -> Outcome<Arc<Family>> {
        let basis = self
            .declarations
            .basis(name)
            .ok_or_else(|| wrong(place, "a formula", "the name of a basis"))?;
        stack::deep(|| self.family_of(name, basis, &Scope::default()))
    }

    /// The declared sets of these symbols, and of the symbols that occur in the declarations of these sets.
    #[must_use]
    pub fn symbols_of(&self, mut names: Vec<Arc<str>>) -> BTreeMap<Arc<str>, Set> {
        let mut all: BTreeMap<Arc<str>, Set> = BTreeMap::new();
        while let Some(name) = names.pop() {
            if all.contains_key(&name) {
                continue;
            }
            let Some(set) = self.declarations.symbol(&name) else {
                continue;
            };
            let mut forms = vec![];
            match set {
                SymbolKind::Integer { least, most } => forms.extend(least.iter().chain(most)),
                SymbolKind::Family { ranges, .. } => {
                    forms.extend(ranges.iter().flat_map(|(a, b)| [a, b]));
                }
                SymbolKind::Real(_) | SymbolKind::Vector(_) => {}
            }
            for form in forms {
                names.extend(form.multiples().map(|(name, _)| Arc::from(name)));
            }
            all.insert(name, set.clone());
        }
        all
    }

    fn fresh(&self, name: &str) -> Variable {
        let number = self.next.get();
        self.next.set(number.saturating_add(1));
        Variable::new(number, name)
    }

    fn made(&self, node: Node, place: Place) -> Term {
        Term {
            node: Arc::new(node),
            place,
        }
    }

    fn term_in(&self, expr: &Expr, scope: &Scope) -> Outcome<Term> {
        if let Some(term) = self.kept(expr, scope) {
            return Ok(term);
        }
        match self.open(expr, scope)? {
            Meaning::Term(term) => {
                self.keep(expr, scope, &term);
                Ok(term)
            }
            other => Err(wrong(
                expr.place,
                other.kind(),
                "a number, vector or matrix",
            )),
        }
    }

    fn terms_in(&self, exprs: &[Expr], scope: &Scope) -> Outcome<Vec<Term>> {
        exprs.iter().map(|e| self.term_in(e, scope)).collect()
    }

    fn statement_in(&self, expr: &Expr, scope: &Scope) -> Outcome<Statement> {
        match self.open(expr, scope)? {
            Meaning::Statement(statement) => Ok(statement),
            other => Err(wrong(expr.place, other.kind(), "a statement")),
        }
    }

    fn open(&self, expr: &Expr, scope: &Scope) -> Outcome<Meaning> {
        let place = expr.place;
        self.count(1, place)?;
        let term = |node| Ok(Meaning::Term(self.made(node, place)));
        match &expr.node {
            formula::Node::Number { value, .. } => term(Node::Number(value.clone())),
            formula::Node::Name(name) => self.named(name, place, scope),
            formula::Node::Call(head, arguments) => self.call(head, arguments, place, scope),
            formula::Node::Index(head, indices) => self.indexed(head, indices, place, scope),
            formula::Node::Negative(inner) => term(Node::Negative(self.term_in(inner, scope)?)),
            formula::Node::Binary(Operator::Power, _, exponent)
                if self.is_no_integer(exponent, scope) =>
            {
                Err(Fault::exponent(exponent.place))
            }
            formula::Node::Binary(operator, a, b) => term(Node::Binary(
                *operator,
                self.term_in(a, scope)?,
                self.term_in(b, scope)?,
            )),
            formula::Node::List(items) => term(Node::List(self.terms_in(items, scope)?)),
            formula::Node::Compare(first, rest) => {
                let mut left = self.term_in(first, scope)?;
                let mut chain: Option<Statement> = None;
                for (relation, right) in rest {
                    let right = self.term_in(right, scope)?;
                    let link = Statement::Compare {
                        relation: *relation,
                        left: left.clone(),
                        right: right.clone(),
                    };
                    chain = Some(match chain {
                        None => link,
                        Some(before) => {
                            Statement::Join(Connective::And, Box::new(before), Box::new(link))
                        }
                    });
                    if !injected(InjectedFault::ChainFromFirst) {
                        left = right;
                    }
                }
                chain
                    .map(Meaning::Statement)
                    .ok_or_else(|| wrong(place, "nothing", "a comparison"))
            }
            formula::Node::Join(connective, a, b) => {
                let side = |tree: &Expr| {
                    let statement = self.statement_in(tree, scope)?;
                    match connective {
                        Connective::And => Ok(statement),
                        Connective::Or | Connective::Implies => {
                            denial::about_points(statement, tree)
                        }
                    }
                };
                let (a, b) = match *connective == Connective::Implies
                    && injected(InjectedFault::ImplicationReversed)
                {
                    true => (b, a),
                    false => (a, b),
                };
                let (a, b) = (Box::new(side(a)?), Box::new(side(b)?));
                Ok(Meaning::Statement(Statement::Join(*connective, a, b)))
            }
            formula::Node::Not(inner) => {
                let denied = self.statement_in(inner, scope)?;
                denial::opposite(denied, inner).map(Meaning::Statement)
            }
        }
    }

    /// Counts new nodes and fails above [`MAX_NODES`].
    fn count(&self, nodes: u64, place: Place) -> Outcome<()> {
        self.nodes.set(self.nodes.get().saturating_add(nodes));
        if self.nodes.get() > MAX_NODES {
            let what = format!("the formula opens to more than {MAX_NODES} terms");
            return Err(Fault::limit(place, what));
        }
        Ok(())
    }

    /// Copies a cached meaning. The copy shares terms; a statement is copied as a tree, so its size is counted.
    fn copied(&self, meaning: &Meaning, place: Place) -> Outcome<Meaning> {
        if let Meaning::Statement(statement) = meaning {
            self.count(statement.size(), place)?;
        }
        Ok(meaning.clone())
    }

    fn named(&self, name: &str, place: Place, scope: &Scope) -> Outcome<Meaning> {
        let term = |node| Ok(Meaning::Term(self.made(node, place)));
        if let Some((variable, _)) = scope.locals.get(name) {
            return term(Node::Variable(variable.clone()));
        }
        if let Some(variable) = scope.globals.get(name) {
            return term(Node::Variable(variable.clone()));
        }
        if let Some(definition) = self.declarations.definition(name) {
            let outside = if injected(InjectedFault::DefinitionOutsideScope) {
                Scope::default()
            } else {
                scope.outside()
            };
            return self.definition(name, definition, place, &outside);
        }
        match self.declarations.symbol(name) {
            Some(SymbolKind::Real(_) | SymbolKind::Integer { .. }) => {
                return term(Node::Symbol(Arc::from(name)));
            }
            Some(SymbolKind::Vector(dimension)) => {
                return term(Node::Vector(Arc::from(name), *dimension));
            }
            Some(SymbolKind::Family { .. }) => {
                return Err(wrong(
                    place,
                    "a family without an index",
                    "one of its members",
                ));
            }
            None => {}
        }
        if let Some(dimension) = self.declarations.function(name) {
            return Ok(Meaning::Function(self.smooth(name, dimension, place)));
        }
        if name == "pi" {
            return term(Node::Pi);
        }
        // `F''` is the second derivative of F by its first parameter.
        let base = name.trim_end_matches('\'');
        let closed = scope.globals.is_empty() && !scope.locals.contains_key(base);
        if closed && let Some(meaning) = self.opened.borrow().get(name) {
            return self.copied(meaning, place);
        }
        if base.len() < name.len()
            && let Ok(Meaning::Function(function)) = self.named(base, place, scope)
            && let Some(parameter) = function.parameters.first().cloned()
        {
            let order = i64::try_from(name.len() - base.len()).unwrap_or(i64::MAX);
            let order = if injected(InjectedFault::PrimesOnce) {
                1
            } else {
                order
            };
            let order = self.made(Node::Number(rational::integer(order)), place);
            let derivative =
                Meaning::Function(self.differentiated(&function, &parameter, order, place));
            if closed {
                let kept = (name.to_owned(), derivative.clone());
                self.opened.borrow_mut().extend([kept]);
            }
            return Ok(derivative);
        }
        Err(match infinite(name) {
            Some(why) => Fault::limit(place, why),
            None => self.unknown(name, place, scope),
        })
    }

    /// Whether an exponent is a fraction, or has a declared real number in it. Parameters of definitions are numbers where the definition
    /// is applied, what replaces a symbol may be an integer: the evaluator refuses those that are none.
    fn is_no_integer(&self, exponent: &Expr, scope: &Scope) -> bool {
        let number = |expr: &Expr| match &expr.node {
            formula::Node::Number { value, .. } => Some(value.clone()),
            formula::Node::Negative(inner) => match &inner.node {
                formula::Node::Number { value, .. } => Some(-value.clone()),
                _ => None,
            },
            _ => None,
        };
        match &exponent.node {
            formula::Node::Number { value, .. } => !value.is_integer(),
            formula::Node::Negative(inner) => self.is_no_integer(inner, scope),
            formula::Node::Binary(Operator::Divide, a, b)
                if let (Some(a), Some(b)) = (number(a), number(b)) =>
            {
                b != rational::integer(0) && !(a / b).is_integer()
            }
            _ => self.has_real(exponent, scope),
        }
    }

    fn has_real(&self, formula: &Expr, scope: &Scope) -> bool {
        match &formula.node {
            formula::Node::Name(name) => {
                !scope.locals.contains_key(name)
                    && !scope.globals.contains_key(name)
                    && matches!(self.declarations.symbol(name), Some(SymbolKind::Real(_)))
            }
            formula::Node::Negative(inner) => self.has_real(inner, scope),
            formula::Node::Binary(_, a, b) => self.has_real(a, scope) || self.has_real(b, scope),
            _ => false,
        }
    }

    fn definition(
        &self,
        name: &str,
        definition: &Definition,
        place: Place,
        scope: &Scope,
    ) -> Outcome<Meaning> {
        let closed = scope.globals.is_empty();
        if closed && let Some(meaning) = self.opened.borrow().get(name) {
            return self.copied(meaning, place);
        }
        if self.depth.get() >= MAX_DEPTH {
            return Err(Fault::at(place, Problem::Circular { limit: MAX_DEPTH }));
        }
        self.depth.set(self.depth.get() + 1);
        let parameters: Vec<Variable> = definition
            .parameters
            .iter()
            .map(|p| self.fresh(p))
            .collect();
        let inside = definition.parameters.iter().zip(&parameters).fold(
            scope.clone(),
            |scope, (name, variable)| {
                let local = if definition.indexed {
                    Local::Index
                } else {
                    Local::Continuous
                };
                scope.with_local(name, variable, local)
            },
        );
        let origin = &definition.body.origin;
        let body = self
            .open(&definition.body.expr, &inside)
            .map_err(|f| f.within(origin));
        self.depth.set(self.depth.get() - 1);
        let name: Arc<str> = Arc::from(name);
        let origin = Arc::new(origin.clone());
        let wrap = |body: Term, closed: bool| {
            self.made(
                Node::Opened {
                    name: Arc::clone(&name),
                    origin: Arc::clone(&origin),
                    closed,
                    body,
                },
                place,
            )
        };
        let meaning = match (body?, parameters.is_empty()) {
            (Meaning::Term(body), true) => Meaning::Term(wrap(body, closed)),
            (Meaning::Statement(statement), true) => {
                Meaning::Statement(statement.mapped(&|term| wrap(term.clone(), closed)))
            }
            (function @ Meaning::Function(_), true) => function,
            (Meaning::Term(body), false) => Meaning::Function(Lambda {
                name: Arc::clone(&name),
                parameters,
                body: wrap(body, false),
            }),
            (other, false) => {
                let fault = wrong(definition.body.expr.place, other.kind(), "a formula");
                return Err(fault.within(&definition.body.origin));
            }
        };
        if closed {
            self.opened
                .borrow_mut()
                .insert(name.to_string(), meaning.clone());
        }
        Ok(meaning)
    }

    fn call(
        &self,
        head: &Expr,
        arguments: &[Expr],
        place: Place,
        scope: &Scope,
    ) -> Outcome<Meaning> {
        let free = |name: &str| {
            !scope.locals.contains_key(name) && self.declarations.definition(name).is_none()
        };
        if let formula::Node::Index(family, indices) = &head.node
            && let formula::Node::Name(name) = &family.node
            && free(name)
            && let Some(basis) = self.declarations.basis(name)
        {
            return self.member(name, basis, indices, arguments, place, scope);
        }
        if let formula::Node::Name(name) = &head.node
            && is_function(name)
            && free(name)
        {
            return self.built_in(name, arguments, place, scope);
        }
        if let formula::Node::Name(name) = &head.node
            && self.indexed_definition(name, scope).is_some()
        {
            return Err(wrong(
                place,
                "a family at arguments in round brackets",
                "its member, `Q[i]`",
            ));
        }
        let opened = self.open(head, scope);
        let opened = opened.map_err(|fault| match (&head.node, &*fault.problem) {
            (formula::Node::Name(own), Problem::UnknownName { name, .. }) if own == name => {
                match out_of_scope(name) {
                    Some(why) => Fault::limit(place, format!("`{name}`: {why}")),
                    None => fault,
                }
            }
            _ => fault,
        });
        match opened? {
            Meaning::Function(function) => {
                let values = self.terms_in(arguments, scope)?;
                self.applied(&function, values, place).map(Meaning::Term)
            }
            other => Err(wrong(head.place, other.kind(), "a function")),
        }
    }

    /// The definition of an indexed family of this name, if nothing in scope hides it.
    fn indexed_definition(&self, name: &str, scope: &Scope) -> Option<&'a Definition> {
        let hidden = scope.locals.contains_key(name) || scope.globals.contains_key(name);
        let definition = self.declarations.definition(name).filter(|_| !hidden)?;
        definition.indexed.then_some(definition)
    }

    fn applied(&self, function: &Lambda, values: Vec<Term>, place: Place) -> Outcome<Term> {
        if values.len() != function.parameters.len() {
            return Err(Fault::at(
                place,
                Problem::Count {
                    name: function.name.to_string(),
                    wanted: counted(function.parameters.len(), "argument"),
                    found: values.len(),
                },
            ));
        }
        let mut values = values;
        if injected(InjectedFault::ArgumentsExchanged) {
            values.reverse();
        }
        // Each parameter is a variable of its own, so no argument can contain the parameter of another.
        let bound = function.parameters.iter().zip(values).rev();
        Ok(
            bound.fold(function.body.clone(), |body, (parameter, value)| {
                let node = Node::Let {
                    variable: parameter.clone(),
                    value,
                    body,
                };
                self.made(node, place)
            }),
        )
    }

    fn unknown(&self, name: &str, place: Place, scope: &Scope) -> Fault {
        let candidates: Vec<&str> = self
            .declarations
            .names()
            .chain(scope.locals.keys().map(String::as_str))
            .chain(FUNCTIONS)
            .collect();
        // Suggest the spelled name of a Greek letter if that name is declared.
        let sign = name.chars().next().filter(|_| name.chars().count() == 1);
        let spelled = sign.and_then(greek::by_sign).map(|letter| letter.name);
        let spelled = spelled.filter(|name| candidates.contains(name));
        let similar = spelled.or_else(|| similar(name, candidates));
        let similar = similar.map(str::to_owned);
        Fault::at(
            place,
            Problem::UnknownName {
                name: name.to_owned(),
                similar,
            },
        )
    }
}

/// Fails if the value contains a symbol that has the name of a variable of a basis whose property the statement is
/// about: the decision procedures for such properties cannot distinguish the two.
fn check_no_shared_variable(statement: &Statement, value: &Term) -> Outcome<()> {
    let mut taken = false;
    for family in statement.families() {
        value.declared_names(&mut |name| {
            taken |= family.variables.iter().any(|own| own.name() == &**name);
        });
    }
    if taken {
        Err(Fault::limit(
            value.place,
            "a property of a basis at a value in the basis's own variable or shape parameters",
        ))
    } else {
        Ok(())
    }
}

fn wrong(place: Place, what: &'static str, wanted: &'static str) -> Fault {
    Fault::at(place, Problem::WrongType { what, wanted })
}

/// `1 argument`, `2 arguments`.
fn counted(number: usize, what: &str) -> String {
    match number {
        1 => format!("1 {what}"),
        n => format!("{n} {what}s"),
    }
}
