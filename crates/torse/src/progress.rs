//! What is told while claims are decided, and how that is ended.

use std::ops::ControlFlow;

/// Something has happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Event<'e> {
    /// A pass over claims begins.
    Begins {
        /// Which one.
        pass: Pass,
        /// How many claims it looks at.
        claims: usize,
    },
    /// A claim is looked at.
    ClaimBegins {
        /// Which pass does.
        pass: Pass,
        /// The claim.
        id: &'e str,
    },
    /// The pass is done with a claim.
    ClaimEnds {
        /// Which pass is.
        pass: Pass,
        /// The claim.
        id: &'e str,
    },
    /// The pass is over.
    Ends {
        /// Which one.
        pass: Pass,
    },
}

/// What is done with claims, one pass after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Pass {
    /// All are decided.
    Deciding,
    /// Corrections of what is refuted are searched.
    Correcting,
}

/// A callback that is told of everything, from any thread; where it breaks, no further claim is begun, and the call that it
/// watches ends with [`Error::Cancelled`](crate::Error::Cancelled). A claim that was begun is finished.
pub type Observer<'o> = &'o (dyn Fn(Event<'_>) -> ControlFlow<()> + Sync);

/// Looks away.
pub fn unobserved(_: Event<'_>) -> ControlFlow<()> {
    ControlFlow::Continue(())
}
