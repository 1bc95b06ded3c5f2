//! The sign of a polynomial on a whole interval.

use super::isolate::middle;
use super::{RootInterval, SturmError, SturmSequence, finite, includes};
use crate::rational::{Rational, integer};
use num_traits::Zero;
use std::cmp::Ordering;
use std::ops::{Bound, RangeBounds};

/// The sign of a polynomial on an interval.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SignOn {
    /// Positive everywhere.
    Positive,
    /// Negative everywhere.
    Negative,
    /// Never negative, and zero exactly at these roots.
    NonNegative(Vec<RootInterval>),
    /// Never positive, and zero exactly at these roots.
    NonPositive(Vec<RootInterval>),
    /// Zero everywhere: the interval is a single point, which is a root.
    Zero,
    /// Both signs occur.
    Mixed {
        /// A point where it is positive.
        positive_at: Rational,
        /// A point where it is negative.
        negative_at: Rational,
    },
}

impl SturmSequence {
    /// The sign of the polynomial on the interval.
    ///
    /// Between neighbouring roots the sign is constant, so one point between each pair decides it.
    ///
    /// ```
    /// use torse_algebra::{SturmSequence, rational::integer, sturm::SignOn};
    /// let parabola = SturmSequence::new(&[integer(-2), integer(0), integer(1)])?;
    /// assert_eq!(parabola.sign_on(integer(2)..), Ok(SignOn::Positive));
    /// assert!(matches!(parabola.sign_on(..), Ok(SignOn::Mixed { .. })));
    /// # Ok::<(), torse_algebra::sturm::SturmError>(())
    /// ```
    ///
    /// # Errors
    /// [`SturmError::EmptyInterval`]; [`SturmError::BudgetSpent`] when roots cannot be separated.
    pub fn sign_on(&self, interval: impl RangeBounds<Rational>) -> Result<SignOn, SturmError> {
        let (start, end) = (interval.start_bound(), interval.end_bound());
        if is_empty(start, end) {
            return Err(SturmError::EmptyInterval);
        }
        let mut roots = self.isolate((start, end))?;
        // Refine the enclosures so that no end of the interval lies strictly inside of one.
        for root in &mut roots {
            *root = self.bisected_until(root, |now| {
                !is_at(start, now.lower()) && !is_at(end, now.upper())
            })?;
        }
        let points = points_of_gaps(start, end, &roots);
        let at = |sign: Ordering| points.iter().find(|x| self.sign_at(x) == sign);
        Ok(match (at(Ordering::Greater), at(Ordering::Less)) {
            (Some(positive), Some(negative)) => SignOn::Mixed {
                positive_at: positive.clone(),
                negative_at: negative.clone(),
            },
            (Some(_), None) if roots.is_empty() => SignOn::Positive,
            (Some(_), None) => SignOn::NonNegative(roots),
            (None, Some(_)) if roots.is_empty() => SignOn::Negative,
            (None, Some(_)) => SignOn::NonPositive(roots),
            (None, None) => SignOn::Zero,
        })
    }
}

fn is_empty(start: Bound<&Rational>, end: Bound<&Rational>) -> bool {
    match (finite(start), finite(end)) {
        (Some(a), Some(b)) => match a.cmp(b) {
            Ordering::Less => false,
            Ordering::Equal => !(includes(start) && includes(end)),
            Ordering::Greater => true,
        },
        _ => false,
    }
}

/// Whether an interval ends at the point.
fn is_at(bound: Bound<&Rational>, x: &Rational) -> bool {
    finite(bound) == Some(x)
}

/// One point of the interval between each two neighbouring roots, before the first and after the last root.
fn points_of_gaps(
    start: Bound<&Rational>,
    end: Bound<&Rational>,
    roots: &[RootInterval],
) -> Vec<Rational> {
    let (Some(first), Some(last)) = (roots.first(), roots.last()) else {
        return vec![match (finite(start), finite(end)) {
            (Some(a), Some(b)) => middle(a, b),
            (Some(a), None) => a + integer(1),
            (None, Some(b)) => b - integer(1),
            (None, None) => Rational::zero(),
        }];
    };
    let mut points = Vec::new();
    match finite(start) {
        None => points.push(first.lower() - integer(1)),
        // If the end is a root, there is nothing before the first root.
        Some(a) if a == first.lower() => {}
        Some(a) => points.push(middle(a, first.lower())),
    }
    points.extend(
        roots
            .windows(2)
            .map(|pair| middle(pair[0].upper(), pair[1].lower())),
    );
    match finite(end) {
        None => points.push(last.upper() + integer(1)),
        Some(b) if b == last.upper() => {}
        Some(b) => points.push(middle(last.upper(), b)),
    }
    points
}
