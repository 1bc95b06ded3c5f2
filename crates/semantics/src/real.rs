//! Real numbers at a point: exact if they are `r + t pi` or `r + m sqrt(d)` with rational r, t and m, otherwise enclosed by a ball.
//!
//! So polynomials at rational points are decided exactly, and so are `sin(pi/2*x)` at 0 or 1 and `exp(x)` at 0.

use crate::arithmetic::{Arithmetic, Comparison};
use crate::no_value::{NoValue, Undefined, Unknown, Work};
use crate::surd::{Exact, Surd};
use dashu_int::ops::BitTest;
use num_traits::{One, Signed, Zero};
use std::borrow::Cow;
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;
use torse_numbers::rational::{integer, ratio};
use torse_numbers::{Ball, Integer, Rational, Scalar};

/// The largest number of bits of the numerator or denominator of an exact number; longer ones are enclosed.
const MAX_EXACT_BITS: usize = 3000;
/// The same for numbers with a root, whose products cost four times as much.
const MAX_SURD_BITS: usize = 640;
/// Enclosed numbers count as equal if they differ by at most `2^-AGREEMENT_BITS` times the maximum of 1 and the
/// sides.
const AGREEMENT_BITS: usize = 128;
/// The separation threshold at points that satisfy the hypotheses only approximately: numbers that differ by less
/// than `2^-SLACK_BITS` are not called different.
pub(crate) const SLACK_BITS: usize = 64;
/// The largest number of bits of the integer part of an enclosed number.
const MAX_SIZE_BITS: u64 = 20_000;

/// A real number. Cloning is cheap, because most of the work is copying.
#[derive(Debug, Clone, PartialEq)]
pub enum Real {
    /// A rational number.
    Rational(Rational),
    /// `rational + turns * pi`.
    Turned(Arc<Turned>),
    /// `rational + multiple * sqrt(radicand)`.
    Surd(Arc<Surd>),
    /// A number in this ball.
    Enclosed(Arc<Ball>),
}

/// `rational + turns * pi` with nonzero `turns`.
#[derive(Debug, PartialEq)]
pub struct Turned {
    rational: Rational,
    turns: Rational,
}

impl From<Rational> for Real {
    fn from(rational: Rational) -> Self {
        Self::Rational(rational)
    }
}

impl From<Exact> for Real {
    fn from(number: Exact) -> Self {
        match number {
            Exact::Rational(rational) => Self::Rational(rational),
            Exact::Surd(surd) => Self::Surd(Arc::new(surd)),
        }
    }
}

impl From<Ball> for Real {
    fn from(ball: Ball) -> Self {
        Self::Enclosed(Arc::new(ball))
    }
}

impl fmt::Display for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rational(rational) => write!(f, "{rational}"),
            Self::Turned(number) => {
                let Turned { rational, turns } = &**number;
                if !rational.is_zero() {
                    write!(f, "{rational}")?;
                }
                let sign = match (turns.is_negative(), rational.is_zero()) {
                    (true, _) => "-",
                    (false, true) => "",
                    (false, false) => "+",
                };
                let size = turns.abs();
                if !size.numer().is_one() {
                    write!(f, "{sign}{}*pi", size.numer())?;
                } else {
                    write!(f, "{sign}pi")?;
                }
                if size.is_integer() {
                    Ok(())
                } else {
                    write!(f, "/{}", size.denom())
                }
            }
            Self::Surd(surd) => write!(f, "{surd}"),
            Self::Enclosed(ball) => write!(f, "{}", ball.decimal(20)),
        }
    }
}

impl Real {
    /// `rational + turns * pi`.
    #[must_use]
    pub fn exact(rational: Rational, turns: Rational) -> Self {
        if turns.is_zero() {
            return Self::Rational(rational);
        }
        Self::Turned(Arc::new(Turned { rational, turns }))
    }

    /// The rational part and the multiple of pi of an exact number; `None` for one with a root.
    pub(crate) fn parts(&self) -> Option<(Cow<'_, Rational>, Cow<'_, Rational>)> {
        match self {
            Self::Rational(rational) => {
                Some((Cow::Borrowed(rational), Cow::Owned(Rational::zero())))
            }
            Self::Turned(number) => Some((
                Cow::Borrowed(&number.rational),
                Cow::Borrowed(&number.turns),
            )),
            Self::Surd(_) | Self::Enclosed(_) => None,
        }
    }

