//! Roots: symbols of which the square is the radicand, and which are not negative.
//!
//! The claim is one in which every root is a symbol w of the set `[0, inf)` with the hypothesis `w^2 == r`
//! ([`torse_core::Claim::rooted`]); the checker makes that claim itself. A value v may take the place of w if v^2 is r,
//! where squares of other roots are their radicands, and v is not negative. And w is zero only where r is.

use super::assumptions::Domain;
use super::gap::{CheckError, Unsupported, Wrong};
use super::quotient::Quotient;
use super::sign::Signs;
use std::sync::Arc;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::proof::assumptions::Signed;
use torse_certificate::symbol::Symbol;
use torse_core::Hypothesis;

/// A root that has no value in other symbols.
struct Root {
    symbol: Symbol,
    radicand: Quotient,
}

impl Domain<'_> {
    /// A symbol that is a root, by a value whose square is the radicand and which is not negative.
    pub(super) fn by_root(&self, place: usize, own: &Signed<Polynomial>) -> Result<(), CheckError> {
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
        let difference = square.minus(&radicand, work)?.above;
        if !self.reduced(&difference, place)?.is_zero(work)? {
            return Err(wrong());
        }
        // Numerator and denominator as they are written.
        let (above, below) = (&determined.value.above, &determined.value.below);
        let product = work.times(above, below)?;
        let same = Quotient::from(product.minus(&own.sign.polynomial));
        if !same.is_zero(work)? {
            return Err(Wrong::Sign.into());
        }
        let signs = Signs::new(self, &own.constraints, place)?;
        signs.check(&own.sign)?;
        match below.is_number() || self.nonzero_at(below, place)? {
            true => Ok(()),
            false => Err(Unsupported::Divisor(below.to_string()).into()),
        }
    }

    /// The roots that are symbols where the first groups have their values, those first of which others are made.
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
            // Every symbol that has its value in it is shown to have it.
            self.note(&met);
            // One that an equation has made a formula in the root itself is no root of something else.
            if radicand.above.degree_in(&symbol) == 0 {
                roots.push(Root { symbol, radicand });
            }
        }
        Ok(roots)
    }

    /// Whether a symbol is a root whose radicand is known not to vanish: then it is positive.
    pub(super) fn is_positive_root(
        &self,
        symbol: &Symbol,
        groups: usize,
    ) -> Result<bool, Unsupported> {
        let mut names = self.claim.hypotheses.iter().filter_map(Hypothesis::root);
        if !names.any(|(name, _)| Symbol::Named(Arc::clone(name)) == *symbol) {
            return Ok(false);
        }
        // What is so before any elimination is so after it: an elimination may have hidden what the root is one of.
        let own = Polynomial::symbol(symbol.clone());
        Ok(self.nonzero_at(&own, groups)? || self.nonzero_at(&own, 0)?)
    }

    /// The polynomial with the squares of roots replaced by their radicands.
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

    /// The polynomial with radicands in place of the roots that divide it: it is zero where that is.
    pub(super) fn unrooted(
        &self,
        polynomial: &Polynomial,
        groups: usize,
    ) -> Result<Polynomial, Unsupported> {
        let mut rest = polynomial.clone();
        let mut names = self.claim.hypotheses.iter().filter_map(Hypothesis::root);
        if !names.any(|(name, _)| rest.degree_in(&Symbol::Named(Arc::clone(name))) > 0) {
            return Ok(rest);
        }
        for root in self.roots(groups)?.iter().rev() {
            let own = Polynomial::symbol(root.symbol.clone());
            while !rest.is_zero()
                && let Some(quotient) = rest.quotient(&own)
            {
                rest = self.work.times(&quotient, &root.radicand.above)?;
            }
        }
        Ok(rest)
    }
}
