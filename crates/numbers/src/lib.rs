//! Numbers that can be trusted.
//!
//! [`Integer`]s and [`Rational`]s of any size, whose order is right; intervals that enclose a real number to any
//! number of bits ([`Ball`]) with pi, sine and cosine; integer-affine index forms ([`Affine`]); and the one
//! trait, [`Scalar`], that lets a formula be written once and run on each of them, on doubles and on all
//! the algebra builds from them.
#![warn(missing_docs)]

pub mod affine;
pub mod ball;
pub mod fault_injection;
pub mod rational;
pub mod scalar;
pub mod stack;
pub mod work;

pub use affine::Affine;
pub use ball::Ball;
pub use rational::{Integer, Rational};
pub use scalar::{ExactError, Scalar, ZeroTest};
