//! Design files from reading to the shop floor.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests"
)]

mod connect;
mod ends;
mod hostile;
mod joints;
mod kinds;
mod mistakes;
mod patterns;
mod rails;
mod random;
mod schema;
mod surfaces;
mod worked;
