//! From statements to decisions.
//!
//! [`context`] collects the hypotheses of a claim; [`evaluate`] turns core terms into exact values (normal forms, and
//! series of symbolic degree); [`decide`] has the procedures that decide one kind of statement; [`combination`] derives
//! equations from given ones without solving these; [`statement`] runs all of it for a claim.
//! [`formula`] writes an exact value as one would write it by hand.
#![warn(missing_docs)]

pub mod arcs;
mod case_split;
pub mod combination;
mod connectives;
pub mod context;
pub mod decide;
mod decider;
mod divisors;
pub mod evaluate;
pub mod evidence;
pub mod existential;
pub mod formula;
pub mod ideal;
pub mod logarithms;
pub mod probabilistic_refuter;
pub mod roots;
mod split;
pub mod statement;
mod term_divisors;
pub mod unknown;

pub use evidence::{Evidence, Witness};
pub use statement::{a_point_of, decide_statement, with_prepared};
