//! Fast refutation of candidate corrections at a pseudo-random point.
//!
//! Every symbol is replaced by an integer that depends on its name alone, sine and cosine by a rational
//! point of the unit circle, an exponential by the square of what stands for that of the half, pi by a number like any other (it is transcendental, so an identity in it
//! is an identity in a variable). A candidate that differs there is no correction; one that agrees is
//! only a candidate and still has to be proved.

use std::fmt::{self, Write};
use torse_algebra::rational::integer;
use torse_algebra::{Angle, Fraction, Rational, Symbol};

/// The hash of Fowler, Noll and Vo of the text that is written to it.
struct Hash(u64);

impl Write for Hash {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        self.0 = text.bytes().fold(self.0, step);
        Ok(())
    }
}

/// The number that stands for a symbol: it depends on its text alone.
fn number(symbol: &Symbol) -> Rational {
    let mut hash = Hash(0xcbf2_9ce4_8422_2325);
    // A hash takes every text.
    let _ = write!(hash, "{symbol}");
    integer(i64::try_from(hash.0 % 9_973).unwrap_or(0) + 11)
}

/// The value of a symbol at the sample point.
#[must_use]
pub fn value(symbol: &Symbol) -> Option<Fraction> {
    // ((1 - t^2)/(1 + t^2), 2t/(1 + t^2)) is on the unit circle. Half angles are the ones that stand beside whole ones:
    // of these the half has the simple point, and the whole angle is doubled. Other parts are taken as they are.
    let circle = |name: &std::sync::Arc<str>, angle: Angle| {
        let whole = angle.parts == 1;
        let own = if whole { angle.over(2) } else { angle };
        let mut t = number(&Symbol::Cos(name.clone(), own));
        if own.parts == 2 {
            t = integer(3) + &t - (&t / integer(89)).floor() * integer(89);
        }
        let below = integer(1) + &t * &t;
        let (cosine, sine) = ((integer(1) - &t * &t) / &below, integer(2) * t / below);
        if whole {
            return (
                &cosine * &cosine - &sine * &sine,
                integer(2) * sine * cosine,
            );
        }
        (cosine, sine)
    };
    Some(match symbol {
        Symbol::Root(_) => return None,
        // As for angles: the whole is the square of the half.
        Symbol::Exp(exponent) => {
            let half = number(&Symbol::Exp(exponent.over(2)));
            match exponent.parts() {
                1 => (&half * &half).into(),
                2 => half.into(),
                _ => number(symbol).into(),
            }
        }
        Symbol::Sin(name, angle) => circle(name, *angle).1.into(),
        Symbol::Cos(name, angle) => circle(name, *angle).0.into(),
        other => number(other).into(),
    })
}

/// The fraction at the sample point; none where a divisor vanishes there.
#[must_use]
pub fn at_sample(fraction: &Fraction) -> Option<Fraction> {
    fraction.substituted(value).ok()
}
