//! Proofs of sign: one certificate, one for each part of the domain, or proofs about factors or coefficients.

use super::certificate::{self, Certificate, CertificateError};
use super::{Sign, growth, prove, without_equations};
use crate::decide::domain::Domain;
use crate::decide::interval::Bound;
use crate::decide::value::{plain, plain_symbol, quotient};
use crate::formula::factored;
use std::collections::BTreeMap;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational, Symbol};
use torse_certificate::line::Line;
use torse_certificate::sign::{
    self as written, Bounded, End, GapTerm, Part, Ray, Sign as Written, Taylor,
};
use torse_certificate::taylor::PartialSum;
use torse_syntax::formula::Relation;

/// A proof of sign about one polynomial, with what shows it.
#[derive(Debug, Clone)]
pub struct Proof {
    /// What is shown to be zero or more: the polynomial, or its negative.
    pub polynomial: Polynomial,
    /// How.
    pub shown: Shown,
}

/// What shows a sign.
#[derive(Debug, Clone)]
pub enum Shown {
    /// A certificate for the domain.
    Whole(Certificate),
    /// One for each of its [`parts`](Domain::parts).
    Parts(Vec<Certificate>),
    /// Proofs about polynomials whose product it is, up to a positive number.
    Factors(Vec<Proof>),
    /// Proofs about polynomials that make it with products of symbols that are not negative.
    Rays(Vec<(Polynomial, Proof)>),
    /// A multiple of the equation in this place of the constraints, and a proof about the rest.
    Along(usize, Polynomial, Box<Proof>),
    /// A proof that a is zero or more, and one about a^2 - b^2, for a - b.
    Squares(Box<[Proof; 2]>),
    /// The signs of factors between their roots; whether the polynomial is more than zero.
    Line(Box<Line<Polynomial>>, bool),
    /// Partial sums of series, and proofs about the coefficients of products of gaps; whether the polynomial is more than zero.
    Taylor(Vec<PartialSum>, Vec<(Vec<u32>, Proof)>, bool),
    /// A symbol, a bound of it, and proofs about the polynomial where its square is zero and where it is that of the bound; whether
    /// the polynomial is more than zero.
    Even(Symbol, Rational, Box<[Proof; 2]>, bool),
    /// A variable, a number c, how often is differentiated, and proofs about the polynomial where the variable is zero and about what
    /// c and the derivatives make; whether the polynomial is more than zero.
    Increasing(Symbol, Rational, u32, Box<[Proof; 2]>, bool),
}

