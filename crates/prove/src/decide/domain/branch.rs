//! A branch of a domain: its points at which the divisors of all eliminations are not zero.
//!
//! An equation `p x + r = 0` says what x is where p is not zero. [`Branch::solve`] is the only function that gives a symbol a value,
//! and it says what becomes of the points at which p is zero ([`Cases`]): they are another branch, which is decided from the
//! hypotheses as they stand and `p == 0` (module `split`).

use super::{Constraint, Domain};
use crate::decide::conditions;
use crate::decide::interval::Interval;
use crate::decide::sign;
use crate::decide::value::{plain_symbol, quotient};
use crate::evaluate::Evaluator;
use crate::evaluate::series::polynomial_of;
use crate::evaluate::value::UNPLACED;
use crate::unknown::{Unknown, mentions};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Fraction, Polynomial, Symbol};
use torse_certificate::proof::assumptions::{
    Determined, Determining, Elimination, RootAlong, Signed,
};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::fault::Fault;
use torse_syntax::formula::Relation;

/// Divisors of more terms than this are not examined for their sign.
const MAX_EXAMINED: usize = 40;

/// The points of a domain at which the divisors of all eliminations are not zero.
///
/// 1. *One writer.* A symbol has a value by [`Branch::solve`] alone, which puts it into every constraint, pivot, radicand and earlier
///    value, so that no formula of the branch contains a symbol that has one.
/// 2. *Every divisor is accounted for.* What a solution divides by is a number, or has a sign that the certificate keeps, or is
///    assumed not to be zero, or is one of [`Branch::splits`] (as it was when it was divided by) and a pivot of the domain (with
///    the values of later solutions). [`Divisors`] cannot be made in another way.
/// 3. *Nothing is forgotten.* The declared range of a symbol that has a value is a constraint on the value.
#[derive(Clone)]
pub struct Branch<'a> {
    /// The evaluator: symbols that were eliminated have their values.
    pub evaluator: Evaluator<'a>,
    /// The domain.
    pub domain: Domain<'a>,
    eliminated: Vec<Elimination<Polynomial>>,
    splits: Vec<Polynomial>,
}

/// What becomes of a branch when an equation is solved.
#[must_use]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cases {
    /// The solution has a value at all of its points.
    Whole,
    /// The branch goes on at the points at which the divisors are not zero; the others are among [`Branch::splits`].
    Split,
    /// A divisor of an earlier solution vanishes identically: no point is left. A constraint that holds nowhere says so.
    Nowhere,
}

/// What a solution divides by, each divisor with the reason why it is not zero, or without one.
#[derive(Debug, Clone, Default)]
pub struct Divisors {
    open: Vec<Polynomial>,
    nonzero: Vec<Signed<Polynomial>>,
}

/// What determines symbols.
#[derive(Debug, Clone)]
pub enum Equation {
    /// An equation among the hypotheses.
    Assumed(Divisors),
    /// Some of the given equations, by their places.
    Given {
        /// The places.
        places: Vec<usize>,
        /// What their solution divides by.
        divisors: Divisors,
    },
    /// That a symbol is a root whose radicand has this sign.
    Root(Box<Signed<Polynomial>>),
    /// The same, where equations make the square of the value the radicand.
    RootAlong(Box<RootAlong<Polynomial>>),
    /// That a symbol is an arc, and that its value lies where arcs do.
    Arc(Vec<Signed<Polynomial>>),
}

impl<'a> Branch<'a> {
    /// The whole domain of the declared sets, with the numbers that the evaluator has fixed.
    #[must_use]
    pub fn new(evaluator: Evaluator<'a>) -> Self {
        Self {
            domain: Domain::new(evaluator.declarations),
            evaluator,
            eliminated: vec![],
            splits: vec![],
        }
    }

    /// How symbols were eliminated, in this order.
    #[must_use]
    pub fn eliminated(&self) -> &[Elimination<Polynomial>] {
        &self.eliminated
    }

    /// The factors of divisors that may vanish, each as it was when it was divided by: what the claim became says nothing
    /// where one of them is zero.
    #[must_use]
    pub fn splits(&self) -> &[Polynomial] {
        &self.splits
    }

    /// Whether a symbol has a value.
    #[must_use]
    pub fn is_solved(&self, symbol: &Symbol) -> bool {
        self.domain.solved.iter().any(|(known, _)| known == symbol)
    }

