//! Limits of the work and the memory that one job may cost.
//!
//! Work is counted, not timed: a unit is about one product of two one-word coefficients (some ten nanoseconds), and
//! more expensive operations spend more units. So a job that exceeds its budget does so on every machine, with the
//! same answer, "more work than the budget allows". Memory is counted where formulas are made and released where they
//! are dropped.
//!
//! Every thread has a meter. [`within`] starts a job with a limit. Operations whose cost can grow call [`spend`]
//! before they work and [`hold`] for the memory of their results. A job that reaches a limit is *over*: nothing is
//! unwound, but every later [`spend`] of the job is refused, and its [`within`] returns the limit ([`Spent`]) instead
//! of the job's result.
//!
//! # Values computed by a job that is over
//!
//! An operation that cannot return an error, such as a product of polynomials, returns a small wrong value after its
//! [`spend`] was refused. No such value may outlive the job:
//! - [`within`] drops the result of the job;
//! - code that writes to a cache or to a variable of the caller calls [`check`] first;
//! - code that can return an error calls [`check`] and does so, so that a job that is over ends soon.
//!
//! Jobs may be nested: the work of an inner job counts for the outer job too. When the inner job is over, the outer
//! job goes on. What runs in [`stoppable`] can be ended from another thread: then all of its jobs are over.

use std::cell::{Cell, RefCell};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The largest memory, in bytes, that the formulas of a job may occupy at once.
///
/// The hardest claim of the papers needs some megabytes. With this limit a process of two or three threads stays
/// below a gigabyte, including the temporary memory of its operations.
pub const MAX_MEMORY: u64 = 256 << 20;

/// The limit that a job reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Spent {
    /// More work than the job may do.
    #[error("more work than the budget of {limit} units allows")]
    Work {
        /// The limit in units.
        limit: u64,
    },
    /// An exponent that exceeds the largest one of a formula.
    #[error("a power with an exponent above {limit}")]
    Exponent {
        /// The largest exponent.
        limit: u16,
    },
    /// Another thread asked for the end: [`stoppable`].
    #[error("ended from outside")]
    Stopped,
    /// More memory than a job may hold.
    #[error("formulas of more than {limit} bytes at once")]
    Memory {
        /// The limit in bytes.
        limit: u64,
    },
}

/// The work and memory counted on one thread.
struct Meter {
    spent: Cell<u64>,
    limit: Cell<u64>,
    /// The budget of the innermost job, for its error.
    budget: Cell<u64>,
    /// Negative if formulas made on other threads were dropped on this one.
    held: Cell<i64>,
    most: Cell<i64>,
    over: Cell<Option<Spent>>,
    /// Whether another thread's wish to end was seen.
    stopped: Cell<bool>,
}

/// The units between two looks at whether another thread asked for the end: a fraction of a millisecond.
const LOOK: u64 = 1 << 14;

thread_local! {
    static STOP: RefCell<Option<Arc<AtomicBool>>> = const { RefCell::new(None) };
}

thread_local! {
    static METER: Meter = const {
        Meter {
            spent: Cell::new(0),
            limit: Cell::new(u64::MAX),
            budget: Cell::new(u64::MAX),
            held: Cell::new(0),
            most: Cell::new(i64::MAX),
            over: Cell::new(None),
            stopped: Cell::new(false),
        }
    };
}

/// The limits of the outer job while an inner job runs; restored when the inner job ends, even by a panic.
struct Around {
    limit: u64,
    budget: u64,
    most: i64,
}

impl Drop for Around {
    fn drop(&mut self) {
        METER.with(|meter| {
            meter.limit.set(self.limit);
            meter.budget.set(self.budget);
            meter.most.set(self.most);
            let stopped = meter.stopped.get().then_some(Spent::Stopped);
            meter.over.set(stopped);
        });
    }
}

/// Runs what another thread may end by setting `stop`: soon after that all of its jobs are over.
///
/// # Errors
/// [`Spent::Stopped`] if the wish was seen: the result would be that of jobs that are over.
///
/// ```
/// use std::sync::{Arc, atomic::{AtomicBool, Ordering}};
/// use torse_numbers::work::{Spent, spend, stoppable, within};
/// let stop = Arc::new(AtomicBool::new(false));
/// assert_eq!(stoppable(&stop, || within(100, || spend(50))), Ok(Ok(Ok(()))));
/// stop.store(true, Ordering::Relaxed);
/// let work = || (0..100_000).map(|_| within(9, || spend(9))).filter(|done| done.is_ok()).count();
/// assert_eq!(stoppable(&stop, work), Err(Spent::Stopped));
/// // Whoever is not asked goes on.
/// assert_eq!(within(100, || spend(50)), Ok(Ok(())));
/// ```
pub fn stoppable<T>(stop: &Arc<AtomicBool>, job: impl FnOnce() -> T) -> Result<T, Spent> {
    /// What was there before; restored even by a panic.
    struct Before(Option<Arc<AtomicBool>>);
    impl Drop for Before {
        fn drop(&mut self) {
            STOP.with(|stop| stop.replace(self.0.take()));
            METER.with(|meter| {
                if meter.stopped.replace(false) {
                    meter.over.set(None);
                }
            });
        }
    }
    let before = Before(STOP.with(|own| own.replace(Some(Arc::clone(stop)))));
    let done = job();
    let stopped = METER.with(|meter| meter.stopped.get());
    drop(before);
    match stopped {
        true => Err(Spent::Stopped),
        false => Ok(done),
    }
}

