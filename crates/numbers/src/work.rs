//! The work that one job may cost.
//!
//! Work is counted, not timed: a unit is about one product of two coefficients of a word each, some ten nanoseconds, and
//! what costs more spends more. So a job that is too much is too much on every machine, and its answer, "more work than
//! the budget allows", is the same everywhere.
//!
//! Every thread has a meter. [`within`] starts a job with a limit, and the operations that can grow [`spend`] before they work.
//! A job that spends more than its limit ends at once: its stack is unwound to its [`within`], as by a panic but without
//! one's message, so that no operation in between needs an error of its own. Jobs may be nested: what an inner one
//! spends is spent by the outer one too, and when the inner one has ended for want of work the outer one goes on.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

/// More work than the limit of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("more work than the budget of {limit} units allows")]
pub struct OutOfWork {
    /// The limit that was met.
    pub limit: u64,
}

thread_local! {
    static SPENT: Cell<u64> = const { Cell::new(0) };
    static LIMIT: Cell<u64> = const { Cell::new(u64::MAX) };
}

/// What is thrown to the innermost job.
struct Ended;

/// Does a job that may spend so many units, or as many as the job around it has left if that is less.
///
/// What the job leaves half done when it ends must be its own: it is dropped, or never looked at again.
///
/// # Errors
/// [`OutOfWork`] when the job needed more.
///
/// ```
/// use torse_numbers::work::{spend, within};
/// let job = || {
///     assert!(within(30, || spend(20)).is_ok());
///     assert_eq!(within(30, || spend(31)).unwrap_err().limit, 30);
///     spend(80);
///     "done"
/// };
/// assert_eq!(within(100, job), Ok("done"));
/// assert_eq!(within(99, job).unwrap_err().limit, 99);
/// ```
pub fn within<T>(limit: u64, job: impl FnOnce() -> T) -> Result<T, OutOfWork> {
    let around = LIMIT.get();
    LIMIT.set(around.min(SPENT.get().saturating_add(limit)));
    let done = catch_unwind(AssertUnwindSafe(job));
    LIMIT.set(around);
    done.or_else(|thrown| match thrown.downcast::<Ended>() {
        Ok(_) => Err(OutOfWork { limit }),
        Err(panic) => resume_unwind(panic),
    })
}

/// Spends units before the work is done. Where fewer are left the job ends here, and nothing is spent.
pub fn spend(units: u64) {
    let spent = SPENT.get().saturating_add(units);
    if spent > LIMIT.get() {
        resume_unwind(Box::new(Ended));
    }
    SPENT.set(spent);
}

/// The units spent on this thread so far, by jobs that ended for want of work too.
#[must_use]
pub fn spent() -> u64 {
    SPENT.get()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_that_ends_leaves_the_limit_and_the_rest_of_the_one_around_it() {
        let outer = within(10, || {
            spend(4);
            let inner = within(100, || {
                spend(6);
                spend(1);
            });
            // The outer job has less left than the inner one asked for.
            assert_eq!(inner, Err(OutOfWork { limit: 100 }));
            spend(1);
        });
        assert_eq!(outer, Err(OutOfWork { limit: 10 }));
        spend(1_000_000);
    }

    #[test]
    fn what_is_refused_is_not_spent() {
        let before = spent();
        assert!(within(5, || spend(u64::MAX)).is_err());
        assert!(within(5, || spend(5)).is_ok());
        assert_eq!(spent() - before, 5);
    }

    #[test]
    fn a_panic_inside_a_job_is_a_panic_outside_and_the_limit_is_put_back() {
        let panicking = || within(5, || std::panic::panic_any("why"));
        let caught = catch_unwind(panicking).unwrap_err();
        assert_eq!(caught.downcast_ref::<&str>(), Some(&"why"));
        spend(6);
    }
}
