//! What is written reads back.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests fail like the tests themselves"
)]

mod cad;
mod damaged;
mod drawings;
mod files;
mod meshes;
mod patterns;
mod reading;
mod sheets;
