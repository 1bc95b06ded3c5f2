//! The places at which smooth functions are taken, and which of them are certainly different.

use super::{Lowering, Pure, Scope};
use crate::elaborator::Outcome;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core::{Node, Term};
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::{Rational, rational};
use torse_syntax::derivation::declarations::{Bound, Declarations, Interval, SymbolKind};
use torse_syntax::formula::{self, Expr, Operator};

/// The place of an argument, and how far the variables of enclosing derivatives lead away from it.
#[derive(Debug, Clone)]
pub(in crate::elaborator) struct At {
    /// The place as a formula in declared symbols.
    pub(super) name: Expr,
    /// The same, as a term.
    pub(super) place: Term,
    /// What is known of it.
    pub(super) kind: Kind,
    /// The argument minus the place.
    pub(super) difference: Difference,
    /// The orders of the derivatives around it that move the argument, by their variables. What is moved by several of them
    /// is differentiated by all.
    pub(super) orders: BTreeMap<u32, usize>,
}

impl At {
    /// How often the derivatives around it may differentiate the argument, all together.
    pub(super) fn order(&self) -> usize {
        let orders = self.orders.values();
        if injected(InjectedFault::OrdersByMaximum) {
            return orders.copied().max().unwrap_or(0);
        }
        orders.fold(0, |sum: usize, order| sum.saturating_add(*order))
    }
}

/// An argument minus its place.
#[derive(Debug, Clone)]
pub(in crate::elaborator) enum Difference {
    /// They are the same.
    Nothing,
    /// This term.
    Term(Term),
    /// Not written yet.
    Open,
}

/// What tells places apart.
#[derive(Debug, Clone)]
pub(in crate::elaborator) enum Kind {
    /// A rational number.
    Number(Rational),
    /// The value of a declared symbol.
    Symbol(Arc<str>),
    /// The value of a formula.
    Formula,
}

impl Lowering<'_, '_> {
    /// The same with the difference written, from a term that has the value of the argument.
    pub(super) fn settled(&self, mut at: At, argument: Term) -> At {
        if matches!(at.difference, Difference::Open) {
            let difference = self.binary(Operator::Subtract, argument, at.place.clone());
            at.difference = Difference::Term(difference);
        }
        at
    }

    /// The place of a term; none if it takes no place of a function. A place has a value for all values of the symbols, since
    /// the symbol that stands for a derivative there has one.
    pub(super) fn at(&self, term: &Term, scope: &Scope) -> Outcome<Option<At>> {
        self.count(term.place)?;
        let still = |name: Expr, kind: Kind| At {
            name,
            place: term.clone(),
            kind,
            difference: Difference::Nothing,
            orders: BTreeMap::new(),
        };
        Ok(match &*term.node {
            Node::Number(value) => Some(still(Expr::number(value), Kind::Number(value.clone()))),
            Node::Symbol(name) => Some(still(Expr::name(name), Kind::Symbol(Arc::clone(name)))),
            Node::Variable(variable) => scope.get(&variable.number()).cloned().flatten(),
            Node::Opened { body, .. } => self.at(body, scope)?,
            Node::Let {
                variable,
                value,
                body,
            } => {
                let Some(value) = self.at(value, scope)? else {
                    return Ok(None);
                };
                let mut inside = scope.clone();
                inside.insert(variable.number(), Some(value));
                self.at(body, &inside)?
            }
            Node::Negative(inner) => match self.at(inner, scope)? {
                Some(inner) => {
                    let name = formula::Node::Negative(Arc::new(inner.name.clone()));
                    let place = Node::Negative(inner.place.clone());
                    let kind = match &inner.kind {
                        Kind::Number(value) => Kind::Number(-value.clone()),
                        _ => Kind::Formula,
                    };
                    Some(self.composed(term, name, place, kind, &[&inner]))
                }
                None => None,
            },
            Node::Binary(operator, a, b) => match (self.at(a, scope)?, self.at(b, scope)?) {
                (Some(a), Some(b)) if is_total(*operator, &b.kind) => {
                    let name = formula::Node::Binary(
                        *operator,
                        Arc::new(a.name.clone()),
                        Arc::new(b.name.clone()),
                    );
                    let place = Node::Binary(*operator, a.place.clone(), b.place.clone());
                    let kind = quotient(*operator, &a.kind, &b.kind);
                    Some(self.composed(term, name, place, kind, &[&a, &b]))
                }
                _ => None,
            },
            node => match self.function(node) {
                Some((function, Some(1), argument)) => match self.at(argument, scope)? {
                    Some(inner) => {
                        let pure = Pure {
                            function: Arc::clone(function),
                            dimension: Some(1),
                            order: 0,
                            argument: super::Argument::At(Box::new(inner.clone())),
                        };
                        let head = Arc::new(Expr::name(function));
                        let name = formula::Node::Call(head, vec![inner.name.clone()]);
                        let jet = self.elaborator.jet(&pure, 0, &inner, term.place)?;
                        Some(self.composed(term, name, jet, Kind::Formula, &[&inner]))
                    }
                    None => None,
                },
                _ => None,
            },
        })
    }

