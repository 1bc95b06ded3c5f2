//! From claims to outcomes.
//!
//! [`engine`] runs all claims of a paper and makes [`outcome`]s, each a claim ([`claim_record`]) and a [`finding`].
//! [`provenance`] finds which hypotheses of ours a proof needs, [`dependencies`] what a statement depends on, [`audit`]
//! flags differences between statement and print. [`repair`] searches for proved corrections of refuted statements,
//! [`consequences`] finds what falls with them, [`mod@derive`] derives the conditions of joins anew. [`net`]
//! cross-checks every verdict by the semantics before it is shown, [`replay`] has its proof ([`certificate`]) checked
//! without search, [`recheck`] repeats both with more work. [`mutants`] are statements with one slip, for mutation
//! testing; `existential` instantiates existential claims. Findings are data; [`words`] says what they show.
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
pub mod words;

pub use claim_record::Assumed;
pub use correction::{Correction, DataChange, DataCorrection};
pub use finding::Finding;
pub use judged::{ConditionCheck, Net, Replay};
pub use outcome::{Outcome, PaperOutcome, ReadingOutcome};
