//! Statements and proofs of claims for the Rocq kernel (Coq 8.16 with Coquelicot).
//!
//! A verdict with a proof that the kernel accepts asks for trust in the printed formula, a page of definitions
//! (`proofs/Torse/Defs.v`) and the kernel, and for none in the prover. [`task`] says by a verdict what is to be proved,
//! [`statement`] writes a claim's core term as a proposition in the order of the print, with [`defined`] as premises
//! beside it since Rocq's operations are total, [`script`] names the tactics that prove it, [`folder`] lays out the files,
//! [`coqc`] asks the kernel. What cannot be written has a [`gap`].
//!
//! Nothing here decides anything: a wrong script is rejected by the kernel.
#![cfg_attr(
    not(test),
    deny(clippy::unwrap_used, clippy::expect_used, clippy::panic)
)]

pub mod binder;
pub mod check;
pub mod closed;
pub mod code;
pub mod context;
pub mod coqc;
pub mod defined;
pub mod digest;
pub mod domain;
pub mod folder;
pub mod forms;
pub mod gap;
pub mod implicit_derivative;
pub mod indexed_recurrence;
pub mod integer;
mod interval;
mod jets;
pub mod kinds;
pub mod library;
pub mod manual_proofs;
pub mod merge;
mod modules;
pub mod name;
mod place;
pub mod point;
pub mod printed;
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
