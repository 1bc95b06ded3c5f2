//! Statements and proofs of claims for the Rocq kernel (Coq 8.16 with Coquelicot).
//!
//! To believe a verdict with a proof that the kernel accepts, one has to trust the parser, [`tree`], which writes the
//! statement that is read from the syntax tree, a page of definitions (`proofs/Torse/Defs.v`) and the kernel, but not
//! the prover. [`task`] derives from a verdict what is to
//! be proved, [`statement`] writes a claim's core term as a proposition in the order of the print, with the premises of
//! [`defined`], since Rocq's operations are total, [`script`] chooses the tactics that prove it, [`folder`] lays out
//! the files, [`coqc`] asks the kernel. A [`gap`] says why something cannot be written.
//!
//! Nothing here decides a claim: the kernel rejects a wrong script.
#![cfg_attr(
    not(test),
    deny(clippy::unwrap_used, clippy::expect_used, clippy::panic)
)]

pub mod accepted;
pub mod binder;
pub mod check;
pub mod closed;
pub mod code;
pub mod context;
pub mod coqc;
mod coqc_output;
pub mod defined;
pub mod digest;
pub mod domain;
mod equal_definitions;
pub mod folder;
pub mod forms;
pub mod gap;
pub mod implicit_derivative;
pub mod indexed_recurrence;
pub mod integer;
mod interval;
mod jets;
pub mod kernel_error;
pub mod kinds;
pub mod library;
pub mod manual_proofs;
pub mod merge;
mod modules;
pub mod name;
mod place;
pub mod point;
pub mod printed;
pub mod process;
pub mod proposition;
mod scheduler;
pub mod script;
pub mod script_search;
pub mod section;
pub mod shape;
pub mod shared;
pub mod solutions;
pub mod solved;
pub mod statement;
pub mod task;
pub mod theorem;
pub mod translation;
pub mod tree;
pub mod unknowns;
pub mod value;
