//! Polynomials that differ from zero by their signs.

use super::gap::{Beyond, Unchecked, Wrong};
use torse_certificate::polynomial::Polynomial;
use torse_certificate::sign::Sign;

/// What differs from zero by its sign.
#[derive(Debug, Default)]
pub(super) struct Apart {
    pub factors: Vec<Polynomial>,
    /// Why a sign could not be followed.
    gap: Option<Beyond>,
}

impl Apart {
    /// Takes a polynomial whose sign was checked.
    pub fn take(
        &mut self,
        checked: Result<(), Unchecked>,
        sign: &Sign<Polynomial>,
    ) -> Result<(), Unchecked> {
        match checked {
            Ok(()) if sign.strict => self.factors.push(sign.polynomial.clone()),
            Ok(()) => return Err(Wrong::Zero.into()),
            Err(Unchecked::Beyond(gap)) => self.gap = Some(gap),
            Err(wrong) => return Err(wrong),
        }
        Ok(())
    }

    /// What is said of a divisor of which nothing that is known says that it does not vanish.
    pub fn may_vanish(&self, divisor: &Polynomial) -> Unchecked {
        match &self.gap {
            Some(gap) => gap.clone().into(),
            None => Wrong::Divisor(divisor.to_string()).into(),
        }
    }
}