/// Whether another thread asked for the end.
#[cold]
fn is_stopped() -> bool {
    STOP.with(|stop| {
        let stop = stop.borrow();
        stop.as_ref()
            .is_some_and(|stop| stop.load(Ordering::Relaxed))
    })
}

/// Runs a job that may spend at most `limit` units (fewer if the outer job has fewer left) and may hold at most
/// [`MAX_MEMORY`] more than was held when the outermost job began.
///
/// A job that is over may have changed only state of its own: see the [module](self).
///
/// # Errors
/// The limit that the job reached. If the outer job is over, `job` does not run.
///
/// ```
/// use torse_numbers::work::{Spent, spend, within};
/// let job = || {
///     assert!(within(30, || spend(20)).is_ok());
///     assert_eq!(within(30, || spend(31)).unwrap_err(), Spent::Work { limit: 30 });
///     spend(80)?;
///     Ok::<_, Spent>("done")
/// };
/// assert_eq!(within(100, job), Ok(Ok("done")));
/// assert_eq!(within(99, job), Err(Spent::Work { limit: 99 }));
/// ```
pub fn within<T>(limit: u64, job: impl FnOnce() -> T) -> Result<T, Spent> {
    check()?;
    let around = METER.with(|meter| {
        let around = Around {
            limit: meter.limit.get(),
            budget: meter.budget.get(),
            most: meter.most.get(),
        };
        let own = meter.spent.get().saturating_add(limit);
        meter.limit.set(around.limit.min(own));
        meter.budget.set(limit);
        if around.most == i64::MAX {
            meter
                .most
                .set(meter.held.get().saturating_add(signed(MAX_MEMORY)));
        }
        around
    });
    let done = job();
    let over = check();
    drop(around);
    over.map(|()| done)
}

/// A budget shared by many jobs of one kind, with a limit for each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Allowance {
    each: u64,
    left: u64,
}

impl Allowance {
    /// Allows `each` units for one job and `together` units for all.
    #[must_use]
    pub fn new(each: u64, together: u64) -> Self {
        Self {
            each,
            left: together,
        }
    }

    /// Runs one of the jobs, as [`within`] does.
    ///
    /// # Errors
    /// The limit that the job reached: its own, or what earlier jobs left of the total.
    ///
    /// ```
    /// use torse_numbers::work::{Allowance, spend};
    /// let mut allowance = Allowance::new(10, 25);
    /// let mut can = |units| allowance.within(|| spend(units)).is_ok();
    /// assert_eq!([can(10), can(11), can(9), can(7), can(6)], [true, false, true, false, true]);
    /// ```
    pub fn within<T>(&mut self, job: impl FnOnce() -> T) -> Result<T, Spent> {
        let before = spent();
        let result = within(self.each.min(self.left), job);
        self.left = self.left.saturating_sub(spent().saturating_sub(before));
        result
    }
}

/// Spends units before the work is done.
///
/// # Errors
/// If fewer units are left, or a limit was reached before, the job is over and nothing is spent.
pub fn spend(units: u64) -> Result<(), Spent> {
    METER.with(|meter| {
        if let Some(limit) = meter.over.get() {
            return Err(limit);
        }
        let before = meter.spent.get();
        let spent = before.saturating_add(units);
        if spent / LOOK != before / LOOK && is_stopped() {
            meter.stopped.set(true);
            meter.over.set(Some(Spent::Stopped));
            return Err(Spent::Stopped);
        }
        if spent > meter.limit.get() {
            let limit = Spent::Work {
                limit: meter.budget.get(),
            };
            meter.over.set(Some(limit));
            return Err(limit);
        }
        meter.spent.set(spent);
        Ok(())
    })
}

/// Ends the current job by a limit that is not counted here. Returns `false` outside of any job, where the limit
/// could not be reported.
#[must_use]
pub fn end(limit: Spent) -> bool {
    METER.with(|meter| {
        let inside = meter.most.get() != i64::MAX;
        if inside && meter.over.get().is_none() {
            meter.over.set(Some(limit));
        }
        inside
    })
}

