//! From claims to outcomes.
//!
//! [`engine`] runs all claims of a paper and makes [`outcome`]s, each a claim ([`claim_record`]) and a [`finding`].
//! [`provenance`] says which hypotheses of ours a proof needs, [`dependencies`] what a statement rests on, [`audit`] what a
//! statement leaves out of the print. [`repair`] searches proved corrections of what is refuted, [`consequences`] says what
//! falls with it, [`mod@derive`] derives the conditions of joins anew. [`net`] judges every verdict by the semantics before it
//! is shown, [`replay`] has its proof ([`certificate`]) checked without search, [`recheck`] does both again with more work.
//! [`mutants`] are statements with one slip, for mutation testing; `existential` instantiates existential claims.
#![warn(missing_docs)]

pub mod agreement;
pub mod audit;
mod author_note;
pub mod certificate;
pub mod claim_record;
mod conclusion;
mod condition;
mod conjunction;
pub mod consequences;
pub mod correction;
pub mod dependencies;
pub mod derive;
mod elaborated_claim;
pub mod engine;
mod existential;
pub mod faults;
pub mod finding;
pub mod judged;
pub mod mutants;
pub mod net;
pub mod outcome;
pub mod pending_claim;
pub mod provenance;
pub mod recheck;
pub mod repair;
pub mod replay;
pub mod restore;
pub mod statement;

pub use claim_record::Assumed;
pub use correction::{Correction, DataChange, DataCorrection};
pub use finding::Finding;
pub use judged::{ConditionCheck, Net, Replay};
pub use outcome::{Outcome, PaperOutcome, ReadingOutcome};
