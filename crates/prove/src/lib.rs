//! From statements to decisions.
//!
//! [`evaluate`] turns trees into exact values (normal forms, and series of symbolic degree), [`context`] makes a
//! claim ready, [`combination`] sees what follows from given equations unsolved, [`decide`] turns its statement into a decision, [`statement`] does all of it for a claim, [`formula`]
//! leads from exact values back to a formula as one would write it by hand.
#![warn(missing_docs)]

mod case_split;
pub mod combination;
mod connectives;
pub mod context;
pub mod decide;
mod decider;
pub mod evaluate;
pub mod evidence;
pub mod existential;
pub mod formula;
pub mod ideal;
pub mod probabilistic_refuter;
pub mod roots;
mod split;
pub mod statement;
pub mod steps;
pub mod unknown;

pub use evidence::{Evidence, Witness};
pub use statement::{a_point_of, decide_statement, with_prepared};
