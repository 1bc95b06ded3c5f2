//! The formula language, derivation files, decision procedures and verdicts.
//!
//! Data flow one way: [`syntax`] turns text into trees, [`derivation`] reads files of claims,
//! [`evaluate`] turns trees into exact values, [`decide`] turns statements into decisions,
//! [`engine`] runs all claims of a paper and writes [`outcome`]s. [`figure`] turns the figures of the files
//! into exact data for drawing.

pub mod consequences;
pub mod decide;
pub mod derivation;
pub mod derive;
pub mod engine;
pub mod evaluate;
pub mod figure;
pub mod mutants;
pub mod notation;
pub mod outcome;
pub mod recheck;
pub mod repair;
pub mod syntax;

pub use outcome::{
    Correction, DataChange, DataCorrection, Evidence, Formula, Kind, Outcome, PaperOutcome,
    Verdict, Witness,
};