    /// The enclosure of this precision.
    #[must_use]
    pub fn ball(&self, bits: usize) -> Ball {
        self.enclosure(bits).into_owned()
    }

    /// The enclosure of this precision, borrowed if the number is stored as one.
    fn enclosure(&self, bits: usize) -> Cow<'_, Ball> {
        match self {
            Self::Rational(rational) => Cow::Owned(Ball::from_rational(rational, bits)),
            Self::Turned(number) => Cow::Owned(
                Ball::from_rational(&number.rational, bits) + Ball::pi(bits).scaled(&number.turns),
            ),
            Self::Surd(surd) => Cow::Owned(surd.ball(bits)),
            Self::Enclosed(ball) => Cow::Borrowed(ball),
        }
    }

    /// The sign, if it is known.
    ///
    /// The sign of an exact number is always known: `r + t pi` is zero only for r = t = 0, because pi is irrational.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        match self {
            Self::Rational(rational) if rational.is_zero() => Some(Ordering::Equal),
            Self::Rational(rational) if rational.is_negative() => Some(Ordering::Less),
            Self::Rational(_) => Some(Ordering::Greater),
            Self::Turned(_) => [128, 1024, 8192]
                .into_iter()
                .find_map(|bits| self.ball(bits).sign()),
            Self::Surd(surd) => Some(surd.sign()),
            Self::Enclosed(ball) => ball.sign(),
        }
    }

    /// Whether the number is zero, if that is known. For `r + t pi` no digits are computed.
    pub(crate) fn is_zero(&self) -> Option<bool> {
        match self {
            Self::Rational(rational) => Some(rational.is_zero()),
            Self::Turned(_) | Self::Surd(_) => Some(false),
            Self::Enclosed(ball) => ball.sign().map(Ordering::is_eq),
        }
    }

    /// The rational value, if the number is known to be rational.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        match self {
            Self::Rational(rational) => Some(rational),
            Self::Turned(_) | Self::Surd(_) | Self::Enclosed(_) => None,
        }
    }

    /// A nearby double, for display.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let (low, high) = self.ball(80).to_f64_bounds();
        f64::midpoint(low, high)
    }
}

/// The arithmetic of real numbers, with balls of a given precision.
#[derive(Debug, Clone, Copy)]
pub struct Reals<'a> {
    /// The number of binary digits after the point.
    pub bits: usize,
    /// The budget.
    pub work: &'a Work,
    /// Whether the numbers satisfy equations only approximately: those that differ by little may be equal at the point that is meant,
    /// so that their order is not known, nor whether there is a quotient by their difference.
    pub near: bool,
}

impl<'a> Reals<'a> {
    /// The arithmetic of numbers that are what they are.
    #[must_use]
    pub const fn new(bits: usize, work: &'a Work) -> Self {
        Self {
            bits,
            work,
            near: false,
        }
    }
}

/// The larger number of bits of numerator and denominator.
pub(crate) fn length(q: &Rational) -> usize {
    q.numer().bit_len().max(q.denom().bit_len())
}

impl Reals<'_> {
    /// Encloses the number if it is too long.
    fn bounded(&self, real: Real) -> Real {
        let bits = match &real {
            Real::Rational(rational) => length(rational),
            Real::Turned(number) => length(&number.rational).max(length(&number.turns)),
            Real::Surd(surd) => surd.parts().iter().map(length).max().unwrap_or(0),
            Real::Enclosed(_) => 0,
        };
        let most = match &real {
            Real::Surd(_) => MAX_SURD_BITS,
            _ => MAX_EXACT_BITS,
        };
        if bits > most {
            return real.ball(self.bits).into();
        }
        real
    }
}

fn is_known_zero(a: &Real) -> bool {
    a.as_rational().is_some_and(Rational::is_zero)
}

fn is_known_one(a: &Real) -> bool {
    a.as_rational().is_some_and(Rational::is_one)
}

/// An operation of a surd with a rational number, or of two surds with one radicand; `None` for other numbers.
fn surds(
    a: &Real,
    b: &Real,
    with_rational: fn(&Surd, &Rational) -> Exact,
    with_surd: fn(&Surd, &Surd) -> Option<Exact>,
) -> Option<Real> {
    let found = match (a, b) {
        (Real::Surd(surd), Real::Rational(q)) | (Real::Rational(q), Real::Surd(surd)) => {
            with_rational(surd, q)
        }
        (Real::Surd(first), Real::Surd(second)) => with_surd(first, second)?,
        _ => return None,
    };
    Some(found.into())
}

