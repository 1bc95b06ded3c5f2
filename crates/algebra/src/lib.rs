//! Exact formulas.
//!
//! Sparse polynomials ([`Polynomial`]) over the rationals in named symbols with pi, square roots of primes and
//! pairs sin/cos of a quarter turn, exponentials, [`Fraction`]s that remember what they were divided by, truncated
//! power series ([`Jet`]), Bernstein forms ([`bernstein`]), real roots ([`sturm`]) and matrices over all
//! of these. The numbers they are made of come from [`torse_numbers`] and are named here again.
#![warn(missing_docs)]

pub mod bernstein;
pub mod fraction;
pub mod jet;
pub mod matrix;
pub mod mersenne;
pub mod polynomial;
pub mod rational_box;
pub mod sturm;
pub mod symbol;

pub use fraction::Fraction;
pub use jet::Jet;
pub use matrix::{Matrix, MatrixError};
pub use polynomial::Polynomial;
pub use polynomial::angles::Finest;
pub use sturm::SturmSequence;
pub use symbol::{Angle, Exponent, Symbol, Unit};
pub use torse_numbers::{
    Affine, Ball, ExactError, Integer, Rational, Scalar, ZeroTest, affine, ball, fault_injection,
    rational, scalar, work,
};
