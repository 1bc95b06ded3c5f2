//! Real roots of polynomials in one variable, counted and isolated exactly.
//!
//! **Sturm (1829).** Let `p_0 = p`, `p_1 = p'` and `p_(i+1) = -(p_(i-1) mod p_i)`, up to positive factors, and let
//! `V(x)` be the number of sign changes in `p_0(x), p_1(x), ...` without zeros. Divide all members by the last one
//! (the greatest common divisor of `p` and `p'`). Then `V(a) - V(b)` is the number of *distinct* real roots in `(a,
//! b]` for all `a < b`, even if `a` or `b` is a root. The division keeps `p_1/p_0 = sum m_i/(x - r_i)`, whose
//! residues are positive; the proof uses nothing else.
//!
//! The members are primitive integer polynomials, so nothing is rounded and coefficients stay small. Polynomials are
//! slices of coefficients, ascending: `[c_0, c_1, ...]`.
//!
//! ```
//! use torse_algebra::{SturmSequence, rational::{integer, ratio}};
//! // (x - 1)^2 (x + 2) = x^3 - 3 x + 2.
//! let roots = SturmSequence::new(&[integer(2), integer(-3), integer(0), integer(1)])?;
//! assert_eq!(roots.count(..), 2);
//! assert_eq!(roots.count(integer(-2)..integer(1)), 1); // -2 included, 1 excluded
//! let root = &roots.isolate(integer(0)..=integer(5))?[0];
//! assert!(roots.refine(root, &ratio(1, 1000).unwrap())?.contains(&integer(1)));
//! # Ok::<(), torse_algebra::sturm::SturmError>(())
//! ```

mod integral;
mod isolate;
mod sign;

use crate::rational::{Integer, Rational};
use dashu_int::ops::BitTest;
use num_traits::Zero;
use std::cmp::Ordering;
use std::ops::{Bound, RangeBounds};

pub use isolate::RootInterval;
pub use sign::SignOn;

/// Why roots could not be counted, isolated or refined.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SturmError {
    /// All coefficients are zero: every number is a root.
    #[error("the zero polynomial has every number as a root")]
    ZeroPolynomial,
    /// The degree is above [`SturmSequence::MAX_DEGREE`].
    #[error("degree {degree} exceeds {limit}")]
    DegreeTooLarge {
        /// The degree.
        degree: usize,
        /// The largest degree.
        limit: usize,
    },
    /// A coefficient, cleared of denominators, is above [`SturmSequence::MAX_BITS`].
    #[error("a coefficient has {bits} bits, more than {limit}")]
    CoefficientTooLarge {
        /// The number of bits of the largest coefficient.
        bits: usize,
        /// The largest number of bits.
        limit: usize,
    },
    /// The interval has no point.
    #[error("the interval is empty")]
    EmptyInterval,
    /// The requested width is not positive.
    #[error("a root cannot be refined to width {width}")]
    WidthNotPositive {
        /// The requested width.
        width: Rational,
    },
    /// Bisection stopped after [`SturmSequence::MAX_BISECTIONS`].
    #[error("after {bisections} bisections {count} roots remain between {lower} and {upper}")]
    BudgetSpent {
        /// The number of bisections made.
        bisections: usize,
        /// Lower end of the current interval.
        lower: Rational,
        /// Upper end of the current interval.
        upper: Rational,
        /// The number of roots in that interval.
        count: usize,
    },
}

/// The Sturm sequence of a polynomial. It counts the distinct real roots in any interval.
#[derive(Debug, Clone)]
pub struct SturmSequence {
    /// The polynomial times a positive number.
    polynomial: Vec<Integer>,
    /// Its Sturm sequence divided by the last member; the first member is square-free.
    members: Vec<Vec<Integer>>,
}

impl SturmSequence {
    /// The largest degree accepted.
    pub const MAX_DEGREE: usize = 128;
    /// The largest number of bits of a coefficient after denominators are cleared and common factors cancelled.
    pub const MAX_BITS: usize = 1 << 14;
    /// The largest number of bisections in one call.
    pub const MAX_BISECTIONS: usize = 4096;

