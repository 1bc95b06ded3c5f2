//! Formulas of LaTeX, read as trees.
//!
//! [`read_latex`] lays a text out as TeX does ([`item`]) and reads the items by what their letters stand for ([`LatexNames`]).
//! The rules stand where they are applied: products, quotients and powers in `arithmetic`, functions without brackets in
//! `functions`, names with scripts in `applied`, sums, integrals and derivatives in `calculus`, relations and conditions in
//! `statement`.
//!
//! A print that mathematicians read in two ways has two readings, and the caller has to choose; what no rule covers is an error
//! with its place. Nothing is left out and nothing is guessed: no meaning is implied that these pages do not state.

mod applied;
mod arithmetic;
mod base;
mod calculus;
mod commands;
mod error;
mod functions;
mod guess;
pub mod item;
mod layout;
mod names;
mod operand;
mod reader;
mod reading;
mod statement;
mod suspects;
pub mod token;

pub use commands::{CommandKind, command_kind, is_relation_sign};
pub use error::LatexError;
pub use guess::LatexGuess;
pub use layout::{layout, layout_tokens, one_form_of_each_letter, without_final_punctuation};
pub use names::{LatexKind, LatexNames, parts};
pub use reader::LatexDoubt;
pub use reading::{LatexReading, read_items, read_latex};
pub use statement::{LatexCondition, LatexStatement};
