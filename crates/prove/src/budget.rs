//! The work that one claim may cost.
//!
//! Work is counted, not timed: the unit is about one term of a polynomial made, one node of a formula visited, or one box
//! examined, some hundred nanoseconds to microseconds each. So a claim that is too much is too much on every machine, and its
//! verdict is `undecided` with the same reason.
//!
//! A budget is a handle: its copies spend from one purse. A [`part`](Budget::part) is a smaller purse inside: what it spends is
//! spent from the whole too, and when it is empty the whole goes on. A search that may fail, such as that for a
//! correction, gets a part; the verdict does not depend on it.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// The work that is left to a claim.
///
/// ```
/// use torse_prove::budget::Budget;
/// let claim = Budget::new(100);
/// let search = claim.part(30);
/// assert!(search.spend(20).is_ok());
/// assert_eq!(search.spend(20).unwrap_err().limit, 30);
/// // The work was done all the same, and the claim goes on.
/// assert_eq!(claim.spent(), 20);
/// assert!(claim.spend(80).is_ok());
/// assert!(claim.spend(1).is_err());
/// ```
#[derive(Debug, Clone)]
pub struct Budget {
    purse: Arc<Purse>,
}

#[derive(Debug)]
struct Purse {
    limit: u64,
    spent: AtomicU64,
    whole: Option<Budget>,
}

/// More work than the budget allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("more work than the budget of {limit} units allows")]
pub struct OutOfBudget {
    /// The limit that was met.
    pub limit: u64,
}

impl Budget {
    /// What a claim gets unless more is asked for: a hundred times what the hardest claims of the papers take.
    pub const STANDARD: u64 = 200_000_000;

    /// A budget of so many units.
    #[must_use]
    pub fn new(limit: u64) -> Self {
        Self::within(limit, None)
    }

    /// A budget inside this one: of so many units, or of what is left here if that is less.
    #[must_use]
    pub fn part(&self, limit: u64) -> Self {
        Self::within(limit, Some(self.clone()))
    }

    fn within(limit: u64, whole: Option<Self>) -> Self {
        let spent = AtomicU64::new(0);
        Self {
            purse: Arc::new(Purse {
                limit,
                spent,
                whole,
            }),
        }
    }

    /// Spends units before the work is done.
    ///
    /// # Errors
    /// [`OutOfBudget`] if fewer are left, here or in the budget of which this is a part; then nothing is spent, and the
    /// work must not be done.
    pub fn spend(&self, units: u64) -> Result<(), OutOfBudget> {
        let purse = &*self.purse;
        let out = OutOfBudget { limit: purse.limit };
        let more = |spent: u64| spent.checked_add(units).filter(|sum| *sum <= purse.limit);
        let order = Ordering::Relaxed;
        purse
            .spent
            .fetch_update(order, order, more)
            .map_err(|_| out)?;
        let Some(whole) = &purse.whole else {
            return Ok(());
        };
        whole.spend(units).inspect_err(|_| {
            purse.spent.fetch_sub(units, order);
        })
    }

    /// The units spent so far, those of parts included.
    #[must_use]
    pub fn spent(&self) -> u64 {
        self.purse.spent.load(Ordering::Relaxed)
    }
}

impl Default for Budget {
    fn default() -> Self {
        Self::new(Self::STANDARD)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_spent_is_not_spent_anywhere() {
        let whole = Budget::new(10);
        let part = whole.part(100);
        assert!(part.spend(6).is_ok());
        assert_eq!(part.spend(6), Err(OutOfBudget { limit: 10 }));
        assert_eq!((part.spent(), whole.spent()), (6, 6));
        assert!(part.spend(u64::MAX).is_err());
        assert!(part.spend(4).is_ok());
        assert_eq!((part.spent(), whole.spent()), (10, 10));
    }

    #[test]
    fn copies_share_a_purse_and_parts_of_parts_spend_from_all() {
        let whole = Budget::new(10);
        let copy = whole.clone();
        let inner = whole.part(5).part(3);
        assert!(copy.spend(2).is_ok() && inner.spend(3).is_ok());
        assert_eq!(inner.spend(1), Err(OutOfBudget { limit: 3 }));
        assert_eq!(whole.spent(), 5);
    }
}
