//! Roots of formulas as symbols.
//!
//! `sqrt(r)` is the number w with `w^2 == r` and `w >= 0`; for r < 0 there is none. So a claim in which `sqrt(r)`
//! occurs is equivalent to the claim in which a new symbol w of the set `[0, inf)` replaces it, under the hypothesis
//! `w^2 == r`: a point of the first at which the root is defined is a point of the second with exactly one value of
//! w, and conversely. [`Claim::rooted`] makes the second claim. `norm(v)` is the root of `dot(v, v)`. Roots of the
//! same radicand become the same symbol.
//!
//! **Under a derivative** the radicand changes with the variable. By Taylor's theorem a derivative of order n at u
//! depends on the root through its first n derivatives there, so the root becomes the polynomial
//! `c_0 + c_1 (x - u) + ... + c_n (x - u)^n` with `c_0 = w = sqrt(r(u))` and, since its square is r up to order n,
//! `c_k = (r_k - sum of c_j c_(k-j) for 0 < j < k)/(2 c_0)`, where `r_k` is the k-th derivative of r at u over k!. So
//! the derivative is defined where r(u) > 0.
//!
//! A root whose radicand contains no symbol is a number and is not replaced.

mod name;
mod part;

use super::{BuiltIn, Claim, Hypothesis, Node, Set, Source, Statement, Term, Variable};
use part::{key, mentions, replaced};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_numbers::rational::{self, integer};
use torse_syntax::derivation::Origin;
use torse_syntax::derivation::declarations::{Bound, Interval};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Operator, Place, Relation};

/// The number of the first variable made here; the variables of texts have smaller numbers.
const FIRST_VARIABLE: u32 = u32::MAX / 2;
/// The largest number of roots of one claim.
const MAX_ROOTS: usize = 24;
/// The largest order of a derivative of a root.
const MAX_ORDER: u32 = 4;
/// The largest number of terms that are visited.
const MAX_NODES: usize = 200_000;

