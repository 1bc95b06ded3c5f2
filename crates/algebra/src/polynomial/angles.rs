//! A common unit for all angles of a variable and for all fractions of an exponent.
//!
//! The sines of x/2 and of x are not independent: `sin(x) = 2 sin(x/2) cos(x/2)`. Where both occur, everything is
//! rewritten in the finest fraction of the angle. Then a normal form is zero if and only if the function is.

use super::Polynomial;
use super::trigonometry::{MAX_MULTIPLE, multiple_of};
use crate::fraction::Fraction;
use crate::symbol::{Angle, Exponent, Symbol, Unit};
use num_integer::lcm;
use std::collections::BTreeMap;
use std::sync::Arc;

/// For each variable that occurs with several fractions of its angle (or exponent): the common fraction of all of
/// them.
///
/// ```
/// use torse_algebra::{Finest, Fraction};
/// let angle = Fraction::named("x");
/// let half = angle.scaled(&torse_algebra::rational::ratio(1, 2).unwrap());
/// let (sine, _) = angle.sine_cosine()?;
/// let (half_sine, half_cosine) = half.sine_cosine()?;
/// let product = Fraction::integer(2) * half_sine * half_cosine;
/// let finest = Finest::new([sine.symbols(), product.symbols()].concat().iter());
/// assert!(finest.write(&sine).is_some_and(|s| s.is_identical(&product)));
/// # use torse_algebra::Scalar as _;
/// # Ok::<(), torse_algebra::ExactError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Finest(BTreeMap<Divided, u16>);

/// An angle or an exponent, of which fractions occur.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Divided {
    /// The angle of a variable.
    Angle(Arc<str>, Unit),
    /// A monomial under exponentials.
    Exponent(Exponent),
}

impl Divided {
    /// The angle or exponent of a symbol, and the number of parts into which the symbol divides it.
    fn new(symbol: &Symbol) -> Option<(Self, u16)> {
        match symbol {
            Symbol::Sin(name, angle) | Symbol::Cos(name, angle) => {
                Some((Self::Angle(Arc::clone(name), angle.unit), angle.parts))
            }
            Symbol::Exp(exponent) => Some((Self::Exponent(exponent.over(1)), exponent.parts())),
            _ => None,
        }
    }
}

impl Finest {
    /// Collects the fractions of angles and exponents in `symbols`. A variable is left out if the common fraction
    /// would be too fine to be written.
    #[must_use]
    pub fn new<'s>(symbols: impl Iterator<Item = &'s Symbol>) -> Self {
        // For each angle or exponent: the least common multiple of the numbers of parts, and whether it differs from
        // one of these numbers.
        let mut all: BTreeMap<Divided, (u64, bool)> = BTreeMap::new();
        for (divided, parts) in symbols.filter_map(Divided::new) {
            let parts = u64::from(parts);
            let (finest, mixed) = all.entry(divided).or_insert((parts, false));
            *mixed |= *finest != parts;
            if *finest <= MAX_MULTIPLE {
                *finest = lcm(*finest, parts);
            }
        }
        let needed = all.into_iter().filter(|(_, (_, mixed))| *mixed);
        let written = needed.filter(|(_, (parts, _))| *parts <= MAX_MULTIPLE);
        Self(
            written
                .filter_map(|(key, (parts, _))| Some((key, u16::try_from(parts).ok()?)))
                .collect(),
        )
    }

    /// Whether no symbol has to be rewritten.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// A symbol with a coarser angle or exponent, written in the finest parts; `None` for all other symbols.
    #[must_use]
    pub fn value(&self, symbol: &Symbol) -> Option<Polynomial> {
        let (divided, own) = Divided::new(symbol)?;
        let parts = *self.0.get(&divided)?;
        if parts == own || !parts.is_multiple_of(own) {
            return None;
        }
        let multiple = parts / own;
        Some(match symbol {
            Symbol::Sin(name, angle) => {
                multiple_of(name, Angle { parts, ..*angle }, i64::from(multiple)).0
            }
            Symbol::Cos(name, angle) => {
                multiple_of(name, Angle { parts, ..*angle }, i64::from(multiple)).1
            }
            Symbol::Exp(exponent) => {
                Polynomial::symbol(Symbol::Exp(exponent.over(parts))).power(u32::from(multiple))
            }
            _ => return None,
        })
    }

    /// Rewrites a fraction in the finest parts; `None` if a divisor of it then is zero.
    #[must_use]
    pub fn write(&self, value: &Fraction) -> Option<Fraction> {
        if self.is_empty() {
            return Some(value.clone());
        }
        value
            .substituted(|symbol| self.value(symbol).map(Fraction::from))
            .ok()
    }
}
