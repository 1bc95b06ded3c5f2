//! Arbitrary smooth functions, replaced by their jets (values and derivatives at points).
//!
//! A declared smooth function is any function with derivatives of all orders, and a formula evaluates a few of its
//! derivatives at a few places. By Taylor's theorem the derivatives of a formula at a place depend on those of the
//! function there, up to the order of the derivative, and on nothing else. By Hermite interpolation there is a
//! polynomial, hence a smooth function, with any given derivatives up to a finite order at finitely many different
//! places. So "for all smooth functions" is equivalent to "for all values of `c(u)`, `c'(u)`, `c''(u)`, ...", and
//! these become symbols like any others.
//!
//! While formulas are opened, `c(t)` is a member of the family of the values of c: [`Node::Member`] with the index t.
//! Then these members are replaced:
//!
//! `c^(k)(u)`, outside of any derivative: by the symbol of this name;
//! * inside of derivatives by variables in t, Taylor's polynomial about the place, whose degree is the sum of their orders: a
//!   mixed derivative of the orders m and n sees m + n derivatives of the function. A derivative
//!   whose formula sees such a function is taken by the difference from the place, `D(e(x), x)` at u as `D(e(u + h), h)` at 0,
//!   which keeps the polynomials short.
//!
//! Two places of one function have to be different for all values in the declared sets. Otherwise the values there
//! are not independent, and the formula is refused.

mod place;

use super::{Elaborator, Lambda, MAX_NODES, Outcome};
pub(super) use place::At;
use place::{Difference, apart, is_literal};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core::{Node, Points, Statement, Term, Variable};
use torse_numbers::rational;
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Expr, Operator, Place};
use torse_syntax::notation;

/// The largest order of a derivative of a smooth function.
const MAX_ORDER: usize = 12;

/// The places of the variables of enclosing binders; `None` for a variable that is no place of a function.
type Scope = BTreeMap<u32, Option<At>>;

/// A derivative of a smooth function, before its argument is resolved to a place.
struct Pure {
    function: Arc<str>,
    dimension: Option<u8>,
    order: usize,
    argument: Argument,
}

/// The argument of a [`Pure`] derivative.
#[derive(Clone)]
enum Argument {
    /// The variable of this number.
    Variable(u32),
    /// A place.
    At(Box<At>),
}

impl Elaborator<'_> {
    /// The declared smooth function of this name, as the family of its values.
    pub(super) fn smooth(&self, name: &str, dimension: Option<u8>, place: Place) -> Lambda {
        let name: Arc<str> = Arc::from(name);
        let parameter = self.fresh("x");
        let values = Points {
            name: Arc::clone(&name),
            dimension,
            ranges: vec![],
        };
        let argument = self.made(Node::Variable(parameter.clone()), place);
        Lambda {
            name,
            parameters: vec![parameter],
            body: self.made(Node::Member(Arc::new(values), vec![argument]), place),
        }
    }

    /// Replaces the smooth functions in a term by their jets.
    pub(super) fn in_jets(&self, term: Term) -> Outcome<Term> {
        if !self.declarations().has_functions() {
            return Ok(term);
        }
        let work = Lowering {
            elaborator: self,
            mentions: RefCell::default(),
            nodes: Cell::new(0),
        };
        work.term(&term, &Scope::new())
    }

    /// Replaces the smooth functions in a statement by their jets.
    pub(super) fn statement_in_jets(&self, statement: Statement) -> Outcome<Statement> {
        if !self.declarations().has_functions() {
            return Ok(statement);
        }
        statement.try_mapped(&|term| self.in_jets(term.clone()))
    }

    /// The symbol of a derivative of a function at a place. Records the place, and fails unless it is different from
    /// all other places of the function.
    fn jet(&self, pure: &Pure, order: usize, at: &At, place: Place) -> Outcome<Node> {
        let mut places = self.places.borrow_mut();
        let known_places = places.entry(Arc::clone(&pure.function)).or_default();
        let argument = notation::text(&at.name);
        if !known_places.contains_key(&argument) {
            for (other, before) in known_places.iter() {
                if !apart(self.declarations(), &before.kind, &at.kind) {
                    let function = &pure.function;
                    return Err(Fault::limit(
                        place,
                        format!(
                            "`{function}` at `{argument}` beside `{function}` at `{other}`, which may be the same place: \
                             declare them in sets that have no point in common"
                        ),
                    ));
                }
            }
            known_places.insert(argument, at.clone());
        }
        let head = Expr::name(&format!("{}{}", pure.function, "'".repeat(order)));
        let call = torse_syntax::formula::Node::Call(Arc::new(head), vec![at.name.clone()]);
        let name: Arc<str> = notation::text(&Expr::made(call)).into();
        Ok(match pure.dimension {
            Some(1) => Node::Symbol(name),
            dimension => Node::Vector(name, dimension),
        })
    }
}

