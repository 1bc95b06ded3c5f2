//! The logarithms of a claim in its domain: those with values in other symbols are eliminated, the equations `exp(w) == r` of the
//! others are taken like all equations, and what is known of exponentials is known of exponents.

use super::{ProofContext, plain};
use crate::decide::domain::Constraint;
use crate::decide::domain::branch::{Divisors, Equation};
use crate::decide::logarithm::Logarithm;
use crate::decide::order::truth;
use crate::decide::sign::{self, Sign};
use crate::logarithms;
use crate::unknown::{Unknown, mentions};
use std::sync::Arc;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Fraction, Polynomial, Symbol};
use torse_core as core;
use torse_core::Term;
use torse_syntax::fault::Fault;
use torse_syntax::formula::Relation;

/// The most terms of a difference of two arguments whose sign is examined.
const MAX_EXAMINED: usize = 40;

impl ProofContext<'_> {
    /// Takes the hypotheses that define logarithms.
    pub(super) fn take_logarithms(&mut self, claim: &core::Claim) -> Result<(), Fault> {
        let all: Vec<(&Arc<str>, &Term)> = claim.logarithms().collect();
        if all.is_empty() {
            return Ok(());
        }
        self.branch.domain.logarithms.clear();
        for (name, argument) in &all {
            let symbol = Symbol::named(name);
            let argument = self.argument(argument)?;
            // A quotient has the sign of the product, of which no factor is zero.
            let product = argument.numerator() * &argument.denominator();
            self.branch.differ_from_zero(argument.conditions());
            self.branch.domain.constraints.push(Constraint {
                value: product.into(),
                relation: Relation::Greater,
            });
            if self.branch.is_solved(&symbol) {
                continue;
            }
            let value = logarithms::resolved(&argument, &self.branch.domain);
            match value.filter(|value| !mentions(value, &symbol)) {
                Some(value) => self.equals(symbol, value)?,
                None => {
                    let log = Logarithm { symbol, argument };
                    self.branch.domain.logarithms.push(log);
                }
            }
        }
        for (name, argument) in &all {
            let symbol = Symbol::named(name);
            let own = self.branch.resolved(&Fraction::symbol(symbol))?;
            let power = own
                .exponential()
                .map_err(|error| Fault::exact(argument.place, error))?;
            let equation = power - self.argument(argument)?;
            self.vanishes_or_stays(&equation)?;
        }
        self.compare_exponents()?;
        self.order_logarithms(&all)
    }

    fn argument(&self, term: &Term) -> Result<Fraction, Fault> {
        let value = self.branch.evaluator.term(term)?;
        let value = plain(&value).ok_or_else(|| {
            Fault::limit(term.place, "the logarithm of a formula of symbolic degree")
        })?;
        self.branch.resolved(&value)
    }

    fn equals(&mut self, symbol: Symbol, value: Fraction) -> Result<(), Fault> {
        let Some(unknown) = Unknown::new(symbol) else {
            return Ok(());
        };
        let solution = [(unknown, value)];
        let _ = self
            .branch
            .solve(&solution, Equation::Assumed(Divisors::default()))?;
        Ok(())
    }

    /// Takes an equation `value == 0`; as a constraint where its solution cannot be put in.
    pub(super) fn vanishes_or_stays(&mut self, value: &Fraction) -> Result<(), Fault> {
        let before = self.clone();
        match self.vanishes(value) {
            Err(fault) if fault.is_limit() => {
                *self = before;
                let value = self.branch.resolved(value)?;
                self.branch.constrain(value, Relation::Equal);
                Ok(())
            }
            taken => taken,
        }
    }

    /// Of two products of exponentials with positive numbers the one with the larger logarithm is larger.
    fn compare_exponents(&mut self) -> Result<(), Fault> {
        let mut place = 0;
        while let Some(constraint) = self.branch.domain.constraints.get(place).cloned() {
            place += 1;
            let Some(difference) = difference_of_logarithms(&constraint.value) else {
                continue;
            };
            if constraint.relation == Relation::Equal {
                self.vanishes_or_stays(&difference)?;
                continue;
            }
            let relation = match injected(InjectedFault::ExponentsReversed) {
                true => constraint.relation.mirrored(),
                false => constraint.relation,
            };
            // A number says nothing new.
            if !difference.symbols().iter().all(Symbol::is_number) {
                self.branch.domain.constraints.push(Constraint {
                    value: difference,
                    relation,
                });
            }
        }
        Ok(())
    }

    /// The logarithm increases: arguments that are ordered on the domain order logarithms, among them `log(1) == 0`.
    fn order_logarithms(&mut self, all: &[(&Arc<str>, &Term)]) -> Result<(), Fault> {
        let mut values = vec![(Fraction::zero(), Fraction::integer(1))];
        for (name, argument) in all {
            let value = self.branch.resolved(&Fraction::named(name))?;
            values.push((value, self.argument(argument)?));
        }
        let mut found = vec![];
        for (place, (first, above)) in values.iter().enumerate() {
            for (second, below) in values.iter().skip(place + 1) {
                let gap = above.clone() - below.clone();
                let product = gap.numerator() * &gap.denominator();
                if product.len() > MAX_EXAMINED {
                    continue;
                }
                let relation = match sign::sign(&product, &self.branch.domain) {
                    Some(Sign::Positive) => Relation::Greater,
                    Some(Sign::Nonnegative) => Relation::AtLeast,
                    Some(Sign::Negative) => Relation::Less,
                    Some(Sign::Nonpositive) => Relation::AtMost,
                    None => continue,
                };
                let value = first.clone() - second.clone();
                if truth(&value, relation).is_none() {
                    found.push(Constraint { value, relation });
                }
            }
        }
        self.branch.domain.constraints.extend(found);
        Ok(())
    }
}

/// `log(A) - log(B)` of a difference `A - B` of two products of exponentials, roots of primes and positive numbers over such a
/// product: it has the sign of the difference.
fn difference_of_logarithms(value: &Fraction) -> Option<Fraction> {
    let numerator = value.numerator();
    if numerator.len() != 2 {
        return None;
    }
    // The divisor is positive.
    Fraction::from(value.denominator()).logarithm().ok()?;
    let (mut above, mut below) = (None, None);
    for term in numerator.terms() {
        let own = term.powers.iter().fold(
            Polynomial::constant(&term.coefficient),
            |product, (symbol, exponent)| {
                let power = Polynomial::symbol((*symbol).clone()).power(u32::from(*exponent));
                &product * &power
            },
        );
        let is_positive = num_traits::Signed::is_positive(&term.coefficient);
        match is_positive {
            true => above = Some(own),
            false => below = Some(-own),
        }
    }
    let above = Fraction::from(above?).logarithm().ok()?;
    let below = Fraction::from(below?).logarithm().ok()?;
    Some(above - below)
}
