//! Refutations of statements.

use crate::evidence::Evidence;
use crate::point::{Counterexample, Value};
use crate::polynomial::Polynomial;
use crate::proof::Proof;
use crate::ratio::Ratio;
use crate::symbol::Symbol;
use serde::Serialize;
use std::collections::BTreeMap;
use torse_numbers::rational::integer;

/// Why a statement is false.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Refuted<P> {
    /// It fails at a point of the domain.
    At(Counterexample<P>),
    /// It fails for these values of integers.
    Instance {
        /// The values.
        integers: BTreeMap<String, i64>,
        /// How it fails there.
        refuted: Box<Refuted<P>>,
    },
    /// It is a negation about the whole domain, but the negated statement is true at each point of the domain, which
    /// is not empty.
    Denied {
        /// The proof of the negated statement.
        proof: Box<Proof<P>>,
        /// A point of the domain, possibly of an instance.
        anywhere: Box<Refuted<P>>,
    },
}

impl<P> Refuted<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Refuted<Q> {
        match self {
            Self::At(point) => Refuted::At(point.map(change)),
            Self::Instance { integers, refuted } => Refuted::Instance {
                integers: integers.clone(),
                refuted: Box::new(refuted.map(change)),
            },
            Self::Denied { proof, anywhere } => Refuted::Denied {
                proof: Box::new(proof.map(change)),
                anywhere: Box::new(anywhere.map(change)),
            },
        }
    }

    /// The point, and how the statement fails there.
    #[must_use]
    pub fn counterexample(&self) -> &Counterexample<P> {
        match self {
            Self::At(point) => point,
            Self::Denied {
                anywhere: refuted, ..
            }
            | Self::Instance { refuted, .. } => refuted.counterexample(),
        }
    }

    /// Mutable access to the counterexample, to complete it.
    pub fn counterexample_mut(&mut self) -> &mut Counterexample<P> {
        match self {
            Self::At(point) => point,
            Self::Denied {
                anywhere: refuted, ..
            }
            | Self::Instance { refuted, .. } => refuted.counterexample_mut(),
        }
    }

    /// The integer values of instances, outermost first.
    #[must_use]
    pub fn integers(&self) -> Vec<(&str, i64)> {
        match self {
            Self::Instance { integers, refuted } => {
                let own = integers.iter().map(|(name, value)| (name.as_str(), *value));
                own.chain(refuted.integers()).collect()
            }
            Self::Denied { anywhere, .. } => anywhere.integers(),
            Self::At(_) => vec![],
        }
    }

    /// The evidence: the point, or the proof of the negated statement.
    #[must_use]
    pub fn evidence(&self) -> Evidence {
        match self {
            Self::At(_) => Evidence::Witness,
            Self::Instance { refuted, .. } => refuted.evidence(),
            Self::Denied { proof, .. } => proof.evidence(),
        }
    }
}

impl Refuted<Polynomial> {
    /// The point, preceded by the integer values of instances.
    #[must_use]
    pub fn at(&self) -> Vec<Value<Polynomial>> {
        let point = &self.counterexample().at;
        let mut all = vec![];
        for (name, value) in self.integers() {
            let symbol = Symbol::named(name);
            if point.iter().all(|own| own.symbol != symbol) {
                let value = Ratio::from(Polynomial::constant(integer(value)));
                all.push(Value { symbol, value });
            }
        }
        all.extend(point.iter().cloned());
        all
    }
}
