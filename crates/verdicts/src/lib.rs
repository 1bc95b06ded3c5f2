//! From claims to outcomes.
//!
//! [`engine`] runs all claims of a paper and writes [`outcome`]s, [`repair`] searches proved corrections of what
//! is refuted, [`consequences`] says what falls with it, [`mod@derive`] derives the conditions of joins anew,
//! [`net`] judges every verdict by the semantics before it is shown, [`mutants`] are slips made on purpose, [`recheck`] replays proofs by other means.
#![warn(missing_docs)]

mod condition;
pub mod consequences;
pub mod derive;
pub mod engine;
pub mod mutants;
pub mod net;
pub mod outcome;
pub mod recheck;
pub mod repair;

pub use outcome::{Correction, DataChange, DataCorrection, Net, Outcome, PaperOutcome, Sides};