impl Proof {
    /// A proof that the polynomial is zero or more; one that it is more if there is one.
    pub(super) fn find(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Self> {
        let proof = |shown| Self {
            polynomial: polynomial.clone(),
            shown,
        };
        let whole = prove(polynomial, domain);
        if whole.as_ref().is_some_and(|certificate| certificate.strict) {
            return whole.map(|certificate| proof(Shown::Whole(certificate)));
        }
        let parts = domain.parts(polynomial);
        let shown: Option<Vec<Certificate>> = parts.iter().map(|p| prove(polynomial, p)).collect();
        match (whole, shown.filter(|shown| !shown.is_empty())) {
            (None, Some(parts)) => Some(proof(Shown::Parts(parts))),
            (Some(_), Some(parts)) if parts.iter().all(|part| part.strict) => {
                Some(proof(Shown::Parts(parts)))
            }
            (whole, _) => whole.map(|certificate| proof(Shown::Whole(certificate))),
        }
    }

    /// It as part of a proof; `None` where a coordinate cannot be written, which none is that was replayed.
    pub(in crate::decide) fn written(&self, domain: &Domain<'_>) -> Option<Written<Polynomial>> {
        let by = match &self.shown {
            Shown::Whole(certificate) => {
                written::Shown::Whole(certificate::written(domain, certificate)?)
            }
            Shown::Parts(certificates) => {
                let parts = domain.parts(&self.polynomial);
                let pairs = parts.iter().zip(certificates);
                let part = |(part, certificate): (&Domain<'_>, &Certificate)| {
                    let before = domain.part.len();
                    let within = part.part.iter().skip(before).map(|(symbol, interval)| {
                        let end = |bound: &Option<Bound>| {
                            bound.as_ref().map(|bound| End {
                                value: quotient(&bound.value),
                                closed: bound.closed,
                            })
                        };
                        Bounded {
                            symbol: plain_symbol(symbol),
                            lower: end(&interval.lower),
                            upper: end(&interval.upper),
                        }
                    });
                    Some(Part {
                        within: within.collect(),
                        certificate: certificate::written(part, certificate)?,
                    })
                };
                written::Shown::Parts(pairs.map(part).collect::<Option<_>>()?)
            }
            Shown::Factors(proofs) => {
                let signs = proofs.iter().map(|proof| proof.written(domain));
                written::Shown::Factors(signs.collect::<Option<_>>()?)
            }
            Shown::Rays(terms) => {
                let ray = |(product, proof): &(Polynomial, Self)| {
                    Some(Ray {
                        product: product.clone(),
                        coefficient: proof.written(domain)?,
                    })
                };
                written::Shown::Rays(terms.iter().map(ray).collect::<Option<_>>()?)
            }
            Shown::Along(equation, multiple, rest) => {
                written::Shown::Along(Box::new(written::Along {
                    equation: *equation,
                    multiple: multiple.clone(),
                    rest: rest.written(domain)?,
                }))
            }
            Shown::Line(line, _) => written::Shown::Line(line.clone()),
            Shown::Even(symbol, bound, own, _) => {
                let [at_zero, at_bound] = &**own;
                written::Shown::Even(Box::new(written::Even {
                    symbol: plain_symbol(symbol),
                    bound: bound.clone(),
                    at_zero: at_zero.written(domain)?,
                    at_bound: at_bound.written(domain)?,
                }))
            }
            Shown::Increasing(variable, rate, order, own, _) => {
                let [start, slope] = &**own;
                written::Shown::Increasing(Box::new(written::Increasing {
                    variable: plain_symbol(variable),
                    rate: rate.clone(),
                    order: *order,
                    start: start.written(domain)?,
                    slope: slope.written(domain)?,
                }))
            }
            Shown::Taylor(bounds, terms, _) => {
                let term = |(exponents, proof): &(Vec<u32>, Self)| {
                    Some(GapTerm {
                        exponents: exponents.clone(),
                        coefficient: proof.written(domain)?,
                    })
                };
                written::Shown::Taylor(Box::new(Taylor {
                    bounds: bounds.clone(),
                    terms: terms.iter().map(term).collect::<Option<_>>()?,
                }))
            }
            Shown::Squares(own) => {
                let [larger, difference] = &**own;
                written::Shown::Squares(Box::new(written::Squares {
                    larger: larger.written(domain)?,
                    difference: difference.written(domain)?,
                }))
            }
        };
        Some(Written {
            polynomial: self.polynomial.clone(),
            strict: self.strict(),
            by,
        })
    }

    /// The sign of a product from those of its factors.
    pub(super) fn of_factors(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Self)> {
        let (content, factors) = factored(polynomial);
        if factors.iter().map(|(_, exponent)| exponent).sum::<u32>() < 2 {
            return None;
        }
        let (mut negative, mut strict, mut proofs) = (content < Rational::default(), true, vec![]);
        for (factor, exponent) in factors {
            let (sign, proof) = without_equations(&factor, domain)?;
            negative ^= matches!(sign, Sign::Negative | Sign::Nonpositive) && exponent % 2 == 1;
            strict &= matches!(sign, Sign::Positive | Sign::Negative);
            proofs.extend((0..exponent).map(|_| proof.clone()));
        }
        let sign = match (negative, strict) {
            (false, true) => Sign::Positive,
            (false, false) => Sign::Nonnegative,
            (true, true) => Sign::Negative,
            (true, false) => Sign::Nonpositive,
        };
        let polynomial = if negative {
            -polynomial
        } else {
            polynomial.clone()
        };
        let shown = Shown::Factors(proofs);
        Some((sign, Self { polynomial, shown }))
    }

    /// The sign of a polynomial whose coefficients with respect to the symbols of `[0, inf)` are not negative.
    pub(super) fn of_rays(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Self)> {
        let mut groups: BTreeMap<Polynomial, Polynomial> = BTreeMap::new();
        for term in polynomial.terms() {
            let mut rays = Polynomial::integer(1);
            let mut rest = Polynomial::constant(&term.coefficient);
            for (symbol, exponent) in &term.powers {
                let power = Polynomial::symbol((*symbol).clone()).power(u32::from(*exponent));
                let part = if is_ray(symbol, domain) {
                    &mut rays
                } else {
                    &mut rest
                };
                *part = &*part * &power;
            }
            let slot = groups.entry(rays).or_insert_with(Polynomial::zero);
            *slot = &*slot + &rest;
        }
        if groups.len() < 2 {
            return None;
        }
        let (mut strict, mut terms) = (false, vec![]);
        for (rays, coefficient) in groups {
            // A multiple of an equation may bring back what was split: without end.
            let (sign, proof) = without_equations(&coefficient, domain)?;
            match sign {
                Sign::Positive => strict |= rays.as_constant().is_some(),
                Sign::Nonnegative => {}
                Sign::Negative | Sign::Nonpositive => return None,
            }
            terms.push((rays, proof));
        }
        let own = Self {
            polynomial: polynomial.clone(),
            shown: Shown::Rays(terms),
        };
        Some(match strict {
            true => (Sign::Positive, own),
            false => (Sign::Nonnegative, own),
        })
    }

    /// The sign of a polynomial from that of what is left when a multiple of an assumed equation is subtracted: one that
    /// cancels a term, or twice that, for `(u + v)^2` is at most `2 u^2 + 2 v^2`.
    pub(super) fn of_equations(
        polynomial: &Polynomial,
        domain: &Domain<'_>,
    ) -> Option<(Sign, Self)> {
        if polynomial.len() > MAX_TERMS {
            return None;
        }
        let short: Vec<(usize, &Polynomial)> = equations(domain)
            .filter(|(_, value)| value.len() <= MAX_TERMS)
            .collect();
        for (place, value) in &short {
            for multiple in multiples(polynomial, value) {
                if let Some(found) = Self::along(polynomial, &[(*place, *value, multiple)], domain)
                {
                    return Some(found);
                }
            }
        }
        Self::along_two(polynomial, &short, domain)
    }

    /// The same with multiples of two equations that cancel a term together, each half of it.
    fn along_two(
        polynomial: &Polynomial,
        equations: &[(usize, &Polynomial)],
        domain: &Domain<'_>,
    ) -> Option<(Sign, Self)> {
        let half = integer(1) / integer(2);
        for (number, (first, one)) in equations.iter().enumerate() {
            for (second, two) in equations.iter().skip(number + 1).take(MAX_MULTIPLES) {
                let shared = multiples(polynomial, two);
                let both = multiples(polynomial, one);
                for multiple in both.iter().filter(|multiple| shared.contains(multiple)) {
                    let multiple = multiple * &half;
                    let along = [(*first, *one, multiple.clone()), (*second, *two, multiple)];
                    if let Some(found) = Self::along(polynomial, &along, domain) {
                        return Some(found);
                    }
                }
            }
        }
        None
    }

    /// The polynomial by the sign of what is left without these multiples of equations.
    fn along(
        polynomial: &Polynomial,
        equations: &[(usize, &Polynomial, Rational)],
        domain: &Domain<'_>,
    ) -> Option<(Sign, Self)> {
        let mut wholes = vec![];
        let mut rest = polynomial.clone();
        for (place, value, multiple) in equations {
            let left = &rest - &value.scaled(multiple);
            wholes.push((*place, multiple, std::mem::replace(&mut rest, left)));
        }
        let found = without_equations(&rest, domain)?;
        let (sign @ (Sign::Positive | Sign::Nonnegative), proof) = found else {
            return None;
        };
        let along = |rest: Self, (place, multiple, polynomial)| Self {
            polynomial,
            shown: Shown::Along(place, Polynomial::constant(multiple), Box::new(rest)),
        };
        Some((sign, wholes.into_iter().rev().fold(proof, along)))
    }

    /// Whether the polynomial is shown to be more than zero.
    pub(super) fn strict(&self) -> bool {
        match &self.shown {
            Shown::Whole(certificate) => certificate.strict,
            Shown::Parts(parts) => parts.iter().all(|part| part.strict),
            Shown::Factors(proofs) => proofs.iter().all(Self::strict),
            // Where all symbols of the rays are zero, the terms without them are left.
            Shown::Rays(terms) => terms
                .iter()
                .any(|(rays, proof)| rays.is_constant() && proof.strict()),
            Shown::Along(_, _, rest) => rest.strict(),
            Shown::Squares(own) => own[1].strict(),
            Shown::Line(_, strict) => *strict,
            Shown::Taylor(.., strict) | Shown::Even(.., strict) | Shown::Increasing(.., strict) => {
                *strict
            }
        }
    }

    /// Replays the certificates.
    ///
    /// # Errors
    /// [`CertificateError`] says where one fails.
    pub fn check(&self, domain: &Domain<'_>) -> Result<(), CertificateError> {
        match &self.shown {
            Shown::Whole(certificate) => certificate::check(&self.polynomial, domain, certificate),
            Shown::Parts(certificates) => {
                let parts = domain.parts(&self.polynomial);
                if parts.is_empty() || parts.len() != certificates.len() {
                    return Err(CertificateError::Domain);
                }
                let mut pairs = parts.iter().zip(certificates);
                pairs.try_for_each(|(part, own)| certificate::check(&self.polynomial, part, own))
            }
            Shown::Factors(proofs) => {
                let one = Polynomial::integer(1);
                let product = proofs.iter().fold(one, |p, proof| &p * &proof.polynomial);
                let ratio = self.polynomial.leading_coefficient() / product.leading_coefficient();
                if ratio <= Rational::default() || product.scaled(&ratio) != self.polynomial {
                    return Err(CertificateError::Equation);
                }
                proofs.iter().try_for_each(|proof| proof.check(domain))
            }
            Shown::Rays(terms) => {
                let sum = terms.iter().fold(Polynomial::zero(), |sum, (rays, proof)| {
                    &sum + &(rays * &proof.polynomial)
                });
                let not_negative = |(rays, _): &(Polynomial, _)| {
                    let positive = rays.leading_coefficient() > Rational::default();
                    let each = rays.symbols().iter().all(|s| is_ray(s, domain));
                    rays.len() == 1 && positive && each
                };
                if sum != self.polynomial || !terms.iter().all(not_negative) {
                    return Err(CertificateError::Equation);
                }
                terms.iter().try_for_each(|(_, proof)| proof.check(domain))
            }
            Shown::Along(place, multiple, rest) => {
                let equation = equations(domain).find(|(own, _)| own == place);
                let (_, value) = equation.ok_or(CertificateError::Domain)?;
                if &rest.polynomial + &(value * multiple) != self.polynomial {
                    return Err(CertificateError::Equation);
                }
                rest.check(domain)
            }
            // What the coefficients make is multiplied out by the checker.
            Shown::Taylor(_, terms, _) => terms.iter().try_for_each(|(_, own)| own.check(domain)),
            Shown::Even(_, _, own, _) => own.iter().try_for_each(|proof| proof.check(domain)),
            Shown::Increasing(variable, rate, order, own, _) => {
                let parts = own.each_ref().map(|proof| &proof.polynomial);
                if !growth::is_made(&self.polynomial, (variable, rate, *order), parts) {
                    return Err(CertificateError::Equation);
                }
                own.iter().try_for_each(|proof| proof.check(domain))
            }
            // Its cells were looked at when it was made, and the checker looks at them again.
            Shown::Line(line, _) => {
                let line = line.map(&plain);
                match line.target.polynomial(&line.factors) {
                    Some(target) if target == plain(&self.polynomial) => Ok(()),
                    _ => Err(CertificateError::Equation),
                }
            }
            Shown::Squares(own) => {
                let [larger, difference] = &**own;
                let smaller = &larger.polynomial - &self.polynomial;
                if &larger.polynomial.power(2) - &smaller.power(2) != difference.polynomial {
                    return Err(CertificateError::Equation);
                }
                larger.check(domain)?;
                difference.check(domain)
            }
        }
    }
}

/// The longest polynomial, and the longest equation, that are looked at together, and the most multiples.
const MAX_TERMS: usize = 16;
const MAX_MULTIPLES: usize = 6;

/// The numerators of the assumed equations, with their places among the constraints.
pub(super) fn equations<'d>(
    domain: &'d Domain<'_>,
) -> impl Iterator<Item = (usize, &'d Polynomial)> {
    let numbered = domain.constraints.iter().enumerate();
    let equations = numbered.filter(|(_, c)| c.relation == Relation::Equal);
    equations.map(|(place, c)| (place, c.value.numerator()))
}

/// Multiples of an equation that cancel a term of the polynomial, and twice these.
fn multiples(polynomial: &Polynomial, equation: &Polynomial) -> Vec<Rational> {
    let mut found: Vec<Rational> = vec![];
    for own in equation.terms() {
        for term in polynomial.terms().filter(|term| term.powers == own.powers) {
            let multiple = term.coefficient / own.coefficient.clone();
            if !found.contains(&multiple) {
                found.push(multiple);
            }
        }
    }
    found.truncate(MAX_MULTIPLES);
    let twice: Vec<Rational> = found.iter().map(|m| m + m).collect();
    found.extend(twice);
    found
}

/// Whether a symbol is any number that is not negative.
fn is_ray(symbol: &Symbol, domain: &Domain<'_>) -> bool {
    let interval = domain.interval(symbol);
    let from_zero = interval.lower.is_some_and(|bound| bound.value.is_zero());
    matches!(symbol, Symbol::Named(_)) && from_zero && interval.upper.is_none()
}
