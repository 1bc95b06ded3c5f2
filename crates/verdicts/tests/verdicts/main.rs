//! What is decided of claims, one file a subject. The certificates have a harness of their own, `proofs`.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "helpers of tests"
)]

mod common;

mod angles;
mod audit;
mod author_note;
mod binders;
mod certificates;
mod corrections;
mod derive;
mod elaboration;
mod ends;
mod exists;
mod exponentials;
mod mutants;
mod order;
mod planted;
mod positivity;
mod provenance;
mod readings;
mod recheck;
mod repair;
mod roots;
mod series;
mod small_stack;
mod soundness;
mod table;
mod typeset;
