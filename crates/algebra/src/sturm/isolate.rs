//! Isolating intervals of roots, and their refinement.

use super::{SturmError, SturmSequence, finite, includes, integral};
use crate::rational::{Integer, Rational};
use num_traits::Signed;
use std::cmp::Ordering;
use std::ops::{Bound, RangeBounds};

/// An enclosure of one root: a rational point that is the root, or an open interval that contains it and whose ends
/// are not roots.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RootInterval {
    lower: Rational,
    upper: Rational,
}

impl RootInterval {
    /// A lower bound of the root.
    #[must_use]
    pub fn lower(&self) -> &Rational {
        &self.lower
    }

    /// An upper bound of the root.
    #[must_use]
    pub fn upper(&self) -> &Rational {
        &self.upper
    }

    /// The root itself, if it is known to be rational.
    #[must_use]
    pub fn exact(&self) -> Option<&Rational> {
        (self.lower == self.upper).then_some(&self.lower)
    }

    /// Whether the point lies in the closed interval between the bounds.
    #[must_use]
    pub fn contains(&self, x: &Rational) -> bool {
        self.lower <= *x && *x <= self.upper
    }

    fn point(x: Rational) -> Self {
        Self {
            lower: x.clone(),
            upper: x,
        }
    }
}

/// The middle of two numbers.
pub(super) fn middle(a: &Rational, b: &Rational) -> Rational {
    (a + b) / Integer::from(2)
}

impl SturmSequence {
    /// Returns one interval for each distinct root in the given interval, in ascending order. Neighbouring intervals
    /// have at most an end in common, which is not a root.
    ///
    /// # Errors
    /// [`SturmError::BudgetSpent`] when roots are too close to be separated.
    pub fn isolate(
        &self,
        interval: impl RangeBounds<Rational>,
    ) -> Result<Vec<RootInterval>, SturmError> {
        let (start, end) = (interval.start_bound(), interval.end_bound());
        if self.count((start, end)) == 0 {
            return Ok(Vec::new());
        }
        // The interval contains a root, so it is not empty after it is bounded; the new ends are not roots.
        let bound = integral::root_bound(&self.polynomial);
        let lower = finite(start).cloned().unwrap_or_else(|| -bound.clone());
        let upper = finite(end).cloned().unwrap_or(bound);
        let mut found = Vec::new();
        if includes(start) && self.is_root(&lower) {
            found.push(RootInterval::point(lower.clone()));
        }
        if includes(end) && self.is_root(&upper) && lower != upper {
            found.push(RootInterval::point(upper.clone()));
        }
        let mut bisections = 0;
        let mut open = vec![(lower, upper)];
        while let Some((lower, upper)) = open.pop() {
            let count = self.count((Bound::Excluded(&lower), Bound::Excluded(&upper)));
            if count == 0 {
                continue;
            }
            if count == 1 && !self.is_root(&lower) && !self.is_root(&upper) {
                found.push(RootInterval { lower, upper });
                continue;
            }
            if bisections == Self::MAX_BISECTIONS {
                return Err(SturmError::BudgetSpent {
                    bisections,
                    lower,
                    upper,
                    count,
                });
            }
            bisections += 1;
            let half = middle(&lower, &upper);
            if self.is_root(&half) {
                found.push(RootInterval::point(half.clone()));
            }
            open.push((lower, half.clone()));
            open.push((half, upper));
        }
        found.sort_by(|a, b| (&a.lower, &a.upper).cmp(&(&b.lower, &b.upper)));
        Ok(found)
    }

    /// Encloses the same root in an interval no wider than `width`.
    ///
    /// # Errors
    /// [`SturmError::WidthNotPositive`]; [`SturmError::BudgetSpent`] when too many bisections are needed.
    pub fn refine(
        &self,
        root: &RootInterval,
        width: &Rational,
    ) -> Result<RootInterval, SturmError> {
        if !width.is_positive() {
            return Err(SturmError::WidthNotPositive {
                width: width.clone(),
            });
        }
        self.bisected_until(root, |current| &current.upper - &current.lower <= *width)
    }

    /// Bisects around a root until the interval satisfies `accept` or the root is known exactly.
    pub(super) fn bisected_until(
        &self,
        root: &RootInterval,
        accept: impl Fn(&RootInterval) -> bool,
    ) -> Result<RootInterval, SturmError> {
        let mut current = root.clone();
        let above = self.square_free_sign_at(&current.upper);
        for _ in 0..Self::MAX_BISECTIONS {
            if current.exact().is_some() || accept(&current) {
                return Ok(current);
            }
            let half = middle(&current.lower, &current.upper);
            match self.square_free_sign_at(&half) {
                Ordering::Equal => current = RootInterval::point(half),
                sign if sign == above => current.upper = half,
                _ => current.lower = half,
            }
        }
        let RootInterval { lower, upper } = current;
        Err(SturmError::BudgetSpent {
            bisections: Self::MAX_BISECTIONS,
            lower,
            upper,
            count: 1,
        })
    }
}
