//! Which forms are linear in symbols by the way they are written.
//!
//! `coefficients` has a value where its forms are linear in the symbols. Most are by their form: sums of products in
//! which a symbol stands once. Nothing has to be assumed of these, and a statement about their coefficients can be
//! denied. Of all others nothing is said here.
//!
//! A form that is linear in several symbols together is a polynomial in them whatever its other parts are worth: each
//! coefficient is what the form is worth where one symbol is 1 and the others are 0, less what it is worth where all are 0. It
//! divides by nothing that depends on the symbols, so that it is defined there where it is defined anywhere else.

use super::{BuiltIn, Node, Term};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_syntax::formula::Operator;

/// The most parts that are looked at.
const MAX_PARTS: usize = 50_000;
/// How deep terms may be nested, not counting chains of one operator.
const MAX_DEPTH: usize = 300;

/// Whether a form is a sum of products with at most one factor that has one of the symbols, whose other factors, divisors
/// included, have none. The symbols are named as they are declared.
#[must_use]
pub fn is_linear(form: &Term, symbols: &BTreeSet<Arc<str>>) -> bool {
    let mut degrees = Degrees {
        symbols,
        variables: BTreeMap::new(),
        seen: 0,
        depth: 0,
    };
    degrees.degree(form).is_some_and(|degree| degree <= 1)
}

/// Bounds of the degree in some symbols together.
struct Degrees<'a> {
    symbols: &'a BTreeSet<Arc<str>>,
    /// What is known of the variables in scope. The calls of a function share its body and its parameters, which have the
    /// degrees of one call after the other: nothing is remembered of a body.
    variables: BTreeMap<u32, u32>,
    seen: usize,
    depth: usize,
}

impl Degrees<'_> {
    /// A bound of the degree of every entry; none where the term is not seen to be a polynomial.
    fn degree(&mut self, term: &Term) -> Option<u32> {
        self.seen += 1;
        if self.seen > MAX_PARTS || self.depth >= MAX_DEPTH {
            return None;
        }
        self.depth += 1;
        let degree = self.node(term);
        self.depth -= 1;
        degree
    }

    fn of_name(&self, name: &Arc<str>) -> u32 {
        u32::from(self.symbols.contains(name))
    }

    fn node(&mut self, term: &Term) -> Option<u32> {
        match &*term.node {
            Node::Number(_) | Node::Pi => Some(0),
            Node::Symbol(name) | Node::Vector(name, _) => Some(self.of_name(name)),
            Node::Variable(variable) => self.variables.get(&variable.number()).copied(),
            Node::Member(points, indices) => {
                // Members are free of each other: one that is not meant has degree zero, and this bound is no less.
                self.without(indices)?;
                Some(self.of_name(&points.name))
            }
            Node::Negative(inner) | Node::Opened { body: inner, .. } => self.degree(inner),
            Node::Binary(..) => self.chain(term),
            Node::List(items) => self.most(items),
            Node::Entry(of, indices) => {
                self.without(indices)?;
                self.degree(of)
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
                self.degree(term)
            }
            Node::Let {
                variable,
                value,
                body,
            } => {
                let degree = self.degree(value)?;
                self.variables.insert(variable.number(), degree);
                self.degree(body)
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
                self.degree(body)
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

    /// A chain of operators, whose left operands are walked without recursion.
    fn chain(&mut self, term: &Term) -> Option<u32> {
        let (mut rights, mut left) = (vec![], term);
        while let Node::Binary(operator, a, b) = &*left.node {
            rights.push((*operator, b));
            left = a;
        }
        let mut degree = self.degree(left)?;
        while let Some((operator, right)) = rights.pop() {
            let other = self.degree(right)?;
            degree = match operator {
                Operator::Add | Operator::Subtract => degree.max(other),
                Operator::Multiply => degree.checked_add(other)?,
                Operator::Divide if other == 0 => degree,
                Operator::Power if degree == 0 && other == 0 => 0,
                Operator::Divide | Operator::Power => return None,
            };
        }
        Some(degree)
    }

    fn applied(&mut self, function: BuiltIn, arguments: &[Term]) -> Option<u32> {
        match (function, arguments) {
            (BuiltIn::Dot | BuiltIn::Cross, [a, b]) => self.degree(a)?.checked_add(self.degree(b)?),
            (BuiltIn::Transpose, [matrix]) => self.degree(matrix),
            (BuiltIn::Solve, [matrix, right]) => {
                self.without([matrix])?;
                self.degree(right)
            }
            // A derivative by a symbol has no higher degree in any.
            (BuiltIn::Coefficients, [forms, _]) => self.degree(forms),
            _ => self.without(arguments),
        }
    }

    /// The largest of the bounds.
    fn most<'t>(&mut self, terms: impl IntoIterator<Item = &'t Term>) -> Option<u32> {
        let mut most = 0;
        for term in terms {
            most = most.max(self.degree(term)?);
        }
        Some(most)
    }

    /// Zero for terms in which the symbol does not occur.
    fn without<'t>(&mut self, terms: impl IntoIterator<Item = &'t Term>) -> Option<u32> {
        self.most(terms).filter(|degree| *degree == 0)
    }
}
