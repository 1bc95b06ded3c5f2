//! Tests that cross rooms live in `tests/tests`; here is what they share: random claims, and claims written for judges that
//! are not in Rust.

#![allow(
    clippy::disallowed_methods,
    reason = "a judge of its own, compared within a tolerance"
)]

pub mod composed;
pub mod dump;
pub mod random;
