//! Exact and certified numbers.
//!
//! [`Integer`]s and [`Rational`]s of any size with a correct order; intervals that enclose a real number to any
//! number of bits ([`Ball`]), with pi, sine and cosine; integer-affine index forms ([`Affine`]). The trait [`Scalar`]
//! lets a formula be written once and evaluated on each of them, on doubles, and on the scalars that `algebra` builds
//! from them. [`work`] counts and limits what a computation may cost.
#![warn(missing_docs)]

pub mod affine;
pub mod ball;
pub mod fault_injection;
pub mod rational;
pub mod scalar;
#[cfg(feature = "stack")]
pub mod stack;
pub mod work;

pub use affine::Affine;
pub use ball::Ball;
pub use rational::{Integer, Rational};
pub use scalar::{ExactError, Scalar, ZeroTest};
