//! The meaning of trees, written to be read beside `derivations/SEMANTICS.md`: one file for each section.
//!
//! - `evaluate`: names, operators, entries; `environment`: the meaning of names
//! - `functions`: the functions of the language, `closure`: functions as values, and derivatives
//! - `basis`, `property`: basis families; `smooth`: arbitrary smooth functions, `jets`: their given derivatives
//! - `integral`, `coefficients`
//! - `statement`: truth at a point; `judge`: a claim at a point
//! - `outline`, `compared`: comparison of trees with what an elaborator makes of them
//! - `slips`: whether the points are able to show errors
//! - `memory`, `remembered`: caching
//!
//! The trees are those of the parser, with the declarations of the file. No other reading of the text is used,
//! because this one judges what the elaborator makes of a claim.

mod basis;
mod closure;
mod coefficients;
mod compared;
mod environment;
mod evaluate;
mod functions;
mod integral;
mod jets;
mod judge;
mod memory;
mod outline;
mod outside;
mod property;
mod remembered;
mod slips;
mod smooth;
mod statement;

pub use compared::{Assignment, Compared, TreeOutline};
pub(crate) use evaluate::Given;
pub(crate) use judge::At;
pub use judge::{Reading, Values};
pub use outline::{BASIS_AT, BASIS_DEGREES, Outline, Piece, printed_number, word};
pub(crate) use statement::joined;
