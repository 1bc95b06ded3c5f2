//! Derivation files: papers and their claims as data.
//!
//! A folder of derivations holds one folder a paper. Its `paper.toml` names the paper, declares symbols,
//! basis families and definitions, and lists the files with claims, in order.

pub mod declarations;
mod error;
mod figure;
mod folder;
mod load;
pub mod schema;
mod source;
mod table;
mod written;

pub use error::{DerivationError, LoadError};
pub use figure::Figure;
pub use folder::MAX_BYTES;
pub use load::{Claim, Loaded, Paper, load, load_all, paper};
pub use source::{Origin, Source};
pub use written::{Written, parsed, written};