    /// Gives unknowns the values that an equation determines, everywhere.
    ///
    /// # Errors
    /// [`Fault`] for a value that cannot be put in, as one of a degree.
    pub fn solve(
        &mut self,
        solutions: &[(Unknown, Fraction)],
        equation: Equation,
    ) -> Result<Cases, Fault> {
        if solutions
            .iter()
            .any(|(unknown, value)| self.excludes(unknown, value))
        {
            self.constrain(Fraction::zero(), Relation::Different);
            return Ok(Cases::Nowhere);
        }
        let is_given = matches!(equation, Equation::Given { .. });
        let (by, open) = match equation {
            Equation::Assumed(Divisors { open, nonzero }) => {
                (Determining::Assumed { nonzero }, open)
            }
            Equation::Given { places, divisors } => {
                let Divisors { open, nonzero } = divisors;
                (Determining::Given { places, nonzero }, open)
            }
            Equation::Root(signed) => (Determining::Root(signed), vec![]),
            Equation::RootAlong(own) => (Determining::RootAlong(own), vec![]),
            Equation::Arc(signs) => (Determining::Arc(signs), vec![]),
        };
        let cases = if open.is_empty() {
            Cases::Whole
        } else {
            Cases::Split
        };
        if !injected(InjectedFault::CaseForgotten) {
            self.domain.pivots.extend(open.iter().cloned());
            self.splits.extend(open);
        }
        let mut values = vec![];
        for (unknown, value) in solutions {
            let value = self.substitute(unknown, value)?;
            match is_given {
                true => self.evaluator.give(),
                // A number moves with no symbol.
                false if value.symbols().is_empty() => {}
                false => self.evaluator.assume(unknown.symbol().clone()),
            }
            values.push(Determined {
                symbol: plain_symbol(unknown.symbol()),
                value: quotient(&value),
            });
        }
        self.eliminated.push(Elimination { values, by });
        Ok(cases)
    }

    /// Whether a value makes a divisor of an earlier solution zero.
    fn excludes(&self, unknown: &Unknown, value: &Fraction) -> bool {
        let Ok(value) = self.resolved(value) else {
            return false;
        };
        let vanishes = |pivot: &Polynomial| {
            let there = replaced(&pivot.clone().into(), unknown.symbol(), &value);
            there.is_ok_and(|pivot| pivot.is_zero())
        };
        self.domain.pivots.iter().any(vanishes)
    }

    /// Replaces a symbol everywhere, and leaves behind what bound it. The value, with those of symbols that were
    /// eliminated before put in.
    fn substitute(&mut self, unknown: &Unknown, value: &Fraction) -> Result<Fraction, Fault> {
        let symbol = unknown.symbol();
        let value = self.resolved(value)?;
        let put = |f: &Fraction| replaced(f, symbol, &value);
        for constraint in &mut self.domain.constraints {
            constraint.value = put(&constraint.value)?;
        }
        for (_, solved) in &mut self.domain.solved {
            *solved = put(solved)?;
        }
        for root in &mut self.domain.roots {
            root.radicand = put(&root.radicand)?;
        }
        self.domain
            .roots
            .retain(|root| root.symbol != *symbol && !mentions(&root.radicand, &root.symbol));
        for arc in &mut self.domain.arcs {
            arc.argument = put(&arc.argument)?;
        }
        self.domain
            .arcs
            .retain(|arc| arc.symbol != *symbol && !mentions(&arc.argument, &arc.symbol));
        for logarithm in &mut self.domain.logarithms {
            logarithm.argument = put(&logarithm.argument)?;
        }
        self.domain.logarithms.retain(|logarithm| {
            logarithm.symbol != *symbol && !mentions(&logarithm.argument, &logarithm.symbol)
        });
        for pivot in &mut self.domain.pivots {
            *pivot = put(&pivot.clone().into())?.numerator().clone();
        }
        self.keep_range(symbol, &value);
        self.domain.solved.push((symbol.clone(), value.clone()));
        for (symbol, value) in self.domain.solved.clone() {
            match &symbol {
                Symbol::Named(name) => self.evaluator.fix(name.to_string(), value),
                _ => self.evaluator.determine([(symbol, value)]),
            }
        }
        Ok(value)
    }

    /// The divisors of a solution, factor by factor.
    #[must_use]
    pub fn divisors(&self, divisors: &[Polynomial]) -> Divisors {
        let vanishes = |divisor: &Polynomial| {
            let ordered = self.domain.with_ordered_exponentials(divisor.symbols());
            divisor.len() > MAX_EXAMINED
                || !ordered.assumes_nonzero(divisor) && !sign::never_zero(divisor, &ordered)
        };
        let factors = conditions::separated(divisors).into_iter();
        let (open, settled): (Vec<_>, Vec<_>) = factors.partition(vanishes);
        Divisors {
            nonzero: self.signed(&settled),
            open,
        }
    }

    /// A divisor of a solution that is known to vanish nowhere.
    #[must_use]
    pub fn nonzero_divisor(&self, divisor: &Polynomial) -> Divisors {
        Divisors {
            nonzero: self.signed(std::slice::from_ref(divisor)),
            open: vec![],
        }
    }

