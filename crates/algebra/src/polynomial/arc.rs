//! The arc tangents and arc sines of numbers.
//!
//! The arc tangent of `p/q` with q > 0 is the angle of the Gaussian integer `q + p i`, and the angle of a product is the sum of
//! the angles of its factors, but for whole turns. So it is a sum of angles of Gaussian primes `a + b i`, each as often as the
//! prime divides, and of a multiple of `pi/4`, which is that of the factors `1 + i` and of the units. Which multiple, an
//! enclosure tells: one of all is left. Multiples of `pi/12` are found by their tangents and sines.

use super::Polynomial;
use super::primes::prime_factors;
use crate::fraction::Fraction;
use crate::rational::{Rational, integer, ratio};
use crate::scalar::{ExactError, Scalar as _};
use crate::symbol::Symbol;
use crate::{Ball, Integer};
use num_traits::{ToPrimitive, Zero};

/// The bits of the enclosures that tell multiples of `pi/4` apart.
const BITS: usize = 128;
/// The most Gaussian primes, counted as often as they divide.
const MAX_FACTORS: usize = 64;

/// A Gaussian integer.
type Gaussian = (Integer, Integer);

impl Polynomial {
    /// The arc tangent of a rational number: a sum of arc tangents of fractions whose squares add up to a prime, and of a
    /// multiple of `pi/4`.
    ///
    /// ```
    /// use torse_algebra::{Polynomial, rational::ratio};
    /// let arc = |n, d| Polynomial::arctangent(&ratio(n, d).unwrap()).unwrap().to_string();
    /// assert_eq!(arc(1, 2), "atan(1/2)");
    /// assert_eq!(arc(1, 3), "-atan(1/2) + 1/4*pi");
    /// assert_eq!(arc(-1, 1), "-1/4*pi");
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoArcTangent`] where the sum of the squares of numerator and denominator has a prime factor that is not
    /// found by dividing by the numbers up to one million or that has more than 32 bits.
    pub fn arctangent(tangent: &Rational) -> Result<Self, ExactError> {
        let refused = || ExactError::NoArcTangent {
            argument: tangent.to_string(),
        };
        let (above, below) = (tangent.numer().clone(), tangent.denom().clone());
        let norm = &above * &above + &below * &below;
        let mut rest: Gaussian = (below, above);
        let mut sum = Self::zero();
        let mut count = 0;
        for (prime, _) in prime_factors(&norm)?.ok_or_else(refused)? {
            let prime = prime.to_u32().ok_or_else(refused)?;
            let Some((a, b)) = gaussian_factor(prime) else {
                continue;
            };
            let arc = Self::symbol(Symbol::Arc(b, a));
            for (sign, factor) in [
                (1, (a.into(), b.into())),
                (-1, (a.into(), -Integer::from(b))),
            ] {
                while let Some(quotient) = divided(&rest, &factor) {
                    rest = quotient;
                    sum = &sum + &arc.scaled(&integer(sign));
                    count += 1;
                    if count > MAX_FACTORS {
                        return Err(refused());
                    }
                }
            }
        }
        // What is left is a product of 1 + i and units.
        let left = Ball::from_rational(tangent, BITS).atan()? - enclosed(&sum)?;
        let quarters = left.divided_by(&Ball::pi(BITS))?.scaled(&integer(4));
        let nearest = quarters.lower().round();
        let is_only = quarters.upper().round() == nearest && quarters.contains(&nearest);
        match is_only.then_some(nearest) {
            Some(eighths) => {
                let turns = eighths / integer(4);
                Ok(&sum + &Self::symbol(Symbol::Pi).scaled(&turns))
            }
            None => Err(refused()),
        }
    }
}

impl Fraction {
    /// The arc tangent of a number: of a rational one, or of the tangent of a multiple of `pi/12`.
    ///
    /// ```
    /// use torse_algebra::{Fraction, Symbol};
    /// let root = Fraction::symbol(Symbol::Root(3));
    /// assert_eq!(root.arctangent().unwrap().to_string(), "1/3*pi");
    /// assert!(Fraction::named("x").arctangent().is_err());
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoArcTangent`] for everything else.
    pub fn arctangent(&self) -> Result<Self, ExactError> {
        if let Some(tangent) = self.as_rational() {
            return Polynomial::arctangent(&tangent).map(Self::from);
        }
        let (above, below) = (self.numerator(), self.denominator());
        twelfth(-5..=5, |sine, cosine| {
            (&(above * cosine) - &(&below * sine)).is_zero()
        })
        .ok_or_else(|| ExactError::NoArcTangent {
            argument: self.to_string(),
        })
    }

    /// The arc sine of a number: of the sine of a multiple of `pi/12`, or of a rational one whose cosine is rational.
    ///
    /// ```
    /// use torse_algebra::{Fraction, rational::ratio};
    /// let arc = |n, d| Fraction::from(ratio(n, d).unwrap()).arcsine().unwrap().to_string();
    /// assert_eq!(arc(-1, 2), "-1/6*pi");
    /// assert_eq!(arc(4, 5), "2*atan(1/2)");
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoArcSine`] for everything else.
    pub fn arcsine(&self) -> Result<Self, ExactError> {
        let refused = || ExactError::NoArcSine {
            argument: self.to_string(),
        };
        let (above, below) = (self.numerator(), self.denominator());
        let known = twelfth(-6..=6, |sine, _| (above - &(&below * sine)).is_zero());
        if let Some(known) = known {
            return Ok(known);
        }
        let sine = self.as_rational().ok_or_else(refused)?;
        let square = integer(1) - &sine * &sine;
        let cosine = Polynomial::square_root(&square).map_err(|_| refused())?;
        let cosine = cosine.as_constant().filter(|c| !c.is_zero());
        let tangent = sine / cosine.ok_or_else(refused)?;
        Polynomial::arctangent(&tangent).map(Self::from)
    }
}

/// The multiple of `pi/12` whose sine and cosine are these.
fn twelfth(
    mut all: std::ops::RangeInclusive<i64>,
    is_it: impl Fn(&Polynomial, &Polynomial) -> bool,
) -> Option<Fraction> {
    all.find_map(|n| {
        let angle = Polynomial::symbol(Symbol::Pi).scaled(&ratio(n, 12)?);
        let (sine, cosine) = angle.sine_cosine().ok()?;
        is_it(&sine, &cosine).then(|| angle.into())
    })
}

/// The numbers a > b > 0 with `a^2 + b^2` this prime, if there are any.
fn gaussian_factor(prime: u32) -> Option<(u32, u32)> {
    if prime % 4 != 1 {
        return None;
    }
    let prime = u64::from(prime);
    let mut b = 1_u64;
    while 2 * b * b < prime {
        let square = prime - b * b;
        let a = num_integer::Roots::sqrt(&square);
        if a * a == square {
            return Some((u32::try_from(a).ok()?, u32::try_from(b).ok()?));
        }
        b += 1;
    }
    None
}

/// The quotient of two Gaussian integers, if it is one.
fn divided((x, y): &Gaussian, (a, b): &Gaussian) -> Option<Gaussian> {
    let norm = a * a + b * b;
    let (above, side) = (x * a + y * b, y * a - x * b);
    let whole = |n: &Integer| (n % &norm).is_zero().then(|| n / &norm);
    Some((whole(&above)?, whole(&side)?))
}

/// The enclosure of a sum of arcs.
fn enclosed(sum: &Polynomial) -> Result<Ball, ExactError> {
    let mut total = Ball::from_rational(&integer(0), BITS);
    for term in sum.terms() {
        if let [(Symbol::Arc(above, below), 1)] = term.powers.as_slice() {
            let tangent = Rational::new((*above).into(), (*below).into());
            let arc = Ball::from_rational(&tangent, BITS).atan()?;
            total = total + arc.scaled(&term.coefficient);
        }
    }
    Ok(total)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arc_of_a_fraction_has_its_value() {
        for above in -20..=20_i64 {
            for below in 1..=20_i64 {
                let tangent = ratio(above, below).unwrap();
                let arc = Polynomial::arctangent(&tangent).unwrap();
                let turns = arc.terms().find(|term| term.powers == [(&Symbol::Pi, 1)]);
                let turns = turns.map_or_else(|| integer(0), |term| term.coefficient);
                let value = enclosed(&arc).unwrap() + Ball::pi(BITS).scaled(&turns);
                let truth = Ball::from_rational(&tangent, BITS).atan().unwrap();
                assert!(value.overlaps(&truth), "{above}/{below}: {arc}");
                let (sine, cosine) = arc.sine_cosine().unwrap();
                let gap = &sine.scaled(&integer(below)) - &cosine.scaled(&integer(above));
                assert!(gap.is_zero(), "{above}/{below}");
            }
        }
    }

    #[test]
    fn the_formula_of_machin_is_zero() {
        let arc = |n, d| Polynomial::arctangent(&ratio(n, d).unwrap()).unwrap();
        let sum = &arc(1, 5).scaled(&integer(16)) - &arc(1, 239).scaled(&integer(4));
        assert_eq!(sum.to_string(), "pi");
    }
}
