//! Light factoring of polynomials, to be read: monomial content, contents with respect to each symbol,
//! repeated factors, linear factors in one variable. Not a complete factorisation.
//!
//! The factors are multiplied out again before they are trusted.

use num_traits::{Signed, ToPrimitive};
use torse_algebra::{Integer, Polynomial, Rational, Symbol, work};

/// Longer polynomials are not factored: greatest common divisors get slow.
const MAX_TERMS: usize = 60;
/// The most work on one polynomial; what needs more is left as it is.
const MAX_WORK: u64 = 3_000_000;

/// Ends of a polynomial in one variable above this are not searched for rational roots.
const MAX_END: u32 = 10_000;

/// `content * product of factor^exponent`.
#[derive(Debug, Clone)]
pub(super) struct Factored {
    pub content: Rational,
    pub factors: Vec<(Polynomial, u32)>,
}

impl Factored {
    /// Factors a polynomial.
    pub fn new(p: &Polynomial) -> Self {
        let (content, primitive) = p.primitive();
        let mut result = Self {
            content,
            factors: vec![],
        };
        if p.as_constant().is_some() {
            return result;
        }
        let factored = work::within(MAX_WORK, || {
            split(&primitive, &mut result);
            result.expanded() == *p
        });
        if factored != Ok(true) {
            result.content = p.primitive().0;
            result.factors = vec![(primitive, 1)];
        }
        result.factors.sort();
        result.turn_complements();
        result
    }

    /// A product of polynomials with exponents.
    pub fn product<'a>(factors: impl Iterator<Item = (&'a Polynomial, u32)>) -> Self {
        let mut result = Self {
            content: torse_algebra::rational::integer(1),
            factors: vec![],
        };
        for (factor, exponent) in factors {
            let own = Self::new(factor);
            let times = usize::try_from(exponent).unwrap_or(usize::MAX);
            result.content *= num_traits::pow(own.content, times);
            for (part, more) in own.factors {
                result.multiply(part, more * exponent);
            }
        }
        result
    }

    /// The polynomial.
    pub fn expanded(&self) -> Polynomial {
        self.factors
            .iter()
            .fold(Polynomial::constant(&self.content), |p, (factor, n)| {
                &p * &factor.power(*n)
            })
    }

    /// Both without the factors that they share.
    pub fn cancelled(&self, other: &Self) -> (Self, Self) {
        let without = |own: &Self, other: &Self| {
            let left = own.factors.iter().map(|(factor, exponent)| {
                let shared = other.factors.iter().find(|(known, _)| known == factor);
                (
                    factor.clone(),
                    exponent.saturating_sub(shared.map_or(0, |(_, n)| *n)),
                )
            });
            Self {
                content: own.content.clone(),
                factors: left.filter(|(_, exponent)| *exponent > 0).collect(),
            }
        };
        (without(self, other), without(other, self))
    }

    fn multiply(&mut self, factor: Polynomial, exponent: u32) {
        match self.factors.iter_mut().find(|(known, _)| *known == factor) {
            Some((_, n)) => *n += exponent,
            None => self.factors.push((factor, exponent)),
        }
    }

    /// Parameters are written `1 - mu`, degrees `k - 1`.
    fn turn_complements(&mut self) {
        for (factor, exponent) in &mut self.factors {
            if unit_binomial(factor) && factor.terms().any(|term| term.coefficient.is_negative()) {
                *factor = -factor.clone();
                if exponent.is_multiple_of(2) {
                    continue;
                }
                self.content = -self.content.clone();
            }
        }
    }
}

/// Whether this is `1 + s` or `1 - s`, up to sign, for a parameter s. By convention single letters from
/// i to n are degrees and indices, not parameters.
pub(super) fn unit_binomial(p: &Polynomial) -> bool {
    let [Symbol::Named(name)] = p.symbols() else {
        return false;
    };
    let index = name.trim_end_matches(|c: char| c.is_ascii_digit()).len() == 1
        && name.starts_with(|c| ('i'..='n').contains(&c));
    let unit = |coefficient: &Rational| coefficient.abs() == torse_algebra::rational::integer(1);
    !index && p.len() == 2 && p.total_degree() == 1 && p.terms().all(|term| unit(&term.coefficient))
}

/// Splits a primitive nonconstant polynomial and multiplies the parts to `into`.
fn split(p: &Polynomial, into: &mut Factored) {
    let (content, p) = p.primitive();
    into.content *= content;
    if p.as_constant().is_some() {
        return;
    }
    let divided = |divisor: &Polynomial| {
        let proper = divisor.as_constant().is_none() && *divisor != p;
        proper.then(|| p.exact_quotient(divisor)).flatten()
    };
    for divisor in divisors(&p) {
        if let Some(quotient) = divided(&divisor) {
            split(&divisor, into);
            split(&quotient, into);
            return;
        }
    }
    into.multiply(p, 1);
}

/// Candidates for proper divisors, cheap ones first.
fn divisors(p: &Polynomial) -> Box<dyn Iterator<Item = Polynomial> + '_> {
    let symbols = || p.symbols().iter();
    let monomial = symbols().map(|s| Polynomial::symbol(s.clone()));
    if p.len() > MAX_TERMS {
        return Box::new(monomial);
    }
    let contents = symbols().map(|s| {
        let coefficients = p.coefficients_in(s);
        coefficients
            .iter()
            .filter(|c| !c.is_zero())
            .fold(Polynomial::zero(), |g, c| g.gcd(c))
    });
    let repeated = symbols().map(|s| p.gcd(&p.partial(s)));
    Box::new(monomial.chain(contents).chain(repeated).chain(linear(p)))
}

/// `q s - r` for every fraction r/q that may be a root of a polynomial in one variable (r divides the
/// last coefficient, q the first).
fn linear(p: &Polynomial) -> Vec<Polynomial> {
    let [symbol @ Symbol::Named(_)] = p.symbols() else {
        return vec![];
    };
    let ends = (p.terms().next(), p.terms().last());
    let (Some(first), Some(last)) = ends else {
        return vec![];
    };
    if first.powers.iter().all(|(_, n)| *n < 2) || !last.powers.is_empty() {
        return vec![];
    }
    let s = Polynomial::symbol(symbol.clone());
    let mut candidates = vec![];
    for q in divisors_of(first.coefficient.numer()) {
        for r in divisors_of(last.coefficient.numer()) {
            let (q, r) = (i64::from(q), i64::from(r));
            let lead = &s * &Polynomial::integer(q);
            candidates.push(&lead - &Polynomial::integer(r));
            candidates.push(&lead + &Polynomial::integer(r));
        }
    }
    candidates
}

/// The positive divisors of a small integer, none for a large one.
fn divisors_of(n: &Integer) -> Vec<u32> {
    let n = n.abs().to_u32().filter(|n| *n <= MAX_END).unwrap_or(0);
    (1..=n).filter(|d| n.is_multiple_of(*d)).collect()
}
