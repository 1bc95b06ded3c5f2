//! What terms divide by, as they are written.
//!
//! An evaluation meets only what it needs: `[1/x, 2][2]` is 2, and `f(1/x, y)` may depend on y alone. But a term with an undefined part
//! is undefined. So the divisors are read from the terms, and each is evaluated by itself.

use crate::evaluate::Evaluator;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_algebra::Polynomial;
use torse_algebra::rational::integer;
use torse_core::{self as core, BuiltIn, Node, Term, Variable, Visited};
use torse_elaborate::MAX_SUMMANDS;
use torse_syntax::formula::Operator;

/// The most divisors of one statement, and the most binders around a divisor.
const MAX_DIVISORS: usize = 64;
const MAX_BINDERS: usize = 16;

/// The values of the divisors of a statement, and of the roots in it, as far as they are formulas (that the argument of a
/// logarithm or an arc has a value is part of what it means): those with the index of a sum of symbolic
/// length, and those in integrals, are left out.
pub(crate) fn term_divisors(
    statement: &core::Statement,
    claim: &core::Claim,
    evaluator: &Evaluator<'_>,
) -> Vec<Polynomial> {
    let mut found = Found::visited(statement, evaluator);
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

/// Whether the statement has more divisors than are looked at.
pub(crate) fn has_too_many_divisors(
    statement: &core::Statement,
    evaluator: &Evaluator<'_>,
) -> bool {
    Found::visited(statement, evaluator).is_cut
}

/// Whether something that divides stands in a sum or a product that may be empty: then it is not known where the statement has a value.
pub(crate) fn divides_in_empty_sum(statement: &core::Statement, evaluator: &Evaluator<'_>) -> bool {
    let divides = |node: &Node| match node {
        Node::Binary(Operator::Divide, _, divisor) => divisor.as_integer().is_none_or(|n| n == 0),
        Node::Binary(Operator::Power, _, exponent) => is_negative(exponent),
        Node::Apply(BuiltIn::Inverse | BuiltIn::Solve | BuiltIn::Factorial, _) => true,
        _ => false,
    };
    stands_in_empty_sum(statement, evaluator, &divides)
}

/// Whether a root, a logarithm or an arc stands in a sum or a product that may be empty, which then asks for none.
pub(crate) fn has_root_in_empty_sum(
    statement: &core::Statement,
    evaluator: &Evaluator<'_>,
) -> bool {
    let is_root = |node: &Node| {
        matches!(
            node,
            Node::Apply(
                BuiltIn::SquareRoot | BuiltIn::Logarithm | BuiltIn::ArcTangent | BuiltIn::ArcSine,
                _
            )
        )
    };
    stands_in_empty_sum(statement, evaluator, &is_root)
}

fn stands_in_empty_sum(
    statement: &core::Statement,
    evaluator: &Evaluator<'_>,
    is_wanted: &dyn Fn(&Node) -> bool,
) -> bool {
    let found = Found::new(evaluator);
    let body = |term: &'_ Term| match &*term.node {
        Node::Sum {
            low, high, term, ..
        }
        | Node::Product {
            low, high, term, ..
        } if found.may_be_empty(low, high) => any(vec![term], &|part| is_wanted(&part.node)),
        _ => false,
    };
    any(statement.terms(), &body)
}

/// Whether this is so of a part of the terms. Shared parts are visited once.
fn any(mut pending: Vec<&Term>, is_so: &dyn Fn(&Term) -> bool) -> bool {
    let mut seen = Visited::default();
    while let Some(term) = pending.pop() {
        if is_so(term) {
            return true;
        }
        if seen.is_new(term) {
            pending.extend(term.parts());
        }
    }
    false
}

/// The value of a bound variable.
type Bound<'t> = (&'t Variable, Term);

struct Found<'f, 'e> {
    /// The values of symbols.
    evaluator: &'f Evaluator<'e>,
    divisors: Vec<Term>,
    /// The declared symbols that were met, roots among them.
    names: BTreeSet<Arc<str>>,
    /// Closed terms that were visited.
    seen: Visited,
    /// Whether there were more divisors, or binders around one, than are looked at.
    is_cut: bool,
}

impl<'f, 'e> Found<'f, 'e> {
    fn new(evaluator: &'f Evaluator<'e>) -> Self {
        Self {
            evaluator,
            divisors: vec![],
            names: BTreeSet::new(),
            seen: Visited::default(),
            is_cut: false,
        }
    }

    /// What the terms of a statement divide by.
    fn visited(statement: &core::Statement, evaluator: &'f Evaluator<'e>) -> Self {
        let mut found = Self::new(evaluator);
        let terms = statement.terms().into_iter();
        terms.for_each(|term| found.visit(term, &[]));
        found
    }

    /// The integer that a closed term is, if it is one for all values of its symbols.
    fn integer(&self, term: &Term) -> Option<i64> {
        term.as_integer()
            .or_else(|| self.evaluator.integer_form(term)?.as_number())
    }

    /// Whether a range of integers may be empty.
    fn may_be_empty(&self, low: &Term, high: &Term) -> bool {
        let forms = [low, high].map(|end| self.evaluator.integer_form(end));
        let [Some(low), Some(high)] = forms else {
            return true;
        };
        let least = self.evaluator.declarations.least(&(high - low));
        least.is_none_or(|least| least < 0)
    }

    fn visit(&mut self, term: &Term, bound: &[Bound<'_>]) {
        if self.divisors.len() > MAX_DIVISORS || bound.len() > MAX_BINDERS {
            self.is_cut = true;
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
                let end = |own: &Term| self.integer(&closed(own, bound));
                let ends = (end(low), end(high));
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
        Node::Negative(inner) => is_positive(inner),
        _ => false,
    }
}

/// Whether an exponent is a positive number.
fn is_positive(exponent: &Term) -> bool {
    match &*exponent.node {
        Node::Number(number) => *number > integer(0),
        Node::Negative(inner) => is_negative(inner),
        _ => false,
    }
}
