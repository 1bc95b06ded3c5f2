//! The places at which smooth functions are evaluated, and which places are certainly different.

use super::{Lowering, Pure, Scope};
use crate::elaborator::Outcome;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core::{Node, Term};
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::{Rational, rational};
use torse_syntax::derivation::declarations::{Bound, Declarations, Interval, SymbolKind};
use torse_syntax::formula::{self, Expr, Operator};

/// The place of an argument, and how far enclosing derivatives move the argument away from it.
#[derive(Debug, Clone)]
pub(in crate::elaborator) struct At {
    /// The place as a formula in declared symbols.
    pub(super) name: Expr,
    /// The same formula as a term.
    pub(super) place: Term,
    /// The kind of place, by which places are distinguished.
    pub(super) kind: Kind,
    /// The argument minus the place.
    pub(super) difference: Difference,
    /// The orders of the enclosing derivatives that move the argument, by their variables. An argument that depends
    /// on several of these variables is differentiated by all of them.
    pub(super) orders: BTreeMap<u32, usize>,
}

impl At {
    /// The total order of the enclosing derivatives.
    pub(super) fn order(&self) -> usize {
        let orders = self.orders.values();
        if injected(InjectedFault::OrdersByMaximum) {
            return orders.copied().max().unwrap_or(0);
        }
        orders.fold(0, |sum: usize, order| sum.saturating_add(*order))
    }
}

/// The argument minus its place.
#[derive(Debug, Clone)]
pub(in crate::elaborator) enum Difference {
    /// Zero: the argument is the place.
    Nothing,
    /// This term.
    Term(Term),
    /// Not computed yet.
    Open,
}

/// The kind of a place, by which places are distinguished.
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
    /// Computes the difference if it is open; `argument` is a term with the value of the argument.
    pub(super) fn settled(&self, mut at: At, argument: Term) -> At {
        if matches!(at.difference, Difference::Open) {
            let difference = self.binary(Operator::Subtract, argument, at.place.clone());
            at.difference = Difference::Term(difference);
        }
        at
    }

    /// The place of a term; `None` if the term cannot be a place of a function. A place has a value for all values of
    /// the symbols, because the symbol of the derivative there has one.
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

    /// The place of a term composed of parts whose places are known.
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
            difference: if parts.iter().all(same) {
                Difference::Nothing
            } else {
                Difference::Open
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

/// Whether the interval `low` lies entirely below the interval `high`; both have rational ends.
fn below(low: &Interval, high: &Interval) -> bool {
    let (Some(upper), Some(lower)) = (&low.upper, &high.lower) else {
        return false;
    };
    match (upper.value.as_rational(), lower.value.as_rational()) {
        (Some(end), Some(start)) => end < start || end == start && !(upper.closed && lower.closed),
        _ => false,
    }
}

/// Whether the operation has a value for all operands, given the second one.
fn is_total(operator: Operator, second: &Kind) -> bool {
    match (operator, second) {
        (Operator::Divide, Kind::Number(b)) => *b != rational::integer(0),
        (Operator::Power, Kind::Number(b)) => b.is_integer() && *b >= rational::integer(0),
        (Operator::Divide | Operator::Power, _) => false,
        _ => true,
    }
}

/// The kind of a quotient: quotients of numbers are compared by value, since they can be written in several ways.
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
