//! Truncated Taylor series: exact derivatives of any order by arithmetic.
//!
//! A [`Jet`] of order `n` holds `c_0 + c_1 t + ... + c_n t^n` modulo `t^(n+1)`. Jets form a ring, and the map from a
//! function to its Taylor coefficients at a point respects sums and products. So a formula evaluated at
//! [`Jet::variable`] yields its Taylor coefficients, and its k-th derivative is `k! c_k`. Quotients and quarter turns
//! are computed from their defining equations, `q b = a` and `s' = (pi/2) u' c`, `c' = -(pi/2) u' s`, by comparing
//! coefficients (Griewank and Walther, *Evaluating Derivatives*, 2nd ed., chapter 13).
//!
//! A jet whose scalars are jets differentiates in two directions, which yields mixed partial derivatives:
//!
//! ```
//! use torse_algebra::{Jet, rational::integer};
//! // f(x, y) = x^3 y^2 at (2, 5): its mixed derivative is 6 x^2 y = 120.
//! let x = Jet::variable(integer(2), 1);
//! let y = Jet::variable(x.constant_like(integer(5)), 1);
//! let x = y.constant_like(x);
//! let f = x.powi(3) * y.powi(2);
//! assert_eq!(f.derivative(1).and_then(|f_y| f_y.derivative(1)), Some(integer(120)));
//! ```

use crate::rational::{Integer, Rational, integer};
use crate::scalar::{ExactError, Scalar, ZeroTest};
use std::ops::{Add, Mul, Neg, Sub};

/// The Taylor coefficients `c_0, ..., c_n` of a function at a point, over any scalar.
///
/// The operators truncate to the smaller order of their operands.
///
/// ```
/// use torse_algebra::{Jet, Scalar, rational::{integer, ratio}};
/// // The third derivative of 1/(1 + t) is -6/(1 + t)^4: -3/8 at t = 1.
/// let t = Jet::variable(integer(1), 3);
/// let reciprocal = t.one_like().divided_by(&(t.one_like() + t)).unwrap();
/// assert_eq!(reciprocal.derivative(3), ratio(-3, 8));
/// assert_eq!(reciprocal.derivative(4), None);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Jet<S> {
    /// `c_0, ..., c_n`; never empty.
    coefficients: Vec<S>,
}

impl<S> Jet<S> {
    /// The largest order of a jet. Constructors use this order where a larger one is asked for.
    pub const MAX_ORDER: usize = 4096;

    /// The series `value + rest[0] t + rest[1] t^2 + ...`, of order `rest.len()`.
    #[must_use]
    pub fn from_coefficients(value: S, rest: impl IntoIterator<Item = S>) -> Self {
        Self {
            coefficients: std::iter::once(value).chain(rest).collect(),
        }
    }

    /// The order `n`, that is, the index of the last coefficient.
    #[must_use]
    pub fn order(&self) -> usize {
        self.coefficients.len() - 1
    }

    /// The value `c_0` at the point.
    #[must_use]
    pub fn value(&self) -> &S {
        &self.coefficients[0]
    }

    /// The Taylor coefficients `c_0, ..., c_n`.
    #[must_use]
    pub fn coefficients(&self) -> &[S] {
        &self.coefficients
    }
}

impl<S: Scalar> Jet<S> {
    /// The independent variable at a point: `at + t`.
    #[must_use]
    pub fn variable(at: S, order: usize) -> Self {
        let mut jet = Self::of_constant(at, order);
        if let Some(slope) = jet.coefficients.get_mut(1) {
            *slope = slope.one_like();
        }
        jet
    }

    /// A constant, as a jet of the given order.
    #[must_use]
    pub fn of_constant(value: S, order: usize) -> Self {
        let zero = value.zero_like();
        Self::from_coefficients(value, vec![zero; order.min(Self::MAX_ORDER)])
    }

    /// A constant, as a jet of the order of `self`.
    #[must_use]
    pub fn constant_like(&self, value: S) -> Self {
        Self::of_constant(value, self.order())
    }

    /// The n-th derivative `n! c_n` at the point; `None` beyond the order.
    #[must_use]
    pub fn derivative(&self, n: usize) -> Option<S> {
        let factorial = || (1..=n).fold(Integer::ONE, |product, k| product * k);
        self.coefficients
            .get(n)
            .map(|c| c.scaled(&Rational::from_integer(factorial())))
    }

    /// The jet of the derivative, of one order less; `None` for order 0.
    #[must_use]
    pub fn differentiated(&self) -> Option<Self> {
        let mut slopes = self.slopes().into_iter();
        slopes
            .next()
            .map(|value| Self::from_coefficients(value, slopes))
    }

