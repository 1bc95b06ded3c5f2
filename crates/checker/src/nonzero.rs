//! Which polynomials have no zero on the domain.
//!
//! Such are conditions, what terms divide by (where one is zero a hypothesis has no value, or the statement claims nothing),
//! what hypotheses state, polynomials whose signs were checked, symbols whose declared range does not contain zero, integer forms
//! that vanish at no integers, and products of these.

use super::assumptions::{Compared, Domain, Met};
use super::eliminated::linear;
use super::gap::{CheckError, Unsupported};
use std::cmp::Ordering;
use std::sync::Arc;
use torse_certificate::number::{holds, order};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::symbol::Symbol;
use torse_core::Set;
use torse_numbers::rational::integer;
use torse_numbers::{Integer, Rational};
use torse_syntax::derivation::declarations::Constant;
use torse_syntax::formula::Relation;

/// The highest power of a factor that is compared with a polynomial, and the most terms of such a factor.
const MAX_EXPONENT: u32 = 4;
const MAX_TERMS: usize = 4;
/// The most terms of an equation, and of a polynomial without a zero, that are added to each other.
const MAX_EQUATION_TERMS: usize = 8;

impl Domain<'_> {
    /// Whether a polynomial is a product of factors that are known to be nonzero, with the symbols of the first
    /// `groups` groups replaced: constants, conditions, divisors of terms, quantities that hypotheses state to be
    /// nonzero, symbols whose declared range does not contain zero, integer forms that vanish at no integers, and the
    /// factors in `besides`.
    pub(super) fn is_nonzero(
        &self,
        polynomial: &Polynomial,
        known: &[Compared],
        groups: usize,
        besides: &[Polynomial],
    ) -> Result<bool, Unsupported> {
        let unrooted = self.unrooted(polynomial, groups)?;
        if self.no_integers_solve(&unrooted) {
            return Ok(true);
        }
        // A root is a divisor of a term as it is, and nonzero where its radicand is.
        let norm = self.norm(&unrooted, groups)?;
        let is_product = || -> Result<bool, Unsupported> {
            let divides = |p: &Polynomial| self.divides(p, known, groups, besides);
            Ok(divides(&unrooted)?
                || unrooted != *polynomial && divides(polynomial)?
                || norm.as_ref().map_or(Ok(false), divides)?)
        };
        if is_product()? {
            return Ok(true);
        }
        self.meet_divisors_of_statement(groups)?;
        if is_product()? || self.excludes(&[polynomial], groups)? {
            return Ok(true);
        }
        match self.mentions_arc(polynomial) {
            true => Err(Unsupported::Construct("the order of arcs")),
            false => Ok(false),
        }
    }

    /// Whether an arc, or a function of one, occurs in a polynomial: of those the prover knows more.
    fn mentions_arc(&self, polynomial: &Polynomial) -> bool {
        let is_arc = |own: &Symbol| {
            let name = own.variable();
            name.is_some_and(|name| self.claim.arcs().any(|arc| **arc.name == *name))
        };
        polynomial.symbols().any(is_arc)
    }

    /// Records what the terms of the statement divide by: it asserts nothing where one of them is undefined.
    fn meet_divisors_of_statement(&self, groups: usize) -> Result<(), Unsupported> {
        for term in self.claim.statement.terms() {
            let expanded = self.expanding(groups, |expander| expander.value(term));
            if expanded == Err(Unsupported::Large) {
                return Err(Unsupported::Large);
            }
        }
        Ok(())
    }

    /// Whether a multiple of the polynomial is an integer form whose constant is not divisible by the greatest common
    /// divisor of its other coefficients, so that it vanishes at no integers.
    fn no_integers_solve(&self, polynomial: &Polynomial) -> bool {
        let (mut multiples, mut constant) = (vec![], integer(0));
        for (monomial, coefficient) in polynomial.terms() {
            match monomial.as_slice() {
                [] => constant = coefficient.clone(),
                [(Symbol::Named(name), 1)]
                    if matches!(self.claim.symbols.get(name), Some(Set::Integer { .. })) =>
                {
                    multiples.push(coefficient);
                }
                _ => return false,
            }
        }
        let all = multiples.iter().copied().chain([&constant]);
        let scale = all.fold(Integer::ONE, |scale, own| scale * own.denom());
        let whole = |own: &Rational| (own * Rational::from_integer(scale.clone())).to_integer();
        let divisors = multiples.into_iter().map(whole);
        let divisor = divisors.fold(Integer::ZERO, common_divisor);
        divisor != Integer::ZERO && whole(&constant) % divisor != Integer::ZERO
    }

    fn divides(
        &self,
        polynomial: &Polynomial,
        known: &[Compared],
        groups: usize,
        besides: &[Polynomial],
    ) -> Result<bool, Unsupported> {
        if polynomial.is_zero() {
            return Ok(false);
        }
        let besides = besides.iter().map(|p| (p.clone(), Met::new()));
        let mut rest = polynomial.clone();
        for (factor, met) in self.factors(known, groups)?.into_iter().chain(besides) {
            if rest.is_number() {
                break;
            }
            if self.divides_power(&rest, &factor)? {
                self.note(&met);
                return Ok(true);
            }
            while let Some(quotient) = rest.quotient(&factor) {
                self.note(&met);
                self.work.spend(factor.len().saturating_mul(rest.len()))?;
                rest = quotient;
            }
        }
        // A nonzero polynomial in pi and roots is a nonzero constant.
        Ok(rest.is_number())
    }

    /// The polynomials without a zero on the domain, with the symbols of the first `groups` groups replaced, each with
    /// the symbols that were: conditions, divisors of terms (where one is zero a hypothesis has no value, or the statement has
    /// none), what hypotheses state, signs that were checked, and symbols whose declared range does not contain zero.
    fn factors(
        &self,
        known: &[Compared],
        groups: usize,
    ) -> Result<Vec<(Polynomial, Met)>, Unsupported> {
        use Relation::{Different, Greater, Less};
        let declared = self.claim.symbols.iter();
        let declared = declared.filter(|(_, set)| !contains_zero(set));
        let declared =
            declared.map(|(name, _)| Polynomial::symbol(Symbol::Named(Arc::clone(name))));
        let declared: Vec<Polynomial> = declared.collect();
        // If c + p = 0 with a nonzero constant c, then p is nonzero.
        let level = self.hypotheses(0);
        let equations = level.all.iter().filter(|c| c.relation == Relation::Equal);
        let implied = equations.filter_map(|c| without_number(&c.difference.above));
        let plain = self.conditions.iter().chain(&self.nonzero).cloned();
        let apart = self.apart.borrow();
        let by_sign = apart.factors.iter().filter(|_| groups == self.groups.len());
        let plain = plain
            .chain(declared.iter().cloned())
            .chain(implied)
            .chain(by_sign.cloned());
        let mut all: Vec<(Polynomial, Met)> = plain.map(|p| (p, Met::new())).collect();
        let divisors = self.divisors.borrow();
        let met = divisors.get(&groups).into_iter().flatten();
        all.extend(met.map(|(p, met)| (p.clone(), met.clone())));
        drop(divisors);
        // A condition, or a symbol by its declared range, is also nonzero after eliminated symbols are replaced in it.
        for own in self.conditions.iter().chain(&declared) {
            let replaced = self.replaced(groups, own)?;
            all.push((replaced.difference.above, replaced.met));
        }
        all.extend(self.bounded_from_zero(known)?);
        let differs = known
            .iter()
            .filter(|c| matches!(c.relation, Different | Less | Greater));
        all.extend(differs.map(|c| (c.difference.above.clone(), c.met.clone())));
        // A root is nonzero where its radicand is, and the other way round.
        let mut radicands = vec![];
        for (factor, met) in &all {
            let unrooted = self.unrooted(factor, groups)?;
            if unrooted != *factor {
                radicands.push((unrooted, met.clone()));
            }
        }
        all.extend(radicands);
        let beside = self.beside_equations(known, &all)?;
        all.extend(beside);
        all.retain(|(factor, _)| !factor.is_number());
        Ok(all)
    }

    /// What these polynomials without a zero are where an equation holds: `y^2` for `x^2 + 1` where `y^2 == x^2 + 1`.
    fn beside_equations(
        &self,
        known: &[Compared],
        nonzero: &[(Polynomial, Met)],
    ) -> Result<Vec<(Polynomial, Met)>, Unsupported> {
        let is_short = |own: &Polynomial| own.len() <= MAX_EQUATION_TERMS;
        let equations = known.iter().filter(|c| {
            let difference = &c.difference;
            c.relation == Relation::Equal
                && difference.below.is_empty()
                && is_short(&difference.above)
        });
        let mut found = vec![];
        for equation in equations {
            let zero = &equation.difference.above;
            for (factor, met) in nonzero.iter().filter(|(factor, _)| is_short(factor)) {
                self.work.spend(factor.len().saturating_mul(zero.len()))?;
                let shared = factor.terms().find_map(|(monomial, own)| {
                    let mut others = zero.terms();
                    let (_, other) = others.find(|(other, _)| *other == monomial)?;
                    Some(own / other)
                });
                let Some(multiple) = shared else { continue };
                let there = factor.minus(&zero.scaled(&multiple));
                if !there.is_zero() && there.len() <= MAX_TERMS {
                    let both = met.iter().chain(&equation.met).cloned().collect();
                    found.push((there, both));
                }
            }
        }
        Ok(found)
    }

    /// The symbols that a hypothesis keeps from zero, since it fails with zero in place of one: x where `x >= 1`, x and y where
    /// `x*y > 1`.
    fn bounded_from_zero(&self, known: &[Compared]) -> Result<Vec<(Polynomial, Met)>, Unsupported> {
        let mut bounded = vec![];
        for compared in known {
            let value = &compared.difference;
            if !value.below.is_empty() || value.above.len() > MAX_TERMS {
                continue;
            }
            for symbol in value.above.symbols().filter(|symbol| !symbol.is_number()) {
                let zero = (symbol.clone(), Polynomial::zero());
                let number = self.put(&value.above, &[zero])?.as_constant();
                if number.is_some_and(|n| !holds(n.cmp(&integer(0)), compared.relation)) {
                    bounded.push((Polynomial::symbol(symbol.clone()), compared.met.clone()));
                }
            }
        }
        Ok(bounded)
    }

    /// Whether a polynomial divides a power of a factor, so that it is nonzero where the factor is: `x^2` where `x*y` is.
    fn divides_power(
        &self,
        polynomial: &Polynomial,
        factor: &Polynomial,
    ) -> Result<bool, Unsupported> {
        self.work
            .spend(factor.len().saturating_mul(polynomial.len()))?;
        if factor.quotient(polynomial).is_some() {
            return Ok(true);
        }
        let degrees = polynomial.symbols().map(|s| polynomial.degree_in(s));
        let exponent = degrees.max().unwrap_or(0).min(MAX_EXPONENT);
        if exponent < 2 || factor.len() > MAX_TERMS {
            return Ok(false);
        }
        let mut power = factor.clone();
        for _ in 1..exponent {
            power = self.work.times(&power, factor)?;
        }
        Ok(power.quotient(polynomial).is_some())
    }

    /// Whether these polynomials are not all zero: with the values that symbols have where they are zero, a hypothesis fails
    /// (`y + z >= 1` where y and z are zero) or something without a zero has one; or one of the polynomials divides a power of such
    /// a thing (a root is nonzero where its radicand is).
    pub(super) fn excludes_common_zero(
        &self,
        polynomials: &[&Polynomial],
        groups: usize,
    ) -> Result<bool, Unsupported> {
        if self.excludes(polynomials, groups)? {
            return Ok(true);
        }
        self.meet_divisors_of_statement(groups)?;
        self.excludes(polynomials, groups)
    }

    fn excludes(&self, polynomials: &[&Polynomial], groups: usize) -> Result<bool, Unsupported> {
        let unrooted = polynomials.iter().map(|p| self.unrooted(p, groups));
        let unrooted: Vec<Polynomial> = unrooted.collect::<Result<_, _>>()?;
        let mut values: Vec<(Symbol, Polynomial)> = vec![];
        for polynomial in polynomials {
            // The value of a symbol is free of those before it: these were replaced.
            values.extend(value_at_zero(&self.put(polynomial, &values)?));
        }
        let there = |polynomial: &Polynomial| self.put(polynomial, &values);
        // What was said of eliminated symbols before they were replaced holds as well.
        let (known, stated) = (self.hypotheses(groups), self.hypotheses(0));
        for compared in known.all.iter().chain(&stated.all) {
            let there = there(&compared.difference.above)?;
            if compared.difference.below.is_empty()
                && self.fails_everywhere(&there, compared.relation)
            {
                self.note(&compared.met);
                return Ok(true);
            }
        }
        let below = known.all.iter().flat_map(|c| {
            let factors = c.difference.below.keys();
            factors.map(|factor| (factor.clone(), c.met.clone()))
        });
        for (nonzero, met) in self.factors(&known.all, groups)?.into_iter().chain(below) {
            let mut excluded = there(&nonzero)?.is_zero();
            for polynomial in &unrooted {
                excluded = excluded || self.divides_power(polynomial, &nonzero)?;
            }
            if excluded {
                self.note(&met);
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether a polynomial compares so with zero nowhere: it is a number that does not, or a sum of a number and of products of
    /// squares and of symbols that are never negative by their declared sets, all with one sign.
    fn fails_everywhere(&self, polynomial: &Polynomial, relation: Relation) -> bool {
        if let Some(number) = polynomial.as_constant() {
            return !holds(number.cmp(&integer(0)), relation);
        }
        let is_never_negative = |(symbol, exponent): &(Symbol, u32)| {
            exponent.is_multiple_of(2)
                || matches!(symbol, Symbol::Named(name)
                    if self.claim.symbols.get(name).is_some_and(|set| !contains_negative(set)))
        };
        let have_sign = |sign: Ordering| {
            let mut terms = polynomial.terms();
            terms.all(|(powers, value)| {
                powers.iter().all(is_never_negative) && value.cmp(&integer(0)) == sign
            })
        };
        let has_number = || polynomial.terms().any(|(powers, _)| powers.is_empty());
        match relation {
            Relation::Less => have_sign(Ordering::Greater),
            Relation::Greater => have_sign(Ordering::Less),
            Relation::AtMost => have_sign(Ordering::Greater) && has_number(),
            Relation::AtLeast => have_sign(Ordering::Less) && has_number(),
            Relation::Equal => {
                has_number() && (have_sign(Ordering::Greater) || have_sign(Ordering::Less))
            }
            Relation::Different => false,
        }
    }

    /// The polynomial with the values of symbols put in, one after the other.
    fn put(
        &self,
        polynomial: &Polynomial,
        values: &[(Symbol, Polynomial)],
    ) -> Result<Polynomial, Unsupported> {
        let mut result = polynomial.clone();
        for (symbol, value) in values {
            let powers = result.coefficients_in(symbol).into_iter().rev();
            // By Horner's rule.
            result = Polynomial::zero();
            for coefficient in powers {
                result = self.work.times(&result, value)?.plus(&coefficient);
            }
        }
        Ok(result)
    }

    /// The error for a polynomial of the statement that is not known to be nonzero.
    pub fn may_vanish_here(&self, polynomial: &Polynomial) -> CheckError {
        self.apart.borrow().may_vanish(polynomial)
    }

    /// Whether the denominator of a quotient of the proof is known to be nonzero.
    pub fn nonzero_here(&self, polynomial: &Polynomial) -> Result<bool, Unsupported> {
        self.nonzero_at(polynomial, self.groups.len())
    }

    /// As [`Domain::nonzero_here`], with only the symbols of the first `groups` groups replaced.
    pub(super) fn nonzero_at(
        &self,
        polynomial: &Polynomial,
        groups: usize,
    ) -> Result<bool, Unsupported> {
        let known = self.hypotheses(groups);
        self.is_nonzero(polynomial, &known.all, groups, &[])
    }
}

/// The greatest common divisor, up to sign, by Euclid's algorithm.
fn common_divisor(mut a: Integer, mut b: Integer) -> Integer {
    while b != Integer::ZERO {
        (a, b) = (b.clone(), a % b);
    }
    a
}

/// Whether a declared set may contain a negative number, as far as its lower bound shows.
fn contains_negative(set: &Set) -> bool {
    match set {
        Set::Real(interval) => {
            let lower = interval.lower.as_ref();
            !lower.is_some_and(|bound| sign(&bound.value).is_some_and(Ordering::is_ge))
        }
        Set::Integer { least, .. } => {
            let least = least.as_ref().and_then(torse_numbers::Affine::as_number);
            least.is_none_or(|n| n < 0)
        }
        Set::Vector(_) | Set::Family { .. } => true,
    }
}

/// The sign of a bound of a declared set.
fn sign(bound: &Constant) -> Option<Ordering> {
    let turns = Polynomial::symbol(Symbol::Pi).scaled(&bound.turns);
    order(&turns.plus(&Polynomial::constant(bound.rational.clone())))
}

/// Whether a declared set may contain zero, as far as its bounds show.
fn contains_zero(set: &Set) -> bool {
    match set {
        Set::Real(interval) => {
            let above = interval.lower.as_ref().is_some_and(|b| {
                sign(&b.value).is_some_and(|s| s.is_gt() || (s.is_eq() && !b.closed))
            });
            let below = interval.upper.as_ref().is_some_and(|b| {
                sign(&b.value).is_some_and(|s| s.is_lt() || (s.is_eq() && !b.closed))
            });
            !above && !below
        }
        Set::Integer { least, most } => {
            let least = least.as_ref().and_then(torse_numbers::Affine::as_number);
            let most = most.as_ref().and_then(torse_numbers::Affine::as_number);
            !(least.is_some_and(|n| n > 0) || most.is_some_and(|n| n < 0))
        }
        Set::Vector(_) | Set::Family { .. } => true,
    }
}

/// The value that a symbol, a sine or a cosine has where a polynomial is zero: of one whose power it is, or in which it is linear with a
/// number before it.
fn value_at_zero(polynomial: &Polynomial) -> Option<(Symbol, Polynomial)> {
    let mut terms = polynomial.terms();
    if let (Some((monomial, _)), None) = (terms.next(), terms.next())
        && let [(symbol, _)] = monomial.as_slice()
        && !symbol.is_number()
    {
        return Some((symbol.clone(), Polynomial::zero()));
    }
    let mut symbols = polynomial.symbols().filter(|symbol| !symbol.is_number());
    symbols.find_map(|symbol| {
        let (rest, slope) = linear(polynomial, symbol)?;
        let slope = slope.as_constant()?;
        Some((symbol.clone(), rest.scaled(&-slope.recip())))
    })
}

/// The polynomial without its constant term, if it has a nonzero one.
fn without_number(polynomial: &Polynomial) -> Option<Polynomial> {
    let number = polynomial
        .terms()
        .filter(|(monomial, _)| monomial.iter().all(|(s, _)| s.is_number()));
    let number = number.fold(Polynomial::zero(), |mut sum, (monomial, value)| {
        sum.enter(monomial.clone(), value.clone());
        sum
    });
    (!number.is_zero()).then(|| polynomial.minus(&number))
}
