//! Fractions of 128-bit integers: the generator computes with numbers of its own, so that a fault in those of the
//! engine cannot hide itself.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// A fraction in lowest terms with a positive denominator.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Q {
    /// Above.
    pub above: i128,
    /// Below, positive.
    pub below: i128,
}

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

impl Q {
    /// 0
    pub const ZERO: Self = Self { above: 0, below: 1 };
    /// 1
    pub const ONE: Self = Self { above: 1, below: 1 };

    /// `above/below`.
    ///
    /// # Panics
    /// For a zero denominator.
    #[must_use]
    pub fn new(above: i128, below: i128) -> Self {
        assert!(below != 0, "a division by zero");
        let common = gcd(above, below) * below.signum();
        Self {
            above: above / common,
            below: below / common,
        }
    }

    /// An integer.
    #[must_use]
    pub fn int(n: i128) -> Self {
        Self { above: n, below: 1 }
    }

    /// The quotient.
    #[must_use]
    pub fn over(self, other: Self) -> Self {
        Self::new(self.above * other.below, self.below * other.above)
    }

    /// A power.
    #[must_use]
    pub fn power(self, exponent: u32) -> Self {
        (0..exponent).fold(Self::ONE, |product, _| product * self)
    }

    /// Whether it is an integer.
    #[must_use]
    pub fn is_integer(self) -> bool {
        self.below == 1
    }
}

impl Add for Q {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let above = self.above * other.below + other.above * self.below;
        Self::new(above, self.below * other.below)
    }
}

impl Sub for Q {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + (-other)
    }
}

impl Mul for Q {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.above * other.above, self.below * other.below)
    }
}

impl Neg for Q {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.above, self.below)
    }
}

impl PartialOrd for Q {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Q {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.above * other.below).cmp(&(other.above * self.below))
    }
}

impl fmt::Display for Q {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.below {
            1 => write!(f, "{}", self.above),
            below => write!(f, "{}/{below}", self.above),
        }
    }
}