impl Claim {
    /// Replaces each root of a formula by a symbol and adds the hypotheses that define these symbols; `origin` is the
    /// origin of the statement.
    ///
    /// # Errors
    /// [`Fault`] for a root that depends on the index of a sum, for more than 24 roots, and for radicands that are
    /// too large.
    pub fn rooted(&self, origin: &Origin) -> Result<Self, Fault> {
        let applies = |s: &Statement| s.terms().into_iter().any(has_root);
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
        for root in work.roots {
            symbols.insert(Arc::clone(&root.name), nonnegative());
            hypotheses.push(root.hypothesis(origin));
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
}

/// The set of nonnegative numbers.
fn nonnegative() -> Set {
    let zero = Bound {
        value: rational::integer(0).into(),
        closed: true,
    };
    Set::Real(Box::new(Interval {
        lower: Some(zero),
        ..Interval::default()
    }))
}

fn has_root(term: &Term) -> bool {
    term.applies(BuiltIn::SquareRoot) || term.applies(BuiltIn::Norm)
}

/// The symbol of a root, and its radicand.
struct Root {
    name: Arc<str>,
    radicand: Term,
}

impl Root {
    /// `w^2 == r`.
    fn hypothesis(self, origin: &Origin) -> Hypothesis {
        let place = self.radicand.place;
        let two = made(Node::Number(integer(2)), place);
        let symbol = made(Node::Symbol(self.name), place);
        Hypothesis {
            statement: Statement::Compare {
                relation: Relation::Equal,
                left: made(Node::Binary(Operator::Power, symbol, two), place),
                right: self.radicand,
            },
            source: Source::Root,
            origin: origin.clone(),
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
    roots: Vec<Root>,
    /// The symbols of the roots, by the keys of their radicands.
    names: BTreeMap<String, Arc<str>>,
    made: u32,
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

    /// Replaces the roots in a term by symbols. Roots that depend on the variable of an enclosing derivative are left
    /// unchanged; the derivative expands them.
    fn term(&mut self, term: &Term, scope: &Scope) -> Result<Term, Fault> {
        if !has_root(term) {
            return Ok(term.clone());
        }
        self.nodes += 1;
        if self.nodes > MAX_NODES {
            return Err(Fault::limit(term.place, "a formula with too many roots"));
        }
        match &*term.node {
            Node::Apply(BuiltIn::SquareRoot, items) if items.len() == 1 => {
                let items = self.all(items, scope)?;
                let radicand = items.into_iter().next();
                let radicand = radicand.ok_or_else(|| nothing(term.place))?;
                self.root(radicand, term.place, scope)
            }
            Node::Apply(BuiltIn::Norm, items) if items.len() == 1 => {
                let items = self.all(items, scope)?;
                let pair = items.first().cloned().into_iter().chain(items);
                let square = Node::Apply(BuiltIn::Dot, pair.collect());
                self.root(made(square, term.place), term.place, scope)
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
                name, origin, body, ..
            } => {
                let body = self.term(body, scope).map_err(|f| f.within(origin))?;
                let node = Node::Opened {
                    name: Arc::clone(name),
                    origin: Arc::clone(origin),
                    closed: body.is_closed(),
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

    /// The symbol of the root of a radicand in which roots have been replaced already.
    fn root(&mut self, radicand: Term, place: Place, scope: &Scope) -> Result<Term, Fault> {
        let radicand = named(&radicand, scope);
        let bound = |kind: fn(&Binder) -> bool| {
            let of_kind = scope.iter().filter(|(_, binder)| kind(binder));
            let mut numbers = of_kind.map(|(number, _)| *number);
            numbers.any(|number| mentions(&radicand, number))
        };
        if bound(|binder| matches!(binder, Binder::Index)) {
            let what = "a root that depends on the index of a sum";
            return Err(Fault::limit(place, what));
        }
        if bound(|binder| matches!(binder, Binder::Integration)) {
            let what = "a root that depends on the variable of an integral: write it without the root, and integrate that";
            return Err(Fault::limit(place, what));
        }
        let moves = bound(|binder| matches!(binder, Binder::Differential));
        if moves || part::is_number(&radicand) {
            let node = Node::Apply(BuiltIn::SquareRoot, vec![radicand]);
            return Ok(made(node, place));
        }
        let key = key(&radicand).ok_or_else(|| Fault::limit(place, "so large a radicand"))?;
        if let Some(name) = self.names.get(&key) {
            return Ok(made(Node::Symbol(Arc::clone(name)), place));
        }
        if self.roots.len() >= MAX_ROOTS {
            let what = format!("more than {MAX_ROOTS} different roots");
            return Err(Fault::limit(place, what));
        }
        let taken = |name: &str| self.roots.iter().any(|root| *root.name == *name);
        let name = name::root_text(&radicand).filter(|name| !taken(name));
        let name = name.unwrap_or_else(|| format!("\u{221a}{}", self.roots.len() + 1));
        let name: Arc<str> = name.into();
        self.names.insert(key, Arc::clone(&name));
        self.roots.push(Root {
            name: Arc::clone(&name),
            radicand,
        });
        Ok(made(Node::Symbol(name), place))
    }

    /// The body of a derivative, in which roots that depend on its variable are replaced by their Taylor polynomials.
    fn expanded(&mut self, term: &Term, around: &Around<'_>) -> Result<Term, Fault> {
        if !term.applies(BuiltIn::SquareRoot) || !mentions(term, around.variable.number()) {
            return Ok(term.clone());
        }
        match &*term.node {
            Node::Apply(BuiltIn::SquareRoot, items) => match items.as_slice() {
                [radicand] => {
                    let moved = self.expanded(radicand, around)?;
                    self.series(radicand, &moved, around)
                }
                _ => Err(nothing(term.place)),
            },
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
                name, origin, body, ..
            } => {
                let body = self.expanded(body, around)?;
                let node = Node::Opened {
                    name: Arc::clone(name),
                    origin: Arc::clone(origin),
                    closed: body.is_closed(),
                    body,
                };
                Ok(made(node, term.place))
            }
            _ => term.with_parts(&mut |part| self.expanded(part, around)),
        }
    }

    /// The Taylor polynomial of a root; `expanded` is the radicand with its own roots expanded.
    fn series(
        &mut self,
        radicand: &Term,
        expanded: &Term,
        around: &Around<'_>,
    ) -> Result<Term, Fault> {
        let place = radicand.place;
        let order = around.order.filter(|order| *order <= MAX_ORDER);
        let order = order.ok_or_else(|| {
            let what =
                format!("a root under a derivative that is not of an order up to {MAX_ORDER}");
            Fault::limit(place, what)
        })?;
        let number = |n: u32| made(Node::Number(integer(i64::from(n))), place);
        let at_point = replaced(radicand, around.variable.number(), around.at);
        let at_point = self.term(&at_point, around.scope)?;
        let mut coefficients = vec![self.root(at_point, place, around.scope)?];
        let twice = binary(
            Operator::Multiply,
            number(2),
            coefficients_first(&coefficients)?,
        );
        let mut factorial = 1;
        for k in 1..=order {
            factorial *= k;
            let rate = self.rate(expanded, k, around);
            let mut left = binary(Operator::Divide, rate, number(factorial));
            let before = coefficients.iter().skip(1);
            for (a, b) in before.clone().zip(before.rev()) {
                let product = binary(Operator::Multiply, a.clone(), b.clone());
                left = binary(Operator::Subtract, left, product);
            }
            coefficients.push(binary(Operator::Divide, left, twice.clone()));
        }
        let variable = made(Node::Variable(around.variable.clone()), place);
        let step = binary(Operator::Subtract, variable, around.at.clone());
        let mut terms = coefficients.into_iter().zip(0..);
        let first = terms.next().ok_or_else(|| nothing(place))?.0;
        Ok(terms.fold(first, |sum, (coefficient, k)| {
            let power = binary(Operator::Power, step.clone(), number(k));
            let product = binary(Operator::Multiply, coefficient, power);
            binary(Operator::Add, sum, product)
        }))
    }

    /// The derivative of the radicand of the given order at the point.
    fn rate(&mut self, radicand: &Term, order: u32, around: &Around<'_>) -> Term {
        let place = radicand.place;
        let variable = Variable {
            number: FIRST_VARIABLE.saturating_add(self.made),
            name: Arc::clone(&around.variable.name),
        };
        self.made += 1;
        let own = made(Node::Variable(variable.clone()), place);
        let body = replaced(radicand, around.variable.number(), &own);
        let node = Node::Derivative {
            order: made(Node::Number(integer(i64::from(order))), place),
            closed: body.is_closed_but_for(variable.number()),
            variable,
            body,
            at: around.at.clone(),
        };
        made(node, place)
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

fn coefficients_first(all: &[Term]) -> Result<Term, Fault> {
    all.first()
        .cloned()
        .ok_or_else(|| nothing(Place::default()))
}

fn nothing(place: Place) -> Fault {
    Fault::limit(place, "a root of nothing")
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
