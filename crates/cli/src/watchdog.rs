//! The time limit: ends a run that takes too long, and names the claims that it was deciding.
//!
//! Verdicts never depend on the clock: a run that is ended writes none.

use crate::exit::Exit;
use crate::terminal;
use std::collections::BTreeSet;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// The claims that are being decided; none once the run writes its output.
static DECIDING: Mutex<Option<BTreeSet<String>>> = Mutex::new(Some(BTreeSet::new()));

fn deciding() -> MutexGuard<'static, Option<BTreeSet<String>>> {
    DECIDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends the process after this time, unless [`finished`] was called before.
pub fn watch(limit: Duration) {
    std::thread::spawn(move || {
        std::thread::sleep(limit);
        if let Some(claims) = &*deciding() {
            terminal::remark(&message(limit, claims));
            std::process::exit(Exit::TimeLimit.code().into());
        }
    });
}

fn message(limit: Duration, claims: &BTreeSet<String>) -> String {
    let ids: Vec<&str> = claims.iter().map(String::as_str).collect();
    let seconds = limit.as_secs();
    let doing = match ids.as_slice() {
        // What is measured or drawn has no verdicts.
        [] => String::new(),
        ids => format!(", without verdicts; being decided: {}", ids.join(", ")),
    };
    format!("the time limit of {seconds} s has ended the run{doing} (--time-limit SECONDS)\n")
}

/// Disarms the limit: everything is decided, and writing is not interrupted.
pub fn finished() {
    *deciding() = None;
}

/// A claim is being decided.
pub fn begin(id: &str) {
    if let Some(claims) = &mut *deciding() {
        claims.insert(id.to_owned());
    }
}

/// It is decided.
pub fn end(id: &str) {
    if let Some(claims) = &mut *deciding() {
        claims.remove(id);
    }
}

/// Does something for a claim or a figure under the eyes of the guard.
pub fn guarded<T>(id: &str, job: impl FnOnce() -> T) -> T {
    begin(id);
    let done = job();
    end(id);
    done
}
