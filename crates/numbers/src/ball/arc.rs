//! The arc tangent and the arc sine.
//!
//! Both increase, so their values at the two ends enclose their values between. At an end x:
//! 1. `atan x` for x < 0 is the opposite of that of -x, and for x > 1 it is `pi/2 - atan(1/x)`;
//! 2. `atan x = 2 atan(x/(1 + sqrt(1 + x^2)))` halves the angle, several times;
//! 3. the series `atan x = x - x^3/3 + x^5/5 - ...` in balls. For 0 <= x < 1 its terms alternate and decrease, so what is left out
//!    is at most the last term that is added, and that is added once more with both signs;
//! 4. `asin x = 2 atan(x/(1 + sqrt(1 - x^2)))`: the tangent of half an angle is the sine over one plus the cosine.
//!
//! The working precision has so many more digits that the rounding of all steps stays below one unit of the result.

use super::{Ball, pi};
use crate::fault_injection::{InjectedFault, injected};
use crate::rational::{Integer, Rational};
use crate::scalar::{ExactError, Scalar as _};
use dashu_int::ops::BitTest;
use num_integer::Roots as _;
use num_traits::Signed;

impl Ball {
    /// The arc tangent: the angle between `-pi/2` and `pi/2` with this tangent.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::integer};
    /// let two = Ball::from_rational(&integer(2), 80);
    /// assert_eq!(two.atan().unwrap().decimal(20), "1.10714871779409050301...");
    /// ```
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] and [`ExactError::NoSquareRoot`] are those of steps that do not fail.
    pub fn atan(&self) -> Result<Self, ExactError> {
        self.increasing(|end| arctangent(end, self.bits))
    }

    /// The arc sine: the angle from `-pi/2` to `pi/2` with this sine.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::ratio};
    /// let part = Ball::from_rational(&ratio(3, 5).unwrap(), 80);
    /// assert_eq!(part.asin().unwrap().decimal(20), "0.64350110879328438680...");
    /// assert!(Ball::from_rational(&ratio(6, 5).unwrap(), 80).asin().is_err());
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoArcSine`] when the ball contains a number that is greater than 1 or less than -1.
    pub fn asin(&self) -> Result<Self, ExactError> {
        let one = Integer::ONE << self.bits;
        if self.lo < -&one || self.hi > one {
            return Err(ExactError::NoArcSine {
                argument: self.to_string(),
            });
        }
        self.increasing(|end| arcsine(end, self.bits))
    }

    /// The values of an increasing function, from those at the ends.
    fn increasing(
        &self,
        value: impl Fn(&Self) -> Result<Self, ExactError>,
    ) -> Result<Self, ExactError> {
        let end = |end: &Integer| Self {
            lo: end.clone(),
            hi: end.clone(),
            bits: self.bits,
        };
        let below = value(&end(&self.lo))?;
        let above = match self.lo == self.hi {
            true => below.clone(),
            false => value(&end(&self.hi))?,
        };
        let hi = match injected(InjectedFault::ArcRoundedDown) {
            true => above.lo,
            false => above.hi,
        };
        Ok(Self {
            lo: below.lo,
            hi,
            bits: self.bits,
        })
    }
}

/// The arc tangent of a dyadic number, with so many digits.
fn arctangent(x: &Ball, bits: usize) -> Result<Ball, ExactError> {
    if x.lo.is_negative() {
        return Ok(-arctangent(&-x.clone(), bits)?);
    }
    let halvings = bits.sqrt() / 2 + 2;
    let working = bits + 2 * halvings + 2 * Integer::from(bits).bit_len() + 16;
    let x = x.rescaled(x.bits.max(working));
    let one = Ball::integer(1, x.bits);
    let value = match x.lo > one.lo {
        true => {
            let quarter = pi::enclosure(working).scaled(&Rational::new(1.into(), 2.into()));
            quarter - of_small(one.divided_by(&x)?.rescaled(working), halvings)?
        }
        false => of_small(x.rescaled(working), halvings)?,
    };
    Ok(value.rescaled(bits))
}

/// The arc tangent of numbers from 0 to 1.
fn of_small(mut x: Ball, halvings: usize) -> Result<Ball, ExactError> {
    let one = Ball::integer(1, x.bits);
    for _ in 0..halvings {
        let length = (&one + &(&x * &x)).sqrt()?;
        x = x.divided_by(&(&one + &length))?;
    }
    let square = &x * &x;
    let (mut power, mut sum) = (x.clone(), x);
    let mut n = 1_u32;
    loop {
        n += 2;
        power = -(&power * &square);
        let term = power.scaled(&Rational::new(1.into(), n.into()));
        sum = &sum + &term;
        let size = term.lo.abs().max(term.hi.abs());
        if size <= Integer::from(2) {
            sum.lo -= &size;
            sum.hi += &size;
            let times = Rational::from_integer(Integer::ONE << halvings);
            return Ok(sum.scaled(&times));
        }
    }
}

/// The arc sine of a dyadic number from -1 to 1, with so many digits.
fn arcsine(x: &Ball, bits: usize) -> Result<Ball, ExactError> {
    // The square is exact with twice as many digits.
    let x = x.rescaled(2 * bits + 8);
    let one = Ball::integer(1, x.bits);
    let cosine = (&one - &(&x * &x)).sqrt()?;
    let tangent = x.divided_by(&(&one + &cosine))?;
    let half = tangent.increasing(|end| arctangent(end, tangent.bits))?;
    Ok(half
        .scaled(&Rational::from_integer(2.into()))
        .rescaled(bits))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rational::ratio;

    #[test]
    fn enclosures_of_few_digits_are_tight_and_contain_those_of_many() {
        for bits in [1, 8, 30, 64, 65, 128, 320] {
            for n in -40..=40_i64 {
                // Dyadic numbers are exact.
                let x = ratio(n, 1 << (n.unsigned_abs() % 4)).unwrap();
                let (few, many) = (Ball::from_rational(&x, bits), Ball::from_rational(&x, 600));
                if few.lo != few.hi {
                    continue;
                }
                let unit = Rational::new(2.into(), Integer::ONE << bits);
                let (arc, fine) = (few.atan().unwrap(), many.atan().unwrap());
                assert!(arc.width() <= unit, "atan({x}) with {bits} bits");
                assert!(arc.lower() <= fine.lower() && fine.upper() <= arc.upper());
                if let (Ok(arc), Ok(fine)) = (few.asin(), many.asin()) {
                    assert!(arc.width() <= unit, "asin({x}) with {bits} bits");
                    assert!(arc.lower() <= fine.lower() && fine.upper() <= arc.upper());
                }
            }
        }
    }
}
