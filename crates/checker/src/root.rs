//! Roots: nonnegative symbols whose squares are their radicands.
//!
//! In the claim that is checked every root is a symbol w of the set `[0, inf)` with the hypothesis `w^2 == r`
//! ([`torse_core::Claim::rooted`]); the checker makes that claim itself. A value v may replace w if v^2 equals r,
//! where squares of other roots are replaced by their radicands, and v is nonnegative. And w is zero only where r is.

use super::assumptions::Domain;
use super::gap::{CheckError, Unsupported, Wrong};
use super::quotient::Quotient;
use super::sign::Signs;
use std::sync::Arc;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::proof::assumptions::{EquationMultiple, Signed};
use torse_certificate::ratio::Constraint;
use torse_certificate::symbol::Symbol;
use torse_core::Hypothesis;
use torse_syntax::formula::Relation;

/// The most terms of a polynomial whose norm is looked at, as in the prover: a shorter reach would refuse proofs.
const MAX_NORMED: usize = 12;

/// A root that has not been replaced by a value in other symbols.
struct Root {
    symbol: Symbol,
    radicand: Quotient,
}

impl Domain<'_> {
    /// A symbol that is a root, by a value whose square is the radicand, but for multiples of equations, and which is not negative.
    pub(super) fn by_root(
        &self,
        place: usize,
        own: &Signed<Polynomial>,
        multiples: &[EquationMultiple<Polynomial>],
    ) -> Result<(), CheckError> {
        let work = self.work;
        let group = self.groups.get(place).ok_or(Wrong::Kind)?;
        let [determined] = group.values.as_slice() else {
            return Err(Wrong::Kind.into());
        };
        let wrong = || CheckError::from(Wrong::Eliminated(determined.symbol.to_string()));
        let mut hypotheses = self.claim.hypotheses.iter().filter_map(Hypothesis::root);
        let found = hypotheses.find(|(name, _)| Symbol::named(name) == determined.symbol);
        let (_, radicand) = found.ok_or_else(wrong)?;
        let (radicand, met) = self.expanding(place, |expander| {
            let value = expander.value(radicand)?;
            value
                .numbers()
                .into_iter()
                .next()
                .cloned()
                .ok_or(Unsupported::Large)
        })?;
        self.note(&met);
        let value = Quotient::from_ratio(&determined.value, work)?;
        let square = value.times(&value, work)?;
        let signs = Signs::new(self, &own.constraints, place)?;
        let mut difference = square.minus(&radicand, work)?;
        for EquationMultiple { equation, multiple } in multiples {
            let zero = work.times(signs.equation(*equation)?, multiple)?;
            difference = difference.plus(&zero.into(), work)?;
        }
        let difference = difference.above;
        if !self.reduced(&difference, place)?.is_zero(work)? {
            return Err(wrong());
        }
        // Numerator and denominator as written.
        let (above, below) = (&determined.value.above, &determined.value.below);
        let product = work.times(above, below)?;
        let same = Quotient::from(product.minus(&own.sign.polynomial));
        if !same.is_zero(work)? {
            return Err(Wrong::Sign.into());
        }
        signs.check(&own.sign)?;
        if below.is_number() || self.nonzero_at(below, place)? {
            Ok(())
        } else {
            Err(Unsupported::Divisor(below.to_string()).into())
        }
    }

    /// The roots that remain symbols after the first `groups` groups are replaced. A root that occurs in the radicand
    /// of another comes first.
    fn roots(&self, groups: usize) -> Result<Vec<Root>, Unsupported> {
        let first = self.groups.get(..groups).unwrap_or_default();
        let mut roots = vec![];
        for (name, radicand) in self.claim.hypotheses.iter().filter_map(Hypothesis::root) {
            let symbol = Symbol::Named(Arc::clone(name));
            let mut determined = first.iter().flat_map(|group| &group.values);
            if determined.any(|d| d.symbol == symbol) {
                continue;
            }
            let (radicand, met) = self.expanding(groups, |expander| {
                let value = expander.value(radicand)?;
                value
                    .numbers()
                    .into_iter()
                    .next()
                    .cloned()
                    .ok_or(Unsupported::Large)
            })?;
            // Every symbol that was replaced in it must be shown to have its value.
            self.note(&met);
            // If an equation has made the radicand depend on the root itself, the equation no longer defines the
            // root.
            if radicand.above.degree_in(&symbol) == 0 {
                roots.push(Root { symbol, radicand });
            }
        }
        Ok(roots)
    }

    /// Whether a symbol is a root whose radicand is known to be nonzero, so that the root is positive.
    pub(super) fn is_positive_root(
        &self,
        symbol: &Symbol,
        groups: usize,
    ) -> Result<bool, Unsupported> {
        let mut names = self.claim.hypotheses.iter().filter_map(Hypothesis::root);
        if !names.any(|(name, _)| Symbol::Named(Arc::clone(name)) == *symbol) {
            return Ok(false);
        }
        // What holds before any elimination also holds after it; an elimination may have hidden the radicand.
        let own = Polynomial::symbol(symbol.clone());
        Ok(self.nonzero_at(&own, groups)? || self.nonzero_at(&own, 0)?)
    }

    /// Whether one of these constraints says of a root that it is positive, and that is not known.
    pub(super) fn has_open_root(
        &self,
        constraints: &[Constraint<Polynomial>],
        groups: usize,
    ) -> Result<bool, Unsupported> {
        for (name, _) in self.claim.hypotheses.iter().filter_map(Hypothesis::root) {
            let symbol = Symbol::Named(Arc::clone(name));
            let says = |own: &Constraint<Polynomial>| {
                let value = &own.value;
                own.relation == Relation::Greater
                    && value.below.is_number()
                    && value.above == Polynomial::symbol(symbol.clone())
            };
            if constraints.iter().any(says) && !self.is_positive_root(&symbol, groups)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Replaces the squares of roots in a polynomial by their radicands.
    fn reduced(&self, polynomial: &Polynomial, groups: usize) -> Result<Quotient, Unsupported> {
        let work = self.work;
        let mut value = Quotient::from(polynomial.clone());
        for root in self.roots(groups)?.iter().rev() {
            let above = value.above.refined().ok_or(Unsupported::Large)?;
            if above.degree_in(&root.symbol) < 2 {
                continue;
            }
            let own = Quotient::from(Polynomial::symbol(root.symbol.clone()));
            let (mut sum, mut power) = (
                Quotient::default(),
                Quotient::number(torse_numbers::rational::integer(1)),
            );
            for pair in above.coefficients_in(&root.symbol).chunks(2) {
                let mut part = Quotient::default();
                if let Some(even) = pair.first() {
                    part = part.plus(&Quotient::from(even.clone()), work)?;
                }
                if let Some(odd) = pair.get(1) {
                    part = part.plus(&Quotient::from(odd.clone()).times(&own, work)?, work)?;
                }
                sum = sum.plus(&part.times(&power, work)?, work)?;
                power = power.times(&root.radicand, work)?;
            }
            // Whether it is zero does not depend on the denominator.
            value = sum;
        }
        Ok(value)
    }

    /// A polynomial without roots that is zero wherever this one is: `x - y` for `sqrt(x) - sqrt(y)`; `None` for one without roots, or a
    /// long one. The prover has its own (`crates/prove/src/roots`), whose faults must not be shared.
    pub(super) fn norm(
        &self,
        polynomial: &Polynomial,
        groups: usize,
    ) -> Result<Option<Polynomial>, Unsupported> {
        let roots = self.roots(groups)?;
        let has = |p: &Polynomial| roots.iter().any(|root| p.degree_in(&root.symbol) > 0);
        if !has(polynomial) {
            return Ok(None);
        }
        let mut value = self.reduced(polynomial, groups)?.above;
        for root in roots.iter().rev() {
            if value.len() > MAX_NORMED {
                return Ok(None);
            }
            if let [even, odd] = value.coefficients_in(&root.symbol).as_slice() {
                // (even + odd w) (even - odd w), where w^2 is the radicand.
                let even: Quotient = self.work.times(even, even)?.into();
                let odd: Quotient = self.work.times(odd, odd)?.into();
                let squared = odd.times(&root.radicand, self.work)?;
                let product = even.minus(&squared, self.work)?.above;
                value = self.reduced(&product, groups)?.above;
            }
        }
        Ok((!has(&value)).then_some(value))
    }

    /// Replaces roots that divide a polynomial by their radicands: the result vanishes where the polynomial does.
    pub(super) fn unrooted(
        &self,
        polynomial: &Polynomial,
        groups: usize,
    ) -> Result<Polynomial, Unsupported> {
        let mut remainder = polynomial.clone();
        let mut names = self.claim.hypotheses.iter().filter_map(Hypothesis::root);
        if !names.any(|(name, _)| remainder.degree_in(&Symbol::Named(Arc::clone(name))) > 0) {
            return Ok(remainder);
        }
        for root in self.roots(groups)?.iter().rev() {
            let own = Polynomial::symbol(root.symbol.clone());
            while !remainder.is_zero()
                && let Some(quotient) = remainder.quotient(&own)
            {
                remainder = self.work.times(&quotient, &root.radicand.above)?;
            }
        }
        Ok(remainder)
    }
}
