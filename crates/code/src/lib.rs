//! Code beside the formula: functions of Python and Rust, compared exactly with what a paper prints.
//!
//! [`compare`] reads a pure function as a formula, with the language's own parser (tree-sitter) and without running it: constants,
//! assignments, loops over constants, branches on constants and calls of functions of the same file are carried out on symbols. Numbers are exact: `0.1` is 1/10, and nothing rounds or
//! overflows. What is not read is refused with its place. Then the equality of this formula with the printed side of a claim is decided like any
//! claim; where they differ, there is a point, and the one change of the code or of the print after which they are equal.
#![warn(missing_docs)]

mod compare;
mod grammar;
mod program;
mod python;
mod run;
mod rust;

pub use compare::{
    CodeEdit, CodeQuestion, CodeVerdict, Comparison, PrintEdit, PrintedSide, compare,
};
pub use grammar::{MAX_CODE_BYTES, MAX_CODE_NESTING};
pub use program::CodeLanguage;
pub use run::{MAX_CODE_NODES, MAX_CODE_STEPS};
