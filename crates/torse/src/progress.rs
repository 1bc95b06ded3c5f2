//! Progress of deciding claims, and how to cancel it.

use std::ops::ControlFlow;

/// An event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Event<'e> {
    /// A pass over claims begins.
    Begins {
        /// The pass.
        pass: Pass,
        /// The number of its claims.
        claims: usize,
    },
    /// Work on a claim begins.
    ClaimBegins {
        /// The pass.
        pass: Pass,
        /// The claim.
        id: &'e str,
    },
    /// Work on a claim ends.
    ClaimEnds {
        /// The pass.
        pass: Pass,
        /// The claim.
        id: &'e str,
        /// The work that this pass has spent on it, in the units of a [`WorkBudget`](crate::WorkBudget): the same on every
        /// machine.
        work: u64,
    },
    /// A pass ends.
    Ends {
        /// The pass.
        pass: Pass,
    },
}

/// The passes over claims, one after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Pass {
    /// Decides all claims.
    Deciding,
    /// Searches for corrections of refuted claims.
    Correcting,
}

/// A callback for all events, from any thread. If it breaks, no further claim is begun, and the call ends with
/// [`Error::Cancelled`](crate::Error::Cancelled). A claim that was begun is finished:
/// [`Verifier::stopped_by`](crate::Verifier::stopped_by) ends that, too.
pub type Observer<'o> = &'o (dyn Fn(Event<'_>) -> ControlFlow<()> + Sync);

/// Ignores all events.
pub fn unobserved(_: Event<'_>) -> ControlFlow<()> {
    ControlFlow::Continue(())
}
