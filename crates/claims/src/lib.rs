//! The formula language, derivation files, decision procedures and verdicts.

pub mod outcome;

pub use outcome::{Correction, Evidence, Formula, Kind, Outcome, PaperOutcome, Verdict, Witness};
