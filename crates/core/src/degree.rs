//! A syntactic test whether a form is linear in some symbols.
//!
//! `coefficients` has a value where its forms are linear in the symbols. Most forms are linear by the way they are
//! written: sums of products in which a symbol occurs once. For these nothing has to be assumed, and a statement
//! about their coefficients can be negated. About all other forms this module makes no statement.
//!
//! A form that passes the test is a polynomial in the symbols, whatever the values of its other parts: each
//! coefficient is the value of the form where one symbol is 1 and the others are 0, minus its value where all are 0.
//! The form divides by nothing that depends on the symbols, so it is defined at those points if it is defined
//! anywhere for the same values of the other symbols.

use super::{BuiltIn, Node, Term};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_syntax::formula::Operator;

/// The largest number of parts that are visited.
const MAX_PARTS: usize = 50_000;
/// The largest nesting depth of terms; a chain of one operator counts once.
const MAX_DEPTH: usize = 300;

/// Whether the form is a sum of products in which at most one factor contains one of the symbols, while all other
/// factors and all divisors contain none. Symbols are named as declared.
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

/// Upper bounds of the joint degree in some symbols.
struct Degrees<'a> {
    symbols: &'a BTreeSet<Arc<str>>,
    /// The degrees of the variables in scope. All calls of a function share its body and its parameters, whose
    /// degrees differ from call to call, so the degree of a body is not cached.
    variables: BTreeMap<u32, u32>,
    seen: usize,
    depth: usize,
}

impl Degrees<'_> {
    /// An upper bound of the degree of every entry, or `None` if the term is not recognized as a polynomial.
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

    fn degree_of_name(&self, name: &Arc<str>) -> u32 {
        u32::from(self.symbols.contains(name))
    }

    fn node(&mut self, term: &Term) -> Option<u32> {
        match &*term.node {
            Node::Number(_) | Node::Pi => Some(0),
            Node::Symbol(name) | Node::Vector(name, _) => Some(self.degree_of_name(name)),
            Node::Variable(variable) => self.variables.get(&variable.number()).copied(),
            Node::Member(points, indices) => {
                // A family counts as a symbol, although members are independent: for other members the degree is
                // zero, and the bound holds as well.
                self.without(indices)?;
                Some(self.degree_of_name(&points.name))
            }
            Node::Negative(inner) | Node::Opened { body: inner, .. } => self.degree(inner),
            Node::Binary(..) => self.chain(term),
            Node::List(items) => self.max_degree(items),
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
                // The derivative is taken of each coefficient of the polynomial.
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
            // Differentiating by a symbol does not raise the degree in any symbol.
            (BuiltIn::Coefficients, [forms, _]) => self.degree(forms),
            _ => self.without(arguments),
        }
    }

    /// The largest degree bound of the terms.
    fn max_degree<'t>(&mut self, terms: impl IntoIterator<Item = &'t Term>) -> Option<u32> {
        let mut maximum = 0;
        for term in terms {
            maximum = maximum.max(self.degree(term)?);
        }
        Some(maximum)
    }

    /// Zero if the symbols occur in none of the terms; else `None`.
    fn without<'t>(&mut self, terms: impl IntoIterator<Item = &'t Term>) -> Option<u32> {
        self.max_degree(terms).filter(|degree| *degree == 0)
    }
}
