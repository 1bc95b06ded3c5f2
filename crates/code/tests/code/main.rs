//! Programs compared with the formulas of the shipped papers.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod equal;
mod misread;
mod page;
mod refused;
mod slips;
mod support;
mod traps;
