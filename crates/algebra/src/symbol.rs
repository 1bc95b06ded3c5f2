//! The symbols that polynomials are made of.
//!
//! Independence is what makes a zero normal form decide an identity, so every symbol states its one
//! relation, if it has any: pi is transcendental; a variable x is algebraically independent of the
//! pair sin, cos of its quarter turn (or of one part of it); the pair satisfies sin^2 + cos^2 = 1; square roots of distinct
//! primes satisfy r^2 = p and nothing else; everything named is free.

use crate::affine::Affine;
use std::fmt;
use std::sync::Arc;

/// What a variable counts where it stands in an angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Unit {
    /// Quarter turns: the angle is pi/2 times the variable.
    QuarterTurn,
    /// Radians: the angle is the variable.
    Radian,
}

/// The angle of a sine or cosine, for a variable x: a part of `pi/2*x` or of `x`.
///
/// The sines of x and of x/2 are not independent; of one variable and unit the finest part that occurs makes all others
/// by the addition theorems ([`Finest`](crate::Finest)).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle {
    /// What the variable counts.
    pub unit: Unit,
    /// Into how many parts the angle is divided.
    pub parts: u16,
}

impl Angle {
    /// pi/2 times the variable.
    pub const QUARTER_TURN: Self = Self {
        unit: Unit::QuarterTurn,
        parts: 1,
    };
    /// The variable itself, in radians.
    pub const RADIAN: Self = Self {
        unit: Unit::Radian,
        parts: 1,
    };

    /// The same divided into so many parts.
    #[must_use]
    pub const fn over(self, parts: u16) -> Self {
        Self { parts, ..self }
    }
}

/// One symbol of a polynomial ring. The order of the variants is the order in which terms sort:
/// control points first, then names, then constants and functions.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Symbol {
    /// A member of a family, such as the control point `R[k-2]` or the net entry `Q[i,1]`.
    Indexed(Arc<str>, Vec<Affine>),
    /// A variable, parameter or integer symbol.
    Named(Arc<str>),
    /// The positive square root of a prime.
    Root(u32),
    /// The circle number.
    Pi,
    /// The sine of an angle made from the named variable.
    Sin(Arc<str>, Angle),
    /// The cosine of an angle made from the named variable.
    Cos(Arc<str>, Angle),
}

impl Symbol {
    /// The symbol with this name.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self::Named(Arc::from(name))
    }

    /// The member of the family `name` at `index`.
    #[must_use]
    pub fn indexed(name: &str, index: Vec<Affine>) -> Self {
        Self::Indexed(Arc::from(name), index)
    }

    /// Whether the symbol is the named variable or a function of it.
    #[must_use]
    pub fn depends_on(&self, variable: &str) -> bool {
        match self {
            Self::Named(name) | Self::Sin(name, _) | Self::Cos(name, _) => &**name == variable,
            Self::Indexed(_, index) => index.iter().any(|i| i.multiple_of(variable) != 0),
            Self::Root(_) | Self::Pi => false,
        }
    }

    /// The cosine that belongs to a sine.
    pub(crate) fn partner(&self) -> Option<Self> {
        match self {
            Self::Sin(name, angle) => Some(Self::Cos(Arc::clone(name), *angle)),
            _ => None,
        }
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let angle = |name: &str, Angle { unit, parts }: Angle| match (unit, parts) {
            (Unit::QuarterTurn, parts) => format!("pi/{}*{name}", 2 * u32::from(parts)),
            (Unit::Radian, 1) => name.to_owned(),
            (Unit::Radian, parts) => format!("1/{parts}*{name}"),
        };
        match self {
            Self::Named(name) => f.write_str(name),
            Self::Indexed(name, index) => {
                let index: Vec<String> = index.iter().map(ToString::to_string).collect();
                write!(f, "{name}[{}]", index.join(","))
            }
            Self::Root(prime) => write!(f, "sqrt({prime})"),
            Self::Pi => f.write_str("pi"),
            Self::Sin(name, a) => write!(f, "sin({})", angle(name, *a)),
            Self::Cos(name, a) => write!(f, "cos({})", angle(name, *a)),
        }
    }
}
