//! Tests that cross rooms live in `tests/tests`; here is what they share: random claims.

pub mod random;
