//! Roots, logarithms and arcs of formulas as symbols.
//!
//! `sqrt(r)` is the number w with `w^2 == r` and `w >= 0`; for r < 0 there is none. So a claim in which `sqrt(r)`
//! occurs is equivalent to the claim in which a new symbol w of the set `[0, inf)` replaces it, under the hypothesis
//! `w^2 == r`: a point of the first at which the root is defined is a point of the second with exactly one value of
//! w, and conversely. [`Claim::rooted`] makes the second claim. `norm(v)` is the root of `dot(v, v)`. Roots of the
//! same radicand become the same symbol.
//!
//! Likewise `log(r)` is the number w with `exp(w) == r`; for r <= 0 there is none. A new symbol w of the set of all
//! numbers replaces it, under the hypotheses `r > 0` and `exp(w) == r`, of which the second implies the first.
//!
//! And `atan(r)` is the number w of `(-pi/2, pi/2)` with `sin(w) == r*cos(w)`, and `asin(r)` the number w of `[-pi/2, pi/2]` with
//! `sin(w) == r`; for r above 1 and below -1 there is none. These are arcs.
//!
//! **Under a derivative** the argument changes with the variable. By Taylor's theorem a derivative of order n at u
//! depends on the function through its first n derivatives there, so it becomes the polynomial
//! `c_0 + c_1 (x - u) + ... + c_n (x - u)^n` with h = x - u (module `taylor`).
//!
//! A root, logarithm or arc whose argument contains no symbol is a number and is not replaced.

mod arc;
mod name;
mod needed;
mod part;
mod size;
mod taylor;

pub use arc::{ArcFunction, ArcSymbol};

use super::{BuiltIn, Claim, Hypothesis, Node, Set, Source, Statement, Term, Variable};
use part::{key, mentions, replaced};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_numbers::rational::{self, integer};
use torse_syntax::derivation::Origin;
use torse_syntax::derivation::declarations::{Bound, Interval};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Operator, Place, Relation};

/// The largest number of roots and logarithms of one claim.
const MAX_MADE: usize = 24;
/// The largest number of terms that are visited.
const MAX_NODES: usize = 200_000;

impl Claim {
    /// Replaces each root and each logarithm of a formula by a symbol and adds the hypotheses that define these symbols;
    /// `origin` is the origin of the statement.
    ///
    /// # Errors
    /// [`Fault`] for one that depends on the index of a sum or the variable of an integral, for more than 24 of them, and for
    /// arguments that are too large.
    pub fn rooted(&self, origin: &Origin) -> Result<Self, Fault> {
        let applies = |s: &Statement| s.terms().into_iter().any(has_implicit);
        if !applies(&self.statement) && !self.hypotheses.iter().any(|h| applies(&h.statement)) {
            return Ok(self.clone());
        }
        let mut work = Work::default();
        let mut hypotheses = vec![];
        for hypothesis in &self.hypotheses {
            let statement = work.statement(&hypothesis.statement);
            hypotheses.push(Hypothesis {
                statement: statement.map_err(|fault| fault.within(&hypothesis.origin))?,
                ..hypothesis.clone()
            });
        }
        let statement = work.statement(&self.statement)?;
        let mut symbols = self.symbols.clone();
        for made in work.made {
            symbols.insert(Arc::clone(&made.name), made.function.set());
            hypotheses.extend(made.hypotheses(origin));
        }
        Ok(Self {
            symbols,
            hypotheses,
            unknowns: self.unknowns.clone(),
            statement,
        })
    }

    /// The symbols that stand for roots, with their radicands. A root that occurs in the radicand of another comes first.
    pub fn roots(&self) -> impl Iterator<Item = (&Arc<str>, &Term)> {
        self.hypotheses.iter().filter_map(Hypothesis::root)
    }

