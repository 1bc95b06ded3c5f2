//! Proofs as values.
//!
//! The prover searches, and its result is a [`Proof`] or a [`Refuted`]: data from which the verdict, the evidence and the
//! conditions are derived, which `steps` of the room of proofs puts into words, and which can be written for another system.
//! Certificates are generic over their polynomials, so that the prover can build them from its own without
//! conversion. Certificates that are written, put into words or checked use the plain [`Polynomial`] of this room.
//!
//! The room `checker` checks a certificate without searching.
//!
//! # The written form
//!
//! `torse verify --proofs DIR` writes `DIR/PAPER.json`, the same bytes on every run: `{"paper", "claims"}`, each claim
//! with `id`, `reading`, `states`, `verdict`, `replayed` and `rests_on`, which is `{"proof": {"conditions", "of"}}` or
//! `{"refutation": ...}`. A node of a proof is an object whose only key is its kind; its fields are those of the type
//! here. Symbols, polynomials and numbers are texts in the notation of derivation files: `P[0,1]`,
//! `2*x^2*sin(pi/2*x) - 1/3`, `-7/3`; a quotient is `{"above", "below"}`, and a constraint `{"value", "relation"}`
//! compares with zero.
//!
//! | kind | what it says | type |
//! |---|---|---|
//! | `identity` | the difference vanishes, by its normal form or as a series of symbolic degree | [`identity::Identity`] |
//! | `combination` | the difference is a sum of multiples of equations | [`identity::Combination`] |
//! | `forced` | the difference can be nothing but zero: between two signs, by its square, or beside factors that do not vanish | [`zero_by_sign::ZeroBySign`] |
//! | `order` | the difference has a sign: certificates with boxes, squares, factors, rays, real roots on the line ([`mod@line`]), partial sums of series ([`taylor`]) | [`order::Order`], [`sign::Sign`] |
//! | `excluded` | hypotheses say that the difference is not zero | [`order::Excluded`] |
//! | `enclosure` | printed numbers are the values, rounded or cut off | [`enclosure::Enclosure`] |
//! | `nonnegative`, `powers` | properties of a basis at every degree | [`family`] |
//! | `wronskians` | total positivity at some degrees, by positive determinants on cells | [`wronskian`] |
//! | `on` | a proof with its assumptions: eliminated symbols, constraints, conditions | [`proof::assumptions::Assumptions`] |
//! | `both`, `clauses`, `parts`, `instances` | conjunctions, of halves, clauses, parts of the domain, values of integers | [`proof::Proof`] |
//! | `split`, `sides` | where a divisor is not zero and where it is; where the argument of an absolute value is not negative and where it is not positive | [`proof::Proof`] |
//! | `alternative`, `conclusion` | one part of `or`, perhaps where the others fail; the end of `implies` | [`proof::Proof`] |
//! | `exists` | `not p` by a point | [`proof::refutation::Refuted`] |
//! | `nowhere`, `defined`, `within` | no point; conditions that only say where terms are defined, or that say where those are that a proof does not need | [`proof::Proof`] |
//!
//! A refutation is `at` a point, at an `instance` of integers, or of a `denied` statement that is proved to hold
//! everywhere.
#![warn(missing_docs)]

pub mod enclosure;
pub mod evidence;
pub mod family;
pub mod identity;
pub mod line;
pub mod number;
pub mod order;
pub mod point;
pub mod polynomial;
pub mod proof;
pub mod ratio;
pub mod sign;
pub mod symbol;
pub mod taylor;
mod text;
pub mod wronskian;
pub mod zero_by_sign;

pub use evidence::Evidence;
pub use polynomial::Polynomial;
pub use proof::Proof;
pub use proof::refutation::Refuted;
pub use ratio::{Constraint, Ratio};
pub use symbol::Symbol;