    /// The place of what is made of others.
    fn composed(
        &self,
        term: &Term,
        name: formula::Node,
        place: Node,
        kind: Kind,
        parts: &[&At],
    ) -> At {
        let same = |part: &&At| matches!(part.difference, Difference::Nothing);
        At {
            name: match &kind {
                Kind::Number(value) => Expr::number(value),
                _ => Expr::made(name),
            },
            place: self.made(place, term.place),
            kind,
            difference: match parts.iter().all(same) {
                true => Difference::Nothing,
                false => Difference::Open,
            },
            orders: {
                let orders = parts.iter().flat_map(|part| &part.orders);
                orders
                    .map(|(variable, order)| (*variable, *order))
                    .collect()
            },
        }
    }
}

/// Whether two places of a function are different for all values in the declared sets.
pub(in crate::elaborator) fn apart(declarations: &Declarations, one: &Kind, other: &Kind) -> bool {
    let set = |kind: &Kind| match kind {
        Kind::Number(value) => {
            let end = || {
                Some(Bound {
                    value: value.clone().into(),
                    closed: true,
                })
            };
            Some(Interval {
                lower: end(),
                upper: end(),
                ..Interval::default()
            })
        }
        Kind::Symbol(name) => match declarations.symbol(name) {
            Some(SymbolKind::Real(interval)) => Some((**interval).clone()),
            _ => None,
        },
        Kind::Formula => None,
    };
    let (Some(one), Some(other)) = (set(one), set(other)) else {
        return false;
    };
    below(&one, &other) || below(&other, &one)
}

/// Whether all of an interval with rational ends is below all of another one.
fn below(low: &Interval, high: &Interval) -> bool {
    let (Some(upper), Some(lower)) = (&low.upper, &high.lower) else {
        return false;
    };
    match (upper.value.as_rational(), lower.value.as_rational()) {
        (Some(end), Some(start)) => end < start || end == start && !(upper.closed && lower.closed),
        _ => false,
    }
}

/// Whether the operation always has a value.
fn is_total(operator: Operator, second: &Kind) -> bool {
    match (operator, second) {
        (Operator::Divide, Kind::Number(b)) => *b != rational::integer(0),
        (Operator::Power, Kind::Number(b)) => b.is_integer() && *b >= rational::integer(0),
        (Operator::Divide | Operator::Power, _) => false,
        _ => true,
    }
}

/// A quotient of numbers is a number, which may be written in several ways.
fn quotient(operator: Operator, a: &Kind, b: &Kind) -> Kind {
    match (operator, a, b) {
        (Operator::Divide, Kind::Number(a), Kind::Number(b)) if *b != rational::integer(0) => {
            Kind::Number(a / b)
        }
        _ => Kind::Formula,
    }
}

/// The number that a term is written as.
pub(in crate::elaborator) fn is_literal(term: &Term) -> Option<usize> {
    match &*term.node {
        Node::Number(value) if value.is_integer() => usize::try_from(&value.to_integer()).ok(),
        _ => None,
    }
}
