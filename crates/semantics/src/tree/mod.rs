//! What a tree means, written to be read beside `derivations/SEMANTICS.md`: one section there, one file here.
//!
//! - `evaluate`: names, operators, entries; `environment`: what names stand for
//! - `functions`: the functions of the language, `closure`: functions as values, and derivatives
//! - `basis`, `property`: basis families; `smooth`: arbitrary smooth functions, `jets`: what is given of them
//! - `integral`, `coefficients`
//! - `statement`: what is true at a point; `judge`: a claim at a point
//! - `outline`, `compared`: trees against what an elaborator makes of them
//! - `slips`: whether points see anything
//! - `memory`, `remembered`: what need not be evaluated twice
//!
//! The trees are those of the parser, with the declarations of the file. No other reading of the text is looked at: what the
//! elaborator makes of a claim is judged by this one.

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
