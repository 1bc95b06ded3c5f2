//! The language in which papers are stated.
//!
//! Data flow one way: [`syntax`] turns text into trees, [`derivation`] reads files of declarations, claims and
//! figures, [`core`] opens trees to terms that lean on nothing, [`notation`] writes trees back: as text, LaTeX, Typst, Rust and SymPy. Nothing here decides or
//! evaluates anything.
#![warn(missing_docs)]

pub mod core;
pub mod derivation;
pub mod fault;
pub mod notation;
pub mod similar;
pub mod syntax;
pub mod words;
