//! The language in which the statements of papers are written.
//!
//! Data flow in one direction: [`formula`] parses texts to trees, [`derivation`] reads files of declarations, claims
//! and figures, and [`notation`] writes trees as text, Rust and SymPy (`torse-typography` sets them). Nothing here decides or
//! evaluates anything.
#![warn(missing_docs)]

pub mod derivation;
pub mod fault;
pub mod formula;
pub mod greek;
pub mod latex;
pub mod notation;
pub mod similar;
pub mod taxonomy;
