//! From syntax trees to core terms.
//!
//! Names are resolved, definitions are opened, families and smooth functions are carried out. Nothing here is trusted:
//! what a statement means is worked out from its text a second time, in the room `semantics`.
#![warn(missing_docs)]

mod claim;
mod elaborator;
mod existential;

pub use claim::elaborate;
pub use elaborator::{Elaborator, Lambda, Meaning};