    /// The symbols that stand for roots and logarithms, with their arguments. One that occurs in the argument of another
    /// comes first.
    pub fn implicit(&self) -> impl Iterator<Item = (&Arc<str>, &Term)> {
        let hypotheses = self.hypotheses.iter();
        hypotheses.filter_map(Hypothesis::implicit)
    }

    /// The symbols that stand for logarithms, with their arguments. One that occurs in the argument of another comes first.
    pub fn logarithms(&self) -> impl Iterator<Item = (&Arc<str>, &Term)> {
        self.hypotheses.iter().filter_map(Hypothesis::logarithm)
    }
}

impl Hypothesis {
    /// The symbol of a root and its radicand, if this hypothesis defines one.
    #[must_use]
    pub fn root(&self) -> Option<(&Arc<str>, &Term)> {
        let Statement::Compare { left, right, .. } = &self.statement else {
            return None;
        };
        match (self.source, &*left.node) {
            (Source::Root, Node::Binary(Operator::Power, base, _)) => match &*base.node {
                Node::Symbol(name) => Some((name, right)),
                _ => None,
            },
            _ => None,
        }
    }

    /// The symbol of a root, a logarithm or an arc, and its argument, if this hypothesis defines one.
    #[must_use]
    pub fn implicit(&self) -> Option<(&Arc<str>, &Term)> {
        let arc = || self.arc().map(|arc| (arc.name, arc.argument));
        self.root().or_else(|| self.logarithm()).or_else(arc)
    }

    /// The symbol of a logarithm and its argument, if this hypothesis defines one.
    #[must_use]
    pub fn logarithm(&self) -> Option<(&Arc<str>, &Term)> {
        let Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
        } = &self.statement
        else {
            return None;
        };
        let Node::Apply(BuiltIn::Exponential, items) = &*left.node else {
            return None;
        };
        match (self.source, items.as_slice()) {
            (Source::Logarithm, [symbol]) => match &*symbol.node {
                Node::Symbol(name) => Some((name, right)),
                _ => None,
            },
            _ => None,
        }
    }
}

/// The functions that symbols stand for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Implicit {
    /// The number w >= 0 with `w^2 == r`.
    Root,
    /// The number w with `exp(w) == r`.
    Logarithm,
    /// The number w between `-pi/2` and `pi/2` with this tangent or sine.
    Arc(ArcFunction),
}

impl Implicit {
    /// The set of all values.
    fn set(self) -> Set {
        if let Self::Arc(function) = self {
            return function.set();
        }
        let zero = || Bound {
            value: rational::integer(0).into(),
            closed: true,
        };
        Set::Real(Box::new(Interval {
            lower: (self == Self::Root).then(zero),
            ..Interval::default()
        }))
    }

    /// The one that a function is.
    fn new(function: BuiltIn) -> Option<Self> {
        Some(match function {
            BuiltIn::SquareRoot => Self::Root,
            BuiltIn::Logarithm => Self::Logarithm,
            BuiltIn::ArcTangent => Self::Arc(ArcFunction::Tangent),
            BuiltIn::ArcSine => Self::Arc(ArcFunction::Sine),
            _ => return None,
        })
    }

    fn built_in(self) -> BuiltIn {
        match self {
            Self::Root => BuiltIn::SquareRoot,
            Self::Logarithm => BuiltIn::Logarithm,
            Self::Arc(function) => function.built_in(),
        }
    }

    /// What it is called in messages.
    fn noun(self) -> &'static str {
        match self {
            Self::Root => "a root",
            Self::Logarithm => "a logarithm",
            Self::Arc(ArcFunction::Tangent) => "an arc tangent",
            Self::Arc(ArcFunction::Sine) => "an arc sine",
        }
    }
}

/// Whether a root or a logarithm occurs in a term.
fn has_implicit(term: &Term) -> bool {
    let all = [
        BuiltIn::SquareRoot,
        BuiltIn::Norm,
        BuiltIn::Logarithm,
        BuiltIn::ArcTangent,
        BuiltIn::ArcSine,
    ];
    all.into_iter().any(|function| term.applies(function))
}

