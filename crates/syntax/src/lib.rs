//! The language in which papers are stated.
//!
//! Data flow one way: [`formula`] turns text into trees, [`derivation`] reads files of declarations, claims and
//! figures, [`notation`] writes trees back: as text, LaTeX, Typst, Rust and SymPy. Nothing here decides or
//! evaluates anything.
#![warn(missing_docs)]

pub mod derivation;
pub mod fault;
pub mod formula;
pub mod greek;
pub mod notation;
pub mod similar;
pub mod taxonomy;
