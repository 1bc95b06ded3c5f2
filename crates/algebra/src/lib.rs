//! Exact formulas.
//!
//! Sparse polynomials ([`Polynomial`]) over the rationals in named symbols, pi, square roots of primes, sines and
//! cosines, and exponentials; [`Fraction`]s that record their divisors; truncated power series ([`Jet`]); Bernstein
//! forms ([`bernstein`]); and matrices over any of these scalars. The number types come from
//! [`torse_numbers`] and are re-exported here.
#![warn(missing_docs)]

pub mod bernstein;
pub mod fraction;
pub mod jet;
pub mod matrix;
pub mod mersenne;
pub mod polynomial;
mod power;
pub mod rational_box;
pub mod symbol;

pub use fraction::Fraction;
pub use jet::Jet;
pub use matrix::{Matrix, MatrixError};
pub use polynomial::Polynomial;
pub use polynomial::angles::Finest;
pub use symbol::{Angle, Exponent, Symbol, Unit};
pub use torse_numbers::{
    Affine, Ball, ExactError, Integer, Rational, Scalar, ZeroTest, affine, ball, fault_injection,
    rational, scalar, work,
};