/// The symbol of a root or a logarithm, and its argument.
struct Made {
    function: Implicit,
    name: Arc<str>,
    argument: Term,
}

impl Made {
    /// `w^2 == r`, or `r > 0` and `exp(w) == r`, or `sin(w) == r*cos(w)`, or `sin(w) == r`.
    fn hypotheses(self, origin: &Origin) -> Vec<Hypothesis> {
        let place = self.argument.place;
        let symbol = made(Node::Symbol(self.name), place);
        let number = |n: i64| made(Node::Number(integer(n)), place);
        let compared = |relation, left, right, source| Hypothesis {
            statement: Statement::Compare {
                relation,
                left,
                right,
            },
            source,
            origin: origin.clone(),
        };
        match self.function {
            Implicit::Root => {
                let square = binary(Operator::Power, symbol, number(2));
                vec![compared(
                    Relation::Equal,
                    square,
                    self.argument,
                    Source::Root,
                )]
            }
            Implicit::Arc(function) => {
                let (left, right) = function.equation(&symbol, self.argument);
                vec![compared(Relation::Equal, left, right, Source::Arc)]
            }
            Implicit::Logarithm => {
                let power = Node::Apply(BuiltIn::Exponential, vec![symbol]);
                let (power, argument) = (made(power, place), self.argument);
                let source = Source::Logarithm;
                vec![
                    compared(Relation::Greater, argument.clone(), number(0), source),
                    compared(Relation::Equal, power, argument, source),
                ]
            }
        }
    }
}

/// What kind of variable an enclosing binder has.
#[derive(Clone)]
enum Binder {
    /// A variable that abbreviates a term, which contains no such variables.
    Name(Term),
    /// The variable of a derivative.
    Differential,
    /// The index of a sum or of a product.
    Index,
    /// The variable of an integral.
    Integration,
}

/// The enclosing binders, by the numbers of their variables.
type Scope = BTreeMap<u32, Binder>;

#[derive(Default)]
struct Work {
    made: Vec<Made>,
    /// The symbols, by their functions and the keys of their arguments.
    names: BTreeMap<(BuiltIn, String), Arc<str>>,
    /// The number of variables made.
    variables: u32,
    nodes: usize,
}

fn made(node: Node, place: Place) -> Term {
    Term {
        node: Arc::new(node),
        place,
    }
}

fn binary(operator: Operator, a: Term, b: Term) -> Term {
    let place = a.place;
    made(Node::Binary(operator, a, b), place)
}

impl Work {
    fn statement(&mut self, statement: &Statement) -> Result<Statement, Fault> {
        let work = std::cell::RefCell::new(self);
        statement.try_mapped(&|term| work.borrow_mut().term(term, &Scope::new()))
    }

