//! The exponential of a polynomial, if it is a quotient of polynomials.
//!
//! `exp(a + b) = exp(a) exp(b)` splits the exponent into its terms. A term is a rational multiple of a monomial in
//! named variables, and its exponential is a power of the exponential of one part of that monomial. All divisors are
//! exponentials, which vanish nowhere, so they are not conditions.

use super::Polynomial;
use crate::fraction::Fraction;
use crate::scalar::ExactError;
use crate::symbol::{Exponent, Symbol};
use num_traits::{Signed, ToPrimitive};

/// The largest multiple of a part that is expanded, and the largest number of parts.
pub(super) const MAX_MULTIPLE: u64 = 64;

impl Polynomial {
    /// The exponential of this polynomial.
    ///
    /// ```
    /// use torse_algebra::{Polynomial, rational::ratio};
    /// let x = Polynomial::named("x");
    /// let half = x.scaled(&ratio(-1, 2).unwrap()).exponential().unwrap();
    /// assert_eq!(half.to_string(), "1/exp(1/2*x)");
    /// assert!(half.conditions().is_empty());
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoExponential`] if pi, roots, sines or members of families occur in the exponent, logarithms
    /// otherwise than as an integer multiple of one, and for multiples above 64 or more than 64 parts.
    pub fn exponential(&self) -> Result<Fraction, ExactError> {
        let refused = || ExactError::NoExponential {
            argument: self.to_string(),
        };
        let (mut above, mut below) = (Self::integer(1), Self::integer(1));
        for term in self.terms() {
            // exp(n log(p)) = p^n
            if let [(Symbol::Log(prime), 1)] = term.powers.as_slice() {
                let times = term
                    .coefficient
                    .is_integer()
                    .then(|| term.coefficient.numer());
                let times = times.and_then(ToPrimitive::to_i64);
                let times = times.filter(|n| n.unsigned_abs() <= MAX_MULTIPLE);
                let times = times.ok_or_else(refused)?;
                let power = Self::integer(i64::from(*prime))
                    .power(times.unsigned_abs().try_into().map_err(|_| refused())?);
                if times < 0 {
                    below = &below * &power;
                } else {
                    above = &above * &power;
                }
                continue;
            }
            let powers = term.powers.iter().map(|(symbol, power)| match symbol {
                Symbol::Named(name) => Some((name.clone(), *power)),
                _ => None,
            });
            let powers: Vec<_> = powers.collect::<Option<_>>().ok_or_else(refused)?;
            let multiple = term.coefficient.numer().abs().to_u32();
            let multiple = multiple.filter(|n| u64::from(*n) <= MAX_MULTIPLE);
            let parts = term.coefficient.denom().to_u16();
            let parts = parts.filter(|n| u64::from(*n) <= MAX_MULTIPLE);
            let (multiple, parts) = multiple.zip(parts).ok_or_else(refused)?;
            let part = Self::symbol(Symbol::Exp(Exponent::new(powers, parts))).power(multiple);
            if term.coefficient.is_negative() {
                below = &below * &part;
            } else {
                above = &above * &part;
            }
        }
        Fraction::from(above).over(&below.into())
    }
}

impl Polynomial {
    /// Whether this is a constant multiple of a product of exponentials, which vanishes nowhere.
    #[must_use]
    pub fn is_exponential(&self) -> bool {
        let mut symbols = self.symbols().iter();
        self.len() == 1
            && !symbols.as_slice().is_empty()
            && symbols.all(|s| matches!(s, Symbol::Exp(_)))
    }
}

impl Exponent {
    /// The exponent as a polynomial.
    #[must_use]
    pub fn polynomial(&self) -> Polynomial {
        let one = Polynomial::constant(&crate::rational::Rational::new(
            1.into(),
            self.parts().into(),
        ));
        self.powers().iter().fold(one, |product, (name, power)| {
            &product * &Polynomial::named(name).power(u32::from(*power))
        })
    }
}
