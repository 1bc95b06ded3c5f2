//! Statements and proofs for the kernel, judged by it. Where coqc is missing the tests print one line and pass.

#![allow(clippy::unwrap_used, clippy::print_stderr, reason = "tests")]

mod forms;
mod kernel;
mod support;
mod tree;
