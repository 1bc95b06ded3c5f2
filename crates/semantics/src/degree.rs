//! The degree of a term in some symbols, as far as its form shows it.
//!
//! A formula that is made of the symbols, and of parts without them, by sums, products and multiples is a polynomial in the
//! symbols whatever the other parts are worth. Where its degree is one at most, it is linear in all symbols together: each
//! coefficient is what the formula is worth where one symbol is 1 and the others are 0, less what it is worth where all are 0.
//! It divides by nothing and raises nothing to a power that depends on the symbols, so that it is defined there where it is
//! defined anywhere else.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_language::core::{BuiltIn, Node, Term};
use torse_language::syntax::Operator;

/// How deep terms may be nested, not counting chains of one operator.
const MAX_DEPTH: usize = 300;
/// The most parts that are looked at: what takes more is not linear at sight.
const MAX_PARTS: usize = 20_000;

/// Whether forms are linear in symbols, all together, by their form: these are the names under which the symbols are declared.
pub(crate) fn is_linear(forms: &Term, symbols: &BTreeSet<Arc<str>>) -> bool {
    let mut walk = Walk {
        symbols,
        bound: BTreeMap::new(),
        known: BTreeMap::new(),
        parts: 0,
    };
    walk.degree(forms, MAX_DEPTH)
        .is_some_and(|degree| degree <= 1)
}

/// A degree; `None` for what is no polynomial at sight, or one of a degree above one.
type Degree = Option<u32>;

struct Walk<'a> {
    symbols: &'a BTreeSet<Arc<str>>,
    /// Degrees of the values of variables, as the innermost binders of each have them.
    bound: BTreeMap<u32, Degree>,
    /// Degrees of terms while the variables have these degrees, by their addresses: formulas share the definitions that they
    /// use.
    known: BTreeMap<usize, Degree>,
    /// The parts looked at.
    parts: usize,
}

/// The degree of a product.
fn product(a: Degree, b: Degree) -> Degree {
    Some(a? + b?).filter(|degree| *degree <= 1)
}

/// The degree of a sum.
fn sum(a: Degree, b: Degree) -> Degree {
    Some(a?.max(b?))
}

impl Walk<'_> {
    fn degree(&mut self, term: &Term, depth: usize) -> Degree {
        let depth = depth.checked_sub(1)?;
        let key = Arc::as_ptr(&term.node).addr();
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        self.parts += 1;
        if self.parts > MAX_PARTS {
            return None;
        }
        let degree = self.node(term, depth);
        self.known.insert(key, degree);
        degree
    }

    /// The degree of a body in which a variable has a value of this degree. The calls of a function share its body, with other
    /// values of its parameters: what was found for one of them does not serve the next.
    fn under(&mut self, variable: u32, value: Degree, body: &Term, depth: usize) -> Degree {
        let before = self.bound.insert(variable, value);
        let other = before.filter(|before| *before != value);
        if other.is_some() {
            self.known.clear();
        }
        let degree = self.degree(body, depth);
        if let Some(other) = other {
            self.bound.insert(variable, other);
            self.known.clear();
        }
        degree
    }

    fn of_symbol(&self, name: &Arc<str>) -> Degree {
        Some(u32::from(self.symbols.contains(name)))
    }

    /// Degree zero if none of the terms has another one.
    fn free<'t>(&mut self, terms: impl IntoIterator<Item = &'t Term>, depth: usize) -> Degree {
        let mut terms = terms.into_iter();
        let free = terms.all(|term| self.degree(term, depth) == Some(0));
        free.then_some(0)
    }

    fn node(&mut self, term: &Term, depth: usize) -> Degree {
        match &*term.node {
            Node::Number(_) | Node::Pi => Some(0),
            Node::Symbol(name) | Node::Vector(name, _) => self.of_symbol(name),
            Node::Variable(variable) => *self.bound.get(&variable.number())?,
            Node::Member(points, indices) => {
                self.free(indices, depth)?;
                self.of_symbol(&points.name)
            }
            Node::Basis {
                index,
                degree,
                arguments,
                ..
            } => {
                // Seeds and steps may name declared symbols.
                let mut names = false;
                term.declared_names(&mut |name| names |= self.symbols.contains(name));
                self.free(arguments.iter().chain([index, degree]), depth)
                    .filter(|_| !names)
            }
            Node::Negative(inner) => self.degree(inner, depth),
            Node::Binary(..) => self.chain(term, depth),
            Node::List(items) => {
                let mut items = items.iter();
                items.try_fold(0, |all, item| sum(Some(all), self.degree(item, depth)))
            }
            Node::Entry(of, indices) => {
                self.free(indices, depth)?;
                self.degree(of, depth)
            }
            Node::Sum {
                index,
                low,
                high,
                term,
            } => {
                self.free([low, high], depth)?;
                self.under(index.number(), Some(0), term, depth)
            }
            Node::Product {
                index,
                low,
                high,
                term,
            } => {
                self.free([low, high], depth)?;
                let factor = self.under(index.number(), Some(0), term, depth);
                factor.filter(|degree| *degree == 0)
            }
            Node::Integral {
                variable,
                low,
                high,
                body,
            } => {
                self.free([low, high], depth)?;
                self.under(variable.number(), Some(0), body, depth)
            }
            Node::Let {
                variable,
                value,
                body,
            } => {
                let value = self.degree(value, depth);
                self.under(variable.number(), value, body, depth)
            }
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => {
                self.free([order, at], depth)?;
                self.under(variable.number(), Some(0), body, depth)
            }
            Node::Apply(BuiltIn::Dot | BuiltIn::Cross, arguments) => {
                let mut arguments = arguments.iter();
                arguments.try_fold(0, |all, factor| {
                    product(Some(all), self.degree(factor, depth))
                })
            }
            Node::Apply(BuiltIn::Transpose, arguments) => {
                let [matrix] = arguments.as_slice() else {
                    return None;
                };
                self.degree(matrix, depth)
            }
            // What coefficients are asked for may not be a symbol of another one that is moved.
            Node::Apply(BuiltIn::Coefficients, _) => {
                let mut names = false;
                term.declared_names(&mut |name| names |= self.symbols.contains(name));
                (!names && term.is_closed()).then_some(0)
            }
            Node::Apply(_, arguments) => self.free(arguments, depth),
            Node::Opened { body, .. } => self.degree(body, depth),
        }
    }

    /// A chain of operators, whose left operands are walked without recursion.
    fn chain(&mut self, term: &Term, depth: usize) -> Degree {
        let (mut rights, mut left) = (vec![], term);
        while let Node::Binary(operator, a, b) = &*left.node {
            rights.push((*operator, b));
            left = a;
        }
        let mut degree = self.degree(left, depth);
        while let Some((operator, right)) = rights.pop() {
            let other = self.degree(right, depth);
            degree = match operator {
                Operator::Add | Operator::Subtract => sum(degree, other),
                Operator::Multiply => product(degree, other),
                Operator::Divide => degree.filter(|_| other == Some(0)),
                Operator::Power => degree.filter(|degree| *degree == 0 && other == Some(0)),
            };
        }
        degree
    }
}
