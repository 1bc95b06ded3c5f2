//! The meaning of statements, computed from the syntax trees of their texts; written to be read.
//!
//! `derivations/SEMANTICS.md` states the meaning of each construct in mathematics; this crate executes it. It shares
//! only the trees, the declarations and the numbers with the elaborator and the prover. So a mistake there goes
//! unnoticed only if the same mistake was made here, in independently written code.
//!
//! - [`tree`]: the value of a tree, with one rule for each construct, over any [`Arithmetic`]: [`Reals`] (exact where
//!   possible, otherwise enclosed), residues modulo a prime, [`Polynomials`] (for identities). Derivatives are
//!   computed with truncated power series ([`Series`]).
//! - [`judge_samples`]: judges a statement at random points of its domain; this cross-checks proofs.
//! - [`check_witness`]: checks whether a printed counterexample is one; this cross-checks refutations.
//! - [`judge_violations`]: judges a statement at points of its domain where a condition fails; this cross-checks conditions.
//! - [`identity`] at [`instances`]: equations at fixed small integers, decided exactly.
//! - [`tree::Compared`]: evaluates trees at random residues, for comparison with what an elaborator makes of them.
//!
//! All work is bounded by budgets of operations, so answers are the same on every machine.
//!
//! ```
//! use std::sync::Arc;
//! use torse_syntax::derivation::{paper, Source};
//! use torse_semantics::tree::Reading;
//! use torse_semantics::{Witness, check_witness, judge_samples};
//!
//! let files = |name: &str| Ok(Arc::new(Source::new(name, match name {
//!     "paper.toml" => r#"
//!         [paper]
//!         id = "p"
//!         title = "t"
//!         authors = "a"
//!         venue = "v"
//!         claims = ["c.toml"]
//!         [symbols]
//!         x = { in = "[0, 1]" }
//!     "#,
//!     _ => r#"
//!         [[claim]]
//!         id = "p/square"
//!         at = "p. 1"
//!         kind = "inequality"
//!         printed = "x² < x"
//!         states = 'x^2 < x'
//!     "#,
//! })));
//! let paper = paper(files)?;
//! let claim = &paper.claims[0];
//! let statement = &claim.statement.as_ref().unwrap().expr;
//!
//! let reading = Reading::new(claim, statement, ["x"]);
//! let found = judge_samples(&reading, &[], "p/square", 20, 1_000_000);
//! let point = found.failing.expect("it is false at the ends");
//! assert!(["x = 0", "x = 1"].contains(&point.to_string().as_str()));
//! let witness = check_witness(claim, statement, [("x", "2")]);
//! assert!(matches!(witness, Witness::Outside(_)));
//! # Ok::<(), torse_syntax::derivation::LoadError>(())
//! ```
#![warn(missing_docs)]

mod arithmetic;
mod branches;
mod divisors;
mod domain;
mod expansion;
mod gradient;
mod instance;
mod judge;
mod judgement;
pub mod linear;
mod name;
mod net;
mod no_value;
mod polynomial;
mod real;
mod residue;
mod scrambled;
mod series;
mod surd;
mod survey;
pub mod tree;
mod value;
mod witness;

pub use arithmetic::{Arithmetic, Comparison};
pub use domain::point::{Outside, Point};
pub use instance::{Identity, Instance, identity, instances};
pub use judgement::Judgement;
pub use name::Name;
pub use net::{SampleStatistics, ViolationStatistics, judge_samples, judge_violations};
pub use no_value::{NoValue, Undefined, Unknown, Work};
pub use polynomial::{Polynomials, Quotient};
pub use real::{Real, Reals, Turned};
pub use scrambled::{Class, Scrambled};
pub use series::Series;
pub use surd::Surd;
pub use value::{Value, dot, transposed};
pub use witness::{Unreadable, Witness, check, check_witness, read};
