//! Balls as decimal text that prints no uncertain digit.

use super::Ball;
use crate::rational::Integer;
use crate::rational::{ceiling_quotient, floor_quotient};
use num_traits::Signed;
use std::fmt;

impl Ball {
    /// The number in decimal, with at most `digits` digits after the point.
    ///
    /// - `0.375` when the ball is a single number that these digits express exactly;
    /// - `45.7079...` when all numbers in the ball begin with these digits (they are cut, not rounded);
    /// - `[45.7079, 45.7080]` otherwise: decimal bounds, rounded outward.
    ///
    /// At most [`Ball::bits`] digits are printed, since further digits would carry no information.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::ratio};
    /// let pi = Ball::pi(16);
    /// assert_eq!(pi.decimal(3), "3.141...");
    /// assert_eq!(pi.decimal(5), "[3.14158, 3.14161]");
    /// assert_eq!(Ball::from_rational(&ratio(-3, 8).unwrap(), 16).decimal(5), "-0.375");
    /// ```
    #[must_use]
    pub fn decimal(&self, digits: usize) -> String {
        let digits = digits.min(self.bits);
        let ten_to_digits = Integer::from(10).pow(digits);
        let unit = Integer::ONE << self.bits;
        let (lo, hi) = (&self.lo * &ten_to_digits, &self.hi * &ten_to_digits);

        if lo == hi && lo.is_multiple_of(&unit) {
            let text = fixed_point(&(lo / unit), digits);
            let trimmed = if digits > 0 {
                text.trim_end_matches('0').trim_end_matches('.')
            } else {
                &text
            };
            return trimmed.to_owned();
        }
        let one_sign = !lo.is_negative() || hi.is_negative();
        let (cut_lo, cut_hi) = (&lo / &unit, &hi / &unit); // toward zero
        if one_sign && cut_lo == cut_hi {
            let minus = if lo.is_negative() && cut_lo.is_zero() {
                "-"
            } else {
                ""
            };
            return format!("{minus}{}...", fixed_point(&cut_lo, digits));
        }
        format!(
            "[{}, {}]",
            fixed_point(&floor_quotient(&lo, &unit), digits),
            fixed_point(&ceiling_quotient(&hi, &unit), digits)
        )
    }
}

/// `numerator * 10^-digits`.
fn fixed_point(numerator: &Integer, digits: usize) -> String {
    let sign = if numerator.is_negative() { "-" } else { "" };
    // At least one digit stands before the point.
    let all = format!(
        "{:0>width$}",
        numerator.abs().to_string(),
        width = digits + 1
    );
    let (whole, fraction) = all.split_at(all.len() - digits);
    let point = if digits > 0 { "." } else { "" };
    format!("{sign}{whole}{point}{fraction}")
}

/// Prints as [`Ball::decimal`] with the number of digits given as in `{:.20}`; by default with all that the precision
/// holds.
impl fmt::Display for Ball {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // log10(2) = 0.30102...
        let held = self.bits.saturating_mul(301) / 1000;
        f.write_str(&self.decimal(f.precision().unwrap_or(held)))
    }
}
