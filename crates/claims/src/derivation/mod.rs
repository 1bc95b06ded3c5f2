//! Derivation files: papers and their claims as data.
//!
//! A folder of derivations holds one folder a paper. Its `paper.toml` names the paper, declares symbols,
//! basis families and definitions, and lists the files with claims, in order.

mod error;
mod load;
pub mod schema;
mod source;

pub use error::{DerivationError, LoadError};
#[cfg(test)]
pub(crate) use load::paper;
pub use load::{Claim, Paper, Written, load};
pub(crate) use load::{parsed, written};
pub use source::{Origin, Source};
