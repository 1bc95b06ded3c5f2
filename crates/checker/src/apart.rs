//! Polynomials that differ from zero by their signs.

use super::gap::{CheckError, Unsupported, Wrong};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::sign::Sign;

/// What differs from zero by its sign.
#[derive(Debug, Default)]
pub(super) struct Apart {
    pub factors: Vec<Polynomial>,
    /// Why a sign could not be followed.
    gap: Option<Unsupported>,
}

impl Apart {
    /// Takes a polynomial whose sign was checked.
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

    /// What is said of a divisor of which nothing that is known says that it does not vanish.
    pub fn may_vanish(&self, divisor: &Polynomial) -> CheckError {
        match &self.gap {
            Some(gap) => gap.clone().into(),
            None => Wrong::Divisor(divisor.to_string()).into(),
        }
    }
}
