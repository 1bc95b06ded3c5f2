//! From claims to outcomes.
//!
//! [`engine`] runs all claims of a paper and writes [`outcome`]s, [`provenance`] says which hypotheses of ours a proof needs,
//! the findings of files are told in words, [`readings`] say what is true of a sentence that may be read in two ways, [`table`] what a statement rests on, [`audit`] what a statement leaves
//! out of the print, [`repair`] searches proved corrections of what
//! is refuted, [`consequences`] says what falls with it, [`mod@derive`] derives the conditions of joins anew,
//! [`net`] judges every verdict by the semantics before it is shown, [`replay`] has its proof ([`grounds`]) checked without
//! search, [`mutants`] are slips made on purpose, witnesses take the place of numbers that there are, [`recheck`] does both again.
#![warn(missing_docs)]

pub mod agreement;
pub mod audit;
mod concluded;
mod condition;
mod conjunction;
pub mod consequences;
pub mod derive;
pub mod engine;
pub mod faults;
mod finding;
pub mod grounds;
mod meant;
pub mod mutants;
pub mod net;
pub mod outcome;
pub mod provenance;
pub mod readings;
pub mod recheck;
pub mod repair;
pub mod replay;
pub mod restore;
mod sought;
pub mod stage;
pub mod table;

pub use outcome::{
    Assumed, Correction, DataChange, DataCorrection, Net, Outcome, PaperOutcome, ReadingOutcome,
    Replay, Sides,
};