/// Returns an error if the current job is over.
///
/// # Errors
/// The limit that the job reached.
pub fn check() -> Result<(), Spent> {
    METER.with(|meter| meter.over.get().map_or(Ok(()), Err))
}

/// Checks, before memory is allocated, that `bytes` more may be held.
///
/// # Errors
/// If they may not, or a limit was reached before, the job is over.
pub fn room(bytes: usize) -> Result<(), Spent> {
    METER.with(|meter| {
        if meter.over.get().is_none()
            && meter.held.get().saturating_add(size(bytes)) > meter.most.get()
        {
            meter.over.set(Some(Spent::Memory { limit: MAX_MEMORY }));
        }
        meter.over.get().map_or(Ok(()), Err)
    })
}

/// Counts `bytes` of a new value as held. If too many are held, the job is over.
pub fn hold(bytes: usize) {
    METER.with(|meter| {
        let held = meter.held.get().saturating_add(size(bytes));
        meter.held.set(held);
        if held > meter.most.get() && meter.over.get().is_none() {
            meter.over.set(Some(Spent::Memory { limit: MAX_MEMORY }));
        }
    });
}

/// Counts `bytes` of a dropped value as released.
pub fn give_back(bytes: usize) {
    // While a thread is being destroyed its meter is gone, and nothing needs to be counted.
    let _ = METER.try_with(|meter| meter.held.set(meter.held.get().saturating_sub(size(bytes))));
}

/// The units spent on this thread so far, including those of jobs that are over.
#[must_use]
pub fn spent() -> u64 {
    METER.with(|meter| meter.spent.get())
}

fn size(bytes: usize) -> i64 {
    i64::try_from(bytes).unwrap_or(i64::MAX)
}

fn signed(bytes: u64) -> i64 {
    i64::try_from(bytes).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::{AssertUnwindSafe, catch_unwind};

    #[test]
    fn a_job_that_is_over_leaves_the_limit_and_the_rest_of_the_one_around_it() {
        let outer = within(10, || {
            spend(4).unwrap();
            let inner = within(100, || {
                spend(6).unwrap();
                spend(1)
            });
            // The outer job has less left than the inner one asked for.
            assert_eq!(inner, Err(Spent::Work { limit: 100 }));
            spend(1)
        });
        assert_eq!(outer, Err(Spent::Work { limit: 10 }));
        spend(1_000_000).unwrap();
    }

    #[test]
    fn a_job_that_is_over_stays_so_whatever_it_does() {
        let job = || {
            let first = spend(11);
            assert_eq!(first, Err(Spent::Work { limit: 10 }));
            // Less would do, and would be enough: but what was refused is missing.
            assert_eq!([spend(0), check(), room(0)], [first; 3]);
            assert_eq!(within(1, || "nothing is begun").map(|_| ()), first);
            "a wrong value"
        };
        assert_eq!(within(10, job), Err(Spent::Work { limit: 10 }));
        assert_eq!(check(), Ok(()));
    }

    #[test]
    fn what_is_refused_is_not_spent() {
        let before = spent();
        assert!(within(5, || spend(u64::MAX)).is_err());
        assert!(within(5, || spend(5)).is_ok());
        assert_eq!(spent() - before, 5);
    }

    #[test]
    fn memory_that_is_given_back_may_be_held_again() {
        let half = usize::try_from(MAX_MEMORY / 2).unwrap();
        hold(3 * half);
        let job = || {
            hold(2 * half);
            assert_eq!(check(), Ok(()));
            give_back(half);
            room(half)
        };
        assert_eq!(within(1, job), Ok(Ok(())));
        give_back(half);
        // The limit is that of the outermost job.
        let nested = || {
            hold(half);
            within(1, || hold(half + 1))
        };
        let limit = Spent::Memory { limit: MAX_MEMORY };
        assert_eq!(within(2, nested).unwrap(), Err(limit));
        give_back(5 * half + 1);
        assert_eq!(within(1, || room(2 * half + 1)), Err(limit));
    }

    #[test]
    fn a_limit_of_others_ends_a_job_and_nothing_outside_of_one() {
        let limit = Spent::Exponent { limit: 9 };
        assert!(!end(limit));
        assert_eq!(check(), Ok(()));
        let job = || {
            assert!(end(limit) && end(Spent::Exponent { limit: 8 }));
        };
        assert_eq!(within(5, job), Err(limit));
        assert_eq!(check(), Ok(()));
    }

    #[test]
    fn a_panic_inside_a_job_is_a_panic_outside_and_the_limit_is_put_back() {
        let panicking = || within(5, || std::panic::panic_any("why"));
        let caught = catch_unwind(AssertUnwindSafe(panicking)).unwrap_err();
        assert_eq!(caught.downcast_ref::<&str>(), Some(&"why"));
        spend(6).unwrap();
    }
}
