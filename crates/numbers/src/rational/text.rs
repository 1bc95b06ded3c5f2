//! Rational numbers as text: `7`, `-22/7`.

use super::{Integer, Rational};
use std::fmt;
use std::str::FromStr;

/// Why a text is not a rational number.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RationalError {
    /// A part of the text is not an integer.
    #[error("{part:?} is not an integer")]
    NoInteger {
        /// The part.
        part: String,
    },
    /// The denominator is zero.
    #[error("the denominator is zero")]
    ZeroDenominator,
    /// The text is longer than the text of the largest number within bounds.
    #[error("a number of {characters} characters is too long: at most {limit}")]
    TooLong {
        /// Its length.
        characters: usize,
        /// The greatest length.
        limit: usize,
    },
}

/// An integer, or two with a slash between them.
pub(super) fn parsed(
    text: &str,
    integer: impl Fn(&str) -> Option<Integer>,
) -> Result<Rational, RationalError> {
    let read = |part: &str| {
        integer(part).ok_or_else(|| RationalError::NoInteger {
            part: part.to_owned(),
        })
    };
    let Some((numerator, denominator)) = text.split_once('/') else {
        return Ok(Rational::from_integer(read(text)?));
    };
    Rational::checked_new(read(numerator)?, read(denominator)?)
        .ok_or(RationalError::ZeroDenominator)
}

impl FromStr for Rational {
    type Err = RationalError;

    /// ```
    /// use torse_numbers::{Rational, rational::ratio};
    /// assert_eq!("-22/7".parse::<Rational>().ok(), ratio(-22, 7));
    /// assert!("1/0".parse::<Rational>().is_err());
    /// ```
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        parsed(text, |part| part.parse().ok())
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

/// As [`Display`](fmt::Display).
impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}
