//! The symbols of the polynomials in certificates.
//!
//! Every symbol represents a real number. Names, members of families and pi are algebraically independent; the square
//! root of a prime satisfies r^2 = p, and sine and cosine of one angle satisfy s^2 + c^2 = 1.

use serde::{Serialize, Serializer};
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// The unit of a variable that is an angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unit {
    /// Quarter turns: the angle is pi/2 times the variable.
    QuarterTurn,
    /// Radians: the angle is the variable.
    Radian,
}

/// A fraction of `pi/2*x` or of `x`, for a variable x.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle {
    /// The unit of the variable.
    pub unit: Unit,
    /// The number of parts into which the angle is divided, at least one.
    pub parts: u16,
}

/// A symbol of a polynomial.
///
/// Symbols are ordered by kind, then by name, then by angle.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// A declared number, a coordinate `v[1]`, or a member of a family, `P[0,1]`; the coordinate of a point of a
    /// family follows its indices, `P[0,1,2]`.
    Named(Arc<str>),
    /// The positive square root of a prime.
    Root(u32),
    /// The number pi.
    Pi,
    /// The sine of an angle of the variable.
    Sine(Arc<str>, Angle),
    /// The cosine of an angle of the variable.
    Cosine(Arc<str>, Angle),
    /// An exponential, or the logarithm or arc tangent of a number, as it is written. The checker treats it as an opaque symbol.
    Exponential(Arc<str>),
}

impl Symbol {
    /// The symbol with this name.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self::Named(Arc::from(name))
    }

    /// The rank of its kind in the order of symbols.
    fn kind(&self) -> u8 {
        match self {
            Self::Named(_) => 0,
            Self::Root(_) => 1,
            Self::Pi => 2,
            Self::Sine(..) => 3,
            Self::Cosine(..) => 4,
            Self::Exponential(_) => 5,
        }
    }

    /// Whether the symbol is a constant: pi or the root of a prime.
    #[must_use]
    pub fn is_number(&self) -> bool {
        matches!(self, Self::Root(_) | Self::Pi)
    }

    /// The variable that the symbol is or depends on.
    #[must_use]
    pub fn variable(&self) -> Option<&str> {
        match self {
            Self::Named(name) | Self::Sine(name, _) | Self::Cosine(name, _) => Some(name),
            Self::Root(_) | Self::Pi | Self::Exponential(_) => None,
        }
    }
}

impl Ord for Symbol {
    fn cmp(&self, other: &Self) -> Ordering {
        // Clones of a symbol share its name, so most equal names need not be compared letter by letter.
        let names = |a: &Arc<str>, b: &Arc<str>| {
            if Arc::ptr_eq(a, b) {
                Ordering::Equal
            } else {
                a.cmp(b)
            }
        };
        match (self, other) {
            (Self::Named(a), Self::Named(b)) | (Self::Exponential(a), Self::Exponential(b)) => {
                names(a, b)
            }
            (Self::Sine(a, x), Self::Sine(b, y)) | (Self::Cosine(a, x), Self::Cosine(b, y)) => {
                names(a, b).then_with(|| x.cmp(y))
            }
            (Self::Root(p), Self::Root(q)) => p.cmp(q),
            _ => self.kind().cmp(&other.kind()),
        }
    }
}

impl PartialOrd for Symbol {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Display for Angle {
    /// The factor before the variable: `pi/2*`, `1/3*`, or nothing.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.unit, self.parts) {
            (Unit::QuarterTurn, parts) => write!(f, "pi/{}*", 2 * u32::from(parts)),
            (Unit::Radian, 1) => Ok(()),
            (Unit::Radian, parts) => write!(f, "1/{parts}*"),
        }
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Named(name) | Self::Exponential(name) => f.write_str(name),
            Self::Root(prime) => write!(f, "sqrt({prime})"),
            Self::Pi => f.write_str("pi"),
            Self::Sine(name, angle) => write!(f, "sin({angle}{name})"),
            Self::Cosine(name, angle) => write!(f, "cos({angle}{name})"),
        }
    }
}

impl Serialize for Symbol {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
