//! The symbols of polynomials.
//!
//! A zero normal form decides an identity only because the symbols are algebraically independent up to known
//! relations: pi is transcendental; a variable x is algebraically independent of the pair sin, cos of its quarter
//! turn (or of one fraction of it); the pair satisfies sin^2 + cos^2 = 1; square roots of distinct primes satisfy r^2
//! = p and nothing else; named symbols are free. Exponentials of different monomials in the variables are independent
//! of one another, of the variables and of their sines and cosines, which are exponentials of imaginary multiples (Ax
//! 1971: if exponents are linearly independent over the rationals modulo constants, their exponentials are
//! algebraically independent over the rational functions). The number e, which is the exponential without variables,
//! is transcendental; whether it is independent of pi is not known. The logarithms of the primes are linearly
//! independent over the rationals, since integers factor in one way; whether they are algebraically independent is not
//! known. So are pi and the arc tangents of fractions `b/a` with primes `a^2 + b^2`, since Gaussian integers factor in one
//! way; no more is known of them either.
//! So a zero normal form also proves an identity between e, pi, logarithms and arcs, but a nonzero normal form in these
//! alone refutes nothing until an enclosure excludes zero.

use crate::affine::Affine;
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

/// The angle of a sine or cosine of a variable x: a fraction of `pi/2*x` or of `x`.
///
/// The sines of x and of x/2 are not independent. The addition theorems express all angles of one variable and unit
/// by the finest fraction that occurs ([`Finest`](crate::Finest)).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle {
    /// The unit of the variable.
    pub unit: Unit,
    /// The number of parts into which the angle is divided.
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

    /// The same angle divided into this many parts.
    #[must_use]
    pub const fn over(self, parts: u16) -> Self {
        Self { parts, ..self }
    }
}

/// An exponent: a monomial in named variables divided by an integer. Without variables the monomial is the number
/// one.
///
/// The exponentials of x and of x/2 are not independent; as for angles, the finest fraction expresses all others
/// ([`Finest`](crate::Finest)).
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Exponent {
    powers: Arc<[(Arc<str>, u16)]>,
    parts: u16,
}

impl Exponent {
    /// The monomial with these variables, in order, divided by `parts`.
    pub(crate) fn new(powers: Vec<(Arc<str>, u16)>, parts: u16) -> Self {
        let powers = powers.into();
        Self { powers, parts }
    }

    /// The variables with their powers.
    #[must_use]
    pub fn powers(&self) -> &[(Arc<str>, u16)] {
        &self.powers
    }

    /// The number by which the monomial is divided.
    #[must_use]
    pub fn parts(&self) -> u16 {
        self.parts
    }

    /// The same monomial divided by another number.
    #[must_use]
    pub fn over(&self, parts: u16) -> Self {
        Self {
            powers: Arc::clone(&self.powers),
            parts,
        }
    }
}

impl fmt::Display for Exponent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let power = |(name, power): &(Arc<str>, u16)| match power {
            1 => name.to_string(),
            power => format!("{name}^{power}"),
        };
        let powers: Vec<String> = self.powers.iter().map(power).collect();
        match (powers.is_empty(), self.parts) {
            (true, 1) => f.write_str("1"),
            (true, parts) => write!(f, "1/{parts}"),
            (false, 1) => f.write_str(&powers.join("*")),
            (false, parts) => write!(f, "1/{parts}*{}", powers.join("*")),
        }
    }
}

/// One symbol of a polynomial ring. The order of the variants is the order of terms: control points first, then
/// names, then constants and functions.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Symbol {
    /// A member of a family, such as the control point `R[k-2]` or the net entry `Q[i,1]`.
    Indexed(Arc<str>, Vec<Affine>),
    /// A variable, parameter or integer symbol.
    Named(Arc<str>),
    /// The positive square root of a prime.
    Root(u32),
    /// The natural logarithm of a prime.
    Log(u32),
    /// The arc tangent of a fraction between 0 and 1, numerator and denominator, whose squares add up to a prime.
    Arc(u32, u32),
    /// The number pi.
    Pi,
    /// The sine of an angle of the named variable.
    Sin(Arc<str>, Angle),
    /// The cosine of an angle of the named variable.
    Cos(Arc<str>, Angle),
    /// The exponential of a monomial; without variables, a root of the number e.
    Exp(Exponent),
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

    /// Whether the symbol is this variable, a function of it, or has it in an index.
    #[must_use]
    pub fn depends_on(&self, variable: &str) -> bool {
        match self {
            Self::Named(name) | Self::Sin(name, _) | Self::Cos(name, _) => &**name == variable,
            Self::Indexed(_, index) => index.iter().any(|i| i.multiple_of(variable) != 0),
            Self::Exp(exponent) => exponent.powers.iter().any(|(name, _)| &**name == variable),
            Self::Root(_) | Self::Log(_) | Self::Arc(..) | Self::Pi => false,
        }
    }

    /// Whether the symbol is a constant number: pi, the root or the logarithm of a prime, or a root of e.
    #[must_use]
    pub fn is_number(&self) -> bool {
        match self {
            Self::Pi | Self::Root(_) | Self::Log(_) | Self::Arc(..) => true,
            Self::Exp(exponent) => exponent.powers.is_empty(),
            _ => false,
        }
    }

    /// The variables that the symbol is a function of; a named symbol is a function of itself.
    pub fn names(&self) -> impl Iterator<Item = &Arc<str>> {
        let angle_variable = match self {
            Self::Named(name) | Self::Sin(name, _) | Self::Cos(name, _) => Some(name),
            Self::Exp(_)
            | Self::Indexed(..)
            | Self::Root(_)
            | Self::Log(_)
            | Self::Arc(..)
            | Self::Pi => None,
        };
        let many = match self {
            Self::Exp(exponent) => exponent.powers(),
            _ => &[],
        };
        angle_variable
            .into_iter()
            .chain(many.iter().map(|(name, _)| name))
    }

    /// The cosine of the same angle, if the symbol is a sine.
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
            Self::Log(prime) => write!(f, "log({prime})"),
            Self::Arc(above, below) => write!(f, "atan({above}/{below})"),
            Self::Pi => f.write_str("pi"),
            Self::Sin(name, a) => write!(f, "sin({})", angle(name, *a)),
            Self::Cos(name, a) => write!(f, "cos({})", angle(name, *a)),
            Self::Exp(exponent) => write!(f, "exp({exponent})"),
        }
    }
}
