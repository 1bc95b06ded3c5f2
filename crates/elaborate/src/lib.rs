//! From syntax trees to core terms.
//!
//! This room resolves names, opens definitions, and replaces families and smooth functions. Its results are
//! tested, not proved: on every claim they have the values of the text at random residues, and the room `semantics` works
//! out the meaning of each statement from its text a second time.
#![warn(missing_docs)]

mod claim;
mod definedness;
mod elaborator;
mod existential;

pub use claim::elaborate;
pub use definedness::MAX_SUMMANDS;
pub use elaborator::{Elaborator, Lambda, Meaning};
