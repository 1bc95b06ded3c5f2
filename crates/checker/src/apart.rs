//! Polynomials that are known to be nonzero by their signs.

use super::gap::{CheckError, Unsupported, Wrong};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::sign::Sign;

/// The polynomials that are nonzero by their signs.
#[derive(Debug, Default)]
pub(super) struct Apart {
    pub factors: Vec<Polynomial>,
    /// Why a sign could not be checked.
    gap: Option<Unsupported>,
}

impl Apart {
    /// Adds a polynomial, given the result of checking its sign.
    pub fn take(
        &mut self,
        checked: Result<(), CheckError>,
        sign: &Sign<Polynomial>,
    ) -> Result<(), CheckError> {
        match checked {
            Ok(()) if sign.strict => self.factors.push(sign.polynomial.clone()),
            Ok(()) => return Err(Wrong::Zero.into()),
            Err(CheckError::Unsupported(gap)) => self.gap = Some(gap),
            Err(wrong) => return Err(wrong),
        }
        Ok(())
    }

    /// The error for a divisor that is not known to be nonzero: unsupported if some sign could not be checked, since
    /// that sign might have covered it; otherwise wrong.
    pub fn may_vanish(&self, divisor: &Polynomial) -> CheckError {
        match &self.gap {
            Some(gap) => gap.clone().into(),
            None => Wrong::Divisor(divisor.to_string()).into(),
        }
    }
}
