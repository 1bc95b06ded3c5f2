//! Tests that cross rooms live in `tests/tests`; here is what they share: random claims, and claims written for judges that
//! are not in Rust.

pub mod composed;
pub mod dump;
pub mod random;