    /// Replaces the roots and logarithms in a term by symbols. Those that depend on the variable of an enclosing derivative
    /// are left unchanged; the derivative expands them.
    fn term(&mut self, term: &Term, scope: &Scope) -> Result<Term, Fault> {
        if !has_implicit(term) {
            return Ok(term.clone());
        }
        self.nodes += 1;
        if self.nodes > MAX_NODES {
            return Err(Fault::limit(
                term.place,
                "a formula with too many roots or logarithms",
            ));
        }
        match &*term.node {
            Node::Apply(own, items)
                if let Some(function) = Implicit::new(*own)
                    && items.len() == 1 =>
            {
                let items = self.all(items, scope)?;
                let argument = items.into_iter().next();
                let argument = argument.ok_or_else(|| nothing(term.place))?;
                self.symbol(function, argument, term.place, scope)
            }
            Node::Apply(BuiltIn::Norm, items) if items.len() == 1 => {
                let items = self.all(items, scope)?;
                let pair = items.first().cloned().into_iter().chain(items);
                let square = Node::Apply(BuiltIn::Dot, pair.collect());
                let square = made(square, term.place);
                self.symbol(Implicit::Root, square, term.place, scope)
            }
            Node::Let {
                variable,
                value,
                body,
            } => {
                let value = self.term(value, scope)?;
                let mut inside = scope.clone();
                inside.insert(variable.number(), Binder::Name(named(&value, scope)));
                let node = Node::Let {
                    variable: variable.clone(),
                    body: self.term(body, &inside)?,
                    value,
                };
                Ok(made(node, term.place))
            }
            Node::Sum {
                index,
                low,
                high,
                term: inner,
            } => {
                let mut inside = scope.clone();
                inside.insert(index.number(), Binder::Index);
                let node = Node::Sum {
                    index: index.clone(),
                    low: self.term(low, scope)?,
                    high: self.term(high, scope)?,
                    term: self.term(inner, &inside)?,
                };
                Ok(made(node, term.place))
            }
            Node::Product { index, .. } => {
                let mut inside = scope.clone();
                inside.insert(index.number(), Binder::Index);
                term.with_parts(&mut |part| self.term(part, &inside))
            }
            Node::Integral { variable, .. } => {
                let mut inside = scope.clone();
                inside.insert(variable.number(), Binder::Integration);
                term.with_parts(&mut |part| self.term(part, &inside))
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => {
                let at = self.term(at, scope)?;
                let mut inside = scope.clone();
                inside.insert(variable.number(), Binder::Differential);
                let body = self.term(body, &inside)?;
                let around = Around {
                    variable,
                    order: literal(order),
                    at: &named(&at, scope),
                    scope,
                };
                let body = self.expanded(&body, &around)?;
                let node = Node::Derivative {
                    variable: variable.clone(),
                    order: self.term(order, scope)?,
                    closed: body.is_closed_but_for(variable.number()),
                    body,
                    at,
                };
                Ok(made(node, term.place))
            }
            Node::Opened {
                name,
                origin,
                closed,
                body,
            } => {
                let body = self.term(body, scope).map_err(|f| f.within(origin))?;
                let node = Node::Opened {
                    name: Arc::clone(name),
                    origin: Arc::clone(origin),
                    closed: *closed && body.is_closed(),
                    body,
                };
                Ok(made(node, term.place))
            }
            _ => term.with_parts(&mut |part| self.term(part, scope)),
        }
    }

    fn all(&mut self, items: &[Term], scope: &Scope) -> Result<Vec<Term>, Fault> {
        items.iter().map(|item| self.term(item, scope)).collect()
    }

    /// The symbol of a function of an argument in which roots and logarithms have been replaced already.
    fn symbol(
        &mut self,
        function: Implicit,
        argument: Term,
        place: Place,
        scope: &Scope,
    ) -> Result<Term, Fault> {
        let argument = named(&argument, scope);
        let noun = function.noun();
        let bound = |kind: fn(&Binder) -> bool| {
            let of_kind = scope.iter().filter(|(_, binder)| kind(binder));
            let mut numbers = of_kind.map(|(number, _)| *number);
            numbers.any(|number| mentions(&argument, number))
        };
        if bound(|binder| matches!(binder, Binder::Index)) {
            let what = format!("{noun} that depends on the index of a sum");
            return Err(Fault::limit(place, what));
        }
        if bound(|binder| matches!(binder, Binder::Integration)) {
            let what = match function {
                Implicit::Root => format!(
                    "{noun} that depends on the variable of an integral: write it without the root, and integrate that"
                ),
                Implicit::Logarithm | Implicit::Arc(_) => {
                    format!("{noun} that depends on the variable of an integral")
                }
            };
            return Err(Fault::limit(place, what));
        }
        let moves = bound(|binder| matches!(binder, Binder::Differential));
        if moves || part::is_number(&argument) {
            let node = Node::Apply(function.built_in(), vec![argument]);
            return Ok(made(node, place));
        }
        let key = key(&argument).ok_or_else(|| {
            let what = match function {
                Implicit::Root => "so large a radicand",
                Implicit::Logarithm => "so large an argument of a logarithm",
                Implicit::Arc(_) => "so large an argument of an arc",
            };
            Fault::limit(place, what)
        })?;
        let key = (function.built_in(), key);
        if let Some(name) = self.names.get(&key) {
            return Ok(made(Node::Symbol(Arc::clone(name)), place));
        }
        if self.made.len() >= MAX_MADE {
            let what = format!("more than {MAX_MADE} different roots, logarithms and arcs");
            return Err(Fault::limit(place, what));
        }
        let taken = |name: &str| self.made.iter().any(|made| *made.name == *name);
        // No text starts a name like these, so that no declared symbol has it.
        let (text, sign) = match function {
            Implicit::Root => (name::root_text(&argument), "\u{221a}"),
            Implicit::Logarithm => (name::applied_text(function.built_in(), &argument), "log#"),
            Implicit::Arc(_) => (name::applied_text(function.built_in(), &argument), "arc#"),
        };
        let name = text.filter(|name| !taken(name));
        let name = name.unwrap_or_else(|| format!("{sign}{}", self.made.len() + 1));
        let name: Arc<str> = name.into();
        self.names.insert(key, Arc::clone(&name));
        self.made.push(Made {
            function,
            name: Arc::clone(&name),
            argument,
        });
        Ok(made(Node::Symbol(name), place))
    }

    /// The body of a derivative, in which roots and logarithms that depend on its variable are replaced by their Taylor
    /// polynomials.
    fn expanded(&mut self, term: &Term, around: &Around<'_>) -> Result<Term, Fault> {
        if !has_implicit(term) || !mentions(term, around.variable.number()) {
            return Ok(term.clone());
        }
        match &*term.node {
            Node::Apply(own, items) if let Some(function) = Implicit::new(*own) => {
                match items.as_slice() {
                    [argument] => {
                        let moved = self.expanded(argument, around)?;
                        self.series(function, argument, &moved, around)
                    }
                    _ => Err(nothing(term.place)),
                }
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => {
                let body = self.expanded(body, around)?;
                let node = Node::Derivative {
                    variable: variable.clone(),
                    order: order.clone(),
                    closed: body.is_closed_but_for(variable.number()),
                    body,
                    at: self.expanded(at, around)?,
                };
                Ok(made(node, term.place))
            }
            Node::Opened {
                name,
                origin,
                closed,
                body,
            } => {
                let body = self.expanded(body, around)?;
                let node = Node::Opened {
                    name: Arc::clone(name),
                    origin: Arc::clone(origin),
                    closed: *closed && body.is_closed(),
                    body,
                };
                Ok(made(node, term.place))
            }
            _ => term.with_parts(&mut |part| self.expanded(part, around)),
        }
    }
}

/// A derivative whose body is being expanded.
struct Around<'s> {
    variable: &'s Variable,
    order: Option<u32>,
    /// The point at which the derivative is taken, without abbreviating variables.
    at: &'s Term,
    /// The enclosing binders.
    scope: &'s Scope,
}

fn nothing(place: Place) -> Fault {
    Fault::limit(place, "a function of nothing")
}

/// Replaces the variables that abbreviate terms by these terms.
fn named(term: &Term, scope: &Scope) -> Term {
    let mut term = term.clone();
    for (number, binder) in scope {
        if let Binder::Name(value) = binder {
            term = replaced(&term, *number, value);
        }
    }
    term
}

/// The order of a derivative, if it is a literal number.
fn literal(order: &Term) -> Option<u32> {
    match &*order.node {
        Node::Number(value) if value.is_integer() => u32::try_from(&value.to_integer()).ok(),
        _ => None,
    }
}