/// One traversal of a term.
struct Lowering<'e, 'a> {
    elaborator: &'e Elaborator<'a>,
    mentions: RefCell<BTreeMap<usize, bool>>,
    nodes: Cell<u64>,
}

impl Lowering<'_, '_> {
    fn made(&self, node: Node, place: Place) -> Term {
        self.elaborator.made(node, place)
    }

    fn integer(&self, value: i64, place: Place) -> Term {
        self.made(Node::Number(rational::integer(value)), place)
    }

    fn binary(&self, operator: Operator, a: Term, b: Term) -> Term {
        let place = a.place;
        self.made(Node::Binary(operator, a, b), place)
    }

    fn count(&self, place: Place) -> Outcome<()> {
        self.nodes.set(self.nodes.get() + 1);
        if self.nodes.get() > MAX_NODES {
            let what = format!("the formula opens to more than {MAX_NODES} terms");
            return Err(Fault::limit(place, what));
        }
        Ok(())
    }

    /// The smooth function whose value this node is, with its dimension and its argument.
    fn function<'t>(&self, node: &'t Node) -> Option<(&'t Arc<str>, Option<u8>, &'t Term)> {
        let Node::Member(points, indices) = node else {
            return None;
        };
        let [argument] = indices.as_slice() else {
            return None;
        };
        let is_function = self
            .elaborator
            .declarations()
            .function(&points.name)
            .is_some();
        is_function.then_some((&points.name, points.dimension, argument))
    }

    /// Whether a smooth function occurs. The answer is cached for shared parts.
    fn mentions(&self, term: &Term) -> bool {
        let key = Arc::as_ptr(&term.node).addr();
        if let Some(known) = self.mentions.borrow().get(&key) {
            return *known;
        }
        let found = self.function(&term.node).is_some()
            || term.parts().into_iter().any(|part| self.mentions(part))
            || match &*term.node {
                Node::Basis { family, .. } => {
                    let steps = [&family.step.0, &family.step.1];
                    let mut parts = family.seeds.iter().chain(steps);
                    parts.any(|part| self.mentions(part))
                }
                _ => false,
            };
        self.mentions.borrow_mut().insert(key, found);
        found
    }

    fn term(&self, term: &Term, scope: &Scope) -> Outcome<Term> {
        if !self.mentions(term) {
            return Ok(term.clone());
        }
        let place = term.place;
        self.count(place)?;
        if let Some(pure) = self.pure(term, scope, &BTreeMap::new())
            && let Some(at) = self.found(&pure.argument, scope)
        {
            return self.taylor(&pure, &at, place);
        }
        match &*term.node {
            node if self.function(node).is_some() => Err(Fault::limit(
                place,
                "a smooth function at what is no symbol or number, nor a sum, a product, a part or a power of these and other \
                 smooth functions",
            )),
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => self.derivative(variable, order, body, at, place, scope),
            Node::Let {
                variable,
                value,
                body,
            } => {
                let mut inside = scope.clone();
                let own = self.made(Node::Variable(variable.clone()), place);
                let at = self.at(value, scope)?.map(|at| self.settled(at, own));
                inside.insert(variable.number(), at);
                let node = Node::Let {
                    variable: variable.clone(),
                    value: self.term(value, scope)?,
                    body: self.term(body, &inside)?,
                };
                Ok(self.made(node, place))
            }
            Node::Sum { index: bound, .. }
            | Node::Product { index: bound, .. }
            | Node::Integral {
                variable: bound, ..
            } => {
                let mut inside = scope.clone();
                inside.insert(bound.number(), None);
                term.with_parts(&mut |part| self.term(part, &inside))
            }
            Node::Basis { family, .. } => {
                let steps = [&family.step.0, &family.step.1];
                if family.seeds.iter().chain(steps).any(|t| self.mentions(t)) {
                    let what = "a smooth function in the seeds or the step of a basis";
                    return Err(Fault::limit(place, what));
                }
                term.with_parts(&mut |part| self.term(part, scope))
            }
            Node::Opened { origin, .. } => term
                .with_parts(&mut |part| self.term(part, scope))
                .map_err(|f| f.within(origin)),
            _ => term.with_parts(&mut |part| self.term(part, scope)),
        }
    }

    /// `D(e(x), x, n)` at u is `D(e(u + h), h, n)` at 0.
    fn derivative(
        &self,
        variable: &Variable,
        order: &Term,
        body: &Term,
        at: &Term,
        place: Place,
        scope: &Scope,
    ) -> Outcome<Term> {
        let outside = self.term(at, scope)?;
        let difference = self.elaborator.fresh(variable.name());
        let step = self.made(Node::Variable(difference.clone()), place);
        let mut inside = scope.clone();
        let moved_place = match (self.at(at, scope)?, is_literal(order)) {
            (Some(moved_place), Some(order)) => {
                let mut moved_place = self.settled(moved_place, outside.clone());
                moved_place.orders.insert(difference.number(), order);
                moved_place.difference = Difference::Term(match moved_place.difference {
                    Difference::Term(before) => self.binary(Operator::Add, before, step.clone()),
                    _ => step.clone(),
                });
                Some(moved_place)
            }
            _ => None,
        };
        inside.insert(variable.number(), moved_place);
        let moved = Node::Let {
            variable: variable.clone(),
            value: self.binary(Operator::Add, outside, step),
            body: self.term(body, &inside)?,
        };
        let moved = self.made(moved, place);
        let node = Node::Derivative {
            order: self.term(order, scope)?,
            closed: moved.is_closed_but_for(difference.number()),
            variable: difference,
            body: moved,
            at: self.integer(0, place),
        };
        Ok(self.made(node, place))
    }

    /// The Taylor polynomial of a function about a place, up to the total order of the enclosing derivatives.
    fn taylor(&self, pure: &Pure, at: &At, place: Place) -> Outcome<Term> {
        let order = at.order();
        if pure.order.saturating_add(order) > MAX_ORDER {
            let what = format!("a smooth function differentiated more than {MAX_ORDER} times");
            return Err(Fault::limit(place, what));
        }
        let jet = |j: usize| {
            let node = self.elaborator.jet(pure, pure.order + j, at, place)?;
            Ok(self.made(node, place))
        };
        let mut sum = jet(0)?;
        let Difference::Term(difference) = &at.difference else {
            return Ok(sum);
        };
        let mut factorial = rational::integer(1);
        for j in 1..=order {
            let exponent = i64::try_from(j).unwrap_or(i64::MAX);
            factorial *= rational::integer(exponent);
            let power = match j {
                1 => difference.clone(),
                _ => {
                    let exponent = self.integer(exponent, place);
                    self.binary(Operator::Power, difference.clone(), exponent)
                }
            };
            let share = self.made(Node::Number(factorial.recip()), place);
            let weight = self.binary(Operator::Multiply, share, power);
            let term = self.binary(Operator::Multiply, weight, jet(j)?);
            sum = self.binary(Operator::Add, sum, term);
        }
        Ok(sum)
    }

    /// Recognizes a term that is nothing but a derivative of a smooth function.
    fn pure(
        &self,
        term: &Term,
        scope: &Scope,
        names: &BTreeMap<u32, Option<Argument>>,
    ) -> Option<Pure> {
        if let Some((function, dimension, argument)) = self.function(&term.node) {
            return Some(Pure {
                function: Arc::clone(function),
                dimension,
                order: 0,
                argument: self.argument(argument, scope, names)?,
            });
        }
        match &*term.node {
            Node::Opened { body, .. } => self.pure(body, scope, names),
            Node::Let {
                variable,
                value,
                body,
            } => {
                let mut inside = names.clone();
                // The argument must have a value even if the body does not use it.
                inside.insert(variable.number(), Some(self.argument(value, scope, names)?));
                self.pure(body, scope, &inside)
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => {
                let inner = self.pure(body, scope, names)?;
                let own = matches!(inner.argument, Argument::Variable(v) if v == variable.number());
                Some(Pure {
                    order: own.then(|| inner.order.checked_add(is_literal(order)?))??,
                    argument: self.argument(at, scope, names)?,
                    ..inner
                })
            }
            _ => None,
        }
    }

    /// Resolves an argument to a variable or a place.
    fn argument(
        &self,
        term: &Term,
        scope: &Scope,
        names: &BTreeMap<u32, Option<Argument>>,
    ) -> Option<Argument> {
        match &*term.node {
            Node::Variable(variable) => match names.get(&variable.number()) {
                Some(known) => known.clone(),
                None => Some(Argument::Variable(variable.number())),
            },
            // Other terms may contain parameters of the functions in between, which are not resolved here.
            _ if names.is_empty() || term.is_closed() => {
                let at = self.at(term, scope).ok()??;
                let at = match at.difference {
                    Difference::Open => self.settled(at, self.term(term, scope).ok()?),
                    _ => at,
                };
                Some(Argument::At(Box::new(at)))
            }
            _ => None,
        }
    }

    fn found(&self, argument: &Argument, scope: &Scope) -> Option<At> {
        match argument {
            Argument::Variable(number) => scope.get(number)?.clone(),
            Argument::At(at) => Some((**at).clone()),
        }
    }
}
