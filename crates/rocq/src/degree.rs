//! Which forms are linear in a symbol by the way they are written.
//!
//! `coefficients` has a value where its forms are linear in the symbols. Most are by their form: sums of products in
//! which the symbol stands once. Nothing has to be assumed of these, and a statement about their coefficients can be
//! denied. Of all others nothing is said here.

use std::collections::BTreeMap;
use std::sync::Arc;
use torse_language::core::{BuiltIn, Node, Term};
use torse_language::syntax::Operator;

/// The most parts that are looked at.
const MAX_PARTS: usize = 50_000;

/// Whether a form is a sum of products with at most one factor that has the symbol, whose other factors, divisors
/// included, have it not.
#[must_use]
pub fn is_linear(form: &Term, symbol: &Arc<str>) -> bool {
    let mut degrees = Degrees {
        symbol,
        variables: BTreeMap::new(),
        seen: 0,
    };
    degrees.of(form).is_some_and(|degree| degree <= 1)
}

/// Bounds of the degree in one symbol.
struct Degrees<'a> {
    symbol: &'a Arc<str>,
    /// What is known of the variables in scope.
    variables: BTreeMap<u32, u32>,
    seen: usize,
}

impl Degrees<'_> {
    /// A bound of the degree of every entry; none where the term is not seen to be a polynomial.
    fn of(&mut self, term: &Term) -> Option<u32> {
        self.seen += 1;
        if self.seen > MAX_PARTS {
            return None;
        }
        match &*term.node {
            Node::Number(_) | Node::Pi => Some(0),
            Node::Symbol(name) | Node::Vector(name, _) => Some(u32::from(name == self.symbol)),
            Node::Variable(variable) => self.variables.get(&variable.number()).copied(),
            Node::Member(points, indices) => {
                // Members are free of each other: another one has degree zero, and this bound is no less.
                self.without(indices)?;
                Some(u32::from(points.name == *self.symbol))
            }
            Node::Negative(inner) | Node::Opened { body: inner, .. } => self.of(inner),
            Node::Binary(operator, a, b) => match operator {
                Operator::Add | Operator::Subtract => Some(self.of(a)?.max(self.of(b)?)),
                Operator::Multiply => self.of(a)?.checked_add(self.of(b)?),
                Operator::Divide => {
                    self.without([b])?;
                    self.of(a)
                }
                Operator::Power => self.without([a, b]),
            },
            Node::List(items) => self.most(items),
            Node::Entry(of, indices) => {
                self.without(indices)?;
                self.of(of)
            }
            Node::Product { .. } | Node::Integral { .. } => None,
            Node::Sum {
                index,
                low,
                high,
                term,
            } => {
                self.without([low, high])?;
                self.variables.insert(index.number(), 0);
                self.of(term)
            }
            Node::Let {
                variable,
                value,
                body,
            } => {
                let degree = self.of(value)?;
                self.variables.insert(variable.number(), degree);
                self.of(body)
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => {
                // The coefficients of a polynomial are differentiated one by one.
                self.without([order, at])?;
                self.variables.insert(variable.number(), 0);
                self.of(body)
            }
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => {
                self.without([index, degree])?;
                self.without(arguments)?;
                for variable in family.bound() {
                    self.variables.insert(variable.number(), 0);
                }
                self.without(family.seeds.iter().chain([&family.step.0, &family.step.1]))
            }
            Node::Apply(function, arguments) => self.applied(*function, arguments),
        }
    }

    fn applied(&mut self, function: BuiltIn, arguments: &[Term]) -> Option<u32> {
        match (function, arguments) {
            (BuiltIn::Dot | BuiltIn::Cross, [a, b]) => self.of(a)?.checked_add(self.of(b)?),
            (BuiltIn::Transpose, [matrix]) => self.of(matrix),
            (BuiltIn::Solve, [matrix, right]) => {
                self.without([matrix])?;
                self.of(right)
            }
            // A derivative by a symbol has no higher degree in any.
            (BuiltIn::Coefficients, [forms, _]) => self.of(forms),
            _ => self.without(arguments),
        }
    }

    /// The largest of the bounds.
    fn most<'t>(&mut self, terms: impl IntoIterator<Item = &'t Term>) -> Option<u32> {
        let mut most = 0;
        for term in terms {
            most = most.max(self.of(term)?);
        }
        Some(most)
    }

    /// Zero for terms in which the symbol does not occur.
    fn without<'t>(&mut self, terms: impl IntoIterator<Item = &'t Term>) -> Option<u32> {
        self.most(terms).filter(|degree| *degree == 0)
    }
}
