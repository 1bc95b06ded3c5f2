//! Numbers that distinguish two readings of a text: residues modulo a prime, where functions are pseudo-random.
//!
//! Two readings of a text mean the same term if they have equal values at random numbers. For this no equation needs
//! to hold and no root needs to exist: where both readings apply a root, any function will do if both use the same
//! one. So the root, sine and cosine, the exponential, the logarithm and the arcs are fixed pseudo-random functions here. Their power series
//! follow from the value by the usual rules, and an integral is a fixed linear combination of two values of the
//! integrand.

use crate::arithmetic::Arithmetic;
use crate::no_value::{NoValue, Undefined, Work};
use crate::residue::field;
use torse_numbers::Rational;
use torse_numbers::rational::{self, ratio};

/// The largest integer that is recovered from a residue.
const MAX_INTEGER: u64 = 1 << 20;

/// A residue modulo the prime.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Class(u64);

impl Class {
    /// A pseudo-random residue that depends only on the text and the number.
    pub(crate) fn drawn(text: &str, number: u64) -> Self {
        let start = text.bytes().fold(number ^ SALTS[4], |hash, byte| {
            mixed(hash ^ u64::from(byte))
        });
        Self(start % field::PRIME)
    }

    /// Whether it is the residue of zero.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.0 == 0
    }

    /// The residue of an integer.
    pub(crate) fn integer(n: i64) -> Self {
        Self(field::integer(n))
    }
}

/// The arithmetic of residues with pseudo-random functions.
#[derive(Debug, Clone, Copy)]
pub struct Scrambled<'a> {
    /// The budget.
    pub work: &'a Work,
}

/// Constants that make the functions different from one another.
const SALTS: [u64; 8] = [
    0x9e37_79b9_7f4a_7c15,
    0xc2b2_ae3d_27d4_eb4f,
    0x1656_67b1_9e37_79f9,
    0x27d4_eb2f_1656_67c5,
    0x8525_0000_1234_5677,
    0xd6e8_feb8_6659_fd93,
    0xa076_1d64_78bd_642f,
    0xe703_7ed1_a0b4_28db,
];

/// The final mixing step of `SplitMix64`.
fn mixed(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

fn scrambled(x: Class, salt: u64) -> Class {
    Class(mixed(x.0.wrapping_add(salt)) % field::PRIME)
}

impl Arithmetic for Scrambled<'_> {
    type Number = Class;

    fn work(&self) -> &Work {
        self.work
    }

    /// If the prime divides the denominator, a fixed residue.
    fn rational(&self, value: &Rational) -> Class {
        Class(field::residue(value).unwrap_or(SALTS[4] % field::PRIME))
    }

    fn integer(&self, n: i64) -> Class {
        Class(field::integer(n))
    }

    fn pi(&self) -> Class {
        Class(1_415_926_535_897_932_384)
    }

    fn plus(&self, a: &Class, b: &Class) -> Result<Class, NoValue> {
        self.work.spend(1)?;
        Ok(Class(field::sum(a.0, b.0)))
    }

    fn negated(&self, a: &Class) -> Class {
        Class(field::negative(a.0))
    }

    fn times(&self, a: &Class, b: &Class) -> Result<Class, NoValue> {
        self.work.spend(1)?;
        Ok(Class(field::product(a.0, b.0)))
    }

    fn over(&self, a: &Class, b: &Class) -> Result<Class, NoValue> {
        self.work.spend(2)?;
        let inverse = field::inverse(b.0).ok_or(Undefined::ZeroDivisor)?;
        Ok(Class(field::product(a.0, inverse)))
    }

    fn square_root(&self, a: &Class) -> Result<Class, NoValue> {
        self.work.spend(1)?;
        Ok(scrambled(*a, SALTS[0]))
    }

    fn sine_cosine(&self, a: &Class) -> Result<(Class, Class), NoValue> {
        self.work.spend(1)?;
        Ok((scrambled(*a, SALTS[1]), scrambled(*a, SALTS[2])))
    }

    fn exponential(&self, a: &Class) -> Result<Class, NoValue> {
        self.work.spend(1)?;
        Ok(scrambled(*a, SALTS[3]))
    }

    fn logarithm(&self, a: &Class) -> Result<Class, NoValue> {
        self.work.spend(1)?;
        Ok(scrambled(*a, SALTS[5]))
    }

    fn arctangent(&self, a: &Class) -> Result<Class, NoValue> {
        self.work.spend(1)?;
        Ok(scrambled(*a, SALTS[6]))
    }

    fn arcsine(&self, a: &Class) -> Result<Class, NoValue> {
        self.work.spend(1)?;
        Ok(scrambled(*a, SALTS[7]))
    }

    fn is_zero(&self, a: &Class) -> Option<bool> {
        Some(a.0 == 0)
    }

    fn as_rational(&self, a: &Class) -> Option<Rational> {
        let integer = |n: u64| Some(rational::integer(i64::try_from(n).ok()?));
        match (a.0, field::negative(a.0)) {
            (n, _) if n <= MAX_INTEGER => integer(n),
            (_, n) if n <= MAX_INTEGER => Some(-integer(n)?),
            _ => None,
        }
    }

    fn bit_length(&self, _: &Class) -> Option<u64> {
        None
    }

    fn stands_for_integral(&self) -> Option<[(Rational, Rational); 2]> {
        Some([
            (ratio(2, 7)?, ratio(3, 5)?),
            (ratio(11, 13)?, ratio(17, 19)?),
        ])
    }
}