/// `sin(pi t)` for rational t, if it is rational.
fn rational_sine(t: &Rational) -> Option<Rational> {
    let sixths = t * integer(6);
    if !sixths.is_integer() {
        return None;
    }
    // The remainder of the truncated division has the sign of the numerator.
    let part = i64::try_from(&(sixths.to_integer() % Integer::from(12))).ok()?;
    Some(match part.rem_euclid(12) {
        0 | 6 => Rational::zero(),
        3 => Rational::one(),
        9 => -Rational::one(),
        1 | 5 => ratio(1, 2)?,
        7 | 11 => ratio(-1, 2)?,
        _ => return None,
    })
}

impl Arithmetic for Reals<'_> {
    type Number = Real;

    fn work(&self) -> &Work {
        self.work
    }

    fn rational(&self, value: &Rational) -> Real {
        self.bounded(value.clone().into())
    }

    fn integer(&self, n: i64) -> Real {
        integer(n).into()
    }

    fn pi(&self) -> Real {
        Real::exact(Rational::zero(), Rational::one())
    }

    fn plus(&self, a: &Real, b: &Real) -> Result<Real, NoValue> {
        // Sums with zero and products with one cost nothing.
        if is_known_zero(a) {
            return Ok(b.clone());
        }
        if is_known_zero(b) {
            return Ok(a.clone());
        }
        self.work.spend(1)?;
        if let (Real::Rational(p), Real::Rational(q)) = (a, b) {
            return Ok(self.bounded((p + q).into()));
        }
        if let Some(sum) = surds(a, b, Surd::plus_rational, Surd::plus) {
            return Ok(self.bounded(sum));
        }
        Ok(match (a.parts(), b.parts()) {
            (Some((p, s)), Some((q, t))) => self.bounded(Real::exact(&*p + &*q, &*s + &*t)),
            _ => (&*a.enclosure(self.bits) + &*b.enclosure(self.bits)).into(),
        })
    }

    fn negated(&self, a: &Real) -> Real {
        match a {
            Real::Rational(rational) => Real::Rational(-rational),
            Real::Turned(number) => Real::exact(-&number.rational, -&number.turns),
            Real::Surd(surd) => surd.times_rational(&integer(-1)).into(),
            Real::Enclosed(ball) => (-&**ball).into(),
        }
    }

    fn times(&self, a: &Real, b: &Real) -> Result<Real, NoValue> {
        if is_known_zero(a) || is_known_zero(b) {
            return Ok(Rational::zero().into());
        }
        if is_known_one(a) {
            return Ok(b.clone());
        }
        if is_known_one(b) {
            return Ok(a.clone());
        }
        self.work.spend(1)?;
        if let Some(product) = surds(a, b, Surd::times_rational, Surd::times) {
            return Ok(self.bounded(product));
        }
        for (a, b) in [(a, b), (b, a)] {
            match (a, b) {
                (Real::Rational(p), Real::Rational(q)) => return Ok(self.bounded((p * q).into())),
                (Real::Rational(q), Real::Turned(number)) => {
                    let product = Real::exact(q * &number.rational, q * &number.turns);
                    return Ok(self.bounded(product));
                }
                _ => {}
            }
        }
        if self.bit_length(a).unwrap_or(0) + self.bit_length(b).unwrap_or(0) > MAX_SIZE_BITS {
            return Err(Unknown::Large { what: "a number" }.into());
        }
        Ok((&*a.enclosure(self.bits) * &*b.enclosure(self.bits)).into())
    }

    fn over(&self, a: &Real, b: &Real) -> Result<Real, NoValue> {
        self.work.spend(2)?;
        match b.is_zero() {
            None => return Err(Unknown::Precision.into()),
            Some(true) => return Err(Undefined::ZeroDivisor.into()),
            Some(false) if self.near && b.ball(self.bits).is_within(SLACK_BITS) => {
                return Err(Unknown::Precision.into());
            }
            Some(false) => {}
        }
        if let (Real::Rational(p), Real::Rational(q)) = (a, b) {
            return Ok(self.bounded((p / q).into()));
        }
        let inverse = match b {
            Real::Surd(surd) => Some(surd.inverse().into()),
            Real::Rational(q) => Some(q.recip().into()),
            Real::Turned(_) | Real::Enclosed(_) => None,
        };
        if let Some(inverse) = inverse
            && let Some(quotient) = surds(a, &inverse, Surd::times_rational, Surd::times)
        {
            return Ok(self.bounded(quotient));
        }
        if let (Some((p, s)), Some((q, t))) = (a.parts(), b.parts()) {
            if t.is_zero() {
                return Ok(self.bounded(Real::exact(&*p / &*q, &*s / &*q)));
            }
            if &*p * &*t == &*s * &*q {
                return Ok(self.bounded((&*s / &*t).into()));
            }
        }
        let quotient = a.ball(self.bits).divided_by(&b.ball(self.bits));
        quotient
            .map(Real::from)
            .map_err(|_| Unknown::Precision.into())
    }

    fn square_root(&self, a: &Real) -> Result<Real, NoValue> {
        self.work.spend(4)?;
        if a.sign() == Some(Ordering::Less) {
            return Err(if self.near && a.ball(self.bits).is_within(SLACK_BITS) {
                Unknown::Precision.into()
            } else {
                Undefined::NegativeRoot.into()
            });
        }
        if let Some(root) = a.as_rational().and_then(Exact::root) {
            return Ok(self.bounded(root.into()));
        }
        let root = a.ball(self.bits).sqrt();
        root.map(Real::from).map_err(|_| Unknown::Precision.into())
    }

    fn sine_cosine(&self, a: &Real) -> Result<(Real, Real), NoValue> {
        self.work.spend(16)?;
        let turns = match a.parts() {
            Some((rational, turns)) if rational.is_zero() => turns,
            _ => {
                let (sine, cosine) = a.ball(self.bits).sin_cos();
                return Ok((sine.into(), cosine.into()));
            }
        };
        // For a rational multiple of pi, the number of quarter turns is rational, which yields the best enclosures.
        let half = Rational::new(1.into(), 2.into());
        let quarters = Ball::from_rational(&(&*turns * integer(2)), self.bits);
        let (sine, cosine) = quarters.quarter_turn().map_err(|_| Unknown::Precision)?;
        let known = |exact: Option<Rational>, ball: Ball| {
            exact.map_or_else(|| Real::from(ball), Real::from)
        };
        Ok((
            known(rational_sine(&turns), sine),
            known(rational_sine(&(&*turns + half)), cosine),
        ))
    }

    fn exponential(&self, a: &Real) -> Result<Real, NoValue> {
        if is_known_zero(a) {
            return Ok(Rational::one().into());
        }
        self.work.spend(16)?;
        let large = |_| Unknown::Large {
            what: "an exponential",
        };
        let power = a.ball(self.bits).exp().map_err(large)?;
        Ok(power.into())
    }

    fn logarithm(&self, a: &Real) -> Result<Real, NoValue> {
        self.work.spend(32)?;
        if matches!(a.sign(), Some(Ordering::Less | Ordering::Equal)) {
            return Err(if self.near && a.ball(self.bits).is_within(SLACK_BITS) {
                Unknown::Precision.into()
            } else {
                Undefined::NoLogarithm.into()
            });
        }
        if a.as_rational().is_some_and(Rational::is_one) {
            return Ok(Rational::zero().into());
        }
        let logarithm = a.ball(self.bits).ln();
        logarithm
            .map(Real::from)
            .map_err(|_| Unknown::Precision.into())
    }

    fn arctangent(&self, a: &Real) -> Result<Real, NoValue> {
        self.work.spend(64)?;
        // The tangents of the rational multiples of pi that are rational are 0, 1 and -1.
        for (tangent, eighths) in [(0, 0), (1, 2), (-1, -2)] {
            if a.as_rational().is_some_and(|own| *own == integer(tangent)) {
                let turns = Rational::new(eighths.into(), 8.into());
                return Ok(Real::exact(Rational::zero(), turns));
            }
        }
        let arc = a.ball(self.bits).atan();
        arc.map(Real::from).map_err(|_| Unknown::Precision.into())
    }

    fn arcsine(&self, a: &Real) -> Result<Real, NoValue> {
        self.work.spend(64)?;
        let one = self.integer(1);
        for beyond in [self.minus(a, &one)?, self.minus(&self.negated(a), &one)?] {
            if beyond.sign() == Some(Ordering::Greater) {
                return Err(
                    if self.near && beyond.ball(self.bits).is_within(SLACK_BITS) {
                        Unknown::Precision.into()
                    } else {
                        Undefined::NoArc.into()
                    },
                );
            }
        }
        // The sines of the rational multiples of pi that are rational.
        for (half_sine, sixths) in [(0, 0), (1, 1), (2, 3), (-1, -1), (-2, -3)] {
            let sine = Rational::new(half_sine.into(), 2.into());
            if a.as_rational() == Some(&sine) {
                let turns = Rational::new(sixths.into(), 6.into());
                return Ok(Real::exact(Rational::zero(), turns));
            }
        }
        let arc = a.ball(self.bits).asin();
        arc.map(Real::from).map_err(|_| Unknown::Precision.into())
    }

    /// By their order, and not by a root: where it is not known, the ball from the greater one of the lower ends to the
    /// greater one of the upper ends.
    fn greater(&self, a: &Real, b: &Real) -> Result<Real, NoValue> {
        let gap = self.minus(a, b)?;
        Ok(match gap.sign() {
            Some(Ordering::Less) => b.clone(),
            Some(_) => a.clone(),
            None => {
                let (a, b) = (a.ball(self.bits), b.ball(self.bits));
                let (low, high) = (a.lower().max(b.lower()), a.upper().max(b.upper()));
                Ball::from_bounds(&low, &high, self.bits).into()
            }
        })
    }

    fn is_beside_domain(&self) -> bool {
        self.near
    }

    fn is_zero(&self, a: &Real) -> Option<bool> {
        a.is_zero()
    }

    fn as_rational(&self, a: &Real) -> Option<Rational> {
        a.as_rational().cloned()
    }

    fn between(&self, low: &Rational, high: &Rational) -> Option<Real> {
        Some(Ball::from_bounds(low, high, self.bits).into())
    }

    /// Differences of exact numbers are exact. Enclosed numbers count as equal if their difference is enclosed within
    /// `2^-128` times the maximum of 1 and the sides.
    fn compare(&self, x: &Real, y: &Real) -> Result<Comparison, NoValue> {
        let gap = self.minus(x, y)?;
        let size = || {
            let one = Ball::from_rational(&integer(1), 8);
            let (x, y) = (x.ball(self.bits).abs(), y.ball(self.bits).abs());
            one.hull(&x).hull(&y).upper()
        };
        let within = |bits: usize| {
            let bound = size() / Rational::from_integer(Integer::ONE << bits);
            gap.ball(self.bits).abs().upper() <= bound
        };
        Ok(match gap.sign() {
            Some(Ordering::Equal) => Comparison::Equal,
            Some(_) | None if within(AGREEMENT_BITS) && (self.near || gap.sign().is_none()) => {
                Comparison::Near
            }
            None => Comparison::Open,
            Some(_) if self.near && within(SLACK_BITS) => Comparison::Open,
            Some(Ordering::Less) => Comparison::Less,
            Some(Ordering::Greater) => Comparison::Greater,
        })
    }

    /// Far smaller than the threshold of comparisons, see the module `judge`.
    fn is_negligible(&self, a: &Real) -> bool {
        let small = Rational::new(1.into(), Integer::from(1) << 136);
        match a {
            Real::Rational(rational) => rational.abs() <= small,
            Real::Turned(_) | Real::Surd(_) => false,
            Real::Enclosed(ball) => {
                let size = ball.abs();
                size.upper() <= small
            }
        }
    }

    fn bit_length(&self, a: &Real) -> Option<u64> {
        let integer_bits =
            |q: &Rational| (q.numer().bit_len() + 1).saturating_sub(q.denom().bit_len());
        let bits = match a {
            Real::Rational(rational) => integer_bits(rational),
            Real::Turned(number) => {
                integer_bits(&number.rational).max(integer_bits(&number.turns) + 2)
            }
            Real::Surd(surd) => {
                let bits = surd.parts().iter().map(integer_bits).max().unwrap_or(0);
                bits.saturating_mul(2)
            }
            Real::Enclosed(ball) => {
                let (low, high) = ball.to_f64_bounds();
                let size = low.abs().max(high.abs());
                if size < 1e300 {
                    // A power of two above the absolute value; doubles below this bound have small exponents.
                    (libm::log2(size).max(0.0).ceil() as usize) + 1
                } else {
                    ball.abs()
                        .upper()
                        .numer()
                        .bit_len()
                        .saturating_sub(ball.bits())
                }
            }
        };
        u64::try_from(bits).ok()
    }
}
