//! One unit for all angles of a variable, and for all multiples of an exponent.
//!
//! The sines of x/2 and of x are not independent: `sin(x) = 2 sin(x/2) cos(x/2)`. Where both occur, so that a normal form
//! is zero only for the zero function, everything is written in the finest part that makes all of them.

use super::Polynomial;
use super::trigonometry::{MAX_MULTIPLE, multiple_of};
use crate::fraction::Fraction;
use crate::symbol::{Angle, Exponent, Symbol, Unit};
use num_integer::lcm;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The finest part in which each variable stands in angles, for the variables with more than one.
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

/// What is divided into parts.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Divided {
    /// The angle of a variable.
    Angle(Arc<str>, Unit),
    /// A monomial under exponentials.
    Exponent(Exponent),
}

impl Divided {
    /// What is divided in this symbol, and into how many parts.
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
    /// What these symbols need; nothing for a variable whose parts have no common part that is coarse enough to be
    /// written in.
    #[must_use]
    pub fn new<'s>(symbols: impl Iterator<Item = &'s Symbol>) -> Self {
        // The least common multiple, and whether it differs from any of the parts.
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

    /// Whether nothing has to be written anew.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The value of a symbol in the finest parts, for one that stands in a coarser part.
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

    /// The fraction in the finest parts; none where a divisor of it turns out to be zero.
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
