//! Absolute values: roots of squares. Every number is zero or more, or zero or less.

use super::part::key;
use crate::{Claim, Hypothesis, Node, Source, Statement, Term};
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::derivation::Origin;
use torse_syntax::formula::{Operator, Relation};

impl Claim {
    /// The symbols that stand for roots of squares, with what is squared. One that occurs in the argument of another comes
    /// first.
    pub fn sizes(&self) -> impl Iterator<Item = (&Arc<str>, &Term)> {
        self.roots()
            .filter_map(|(name, radicand)| Some((name, squared(radicand)?)))
    }

    /// The claim at the points at which a number compares so with zero.
    #[must_use]
    pub fn where_compared(&self, number: &Term, relation: Relation, origin: &Origin) -> Self {
        let zero = Term {
            node: Arc::new(Node::Number(integer(0))),
            place: number.place,
        };
        let mut side = self.clone();
        side.hypotheses.push(Hypothesis {
            statement: Statement::Compare {
                relation,
                left: number.clone(),
                right: zero,
            },
            source: Source::Assume,
            origin: origin.clone(),
        });
        side
    }
}

/// The term a of a product `a*a` or a power `a^2`.
fn squared(term: &Term) -> Option<&Term> {
    match &*term.node {
        Node::Binary(Operator::Multiply, a, b) if Arc::ptr_eq(&a.node, &b.node) => Some(a),
        Node::Binary(Operator::Multiply, a, b) => (key(a)? == key(b)?).then_some(a),
        Node::Binary(Operator::Power, a, exponent) => {
            (exponent.as_integer() == Some(2)).then_some(a)
        }
        _ => None,
    }
}
