//! Logarithms of formulas: symbols w with `exp(w) == r` ([`torse_core::Claim::rooted`]).
//!
//! Where a power of r is a product of powers of arguments of other logarithms, of exponentials and of a positive number, the
//! logarithm is a sum of the logarithms of these: `r^m = c exp(p) r_1^n_1 ... r_k^n_k` gives
//! `m log(r) = log(c) + p + n_1 log(r_1) + ... + n_k log(r_k)`, since all arguments are positive. The exponents are found by a
//! linear system over polynomials without common factors of which all arguments are products. A root is a power of half
//! its radicand.

use crate::decide::domain::Domain;
use crate::roots::reduced;
use num_traits::{ToPrimitive, Zero};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Integer, Polynomial, Rational, Scalar as _, Symbol};

/// The most terms of an argument whose factors are looked for, and the most factors.
const MAX_TERMS: usize = 60;
const MAX_FACTORS: usize = 16;
/// The largest exponent.
const MAX_EXPONENT: i32 = 24;

/// The value of the logarithm of this argument in terms of those that are known, if it is found.
#[must_use]
pub fn resolved(argument: &Fraction, domain: &Domain<'_>) -> Option<Fraction> {
    let own = Product::new(argument, domain)?;
    let known = domain.logarithms.iter();
    let known: Vec<(&Symbol, Product)> = known
        .filter_map(|log| Some((&log.symbol, Product::new(&log.argument, domain)?)))
        .collect();
    let all = || known.iter().map(|(_, product)| product).chain([&own]);
    let factors = coprime_factors(all().flat_map(Product::polynomials).cloned().collect())?;
    let rows = factors.iter().map(|factor| {
        let exponents = all().map(|product| Some(integer(product.exponent_of(factor)?)));
        exponents.collect::<Option<Vec<Rational>>>()
    });
    let exponents = solution(rows.collect::<Option<_>>()?, known.len())?;
    let common = exponents.iter().fold(Integer::from(1), |common, exponent| {
        num_integer::lcm(common, exponent.denom().clone())
    });
    let common = Rational::from_integer(common);
    let whole = |value: &Rational| {
        let value = (value * &common).to_integer().to_i32()?;
        (value.abs() <= MAX_EXPONENT).then_some(value)
    };
    // own^common over the product of the powers of the others is a number times exponentials.
    let mut rest = own.value.power(whole(&integer(1))?).ok()?;
    let mut sum = Fraction::zero();
    for ((symbol, product), exponent) in known.iter().zip(&exponents) {
        let exponent = whole(exponent)?;
        rest = rest.over(&product.value.power(exponent).ok()?).ok()?;
        if exponent != 0 && !injected(InjectedFault::LogarithmFactorForgotten) {
            let times = integer(i64::from(exponent) * i64::from(product.power));
            sum = sum + Fraction::symbol((*symbol).clone()).scaled(&times);
        }
    }
    sum = sum + rest.without_conditions().logarithm().ok()?;
    let times = common * integer(i64::from(own.power));
    Some(sum.scaled(&times.recip()).without_conditions())
}

/// An argument of a logarithm without roots: the value is the argument to this power.
struct Product {
    value: Fraction,
    power: u32,
    /// Primitive polynomials and whether they divide.
    parts: Vec<(Polynomial, i64)>,
}

impl Product {
    fn new(argument: &Fraction, domain: &Domain<'_>) -> Option<Self> {
        let has_root = |value: &Fraction| {
            let symbols = value.symbols();
            let mut roots = domain.roots.iter();
            roots.any(|root| symbols.contains(&root.symbol))
        };
        let (mut value, mut power) = (argument.clone().without_conditions(), 1);
        if has_root(&value) {
            let square = reduced(&(value.clone() * value.clone()), &domain.roots)?;
            if !has_root(&square) {
                (value, power) = (square.without_conditions(), 2);
            }
        }
        if value.numerator().len() > MAX_TERMS || value.is_zero() {
            return None;
        }
        let mut parts = vec![(plain_part(value.numerator()), 1)];
        for (factor, exponent) in value.denominator_factors() {
            parts.push((plain_part(factor), -i64::from(exponent)));
        }
        parts.retain(|(part, _)| part.as_constant().is_none());
        Some(Self {
            value,
            power,
            parts,
        })
    }

    fn polynomials(&self) -> impl Iterator<Item = &Polynomial> {
        self.parts.iter().map(|(part, _)| part)
    }