    /// `k c_k` for `k = 1, ..., n`.
    fn slopes(&self) -> Vec<S> {
        (1..)
            .zip(self.coefficients.iter().skip(1))
            .map(|(k, c)| c.scaled(&integer(k)))
            .collect()
    }

    /// The power with a natural exponent; `powi(0)` is one.
    #[must_use]
    pub fn powi(&self, exponent: u32) -> Self {
        let Some(highest) = exponent.checked_ilog2() else {
            return self.one_like();
        };
        // The binary digits of the exponent after the leading one.
        (0..highest).rev().fold(self.clone(), |power, place| {
            let square = power.clone() * power;
            if exponent >> place & 1 == 1 {
                square * self.clone()
            } else {
                square
            }
        })
    }
}

/// `a_0 b_n + a_1 b_(n-1) + ... + a_n b_0` for two lists of the same length; `None` when they are empty.
fn convolution<S: Scalar>(a: &[S], b: &[S]) -> Option<S> {
    a.iter()
        .zip(b.iter().rev())
        .map(|(x, y)| x.clone() * y.clone())
        .reduce(Add::add)
}

impl<S: Scalar> Add for Jet<S> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let pairs = self.coefficients.into_iter().zip(other.coefficients);
        Self {
            coefficients: pairs.map(|(a, b)| a + b).collect(),
        }
    }
}

impl<S: Scalar> Sub for Jet<S> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let pairs = self.coefficients.into_iter().zip(other.coefficients);
        Self {
            coefficients: pairs.map(|(a, b)| a - b).collect(),
        }
    }
}

impl<S: Scalar> Neg for Jet<S> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            coefficients: self.coefficients.into_iter().map(Neg::neg).collect(),
        }
    }
}

impl<S: Scalar> Mul for Jet<S> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = (&self.coefficients, &other.coefficients);
        let length = a.len().min(b.len());
        Self {
            coefficients: (1..=length)
                .filter_map(|n| convolution(&a[..n], &b[..n]))
                .collect(),
        }
    }
}

impl<S: Scalar> Scalar for Jet<S> {
    fn constant(&self, q: &Rational) -> Self {
        self.constant_like(self.value().constant(q))
    }

    /// Solves `b_0 q_n = a_n - (b_1 q_(n-1) + ... + b_n q_0)` for `q_n`, so the only divisor is the value `b_0`.
    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        let (a, b) = (&self.coefficients, &divisor.coefficients);
        let mut quotient = Vec::with_capacity(a.len());
        for (n, a_n) in a.iter().enumerate().take(b.len()) {
            let numerator = match convolution(&b[1..=n], &quotient) {
                Some(known) => a_n.clone() - known,
                None => a_n.clone(),
            };
            quotient.push(numerator.divided_by(divisor.value())?);
        }
        Ok(Self {
            coefficients: quotient,
        })
    }

    /// With `w_k = (pi/2) k u_k`: `n s_n = w_1 c_(n-1) + ... + w_n c_0`, and `-n c_n` is the same sum with `s` for
    /// `c`.
    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        let (sine, cosine) = self.value().quarter_turn()?;
        if self.order() == 0 {
            return Ok((
                Self::from_coefficients(sine, []),
                Self::from_coefficients(cosine, []),
            ));
        }
        let half = Rational::new(Integer::ONE, Integer::from(2));
        let half_pi = self.value().pi_like()?.scaled(&half);
        let slopes: Vec<S> = self
            .slopes()
            .into_iter()
            .map(|slope| slope * half_pi.clone())
            .collect();
        let (mut s, mut c) = (vec![sine], vec![cosine]);
        for n in 1..=self.order() {
            let nth = Rational::new(Integer::ONE, Integer::from(n));
            let along = |other: &[S]| convolution(&slopes[..n], other).map(|sum| sum.scaled(&nth));
            let (s_n, c_n) = (along(&c), along(&s));
            s.extend(s_n);
            c.extend(c_n.map(Neg::neg));
        }
        Ok((Self { coefficients: s }, Self { coefficients: c }))
    }

    fn pi_like(&self) -> Result<Self, ExactError> {
        self.value().pi_like().map(|pi| self.constant_like(pi))
    }

    fn scaled(&self, q: &Rational) -> Self {
        Self {
            coefficients: self.coefficients.iter().map(|c| c.scaled(q)).collect(),
        }
    }
}

/// A jet is known to be zero if all its coefficients are. It is known to be nonzero if its value is; exactly then it
/// is a valid divisor.
impl<S: Scalar + ZeroTest> ZeroTest for Jet<S> {
    fn is_known_zero(&self) -> bool {
        self.coefficients.iter().all(ZeroTest::is_known_zero)
    }

    fn is_known_nonzero(&self) -> bool {
        self.value().is_known_nonzero()
    }
}
