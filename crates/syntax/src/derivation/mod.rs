//! Derivation files: papers and their claims as data.
//!
//! A folder of derivations contains one folder for each paper. Its `paper.toml` names the paper, declares symbols,
//! basis families and definitions, and lists the files with claims, in order.

mod author_note;
mod claim;
mod corrigendum;
pub mod declarations;
mod definitions;
mod error;
mod existential;
mod figure;
mod folder;
mod interval;
mod latex_formula;
mod latex_names;
mod latex_question;
mod load;
mod look_alikes;
mod one_by_one;
mod paper;
mod provenance;
mod question;
mod references;
mod rests_on;
pub mod schema;
mod source;
mod table;
mod written;

pub use author_note::{AuthorNote, Form, Piece};
pub use claim::{Answer, Claim, Reading};
pub use corrigendum::{CorrectedClaim, Corrigendum, Rewording};
pub use error::{DerivationError, LoadError, LookAlike};
pub use existential::Existential;
pub use figure::Figure;
pub use folder::MAX_BYTES;
pub use latex_names::latex_names;
pub use latex_question::latex_question;
pub use load::{Loaded, load, load_all, load_all_with, open, paper};
pub use look_alikes::name_taken_for;
pub use one_by_one::OneByOne;
pub use paper::Paper;
pub use provenance::{Hypothesis, Provenance, Quote};
pub use question::{question, undeclared_names};
pub use rests_on::RestsOn;
pub use schema::corrigendum::LetterPart;
pub use source::{Origin, Source};
pub use written::{Written, parsed, written};
