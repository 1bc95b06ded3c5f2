//! Runs tasks that depend on one another: each starts as soon as its dependencies are done, several at once.

use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

/// A task, and the positions of the earlier tasks that it depends on.
pub(crate) type Job<I> = (I, Vec<usize>);

/// The remaining tasks, and the results of the others.
struct State<T> {
    left: Vec<usize>,
    found: BTreeMap<usize, T>,
}

/// A queue for several threads.
struct Queue<'a, I, T> {
    jobs: &'a [Job<I>],
    state: Mutex<State<T>>,
    changed: Condvar,
}

impl<'a, I, T> Queue<'a, I, T> {
    fn state(&self) -> MutexGuard<'_, State<T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes the first task whose dependencies are done; waits if all remaining tasks depend on running ones. None at
    /// the end.
    fn next(&self) -> Option<(usize, &'a I)> {
        let mut state = self.state();
        while !state.left.is_empty() {
            let is_ready = |place: &usize| {
                let mut needs = self.jobs.get(*place).into_iter().flat_map(|(_, n)| n);
                needs.all(|needed| needed >= place || state.found.contains_key(needed))
            };
            if let Some(at) = state.left.iter().position(is_ready) {
                let place = state.left.remove(at);
                return self.jobs.get(place).map(|(item, _)| (place, item));
            }
            let waiting = self.changed.wait(state);
            state = waiting.unwrap_or_else(PoisonError::into_inner);
        }
        None
    }
}

/// A running task: its end wakes the waiting threads, and its panic ends all.
struct Going<'a, 'b, I, T>(&'a Queue<'b, I, T>);

impl<I, T> Drop for Going<'_, '_, I, T> {
    fn drop(&mut self) {
        if thread::panicking() {
            self.0.state().left.clear();
        }
        self.0.changed.notify_all();
    }
}

/// Runs `work` on all tasks in this number of threads and returns the results in order; of the ready tasks, the first
/// starts first. After a failure no further task starts.
///
/// # Errors
/// The error of the first task that has one.
pub(crate) fn worked<I: Sync, T: Send, E: Send>(
    jobs: &[Job<I>],
    at_once: usize,
    work: &(dyn Fn(&I) -> Result<T, E> + Sync),
) -> Result<Vec<T>, E> {
    let queue = Queue {
        jobs,
        state: Mutex::new(State {
            left: (0..jobs.len()).collect(),
            found: BTreeMap::new(),
        }),
        changed: Condvar::new(),
    };
    let worker = || {
        while let Some((place, item)) = queue.next() {
            let _going = Going(&queue);
            let result = work(item);
            let mut state = queue.state();
            if result.is_err() {
                state.left.clear();
            }
            state.found.insert(place, result);
        }
    };
    thread::scope(|scope| {
        for _ in 0..at_once.clamp(1, jobs.len().max(1)) {
            scope.spawn(worker);
        }
    });
    let state = queue.state.into_inner();
    let found = state.unwrap_or_else(PoisonError::into_inner).found;
    found.into_values().collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "helpers of tests")]

    use super::*;
    use std::time::Duration;

    /// Both ends of a diamond, a task without dependencies, and a chain behind.
    fn jobs() -> Vec<Job<usize>> {
        let needs = [
            vec![],
            vec![0],
            vec![0],
            vec![1, 2],
            vec![],
            vec![3],
            vec![5, 4],
        ];
        (0..).zip(needs).collect()
    }

    #[test]
    fn nothing_is_begun_before_what_it_needs_is_done_and_all_is_done_once() {
        for at_once in 0..9 {
            let events = Mutex::new(vec![]);
            let work = |place: &usize| -> Result<usize, ()> {
                events.lock().unwrap().push((*place, "begun"));
                thread::sleep(Duration::from_millis(1));
                events.lock().unwrap().push((*place, "done"));
                Ok(*place)
            };
            assert_eq!(
                worked(&jobs(), at_once, &work).unwrap(),
                [0, 1, 2, 3, 4, 5, 6]
            );
            let events = events.into_inner().unwrap();
            let at = |event| events.iter().position(|own| *own == event).unwrap();
            assert_eq!(events.len(), 2 * jobs().len());
            for (place, needed) in jobs() {
                for needed in needed {
                    assert!(at((needed, "done")) < at((place, "begun")), "{events:?}");
                }
            }
        }
    }

    #[test]
    fn one_thread_keeps_the_order_and_a_failure_ends_the_work() {
        let seen = Mutex::new(vec![]);
        let work = |place: &usize| {
            seen.lock().unwrap().push(*place);
            if *place == 3 { Err(*place) } else { Ok(()) }
        };
        assert_eq!(worked(&jobs(), 1, &work), Err(3));
        assert_eq!(seen.into_inner().unwrap(), [0, 1, 2, 3]);
    }

    #[test]
    fn two_things_that_need_each_other_or_themselves_are_no_reason_to_wait() {
        let work = |n: &usize| -> Result<usize, ()> { Ok(*n) };
        let jobs = [(7, vec![1]), (8, vec![0]), (9, vec![2])];
        assert_eq!(worked(&jobs, 2, &work), Ok(vec![7, 8, 9]));
        assert_eq!(worked(&[], 2, &work), Ok(vec![]));
    }

    #[test]
    #[should_panic(expected = "a scoped thread panicked")]
    fn work_that_panics_leaves_nobody_waiting() {
        let work = |place: &usize| -> Result<(), ()> {
            assert!(*place != 3);
            Ok(())
        };
        let _ = worked(&jobs(), 3, &work);
    }
}