    /// The signs of divisors that do not vanish, where no hypothesis says so.
    fn signed(&self, divisors: &[Polynomial]) -> Vec<Signed<Polynomial>> {
        let signed = |divisor: &Polynomial| {
            let ordered = self.domain.with_ordered_exponentials(divisor.symbols());
            if ordered.assumes_nonzero(divisor) {
                return None;
            }
            Some(Signed {
                sign: sign::positive(divisor, &ordered)?,
                constraints: written(&ordered.constraints),
            })
        };
        divisors.iter().filter_map(signed).collect()
    }

    /// Whether a divisor is known to vanish nowhere on the domain; long ones are not examined.
    #[must_use]
    pub fn never_zero(&self, divisor: &Polynomial) -> bool {
        divisor.len() <= MAX_EXAMINED
            && (self.domain.assumes_nonzero(divisor) || sign::never_zero(divisor, &self.domain))
    }

    /// Adds a constraint, and that it is defined.
    pub fn constrain(&mut self, value: Fraction, relation: Relation) {
        self.differ_from_zero(value.conditions());
        self.domain.constraints.push(Constraint { value, relation });
    }

    /// A hypothesis holds only where it is defined.
    pub fn differ_from_zero(&mut self, divisors: &[Polynomial]) {
        for divisor in divisors {
            let value = Fraction::from(divisor.clone());
            let relation = Relation::Different;
            let constraint = Constraint { value, relation };
            let known = |c: &Constraint| c.relation == relation && c.value.numerator() == divisor;
            if !self.domain.constraints.iter().any(known) {
                self.domain.constraints.push(constraint);
            }
        }
    }

    /// The declared range of a symbol as constraints on the value that replaces it.
    pub fn keep_range(&mut self, symbol: &Symbol, value: &Fraction) {
        let Symbol::Named(name) = symbol else {
            return;
        };
        if injected(InjectedFault::RangeForgotten) {
            return;
        }
        let mut bounds: Vec<(Fraction, Relation)> = vec![];
        match self.domain.declarations.symbol(name) {
            Some(SymbolKind::Real(interval)) => {
                let interval = Interval::from(&**interval);
                bounds.extend(interval.lower.map(|b| match b.closed {
                    true => (value.clone() - b.value, Relation::AtLeast),
                    false => (value.clone() - b.value, Relation::Greater),
                }));
                bounds.extend(interval.upper.map(|b| match b.closed {
                    true => (value.clone() - b.value, Relation::AtMost),
                    false => (value.clone() - b.value, Relation::Less),
                }));
            }
            Some(SymbolKind::Integer { least, most }) => {
                let form = |form| Fraction::from(polynomial_of(form));
                bounds.extend(
                    least
                        .iter()
                        .map(|l| (value.clone() - form(l), Relation::AtLeast)),
                );
                bounds.extend(
                    most.iter()
                        .map(|m| (value.clone() - form(m), Relation::AtMost)),
                );
            }
            _ => {}
        }
        // A bound may itself be in terms of symbols that have values.
        for (bound, relation) in bounds {
            let bound = self.resolved(&bound).unwrap_or(bound);
            self.domain.constraints.push(Constraint {
                value: bound,
                relation,
            });
        }
    }

    /// The value with all eliminated and fixed symbols put in.
    ///
    /// # Errors
    /// [`Fault`] for a value that cannot be put in.
    pub fn resolved(&self, value: &Fraction) -> Result<Fraction, Fault> {
        let mut solved = self.domain.solved.iter();
        let value = solved.try_fold(value.clone(), |value, (symbol, by)| {
            replaced(&value, symbol, by)
        })?;
        let mut fixed = self.evaluator.fixed().iter();
        fixed.try_fold(value, |value, (name, by)| {
            replaced(&value, &Symbol::named(name), by)
        })
    }
}

/// The constraints as parts of a proof.
pub(crate) fn written(
    constraints: &[Constraint],
) -> Vec<torse_certificate::Constraint<Polynomial>> {
    let constraint = |c: &Constraint| torse_certificate::Constraint {
        value: quotient(&c.value),
        relation: c.relation,
    };
    constraints.iter().map(constraint).collect()
}

/// The value with a symbol replaced, wherever it stands.
fn replaced(value: &Fraction, symbol: &Symbol, by: &Fraction) -> Result<Fraction, Fault> {
    if !mentions(value, symbol) {
        return Ok(value.clone());
    }
    match symbol {
        Symbol::Named(name) => value.at(name, by),
        _ => value.substituted(|s| (s == symbol).then(|| by.clone())),
    }
    .map_err(|e| Fault::exact(UNPLACED, e))
}
