//! What statements mean, tested from texts.
#![allow(clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod domain;
mod instances;
mod laws;
mod net;
mod smooth;
mod support;
mod tree;
mod values;
