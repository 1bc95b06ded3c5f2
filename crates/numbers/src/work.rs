//! The work and the memory that one job may cost.
//!
//! Work is counted, not timed: a unit is about one product of two coefficients of a word each, some ten nanoseconds, and
//! what costs more spends more. So a job that is too much is too much on every machine, and its answer, "more work than
//! the budget allows", is the same everywhere. Memory is counted where formulas are made and given back where they are
//! dropped.
//!
//! Every thread has a meter. [`within`] starts a job with a limit, and the operations that can grow [`spend`] before they
//! work and [`hold`] what they made. A job that meets a limit is *over*: nothing is unwound, each later [`spend`] of it is
//! refused, and its [`within`] returns the [`Spent`] limit in place of whatever the job came to.
//!
//! # What is computed by a job that is over
//!
//! An operation that cannot return an error, such as a product of polynomials, answers with a small value in place of the
//! true one once its [`spend`] is refused. No such value may outlive the job:
//! - [`within`] drops what the job returns;
//! - what writes into memory that others read, or into a variable of the caller, asks [`check`] first;
//! - what can return an error asks [`check`] and does, so that a job that is over ends soon.
//!
//! Jobs may be nested: what an inner one spends is spent by the outer one too, and when the inner one is over the outer one
//! goes on.

use std::cell::Cell;

/// The most bytes that a job may hold at once, in formulas.
///
/// The hardest claim of the papers holds some megabytes. With what an operation needs besides, and two or three threads, a
/// process stays below a gigabyte.
pub const MAX_MEMORY: u64 = 256 << 20;

/// The limit of a job that it met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Spent {
    /// More work than the job may do.
    #[error("more work than the budget of {limit} units allows")]
    Work {
        /// The limit in units.
        limit: u64,
    },
    /// A power that no formula holds.
    #[error("a power with an exponent above {limit}")]
    Exponent {
        /// The highest exponent.
        limit: u16,
    },
    /// More memory than a job may hold.
    #[error("formulas of more than {limit} bytes at once")]
    Memory {
        /// The limit in bytes.
        limit: u64,
    },
}

/// What one thread has spent and holds.
struct Meter {
    spent: Cell<u64>,
    limit: Cell<u64>,
    /// What the innermost job may spend, for its error.
    budget: Cell<u64>,
    /// Below zero where formulas of other threads are dropped here.
    held: Cell<i64>,
    most: Cell<i64>,
    over: Cell<Option<Spent>>,
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
        }
    };
}

/// What the job around had when an inner one began; put back at its end, in a panic too.
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
            meter.over.set(None);
        });
    }
}

/// Does a job that may spend so many units, or as many as the job around it has left if that is less, and hold
/// [`MAX_MEMORY`] more than the outermost job found held.
///
/// What the job leaves behind when it is over must be its own: see the [module](self).
///
/// # Errors
/// The limit that the job met. Inside a job that is over nothing is begun.
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

/// What many jobs of one kind may spend, each and together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Allowance {
    each: u64,
    left: u64,
}

impl Allowance {
    /// So many units for each job, and so many for all.
    #[must_use]
    pub fn new(each: u64, together: u64) -> Self {
        Self {
            each,
            left: together,
        }
    }

    /// Does one of the jobs, as [`within`] does.
    ///
    /// # Errors
    /// The limit that the job met: its own, or what the jobs before it left.
    ///
    /// ```
    /// use torse_numbers::work::{Allowance, spend};
    /// let mut allowance = Allowance::new(10, 25);
    /// let mut can = |units| allowance.within(|| spend(units)).is_ok();
    /// assert_eq!([can(10), can(11), can(9), can(7), can(6)], [true, false, true, false, true]);
    /// ```
    pub fn within<T>(&mut self, job: impl FnOnce() -> T) -> Result<T, Spent> {
        let before = spent();
        let done = within(self.each.min(self.left), job);
        self.left = self.left.saturating_sub(spent().saturating_sub(before));
        done
    }
}

/// Spends units before the work is done.
///
/// # Errors
/// Where fewer units are left, or a limit was met before, the job is over and nothing is spent.
pub fn spend(units: u64) -> Result<(), Spent> {
    METER.with(|meter| {
        if let Some(limit) = meter.over.get() {
            return Err(limit);
        }
        let spent = meter.spent.get().saturating_add(units);
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

/// Ends the job by a limit that is not counted here; `false` outside of every job, where nothing could tell.
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

/// Whether the job is not over.
///
/// # Errors
/// The limit that the job met.
pub fn check() -> Result<(), Spent> {
    METER.with(|meter| meter.over.get().map_or(Ok(()), Err))
}

/// Whether so many bytes more may be held, which is asked before they are made.
///
/// # Errors
/// Where they may not, or a limit was met before, the job is over.
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

/// Holds bytes that were made. Where they are too many the job is over.
pub fn hold(bytes: usize) {
    METER.with(|meter| {
        let held = meter.held.get().saturating_add(size(bytes));
        meter.held.set(held);
        if held > meter.most.get() && meter.over.get().is_none() {
            meter.over.set(Some(Spent::Memory { limit: MAX_MEMORY }));
        }
    });
}

/// Gives back bytes that are dropped.
pub fn give_back(bytes: usize) {
    // While a thread ends there is nothing left to count.
    let _ = METER.try_with(|meter| meter.held.set(meter.held.get().saturating_sub(size(bytes))));
}

/// The units spent on this thread so far, by jobs that met a limit too.
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
