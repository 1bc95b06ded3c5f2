//! Tests that cross rooms live in `tests/tests`; here is what they share: random claims.

#![allow(clippy::panic, reason = "a library of tests")]

pub mod random;
