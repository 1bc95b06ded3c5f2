//! From syntax trees to core terms.
//!
//! This room resolves names, opens definitions, and replaces families and smooth functions. Its results are not
//! trusted: the room `semantics` works out the meaning of each statement from its text a second time.
#![warn(missing_docs)]

mod claim;
mod elaborator;
mod existential;

pub use claim::elaborate;
pub use elaborator::{Elaborator, Lambda, Meaning};
