//! Proofs as values.
//!
//! The prover searches, and what it finds is a [`Proof`] or a [`Refuted`]: data from which verdict, evidence, conditions
//! and the steps in words are read, and from which the proof can be written for another system. Values are generic over
//! their polynomials, so that the prover builds them from its own and pays for nothing else; written, worded and checked
//! are those of the plain [`Polynomial`] of this room.
//!
//! [`check`] goes through a proof without any search. It knows the core claim and the numbers, and nothing of the prover:
//! it expands the terms itself, multiplies combinations out, expands Bernstein forms, sees that boxes fill the domain, and
//! puts counterexamples in.
//!
//! # The written form
//!
//! A proof is written as JSON, one object a node with its kind as the only key, as the types of this room nest. Symbols,
//! polynomials and numbers are texts in the notation of derivation files: `P[0,1]`, `2*x^2*sin(pi/2*x) - 1/3`, `-7/3`; a
//! quotient is `{"above": ..., "below": ...}`, a constraint `{"value": ..., "relation": ">="}` compares with zero.
#![warn(missing_docs)]

pub mod check;
pub mod enclosure;
pub mod evidence;
pub mod family;
pub mod identity;
pub mod number;
pub mod order;
pub mod point;
pub mod polynomial;
pub mod proof;
pub mod ratio;
pub mod sign;
pub mod symbol;
mod text;

pub use evidence::Evidence;
pub use polynomial::Polynomial;
pub use proof::Proof;
pub use proof::refutation::Refuted;
pub use ratio::{Constraint, Ratio};
pub use symbol::Symbol;