    /// The sequence of the polynomial with these coefficients, ascending; trailing zeros are ignored.
    ///
    /// # Errors
    /// [`SturmError::ZeroPolynomial`], [`SturmError::DegreeTooLarge`],
    /// [`SturmError::CoefficientTooLarge`].
    pub fn new(coefficients: &[Rational]) -> Result<Self, SturmError> {
        let length = coefficients
            .iter()
            .rposition(|c| !c.is_zero())
            .map_or(0, |last| last + 1);
        let degree = length.checked_sub(1).ok_or(SturmError::ZeroPolynomial)?;
        if degree > Self::MAX_DEGREE {
            return Err(SturmError::DegreeTooLarge {
                degree,
                limit: Self::MAX_DEGREE,
            });
        }
        let polynomial = integral::cleared(&coefficients[..length]);
        let bits = polynomial.iter().map(BitTest::bit_len).max().unwrap_or(0);
        if bits > Self::MAX_BITS {
            return Err(SturmError::CoefficientTooLarge {
                bits,
                limit: Self::MAX_BITS,
            });
        }
        let mut members = vec![polynomial.clone(), integral::derivative(&polynomial)];
        while let [.., before, last] = members.as_slice() {
            if last.is_empty() {
                members.pop();
                break;
            }
            members.push(integral::negated_remainder(before, last));
        }
        if let Some(common) = members.last().cloned() {
            for member in &mut members {
                *member = integral::exact_quotient(member, &common);
            }
        }
        Ok(Self {
            polynomial,
            members,
        })
    }

    /// The sign of the polynomial at a point.
    #[must_use]
    pub fn sign_at(&self, x: &Rational) -> Ordering {
        integral::sign_at(&self.polynomial, x)
    }

    /// The number of distinct real roots in the interval, whose ends may be included, excluded or
    /// absent: `a..=b`, `a..b`, `..=b`, `..`, or a pair of [`Bound`]s. An empty interval has none.
    #[must_use]
    pub fn count(&self, interval: impl RangeBounds<Rational>) -> usize {
        let (lower, upper) = (interval.start_bound(), interval.end_bound());
        if let (Some(a), Some(b)) = (finite(lower), finite(upper)) {
            match a.cmp(b) {
                Ordering::Less => {}
                Ordering::Equal if includes(lower) && includes(upper) => {
                    return usize::from(self.is_root(a));
                }
                Ordering::Equal | Ordering::Greater => return 0,
            }
        }
        // Count (a, b], add a if it is an included root, subtract b if it is an excluded root.
        let at_lower =
            usize::from(includes(lower) && finite(lower).is_some_and(|a| self.is_root(a)));
        let at_upper =
            usize::from(!includes(upper) && finite(upper).is_some_and(|b| self.is_root(b)));
        let beyond = |bound, infinity| match finite(bound) {
            Some(x) => self.variations(|member| integral::sign_at(member, x)),
            None => self.variations(|member| integral::sign_at_infinity(member, infinity)),
        };
        let changes = beyond(lower, Ordering::Less) - beyond(upper, Ordering::Greater);
        changes + at_lower - at_upper
    }

    /// Whether the polynomial vanishes at the point.
    fn is_root(&self, x: &Rational) -> bool {
        self.sign_at(x).is_eq()
    }

    /// The sign of the square-free part at a point; it changes at every root.
    fn square_free_sign_at(&self, x: &Rational) -> Ordering {
        self.members
            .first()
            .map_or(Ordering::Equal, |first| integral::sign_at(first, x))
    }

    /// The number of sign changes along the sequence, ignoring zeros.
    fn variations(&self, sign: impl Fn(&[Integer]) -> Ordering) -> usize {
        let signs: Vec<_> = self
            .members
            .iter()
            .map(|m| sign(m))
            .filter(|s| s.is_ne())
            .collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}

/// The finite end of an interval; `None` if it is unbounded there.
fn finite(bound: Bound<&Rational>) -> Option<&Rational> {
    match bound {
        Bound::Included(end) | Bound::Excluded(end) => Some(end),
        Bound::Unbounded => None,
    }
}

/// Whether an interval contains this end.
fn includes(bound: Bound<&Rational>) -> bool {
    matches!(bound, Bound::Included(_))
}