    /// How often a factor divides the product.
    fn exponent_of(&self, factor: &Polynomial) -> Option<i64> {
        let mut sum = 0;
        for (part, times) in &self.parts {
            let (mut rest, mut count) = (part.clone(), 0);
            while let Some(quotient) = rest.exact_quotient(factor) {
                rest = quotient;
                count += 1;
                if count > i64::from(MAX_EXPONENT) {
                    return None;
                }
            }
            sum += times * count;
        }
        Some(sum)
    }
}

/// The primitive part without factors whose logarithms are known: exponentials and roots of primes.
fn plain_part(polynomial: &Polynomial) -> Polynomial {
    let mut rest = polynomial.primitive().1;
    for symbol in polynomial.symbols() {
        if !matches!(symbol, Symbol::Exp(_) | Symbol::Root(_)) {
            continue;
        }
        let own = Polynomial::symbol(symbol.clone());
        while rest.as_constant().is_none()
            && let Some(quotient) = rest.exact_quotient(&own)
            && quotient.degree_in(symbol) < rest.degree_in(symbol)
        {
            rest = quotient;
        }
    }
    rest
}

/// Polynomials without common factors of which all of these are products of powers, up to numbers.
fn coprime_factors(mut pending: Vec<Polynomial>) -> Option<Vec<Polynomial>> {
    let mut found: Vec<Polynomial> = vec![];
    while let Some(next) = pending.pop() {
        if next.as_constant().is_some() {
            continue;
        }
        let common = found.iter().enumerate().find_map(|(place, own)| {
            let common = own.gcd(&next);
            common.as_constant().is_none().then_some((place, common))
        });
        match common {
            None => found.push(next.primitive().1),
            Some((place, common)) => {
                let own = found.swap_remove(place);
                pending.push(own.exact_quotient(&common)?);
                pending.push(next.exact_quotient(&common)?);
                pending.push(common);
            }
        }
        if found.len() + pending.len() > 4 * MAX_FACTORS {
            return None;
        }
    }
    (found.len() <= MAX_FACTORS).then_some(found)
}

/// Some solution of linear equations in so many unknowns; the last entry of a row is its right side.
fn solution(mut rows: Vec<Vec<Rational>>, unknowns: usize) -> Option<Vec<Rational>> {
    let mut pivots: Vec<usize> = vec![];
    for column in 0..unknowns {
        let from = pivots.len();
        let Some(place) = (from..rows.len()).find(|row| {
            let entry = rows.get(*row).and_then(|row| row.get(column));
            entry.is_some_and(|entry| !entry.is_zero())
        }) else {
            continue;
        };
        rows.swap(from, place);
        let pivot = rows.get(from)?.clone();
        let lead = pivot.get(column)?.clone();
        for (number, row) in rows.iter_mut().enumerate() {
            let factor = row.get(column)? / &lead;
            if number == from || factor.is_zero() {
                continue;
            }
            for (entry, own) in row.iter_mut().zip(&pivot) {
                *entry -= &factor * own;
            }
        }
        pivots.push(column);
    }
    let mut values = vec![integer(0); unknowns];
    for (number, row) in rows.iter().enumerate() {
        let right = row.last()?;
        match pivots.get(number) {
            Some(column) => *values.get_mut(*column)? = right / row.get(*column)?,
            None if !right.is_zero() => return None,
            None => {}
        }
    }
    Some(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::decide::logarithm::Logarithm;
    use torse_syntax::derivation::declarations::Declarations;

    fn all(arguments: &[(&str, Fraction)]) -> Vec<Logarithm> {
        let log = |(name, argument): &(&str, Fraction)| Logarithm {
            symbol: Symbol::named(name),
            argument: argument.clone(),
        };
        arguments.iter().map(log).collect()
    }

    #[test]
    fn the_logarithm_of_a_product_is_the_sum_whatever_is_known_first() {
        let declarations = Declarations::default();
        let (x, y) = (Fraction::named("x"), Fraction::named("y"));
        let mut domain = Domain::new(&declarations);
        domain.logarithms = all(&[("lx", x.clone()), ("lxy", x.clone() * y.clone())]);
        let found = resolved(&(y.clone() * y.clone()).scaled(&integer(3)), &domain).unwrap();
        assert_eq!(found.to_string(), "-2*lx + 2*lxy + log(3)");
        let quotient = x.over(&y).unwrap();
        assert_eq!(
            resolved(&quotient, &domain).unwrap().to_string(),
            "2*lx - lxy"
        );
        assert!(resolved(&(x + y), &domain).is_none());
    }

    #[test]
    fn a_sign_is_no_factor() {
        let declarations = Declarations::default();
        let mut domain = Domain::new(&declarations);
        let x = Fraction::named("x");
        domain.logarithms = all(&[("lx", x.clone())]);
        assert!(resolved(&-x, &domain).is_none());
    }
}
