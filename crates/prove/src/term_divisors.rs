//! What terms divide by, as they are written.
//!
//! An evaluation meets only what it needs: `[1/x, 2][2]` is 2, and `f(1/x, y)` may depend on y alone. But a term with an undefined part
//! is undefined. So the divisors are read from the terms, and each is evaluated by itself.

use crate::evaluate::Evaluator;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_algebra::Polynomial;
use torse_algebra::rational::integer;
use torse_core::{self as core, Node, Term, Variable, Visited};
use torse_syntax::formula::Operator;

/// The most divisors of one statement, the most terms of a sum that are looked at one by one, and the most binders around a divisor.
const MAX_DIVISORS: usize = 64;
const MAX_SUMMANDS: i64 = 8;
const MAX_BINDERS: usize = 16;

/// The values of the divisors of a statement, and of the roots in it, as far as they are formulas: those with the index of a sum of symbolic
/// length, and those in integrals, are left out.
pub(crate) fn term_divisors(
    statement: &core::Statement,
    claim: &core::Claim,
    evaluator: &Evaluator<'_>,
) -> Vec<Polynomial> {
    let mut found = Found::default();
    statement
        .terms()
        .into_iter()
        .for_each(|term| found.visit(term, &[]));
    // A root that occurs in the radicand of another comes first.
    let roots: Vec<_> = claim.roots().collect();
    for (name, radicand) in roots.into_iter().rev() {
        if found.names.contains(name) {
            found.visit(radicand, &[]);
        }
    }
    let values = found.divisors.iter().filter_map(|divisor| {
        let value = evaluator.term(divisor).ok()?;
        let entries = value.entries().into_iter();
        let numerators = entries.map(|entry| Some(entry.as_fraction()?.numerator().clone()));
        numerators.collect::<Option<Vec<Polynomial>>>()
    });
    let mut all: Vec<Polynomial> = values.flatten().collect();
    all.retain(|divisor| divisor.as_constant().is_none());
    all.sort();
    all.dedup();
    all
}

/// The value of a bound variable.
type Bound<'t> = (&'t Variable, Term);

#[derive(Default)]
struct Found {
    divisors: Vec<Term>,
    /// The declared symbols that were met, roots among them.
    names: BTreeSet<Arc<str>>,
    /// Closed terms that were visited.
    seen: Visited,
}

impl Found {
    fn visit(&mut self, term: &Term, bound: &[Bound<'_>]) {
        if self.divisors.len() >= MAX_DIVISORS || bound.len() > MAX_BINDERS {
            return;
        }
        if bound.is_empty() && !self.seen.is_new(term) {
            return;
        }
        match &*term.node {
            Node::Symbol(name) => {
                self.names.insert(Arc::clone(name));
            }
            Node::Binary(operator, a, b) => {
                let divisor = match operator {
                    Operator::Divide => Some(b),
                    Operator::Power if is_negative(b) => Some(a),
                    _ => None,
                };
                self.divisors.extend(divisor.map(|own| closed(own, bound)));
                self.visit(a, bound);
                self.visit(b, bound);
            }
            Node::Let {
                variable,
                value,
                body,
            }
            | Node::Derivative {
                variable,
                at: value,
                body,
                ..
            } => {
                self.visit(value, bound);
                if let Node::Derivative { order, .. } = &*term.node {
                    self.visit(order, bound);
                }
                let inside = [bound, &[(variable, value.clone())]].concat();
                self.visit(body, &inside);
            }
            Node::Sum {
                index,
                low,
                high,
                term: body,
            }
            | Node::Product {
                index,
                low,
                high,
                term: body,
            } => {
                self.visit(low, bound);
                self.visit(high, bound);
                let ends = (whole(low), whole(high));
                match ends {
                    (Some(low), Some(high)) if high.saturating_sub(low) < MAX_SUMMANDS => {
                        for number in low..=high {
                            let value = Term {
                                node: Arc::new(Node::Number(integer(number))),
                                place: body.place,
                            };
                            let inside = [bound, &[(index, value)]].concat();
                            self.visit(body, &inside);
                        }
                    }
                    // A divisor with the index in it has no value here, and is left out.
                    _ => self.visit(body, bound),
                }
            }
            Node::Integral { low, high, .. } => {
                self.visit(low, bound);
                self.visit(high, bound);
            }
            _ => {
                for part in term.parts() {
                    self.visit(part, bound);
                }
            }
        }
    }
}

/// The term with what is bound around it.
fn closed(term: &Term, bound: &[Bound<'_>]) -> Term {
    bound
        .iter()
        .rev()
        .fold(term.clone(), |body, (variable, value)| Term {
            place: body.place,
            node: Arc::new(Node::Let {
                variable: (*variable).clone(),
                value: value.clone(),
                body,
            }),
        })
}

/// Whether an exponent is a negative number.
fn is_negative(exponent: &Term) -> bool {
    match &*exponent.node {
        Node::Number(number) => *number < integer(0),
        Node::Negative(inner) => matches!(&*inner.node, Node::Number(n) if *n > integer(0)),
        _ => false,
    }
}

/// The integer that a term is written as.
fn whole(term: &Term) -> Option<i64> {
    match &*term.node {
        Node::Number(number) if number.is_integer() => number.to_integer().try_into().ok(),
        Node::Negative(inner) => whole(inner)?.checked_neg(),
        _ => None,
    }
}
