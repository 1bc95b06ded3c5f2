//! Work on things that need one another: each is begun as soon as what it needs is done, several at once.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

/// What is left, what is done, and what went wrong.
struct State<E> {
    left: Vec<usize>,
    done: BTreeSet<usize>,
    failed: BTreeMap<usize, E>,
}

/// A queue that several threads work on.
struct Queue<'a, E> {
    /// What each thing needs, by position.
    needs: &'a [Vec<usize>],
    state: Mutex<State<E>>,
    changed: Condvar,
}

impl<E> Queue<'_, E> {
    fn state(&self) -> MutexGuard<'_, State<E>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes the first thing that can be begun; waits where all that is left needs what is being worked on. Nothing at the end.
    fn next(&self) -> Option<usize> {
        let mut state = self.state();
        loop {
            if state.left.is_empty() {
                return None;
            }
            let is_ready = |place: &usize| {
                let mut needs = self.needs.get(*place).into_iter().flatten();
                needs.all(|needed| needed >= place || state.done.contains(needed))
            };
            if let Some(at) = state.left.iter().position(is_ready) {
                return Some(state.left.remove(at));
            }
            let waiting = self.changed.wait(state);
            state = waiting.unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// Work that is going on; its end is told to those who wait, and one that panics is the end of all.
struct Going<'a, 'b, E>(&'a Queue<'b, E>);

impl<E> Drop for Going<'_, '_, E> {
    fn drop(&mut self) {
        if thread::panicking() {
            self.0.state().left.clear();
        }
        self.0.changed.notify_all();
    }
}

/// Works on all things in so many threads. Each needs some of those before it, by position; of those that can be begun the
/// first is. After a failure nothing more is begun.
///
/// # Errors
/// The error of the first thing that has one.
pub(crate) fn worked<E: Send>(
    needs: &[Vec<usize>],
    at_once: usize,
    work: &(dyn Fn(usize) -> Result<(), E> + Sync),
) -> Result<(), E> {
    let queue = Queue {
        needs,
        state: Mutex::new(State {
            left: (0..needs.len()).collect(),
            done: BTreeSet::new(),
            failed: BTreeMap::new(),
        }),
        changed: Condvar::new(),
    };
    let worker = || {
        while let Some(place) = queue.next() {
            let _going = Going(&queue);
            let result = work(place);
            let mut state = queue.state();
            match result {
                Ok(()) => {
                    state.done.insert(place);
                }
                Err(error) => {
                    state.left.clear();
                    state.failed.insert(place, error);
                }
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..at_once.clamp(1, needs.len().max(1)) {
            scope.spawn(worker);
        }
    });
    let state = queue.state.into_inner();
    let mut failed = state.unwrap_or_else(PoisonError::into_inner).failed;
    match failed.pop_first() {
        Some((_, error)) => Err(error),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "helpers of tests")]

    use super::*;
    use std::time::Duration;

    /// Both ends of a diamond, something that needs nothing, and a chain behind.
    fn needs() -> Vec<Vec<usize>> {
        vec![
            vec![],
            vec![0],
            vec![0],
            vec![1, 2],
            vec![],
            vec![3],
            vec![5, 4],
        ]
    }

    #[test]
    fn nothing_is_begun_before_what_it_needs_is_done_and_all_is_done_once() {
        for at_once in 0..9 {
            let events = Mutex::new(vec![]);
            let work = |place: usize| -> Result<(), ()> {
                events.lock().unwrap().push((place, "begun"));
                thread::sleep(Duration::from_millis(1));
                events.lock().unwrap().push((place, "done"));
                Ok(())
            };
            worked(&needs(), at_once, &work).unwrap();
            let events = events.into_inner().unwrap();
            let at = |event| events.iter().position(|own| *own == event).unwrap();
            assert_eq!(events.len(), 2 * needs().len());
            for (place, needed) in needs().iter().enumerate() {
                for needed in needed {
                    assert!(at((*needed, "done")) < at((place, "begun")), "{events:?}");
                }
            }
        }
    }

    #[test]
    fn one_thread_keeps_the_order_and_a_failure_ends_the_work() {
        let seen = Mutex::new(vec![]);
        let work = |place: usize| {
            seen.lock().unwrap().push(place);
            if place == 3 { Err(place) } else { Ok(()) }
        };
        assert_eq!(worked(&needs(), 1, &work), Err(3));
        assert_eq!(seen.into_inner().unwrap(), [0, 1, 2, 3]);
    }

    #[test]
    fn two_things_that_need_each_other_or_themselves_are_no_reason_to_wait() {
        let work = |_: usize| -> Result<(), ()> { Ok(()) };
        assert_eq!(worked(&[vec![1], vec![0], vec![2]], 2, &work), Ok(()));
        assert_eq!(worked(&[], 2, &work), Ok(()));
    }

    #[test]
    #[should_panic(expected = "a scoped thread panicked")]
    fn work_that_panics_leaves_nobody_waiting() {
        let work = |place: usize| -> Result<(), ()> {
            assert!(place != 3);
            Ok(())
        };
        let _ = worked(&needs(), 3, &work);
    }
}
