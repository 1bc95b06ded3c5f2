//! Exact numbers and formulas.
//!
//! Everything here is exact or certified: [`Rational`] numbers, sparse polynomials ([`Polynomial`]) over
//! the rationals in named symbols with pi, square roots of primes and pairs sin/cos of a quarter
//! turn, [`Fraction`]s that remember what they were divided by, truncated power series ([`Jet`]),
//! intervals that enclose a real number to any number of bits ([`Ball`]), and matrices over all of
//! these. One trait, [`Scalar`], lets the geometry be written once and run on each of them.
#![warn(missing_docs)]

pub mod affine;
pub mod ball;
pub mod bernstein;
pub mod branch;
pub mod fraction;
pub mod jet;
pub mod matrix;
pub mod order;
pub mod polynomial;
pub mod positivity;
pub mod rational;
pub mod scalar;
pub mod sturm;
pub mod symbol;

pub use affine::Affine;
pub use ball::Ball;
pub use fraction::Fraction;
pub use jet::Jet;
pub use matrix::{Matrix, MatrixError};
pub use polynomial::Polynomial;
pub use rational::{Integer, Rational};
pub use scalar::{ExactError, Scalar, ZeroTest};
pub use sturm::SturmSequence;
pub use symbol::{Angle, Symbol};
