//! Arc tangents and arc sines: what defines them, and their Taylor polynomials.

use super::{binary, made};
use crate::{BuiltIn, Hypothesis, Node, Set, Source, Statement, Term};
use std::sync::Arc;
use torse_numbers::Rational;
use torse_numbers::fault_injection::{InjectedFault, injected};
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::{Bound, Constant, Interval};
use torse_syntax::formula::{Operator, Relation};

/// The functions of which an arc is an inverse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ArcFunction {
    /// `atan(r)` is the number w of `(-pi/2, pi/2)` with `sin(w) == r*cos(w)`.
    Tangent,
    /// `asin(r)` is the number w of `[-pi/2, pi/2]` with `sin(w) == r`.
    Sine,
}

/// A symbol that stands for an arc.
#[derive(Debug, Clone, Copy)]
pub struct ArcSymbol<'h> {
    /// What the arc is the inverse of.
    pub function: ArcFunction,
    /// The name of the symbol.
    pub name: &'h Arc<str>,
    /// The argument.
    pub argument: &'h Term,
}

impl ArcFunction {
    /// The set of all values.
    pub(super) fn set(self) -> Set {
        let end = |turns: i64| {
            Some(Bound {
                value: Constant {
                    rational: integer(0),
                    turns: Rational::new(turns.into(), 2.into()),
                },
                closed: self == Self::Sine,
            })
        };
        Set::Real(Box::new(Interval {
            lower: end(-1),
            upper: end(1),
            ..Interval::default()
        }))
    }

    pub(super) fn built_in(self) -> BuiltIn {
        match self {
            Self::Tangent => BuiltIn::ArcTangent,
            Self::Sine => BuiltIn::ArcSine,
        }
    }

    /// The sides of the equation that defines the arc.
    pub(super) fn equation(self, symbol: &Term, argument: Term) -> (Term, Term) {
        let place = argument.place;
        let of = |function| made(Node::Apply(function, vec![symbol.clone()]), place);
        let sine = of(BuiltIn::Sine);
        match self {
            Self::Tangent => {
                let cosine = of(BuiltIn::Cosine);
                (sine, binary(Operator::Multiply, argument, cosine))
            }
            Self::Sine => (sine, argument),
        }
    }
}

impl Hypothesis {
    /// The symbol of an arc, if this hypothesis defines one.
    #[must_use]
    pub fn arc(&self) -> Option<ArcSymbol<'_>> {
        let Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
        } = &self.statement
        else {
            return None;
        };
        let name = match (self.source, &*left.node) {
            (Source::Arc, Node::Apply(BuiltIn::Sine, items)) => symbol_of(items)?,
            _ => return None,
        };
        // The argument of an arc does not contain its symbol.
        let tangent = match &*right.node {
            Node::Binary(Operator::Multiply, argument, cosine) => match &*cosine.node {
                Node::Apply(BuiltIn::Cosine, items) if symbol_of(items) == Some(name) => {
                    Some(argument)
                }
                _ => None,
            },
            _ => None,
        };
        Some(ArcSymbol {
            function: match tangent {
                Some(_) => ArcFunction::Tangent,
                None => ArcFunction::Sine,
            },
            name,
            argument: tangent.unwrap_or(right),
        })
    }
}

impl crate::Claim {
    /// The symbols that stand for arcs. One that occurs in the argument of another comes first.
    pub fn arcs(&self) -> impl Iterator<Item = ArcSymbol<'_>> {
        self.hypotheses.iter().filter_map(Hypothesis::arc)
    }
}

/// The symbol that is the only argument.
fn symbol_of(items: &[Term]) -> Option<&Arc<str>> {
    match items {
        [item] => match &*item.node {
            Node::Symbol(name) => Some(name),
            _ => None,
        },
        _ => None,
    }
}

/// The coefficients of an arc with this value, of an argument with these coefficients: `w' q == r'` with `q == 1 + r^2` for an arc
/// tangent, and with `q == cos(w)` for an arc sine, where `q' == -r w'`.
pub(super) fn arc_series(function: ArcFunction, first: Term, rates: &[Term]) -> Vec<Term> {
    let place = first.place;
    let number = |j: usize, k: usize| {
        let whole = |n: usize| i64::try_from(n).unwrap_or(i64::MAX).into();
        made(Node::Number(Rational::new(whole(j), whole(k))), place)
    };
    let one = number(1, 1);
    let times = |a: &Term, b: &Term| binary(Operator::Multiply, a.clone(), b.clone());
    let cosine = made(Node::Apply(BuiltIn::Cosine, vec![first.clone()]), place);
    let mut coefficients = vec![first];
    let mut below: Vec<Term> = vec![];
    for k in 1..rates.len() {
        // The coefficient of q before the one that is found.
        let last = below.len();
        below.push(match (function, last) {
            (ArcFunction::Sine, 0) => cosine.clone(),
            (ArcFunction::Sine, _) => {
                let mut sum = number(0, 1);
                for j in 1..=last {
                    if let (Some(own), Some(rate)) = (coefficients.get(j), rates.get(last - j)) {
                        let product = times(&number(j, last), &times(own, rate));
                        sum = binary(Operator::Subtract, sum, product);
                    }
                }
                sum
            }
            (ArcFunction::Tangent, _) => {
                let start = if last == 0 { one.clone() } else { number(0, 1) };
                let pairs = rates.iter().zip(rates.iter().take(last + 1).rev());
                pairs.fold(start, |sum, (a, b)| binary(Operator::Add, sum, times(a, b)))
            }
        });
        let mut left = match rates.get(k) {
            Some(rate) => rate.clone(),
            None => break,
        };
        for j in 1..k {
            if injected(InjectedFault::ArcWithoutEarlier) {
                continue;
            }
            if let (Some(own), Some(q)) = (coefficients.get(j), below.get(k - j)) {
                let product = times(&number(j, k), &times(own, q));
                left = binary(Operator::Subtract, left, product);
            }
        }
        if let Some(q) = below.first() {
            coefficients.push(binary(Operator::Divide, left, q.clone()));
        }
    }
    coefficients
}
