//! The outputs as a reader gets them, from a made-up paper with every verdict and hostile strings.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

#[path = "../../examples/sample/paper.rs"]
mod paper;
mod support;

mod claims;
mod figures;
mod findings;
mod json;
mod letters;
mod mathematics;
mod page;
mod pdf;
