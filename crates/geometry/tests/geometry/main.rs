//! The laws of the library, each checked in two independent ways.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests fail like the tests themselves"
)]

mod agreement;
mod batches;
mod certified;
mod connections;
mod constructions;
mod covers;
mod developables;
mod enclosures;
mod extremes;
mod hostile;
mod identities;
mod itself;
mod joins;
mod panels;
mod patterns;
mod singular;
mod splines;
mod support;
mod surfaces;
mod traces;
mod ulps;
