//! Coefficients as fractions with denominators of their own.
//!
//! A polynomial keeps one common denominator. If the denominators of the coefficients are unrelated, the common one
//! is about their product, thousands of digits long, and so is each integer coefficient over it, although each
//! coefficient in lowest terms is short. Then products are summed as short fractions, without looking for common
//! factors, and a sum is brought over the common denominator once instead of at every product.

use super::Polynomial;
use super::coefficients::Coefficients;
use crate::rational::Integer;
use dashu_int::ops::BitTest;
use num_integer::Integer as _;

/// The number of terms of each factor that are reduced to lowest terms as a sample.
const TRIALS: usize = 8;
/// Terms are reduced only if each takes part in this many products on average.
const PRODUCTS_PER_TERM: usize = 8;
/// Fractions are used only if the estimated work with the common denominator is this many times larger.
const MARGIN: usize = 4;
/// A sum whose denominator has more bits is brought over the common denominator. So an addition costs a few dozen
/// words of work, little compared with the hundreds of words of a common denominator that is worth avoiding.
const MAX_BITS: usize = 1024;

/// A fraction whose denominator is positive; in lowest terms when it is a coefficient.
#[derive(Clone)]
pub(super) struct Quotient {
    numerator: Integer,
    denominator: Integer,
}

/// The number `whole / common + part`, where `common` is the common denominator.
#[derive(Clone)]
pub(super) struct Sum {
    whole: Integer,
    part: Quotient,
}

/// Sums of short fractions whose common denominator is long.
pub(super) struct Quotients {
    common: Integer,
}

/// The coefficient `c` of `p` in lowest terms.
fn lowest(p: &Polynomial, c: &Integer) -> Quotient {
    let divisor = c.gcd(&p.body.denominator);
    Quotient {
        numerator: c / &divisor,
        denominator: &p.body.denominator / &divisor,
    }
}

/// The average number of bits of the denominators of sampled coefficients in lowest terms.
fn trial(p: &Polynomial) -> usize {
    let step = p.len().div_ceil(TRIALS).max(1);
    let tried = p.body.coefficients.iter().step_by(step);
    let bits = tried.map(|c| lowest(p, c).denominator.bit_len());
    bits.sum::<usize>() / p.len().div_ceil(step).max(1)
}

/// The average number of bits of the coefficients.
fn length(p: &Polynomial) -> usize {
    let bits = p.body.coefficients.iter().map(BitTest::bit_len);
    bits.sum::<usize>() / p.len().max(1)
}

impl Quotients {
    /// Chooses this arithmetic for the product of `a` and `b` if it promises to be faster than integers over the
    /// common denominator; else `None`.
    pub(super) fn if_faster(a: &Polynomial, b: &Polynomial) -> Option<Self> {
        let products = a.len().saturating_mul(b.len());
        let common = a.body.denominator.bit_len() + b.body.denominator.bit_len();
        if common <= MAX_BITS || products < PRODUCTS_PER_TERM * (a.len() + b.len()) {
            return None;
        }
        // Bringing a fraction over the common denominator costs one product and one division by the denominator of
        // the fraction.
        let own = common.saturating_mul(2 * (trial(a) + trial(b)));
        let integers = length(a).saturating_mul(length(b));
        (own.saturating_mul(MARGIN) <= integers).then(|| Self::new(a, b))
    }

    /// This arithmetic for the product of `a` and `b`, whether fast or not.
    pub(super) fn new(a: &Polynomial, b: &Polynomial) -> Self {
        Self {
            common: &a.body.denominator * &b.body.denominator,
        }
    }

    /// The coefficients of a factor.
    pub(super) fn factors(p: &Polynomial) -> Vec<Quotient> {
        p.body.coefficients.iter().map(|c| lowest(p, c)).collect()
    }

    /// The numerator of the fraction over the common denominator, which is a multiple of its own.
    fn over_common(&self, part: &Quotient) -> Integer {
        &part.numerator * &self.common / &part.denominator
    }
}

impl Coefficients for Quotients {
    type Factor = Quotient;
    type Sum = Sum;

    fn zero(&self) -> Sum {
        Sum {
            whole: Integer::ZERO,
            part: Quotient {
                numerator: Integer::ZERO,
                denominator: Integer::ONE,
            },
        }
    }

    fn add_product(&self, sum: &mut Sum, x: &Quotient, y: &Quotient) {
        let numerator = &x.numerator * &y.numerator;
        let denominator = &x.denominator * &y.denominator;
        let Sum { whole, part } = sum;
        if !part.numerator.is_zero()
            && part.denominator.bit_len() + denominator.bit_len() > MAX_BITS
        {
            *whole += self.over_common(part);
            part.numerator = Integer::ZERO;
        }
        if part.numerator.is_zero() {
            *part = Quotient {
                numerator,
                denominator,
            };
            return;
        }
        part.numerator *= &denominator;
        part.numerator += numerator * &part.denominator;
        part.denominator *= denominator;
    }

    fn is_zero(&self, sum: &Sum) -> bool {
        if sum.whole.is_zero() {
            sum.part.numerator.is_zero()
        } else {
            !sum.part.numerator.is_zero() && (&sum.whole + self.over_common(&sum.part)).is_zero()
        }
    }

    fn value(&self, sum: Sum) -> Integer {
        sum.whole + self.over_common(&sum.part)
    }
}
