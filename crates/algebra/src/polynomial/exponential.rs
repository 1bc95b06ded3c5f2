//! The exponential of a polynomial, where it is a quotient of polynomials again.
//!
//! `exp(a + b) = exp(a) exp(b)` splits the exponent into its terms; a term is a rational multiple of a monomial in named
//! variables, and its exponential a power of that of one part of the monomial. What is divided by are exponentials alone,
//! which vanish nowhere and are no condition.

use super::Polynomial;
use crate::fraction::Fraction;
use crate::scalar::ExactError;
use crate::symbol::{Exponent, Symbol};
use num_traits::{Signed, ToPrimitive};

/// The largest multiple of a part that is expanded, and the finest part.
pub(super) const MAX_MULTIPLE: u64 = 64;

impl Polynomial {
    /// The exponential of the polynomial.
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
    /// [`ExactError::NoExponential`] for pi, roots, sines and members of families in the exponent, and for multiples
    /// above 64 or parts finer than a 64th.
    pub fn exponential(&self) -> Result<Fraction, ExactError> {
        let refused = || ExactError::NoExponential {
            argument: self.to_string(),
        };
        let (mut above, mut below) = (Self::integer(1), Self::integer(1));
        for term in self.terms() {
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
    /// Whether this is a multiple of a product of exponentials, which vanishes nowhere.
    #[must_use]
    pub fn is_exponential(&self) -> bool {
        let mut symbols = self.symbols().iter();
        self.len() == 1
            && !symbols.as_slice().is_empty()
            && symbols.all(|s| matches!(s, Symbol::Exp(_)))
    }
}

impl Exponent {
    /// What stands in the exponent.
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
